// The corners of a contact of two boxes, four at once.
#include "query/contact/box_corners.hpp"

#include <bit>

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/contact/box_corners.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef PLUMB_BOX_CORNERS_ONCE
#define PLUMB_BOX_CORNERS_ONCE
namespace plumb::query::touching::box_corners {

/// A box, and its side that faces the other.  As it stands it is one whose pose has a weight of one and no turn.
struct BoxSide {
  PosedBox box;
  bool is_aligned;  // and stands
  std::array<Index, 4> corners;
  std::array<std::size_t, 2> along;  // the axes of its first edge and its second

  static std::optional<BoxSide> of(const Seen& seen, const Facing& facing) {
    if (facing.corners.size() != 4) return {};
    const auto box = seen.core.posed_box();
    if (!box) return {};
    const auto& f = facing.corners;
    const Index first = f[0] ^ f[1], second = f[1] ^ f[2];
    const auto is_bit = [](Index x) { return x == 1 || x == 2 || x == 4; };
    if (!is_bit(first) || !is_bit(second) || first == second || (f[2] ^ f[3]) != first) return {};
    const bool is_aligned = seen.core.is_aligned() && seen.core.pose().stands();
    return BoxSide{*box, is_aligned, {f[0], f[1], f[2], f[3]}, {first >> 1, second >> 1}};
  }
  [[nodiscard]] const Vector3& edge(std::size_t i) const { return box.axes[along[i & 1]]; }
};

}  // namespace plumb::query::touching::box_corners
#endif

#include "query/contact/many_balls.hpp"
#include "query/penetration/many_vectors.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::touching::box_corners::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

using namespace parting::many_vectors::HWY_NAMESPACE;  // NOLINT: all of it is of this text
using many_balls::HWY_NAMESPACE::Balls;

HWY_INLINE Space<Twofolds> between(const Space<Twofolds>& p, const Space<Twofolds>& q) {
  return {q.x - p.x, q.y - p.y, q.z - p.z};
}
/// 1 / x, lane by lane.
HWY_INLINE Twofolds inverse_of(const Twofolds& x) {
  Four high, low, magnitude;
  store(x.high, high), store(x.low, low), store(x.magnitude, magnitude);
  double e = 0, w = 0;  // the same of each
  for (std::size_t k = 0; k < 4; ++k) {
    const One q = quotient(One(1.0), One{high[k], low[k], magnitude[k], x.error, x.width});
    high[k] = q.high, low[k] = q.low, magnitude[k] = q.magnitude, e = q.error, w = q.width;
  }
  return {loaded_four(high), loaded_four(low), loaded_four(magnitude), e, w};
}

/// Which numbers of the normal are none, exactly, and the axis of space that it is along, or -1.
struct Zeros {
  std::array<bool, 3> is;
  [[nodiscard]] int axis() const {
    if (is[0] && is[1]) return 2;
    return !is[2] ? -1 : is[0] ? 1 : is[1] ? 0 : -1;
  }
};

/// Four points or numbers, each rounded once where its bit is set.
struct ToldPoints {
  Four x, y, z;
  unsigned are_told;
  [[nodiscard]] bool has(std::size_t k) const { return (are_told >> k & 1) != 0; }
  [[nodiscard]] Point3 operator[](std::size_t k) const { return {x[k] + 0.0, y[k] + 0.0, z[k] + 0.0}; }
};
struct ToldFour {
  Four x;
  unsigned are_told;
  [[nodiscard]] bool has(std::size_t k) const { return (are_told >> k & 1) != 0; }
};
HWY_INLINE Truth is_in_range(const Many& x) {
  return certify::many_lanes::HWY_NAMESPACE::at_most(size(x), of_all(0x1p1000));
}
HWY_INLINE void tell(const Space<Twofolds>& p, ToldPoints& to) {
  Many x, y, z;
  const Truth are = p.x.told(x) & p.y.told(y) & p.z.told(z);
  store(x, to.x), store(y, to.y), store(z, to.z);
  to.are_told = bits_of(are & is_in_range(x) & is_in_range(y) & is_in_range(z));
}
/// But for these numbers, which are known otherwise.
HWY_INLINE void tell(const Space<Twofolds>& p, const Zeros& but, ToldPoints& to) {
  unsigned are = 15;
  const auto part = [&](const Twofolds& x, Four& of) HWY_ATTR {
    Many told;
    const Truth is = x.told(told);
    store(told, of), are &= bits_of(is & is_in_range(told));
  };
  if (!but.is[0]) part(p.x, to.x);
  if (!but.is[1]) part(p.y, to.y);
  if (!but.is[2]) part(p.z, to.z);
  to.are_told = are;
}
HWY_INLINE void tell(const Twofolds& p, ToldFour& to) {
  Many x;
  const Truth is = p.told(x);
  store(x, to.x);
  to.are_told = bits_of(is & is_in_range(x));
}

