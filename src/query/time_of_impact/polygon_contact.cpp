// The earliest of what meets the edges and of the ends' balls where they first touch the plane inside of the polygon.
#include "plumb/query/time_of_impact/polygon_contact.hpp"

#include <tuple>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/chains.hpp"
#include "query/overlap/polygon_relation.hpp"

namespace plumb {
namespace query {
namespace {

/// at + t slope.
struct LinearInTime {
  mpq_class at, slope;
};
Rational rational_of(const mpq_class& x) { return Rational(BigRational{x}); }
Sign sign_at(const Root& t, const LinearInTime& x) {
  return t.sign_of(std::array{rational_of(x.at), rational_of(x.slope)});
}

/// Is a point of the polygon's plane strictly inside?  By the edges that pass beside it, seen along an axis.
bool is_inside_at(const Root& t, const SpannedChains& chains, const Exact3& normal,
                  const std::array<LinearInTime, 3>& p) {
  const std::size_t along = sgn(normal[0]) != 0   ? 0
                            : sgn(normal[1]) != 0 ? 1
                                                  : 2,
                    x = (along + 1) % 3, y = (along + 2) % 3;
  const auto sign_less = [&](const mpq_class& c, std::size_t k) {  // of c - p
    return sign_at(t, {c - p[k].at, -p[k].slope});
  };
  bool odd = false;
  for (std::size_t i = 0; i < chains.vertices.size(); ++i) {
    const Exact3 &a = chains.vertices[i], &b = chains.vertices[chains.next[i]];
    const Sign a_above = sign_less(a[y], y), b_above = sign_less(b[y], y);
    const mpq_class dx = b[x] - a[x], dy = b[y] - a[y];
    const Sign side = sign_at(t, {dx * (p[y].at - a[y]) - dy * (p[x].at - a[x]), dx * p[y].slope - dy * p[x].slope});
    const auto apart = [](Sign u, Sign v) { return u == v && u != Sign::zero; };
    if (side == Sign::zero && !apart(a_above, b_above) && !apart(sign_less(a[x], x), sign_less(b[x], x))) return false;
    if ((a_above == Sign::positive) == (b_above == Sign::positive)) continue;
    if (side == (b_above == Sign::positive ? Sign::positive : Sign::negative)) odd = !odd;
  }
  return odd;
}

Exact3 exactly(const Point3& p) { return {p.x, p.y, p.z}; }
Exact3 exactly(const Vector3& v) { return {v.x, v.y, v.z}; }

struct BallEnd {
  Point3 center;
  Feature feature;
};
std::vector<BallEnd> ends_of(const Sphere3& s) { return {{s.center, {FeatureKind::face, 0}}}; }
std::vector<BallEnd> ends_of(const Capsule3& s) {
  return {{s.a, {FeatureKind::vertex, 0}}, {s.b, {FeatureKind::vertex, 1}}};
}

/// Lower ones are told.
auto rank(const PolygonContact& c) {
  return std::tuple(static_cast<int>(c.on_round.kind) + static_cast<int>(c.on_polygon.kind), c.on_round.kind,
                    c.on_round.index, c.on_polygon.kind, c.on_polygon.index);
}

/// The earliest; of equally early ones that of the lowest features.
class EarliestContact {
 public:
  void see(PolygonContact c) {
    if (best_) {
      const auto order = c.time <=> best_->time;
      if (order > 0 || (order == 0 && !(rank(c) < rank(*best_)))) return;
    }
    best_ = std::move(c);
  }
  [[nodiscard]] std::optional<PolygonContact> best() && { return std::move(best_); }