/// The corners of a side as numbers, and rounded: sums that lose nothing are known to be halfway between two doubles.
struct Corners4 {
  Space<Twofolds> at;
  ToldPoints told;
};
struct Coordinate {
  Twofolds at;
  Many told;
  Truth is_told;
};
/// A row of the matrix, one of the axes, and the turn of the center.
struct Row {
  double at;
  std::array<double, 3> matrix, axes;
  int along;
};
HWY_INLINE Coordinate coordinate_of(const PosedBox& b, Row row, const One& share, const std::array<Many, 3>& ends) {
  const bool is_turned = b.center.x != 0 || b.center.y != 0 || b.center.z != 0;
  const bool is_divided = b.weight != 1 && row.along == 0;
  if (b.weight != 1 && !is_divided) {  // what is not zero is the weight, or its opposite
    for (std::size_t k = 0; k < 3; ++k) {
      const auto unit = [](double x) { return x == 0 ? 0.0 : x > 0 ? 1.0 : -1.0; };
      row.matrix[k] = unit(row.matrix[k]), row.axes[k] = unit(row.axes[k]);
    }
  }
  const Many at = of_all(row.at);
  const std::array<Many, 3> axis{of_all(row.axes[0]), of_all(row.axes[1]), of_all(row.axes[2])};
  const std::array<Many, 3> center{of_all(b.center.x), of_all(b.center.y), of_all(b.center.z)};
  const std::array<Many, 3> matrix{of_all(row.matrix[0]), of_all(row.matrix[1]), of_all(row.matrix[2])};
  const auto tell = [](const Twofolds& x) HWY_ATTR {
    Many told;
    const Truth is_told = x.told(told);
    return Coordinate{x, told, is_told};
  };
  if (is_divided) {
    Twofolds sum = (product_of(ends[0], axis[0]) + product_of(ends[1], axis[1])) + product_of(ends[2], axis[2]);
    if (is_turned) {
      sum = sum +
            ((product_of(center[0], matrix[0]) + product_of(center[1], matrix[1])) + product_of(center[2], matrix[2]));
    }
    return tell(at + sum * of_all(share));
  }
  Twofolds sum = ((at + product_of(ends[0], axis[0])) + product_of(ends[1], axis[1])) + product_of(ends[2], axis[2]);
  if (is_turned) {
    sum = sum +
          ((product_of(center[0], matrix[0]) + product_of(center[1], matrix[1])) + product_of(center[2], matrix[2]));
  }
  const Coordinate quick = tell(sum);
  if (all(quick.is_told)) return quick;
  const auto product = [](const Many& p, const Many& q) HWY_ATTR { return Balls::exact(p) * Balls::exact(q); };
  Balls exact =
      ((Balls::exact(at) + product(ends[0], axis[0])) + product(ends[1], axis[1])) + product(ends[2], axis[2]);
  if (is_turned) {
    exact = exact + ((product(center[0], matrix[0]) + product(center[1], matrix[1])) + product(center[2], matrix[2]));
  }
  const Truth is_exact = exact.is_exact();
  return {sum, chosen(is_exact, exact.high, quick.told), is_exact | quick.is_told};
}
HWY_INLINE void corners_of(const BoxSide& s, Corners4& to) {
  const auto bit = [&](std::size_t k, std::size_t i) HWY_ATTR { return (s.corners[i] >> k & 1) != 0; };
  std::array<Four, 3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    const GivenBox::Ends& e = s.box.length[k];
    for (std::size_t i = 0; i < 4; ++i) ends[k][i] = bit(k, i) ? e.to : e.from;
  }
  const std::array<Many, 3> part{loaded_four(ends[0]), loaded_four(ends[1]), loaded_four(ends[2])};
  if (s.is_aligned) {  // these are its coordinates
    to.at = {Twofolds::exact(part[0]), Twofolds::exact(part[1]), Twofolds::exact(part[2])};
    to.told = {ends[0], ends[1], ends[2], 15};
    return;
  }
  const auto& [u, v, w] = s.box.axes;
  const auto& [c, d, e] = s.box.columns;
  const One share = s.box.weight == 1 ? One(1.0) : quotient(One(1.0), One(s.box.weight));
  const Vector3& from = s.box.at;
  const auto& is = s.box.along;
  const Coordinate x = coordinate_of(s.box, {from.x, {c.x, d.x, e.x}, {u.x, v.x, w.x}, is[0]}, share, part),
                   y = coordinate_of(s.box, {from.y, {c.y, d.y, e.y}, {u.y, v.y, w.y}, is[1]}, share, part),
                   z = coordinate_of(s.box, {from.z, {c.z, d.z, e.z}, {u.z, v.z, w.z}, is[2]}, share, part);
  to.at = {x.at, y.at, z.at};
  store(x.told, to.told.x), store(y.told, to.told.y), store(z.told, to.told.z);
  to.told.are_told =
      bits_of(x.is_told & y.is_told & z.is_told & is_in_range(x.told) & is_in_range(y.told) & is_in_range(z.told));
}