 private:
  std::optional<PolygonContact> best_;
};

/// Where the ball about an end first touches the plane, if that is inside.
void see_face(EarliestContact& earliest, const BallEnd& end, double radius, const Exact3& by,
              const SpannedChains& chains) {
  const Exact3& from = chains.vertices[chains.span[0]];
  const Exact3 normal = cross(chains.vertices[chains.span[1]] - from, chains.vertices[chains.span[2]] - from);
  const Exact3 c = exactly(end.center);
  const mpq_class square = dot(normal, normal), height = dot(normal, c - from), rise = dot(normal, by);
  const mpq_class rest = height * height - mpq_class(radius) * mpq_class(radius) * square;
  if (sgn(rest) < 0) return;  // across the plane from the start: it meets edges first
  std::array<LinearInTime, 3> foot;
  for (std::size_t k = 0; k < 3; ++k) {
    foot[k] = {c[k] - normal[k] * height / square, by[k] - normal[k] * rise / square};
  }
  const auto look = [&](const Root& t) {
    if (is_inside_at(t, chains, normal, foot)) earliest.see({t, end.feature, {FeatureKind::face, 0}});
  };
  if (sgn(rest) == 0) return look(Root(0));
  if (sgn(rise) == 0 || sgn(rise) == sgn(height)) return;
  const std::array quadratic{rational_of(rest), rational_of(2 * height * rise), rational_of(rise * rise)};
  const auto times = real_roots(quadratic, Rational(0.0), Rational(1.0));
  if (!times.empty()) look(times.front());
}

template <class Shape>
std::vector<std::vector<Point3>> chains_in_doubles(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Quadrilateral3>) {
    return {{s.a, s.b, s.c, s.d}};
  } else if constexpr (std::is_same_v<Shape, Polygon3>) {
    return {s.vertices};
  } else {
    std::vector<std::vector<Point3>> all{s.outer.vertices};
    for (const Polygon3& hole : s.holes) all.push_back(hole.vertices);
    return all;
  }
}

/// A rectangle is a flat box, whose features have other numbers.
Feature of_rectangle(const Feature& f) {
  if (f.kind == FeatureKind::vertex) return {f.kind, f.index & 3};
  if (f.kind == FeatureKind::edge) return {f.kind, 2 * (f.index / 4) + (f.index & 1)};
  return f.kind == FeatureKind::face ? Feature{f.kind, 0} : f;
}

template <class Round>
std::optional<PolygonContact> contact_with_rectangle(const Translating<Round>& round,
                                                     const Translating<Rectangle3>& r) {
  const auto& [center, axes, half] = r.shape;
  const Translating<Obb3> box{{center, {axes[0], axes[1], {0, 0, 0}}, {half.x, half.y, 0}}, r.by};
  const auto time = first_contact_time(round, box);
  if (!time) return {};
  const Contact c = *first_contact(round, box);
  return PolygonContact{*time, c.feature_a, of_rectangle(c.feature_b)};
}

template <class Round, class Shape>
std::optional<PolygonContact> contact_with_chains(std::string_view function, const Translating<Round>& round,
                                                  const Translating<Shape>& polygon) {
  static_cast<void>(exact_chains(function, view_of(polygon.shape)));  // throws where it is not planar
  const SpannedChains chains = chains_of(view_of(polygon.shape));
  const Feature interior{FeatureKind::interior, 0};
  const Relation start = relate(round.shape, polygon.shape);
  if (start == Relation::overlapping) return PolygonContact{Root(0), interior, interior};
  EarliestContact earliest;
  std::uint32_t first = 0;
  for (const auto& chain : chains_in_doubles(polygon.shape)) {
    const auto size = static_cast<std::uint32_t>(chain.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t next = i + 1 == size ? 0 : i + 1;
      const Translating<Segment3> edge{{chain[i], chain[next]}, polygon.by};
      auto time = first_contact_time(round, edge);
      if (!time) continue;
      const Contact c = *first_contact(round, edge);
      Feature on{FeatureKind::edge, first + i};
      if (c.feature_b.kind == FeatureKind::vertex)
        on = {FeatureKind::vertex, first + (c.feature_b.index == 0 ? i : next)};
      earliest.see({std::move(*time), c.feature_a, on});
    }
    first += size;
  }
  if (chains.span.size() == 3) {
    const Exact3 by = exactly(round.by) - exactly(polygon.by);
    for (const BallEnd& end : ends_of(round.shape)) see_face(earliest, end, round.shape.radius, by, chains);
  }
  return std::move(earliest).best();
}

}  // namespace

template <MovesRound Round, MovesAsPolygon Shape>
std::optional<PolygonContact> polygon_contact(std::string_view function, const Translating<Round>& round,
                                              const Translating<Shape>& polygon) {
  require_figures(function, view_of(round.shape), view_of(polygon.shape));
  require_finite_parts(function, {"the motion of the round figure", "the motion of the polygon"}, round.by, polygon.by);
  if constexpr (std::is_same_v<Shape, Rectangle3>) {
    return contact_with_rectangle(round, polygon);
  } else {
    return contact_with_chains(function, round, polygon);
  }
}

#define PLUMB_POLYGON_CONTACT(Round, Shape)                                                           \
  template std::optional<PolygonContact> polygon_contact(std::string_view, const Translating<Round>&, \
                                                         const Translating<Shape>&);
PLUMB_POLYGON_CONTACT(Sphere3, Quadrilateral3)
PLUMB_POLYGON_CONTACT(Sphere3, Polygon3)
PLUMB_POLYGON_CONTACT(Sphere3, HoledPolygon3)
PLUMB_POLYGON_CONTACT(Sphere3, Rectangle3)
PLUMB_POLYGON_CONTACT(Capsule3, Quadrilateral3)
PLUMB_POLYGON_CONTACT(Capsule3, Polygon3)
PLUMB_POLYGON_CONTACT(Capsule3, HoledPolygon3)
PLUMB_POLYGON_CONTACT(Capsule3, Rectangle3)
#undef PLUMB_POLYGON_CONTACT

}  // namespace query
}  // namespace plumb