HWY_INLINE double part_of(const Vector3& v, int k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
HWY_INLINE Four& part_of(ToldPoints& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }
HWY_INLINE const Four& part_of(const ToldPoints& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// What corners of one side are before, on the other.
struct Ahead {
  ToldPoints at;
  ToldFour apart;
};
/// `back`: the corners are those of b, from which the normal leads away.
HWY_INLINE void ahead_of(const Corners4& of, const BoxSide& other, const Corners4& on, const Space<Twofolds>& normal,
                         const Twofolds& length, bool back, const Zeros& zeros, Ahead& to) {
  const Space<Twofolds> plane = cross_of(all_of(other.edge(0)), all_of(other.edge(1)));
  const Twofolds along = dot_of(plane, normal);
  const One inverse = quotient(One(1.0), first_of(along));
  const Space<Twofolds> base{of_all(first_of(on.at.x)), of_all(first_of(on.at.y)), of_all(first_of(on.at.z))};
  const Twofolds share = dot_of(plane, between(of.at, base)) * of_all(inverse);  // of the normal, from here
  const Space<Twofolds> at{of.at.x + normal.x * share, of.at.y + normal.y * share, of.at.z + normal.z * share};
  tell(back ? -(share * length) : share * length, to.apart);
  tell(at, zeros, to.at);
  for (const int k : {0, 1, 2}) {  // these coordinates stay
    if (zeros.is[static_cast<std::size_t>(k)]) part_of(to.at, k) = part_of(of.told, k);
  }
  const int axis = zeros.axis();
  // Where the plane is level along an axis of space, it has one coordinate there.
  if (axis >= 0 && part_of(other.edge(0), axis) == 0 && part_of(other.edge(1), axis) == 0) {
    part_of(to.at, axis).fill(part_of(on.told, axis)[0]);
    to.at.are_told = on.told.has(0) ? 15 : 0;
  }
}

/// Where edges cross: of the two that a side has, of either body.
struct Crossings {
  Space<Twofolds> across_a, across_b, both;  // lane 2 i + j: of edges i and j with the normal, and with one another
  Space<Many> edge_a, edge_b;
  Twofolds inverse;  // 1 / (edge_a . across_b)
};
HWY_INLINE Space<Many> edges_of(const BoxSide& s, bool is_first) {
  const auto pick = [&](double p, double q) HWY_ATTR {
    return loaded_four(is_first ? Four{p, p, q, q} : Four{p, q, p, q});
  };
  const Vector3 &u = s.edge(0), &v = s.edge(1);
  return {pick(u.x, v.x), pick(u.y, v.y), pick(u.z, v.z)};
}
HWY_INLINE Space<Twofolds> opposite_of(const Space<Twofolds>& v) { return {-v.x, -v.y, -v.z}; }
HWY_INLINE Crossings crossings_of(const std::array<const BoxSide*, 2>& side, const Space<Twofolds>& normal) {
  const Space<Many> a = edges_of(*side[0], true), b = edges_of(*side[1], false);
  const Space<Twofolds> of_a = opposite_of(cross_of(normal, a)), of_b = opposite_of(cross_of(normal, b));
  return {of_a, of_b, cross_of(a, b), a, b, inverse_of(dot_of(of_b, a))};
}

using Places = hn::Indices256<double>;
HWY_INLINE Many at_places(const Many& x, const Places& k) { return {hn::TableLookupLanes(x.v, k)}; }
HWY_INLINE Twofolds at_places(const Twofolds& x, const Places& k) {
  return {at_places(x.high, k), at_places(x.low, k), at_places(x.magnitude, k), x.error, x.width};
}
template <class T>
HWY_INLINE Space<T> at_places(const Space<T>& x, const Places& k) {
  return {at_places(x.x, k), at_places(x.y, k), at_places(x.z, k)};
}

/// Holds the coordinates of four points, and says which of them are told.
struct ToldParts {
  std::array<Four, 3> at;
  std::array<unsigned, 3> are_told;
  [[nodiscard]] Point3 operator[](std::size_t k) const { return {at[0][k] + 0.0, at[1][k] + 0.0, at[2][k] + 0.0}; }
  [[nodiscard]] bool has(std::size_t k) const { return ((are_told[0] & are_told[1] & are_told[2]) >> k & 1) != 0; }
  /// What is told of the same points besides.
  void take(const ToldParts& same, std::size_t k) {
    for (std::size_t i = 0; i < 3; ++i) {
      if ((are_told[i] >> k & 1) != 0 || (same.are_told[i] >> k & 1) == 0) continue;
      at[i][k] = same.at[i][k], are_told[i] |= 1U << k;
    }
  }
};
/// On an edge: where it does not lead along an axis of space, the coordinate is that of the corner that it leaves.
HWY_INLINE void tell(const Space<Twofolds>& p, const Space<Many>& edge, const Corners4& of, const Places& corner,
                     const std::array<std::int64_t, 4>& corners, ToldParts& to) {
  unsigned have = 0;
  for (std::size_t k = 0; k < 4; ++k) have |= of.told.has(static_cast<std::size_t>(corners[k])) ? 1U << k : 0U;
  const auto part = [&](std::size_t i, const Twofolds& x, const Many& e, const Four& of_corner) HWY_ATTR {
    Many told;
    const Truth is = x.told(told) & is_in_range(told);
    const unsigned level = bits_of(certify::many_lanes::HWY_NAMESPACE::is_zero(e)) & have;
    store(told, to.at[i]);
    to.are_told[i] = bits_of(is) | level;
    if (level == 0) return;
    Four known;
    store(at_places(loaded_four(of_corner), corner), known);
    for (std::size_t k = 0; k < 4; ++k) to.at[i][k] = (level >> k & 1) != 0 ? known[k] : to.at[i][k];
  };
  part(0, p.x, edge.x, of.told.x), part(1, p.y, edge.y, of.told.y), part(2, p.z, edge.z, of.told.z);
}

struct Crossed {
  ToldParts on_a, on_b;
  ToldFour apart;
};
/// The pair is edge i of a and edge j of b, in lanes.
HWY_INLINE void cross_at(const Crossings& c, const Corners4& a, const Corners4& b, const Twofolds& length,
                         const std::array<std::int64_t, 4>& i, const std::array<std::int64_t, 4>& j, Crossed& to) {
  std::array<std::int64_t, 4> pair{};
  for (std::size_t k = 0; k < 4; ++k) pair[k] = 2 * (i[k] & 1) + (j[k] & 1);
  const Places of_a = hn::SetTableIndices(Lanes(), i.data()), of_b = hn::SetTableIndices(Lanes(), j.data()),
               of = hn::SetTableIndices(Lanes(), pair.data());
  const Space<Twofolds> p = at_places(a.at, of_a), q = at_places(b.at, of_b), way = between(p, q);
  const Twofolds inverse = at_places(c.inverse, of);
  const Twofolds on_a = dot_of(at_places(c.across_b, of), way) * inverse,
                 on_b = dot_of(at_places(c.across_a, of), way) * inverse;
  const Space<Many> e = at_places(c.edge_a, of), g = at_places(c.edge_b, of);
  tell({p.x + on_a * e.x, p.y + on_a * e.y, p.z + on_a * e.z}, e, a, of_a, i, to.on_a);
  tell({q.x + on_b * g.x, q.y + on_b * g.y, q.z + on_b * g.z}, g, b, of_b, j, to.on_b);
  tell(dot_of(at_places(c.both, of), way) * inverse * length, to.apart);
}

/// The corners in the order in which they are told.
class Telling {
 public:
  Telling(const Pair& pair, const Matched& m, const Whole& whole, QuickCorners& to)
      : m_(m), whole_(whole), level_(m), margin_(pair.margin()), to_(to) {}

  [[nodiscard]] bool is_level(std::size_t at) const { return level_.has(m_.corners[at]); }
  [[nodiscard]] bool does_touch(std::size_t at) const { return whole_.relation == Relation::touching && is_level(at); }
  void tell(std::size_t at, const Point3& on_a, const Point3& on_b, const ToldFour& apart, std::size_t lane) {
    const ContactId& id = m_.corners[at].id;
    std::optional<Corner>& to = to_.begin()[at];
    if (is_level(at)) {
      to = Corner{true, {on_a, on_b, whole_.distance, id}};
    } else if (apart.has(lane)) {
      // Rounding is monotone: what is rounded to another double than the margin is on that side of it.
      const double distance = apart.x[lane] + 0.0;
      if (distance < margin_) to = Corner{true, {on_a, on_b, distance, id}};
      if (distance > margin_) to = Corner{false, {}};
    }
  }

 private:
  const Matched& m_;
  const Whole& whole_;
  LevelParts level_;
  double margin_;
  QuickCorners& to_;
};

HWY_INLINE void tell_vertices(const std::array<const BoxSide*, 2>& side, const std::array<Corners4, 2>& corners,
                              const Space<Twofolds>& normal, const Twofolds& length, const Zeros& zeros, std::size_t of,
                              const FoundCorners& found, Telling& telling) {
  const CornerKind kind = of == 0 ? CornerKind::vertex_of_a : CornerKind::vertex_of_b;
  Ahead ahead;
  bool is_asked = false;
  for (std::size_t at = 0; at < found.size(); ++at) {
    if (found[at].kind != kind) continue;
    if (!is_asked) ahead_of(corners[of], *side[1 - of], corners[1 - of], normal, length, of == 1, zeros, ahead);
    is_asked = true;
    const std::size_t k = of == 0 ? found[at].i : found[at].j;
    const bool touches = telling.does_touch(at);
    if (!corners[of].told.has(k) || (!touches && !ahead.at.has(k))) continue;
    const Point3 here = corners[of].told[k], there = touches ? here : ahead.at[k];
    telling.tell(at, of == 0 ? here : there, of == 0 ? there : here, ahead.apart, k);
  }
}

HWY_INLINE void tell_crossings(const std::array<const BoxSide*, 2>& side, const std::array<Corners4, 2>& corners,
                               const Space<Twofolds>& normal, const Twofolds& length, const FoundCorners& found,
                               Telling& telling) {
  std::array<std::size_t, 8> edges{};
  std::size_t size = 0;
  for (std::size_t at = 0; at < found.size(); ++at) {
    if (found[at].kind == CornerKind::edges && size < edges.size()) edges[size++] = at;
  }
  if (size == 0) return;
  const Crossings crossings = crossings_of(side, normal);
  for (std::size_t first = 0; first < size; first += 4) {
    const std::size_t count = std::min<std::size_t>(4, size - first);
    std::array<std::int64_t, 4> i{}, j{};
    for (std::size_t k = 0; k < count; ++k) i[k] = found[edges[first + k]].i, j[k] = found[edges[first + k]].j;
    Crossed crossed;
    cross_at(crossings, corners[0], corners[1], length, i, j, crossed);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = edges[first + k];
      const bool touches = telling.does_touch(at);
      if (touches) crossed.on_a.take(crossed.on_b, k);
      if (!crossed.on_a.has(k) || (!touches && !crossed.on_b.has(k))) continue;
      telling.tell(at, crossed.on_a[k], touches ? crossed.on_a[k] : crossed.on_b[k], crossed.apart, k);
    }
  }
}

[[maybe_unused]] void tell_all(const Pair& pair, const Matched& m, const Whole& whole,
                               const std::array<bool, 3>& is_zero, QuickCorners& to) {
  const auto spanned = pair.way().spanned_by();
  if (!spanned || !pair.radii().are_none()) return;
  const auto a = BoxSide::of(m.seen[0], m.facing[0]), b = BoxSide::of(m.seen[1], m.facing[1]);
  if (!a || !b) return;
  const std::array<const BoxSide*, 2> side{&*a, &*b};
  // The way leads from b to a, the normal back.
  const Space<Twofolds> normal = cross_of(all_of((*spanned)[1]), all_of((*spanned)[0]));
  const Twofolds length = of_all(root(first_of(dot_of(normal, normal))));
  const Zeros zeros{{is_zero[0], is_zero[1], is_zero[2]}};
  std::array<Corners4, 2> corners;
  corners_of(*side[0], corners[0]), corners_of(*side[1], corners[1]);
  Telling telling(pair, m, whole, to);
  for (const std::size_t of : {0U, 1U}) tell_vertices(side, corners, normal, length, zeros, of, m.corners, telling);
  tell_crossings(side, corners, normal, length, m.corners, telling);
}

#else

[[maybe_unused]] void tell_all(const Pair&, const Matched&, const Whole&, const std::array<bool, 3>&, QuickCorners&) {}

#endif

}  // namespace
}  // namespace plumb::query::touching::box_corners::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query::touching {

void tell_box_corners(const Pair& pair, const Matched& m, const Whole& whole, const std::array<bool, 3>& is_zero,
                      QuickCorners& to) {
  PLUMB_BY_LANES(box_corners, tell_all(pair, m, whole, is_zero, to));
}

}  // namespace plumb::query::touching
#endif
