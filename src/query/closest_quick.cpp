// Feet of perpendiculars in pairs of doubles: x, y and z in three lanes, bounds of the errors beside them.
//
// u is 2^-53.  The names of docs/closest.md: a line through o along d, w = p - o, t = w.d / d.d.
#include "query/closest_quick.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plumb/arith/error_free.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates.hpp"

#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest_quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef PLUMB_CLOSEST_QUICK_ONCE
#define PLUMB_CLOSEST_QUICK_ONCE
namespace plumb::query::quick {

/// Points a, b, p: how far p is beyond b.
struct Beyond {
  static constexpr std::string_view name = "closest_points";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    using namespace predicates;
    return dot(difference(p, 0, 1), difference(p, 0, 2)) - dot(difference(p, 0, 1), difference(p, 0, 1));
  }
};

/// Points a, b, c, p: positive on c's side of ab, seen along the normal of the triangle, where p projects.
struct Within {
  static constexpr std::string_view name = "closest_points";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    using namespace predicates;
    const auto ab = difference(p, 0, 1), ac = difference(p, 0, 2), ap = difference(p, 0, 3), bp = difference(p, 1, 3);
    return dot(ab, ap) * dot(ac, bp) - dot(ab, bp) * dot(ac, ap);
  }
};

/// Center, axes u, v, w, halves, p: what is left of the way to p, along u; the same across u, along v; and along u x v.
struct OffBox {
  static constexpr std::string_view name = "closest_points";
  static constexpr int points = 6, dimension = 3;
  static constexpr bool homogeneous = false;
  template <class T>
  static constexpr auto along(const std::array<T, 18>& p, std::size_t u) {
    using namespace predicates;
    const auto at = [&](std::size_t i) { return dot(argument(p, i), argument(p, u)) * p[11 + i]; };
    return dot(difference(p, 0, 5), argument(p, u)) - at(1) - at(2) - at(3);
  }
};
struct AlongAxis : OffBox {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    return along(p, 1);
  }
};
struct AcrossAxis : OffBox {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    using namespace predicates;
    const auto u = argument(p, 1);
    return dot(u, u) * along(p, 2) - dot(u, argument(p, 2)) * along(p, 1);
  }
};
struct AboveAxes : OffBox {
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    using namespace predicates;
    const auto n = cross(argument(p, 1), argument(p, 2));
    return dot(difference(p, 0, 5), n) - dot(argument(p, 3), n) * p[14];
  }
};

// Twice the filters' constants pay for another order of their sums.
constexpr double along_constant = 2 * filter_constant<predicates::Angle3d>();
constexpr double beyond_constant = 2 * filter_constant<Beyond>();
// Of three products of numbers up to a largest one, and of twice nine products of four.
constexpr double dot_constant = 3 * along_constant, within_constant = 18 * 2 * filter_constant<Within>();

// For axes up to a, with |p - c| and the sum of half axes up to l: of 3 a l, 18 a^3 l and 6 a^2 l.
constexpr double box_along = 3 * 2 * filter_constant<AlongAxis>(), box_across = 18 * 2 * filter_constant<AcrossAxis>(),
                 box_above = 6 * 2 * filter_constant<AboveAxes>();

/// By the axes between whose ends p is, and those at whose upper end it is: as voronoi_region has them.
constexpr auto box_features = [] {
  std::array<std::array<Feature, 8>, 8> table{};
  for (std::uint32_t free = 0; free < 8; ++free) {
    for (std::uint32_t upper = 0; upper < 8; ++upper) {
      std::uint32_t places = 0, ends = 0, free_axes = 0, free_axis = 0, fixed_axis = 0;
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        if ((free >> axis & 1) != 0) {
          ++free_axes, free_axis = axis;
        } else {
          fixed_axis = axis, ends |= (upper >> axis & 1) << places++;
        }
      }
      table[free][upper] = free_axes == 0   ? Feature{FeatureKind::vertex, ends}
                           : free_axes == 1 ? Feature{FeatureKind::edge, 4 * free_axis + ends}
                           : free_axes == 2 ? Feature{FeatureKind::face, 2 * fixed_axis + ends}
                                            : Feature{FeatureKind::interior, 0};
    }
  }
  return table;
}();

struct Parts {  // a value, what it lacks, and how much it may lack besides
  double value, rest, bound;
};

/// Where one double alone is nearest to it.
inline bool round(const Parts& x, double& to) {
  const double from = x.value + (x.rest - x.bound), until = x.value + (x.rest + x.bound);
  to = from + 0.0;
  return from == until;
}

}  // namespace plumb::query::quick
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::FixedTag<double, 4>;
using V = hn::Vec<D>;
using hn::Abs, hn::Add, hn::Mul, hn::MulAdd, hn::MulSub, hn::Sub;

HWY_INLINE V set(double x) { return hn::Set(D(), x); }
HWY_INLINE V load(const Point3& p) { return hn::MaskedLoad(hn::FirstN(D(), 3), D(), &p.x); }

/// h + l, exactly.
struct Pair {
  V h, l;
};
HWY_INLINE Pair sum(V a, V b) {
  const V s = Add(a, b), part = Sub(s, a);
  return {s, Add(Sub(a, Sub(s, part)), Sub(b, part))};
}
HWY_INLINE Pair difference(V a, V b) {
  const V s = Sub(a, b), part = Sub(s, a);
  return {s, Sub(Sub(a, Sub(s, part)), Add(b, part))};
}
HWY_INLINE Pair product(V a, V b) {
  const V p = Mul(a, b);
  return {p, MulSub(a, b, p)};
}

/// The lanes, of which the last is zero.
struct Three {
  double x, y, z;
};
HWY_INLINE Three lanes(V v) {
  const auto low = hn::LowerHalf(v);
  return {hn::GetLane(low), hn::GetLane(hn::Shuffle01(low)), hn::GetLane(hn::UpperHalf(hn::Half<D>(), v))};
}
HWY_INLINE double total(V v) {
  const auto [x, y, z] = lanes(v);
  return x + y + z;
}
/// x + y + z + rest, to one rounding and 40 u^2 of the sum of magnitudes.
HWY_INLINE plumb::Rounded total(V h, V rest) {
  const auto [x, y, z] = lanes(h);
  const plumb::Rounded first = two_sum(x, y), second = two_sum(first.value, z);
  return two_sum(second.value, (first.error + second.error) + total(rest));
}

/// Zero, or so far from under- and overflow that no product of four of them comes near.
HWY_INLINE bool moderate(V v) {
  const V a = Abs(v);
  return hn::AllTrue(D(), hn::Or(hn::Eq(a, hn::Zero(D())), hn::And(hn::Ge(a, set(0x1p-60)), hn::Le(a, set(0x1p60)))));
}

HWY_INLINE bool round(V h, V rest, V bound, Point3& to) {
  const V from = Add(h, Sub(rest, bound)), until = Add(h, Add(rest, bound));
  HWY_ALIGN double all[4];
  hn::Store(Add(from, hn::Zero(D())), D(), all);
  to = {all[0], all[1], all[2]};
  return hn::AllTrue(D(), hn::Eq(from, until));
}

/// The root of what is positive, of which the rest is a small part.
HWY_INLINE Parts root(const Parts& s) {
  const double r = hn::GetLane(hn::Sqrt(hn::Set(hn::FixedTag<double, 2>(), s.value))), half = 0.5 / r;
  const double square = r * r, error = __builtin_fma(r, r, -square);
  const double rest = (((s.value - square) - error) + s.rest) * half;
  return {r, rest, (s.bound + rest * rest) * half + r * 0x1p-100};
}

/// |h + l|^2, where the lanes are off by `slack` at most.
HWY_INLINE Parts square(V h, V l, V slack) {
  const Pair p = product(h, h);
  const plumb::Rounded s = total(p.h, MulAdd(l, l, MulAdd(Add(h, h), l, p.l)));
  const V off = Mul(slack, MulAdd(set(4), Abs(h), slack));
  return {s.value, s.error, s.value * 0x1p-100 + total(off)};
}

/// Between the ends of a line that passes o.h + o.l, off by `slack` at most.
HWY_INLINE bool on_line(Wanted wanted, Pair o, Pair w, Pair d, V slack, double along, double whole, Numbers& to) {
  const double inverse = 1 / whole, t = along * inverse;
  if (!(std::fabs(t) >= 0x1p-300)) return false;
  const V way = set(t);
  const Pair p = product(way, d.h);
  const V k = MulAdd(way, d.l, p.l);
  const Pair e = difference(w.h, p.h);
  const V x = Add(e.l, Sub(w.l, k));
  const Pair a = product(e.h, d.h);
  const plumb::Rounded r = total(a.h, Add(a.l, MulAdd(e.h, d.l, Mul(x, d.h))));
  const V size = MulAdd(slack, set(0x1p100), Abs(p.h)), magnitude = Abs(d.h);
  const double change = r.value * inverse;
  const double doubt = 0x1p-98 * total(Mul(Add(Abs(w.h), size), magnitude)) * inverse + 0x1p-48 * std::fabs(change);
  const V by = set(change), off = Mul(set(doubt), magnitude);
  bool certain = true;
  if (wanted != Wanted::distance) {
    const Pair h = sum(o.h, p.h);
    const V rest = MulAdd(by, d.h, Add(h.l, Add(k, o.l)));
    certain = round(h.h, rest, MulAdd(set(0x1p-100), Add(Abs(o.h), size), off), to.point);
  }
  if (wanted != Wanted::point && certain) {
    Parts f = square(e.h, x, Mul(set(0x1p-100), Add(Abs(w.h), size)));  // less the part of it that is along d
    f.rest -= r.value * change;
    f.bound += 4 * std::fabs(r.value) * doubt;
    certain = quick::round(root(f), to.distance);
  }
  return certain;
}

HWY_INLINE bool at_point(Wanted wanted, const Point3& q, Pair w, Numbers& to) {
  to.point = {q.x + 0.0, q.y + 0.0, q.z + 0.0};
  if (wanted == Wanted::point) return true;
  return moderate(w.h) && quick::round(root(square(w.h, w.l, hn::Zero(D()))), to.distance);
}

bool segment(Wanted wanted, const Segment3& s, const Point3& p, Quickly& found) {
  const V a = load(s.a), b = load(s.b), q = load(p);
  const Pair d = difference(b, a), w = difference(q, a);
  if (!moderate(d.h) || !moderate(w.h)) return false;
  const V terms = Mul(w.h, d.h);
  const double along = total(terms), size = total(Abs(terms)), whole = total(Mul(d.h, d.h));
  if (along < -along_constant * size) {
    found.feature = {FeatureKind::vertex, 0};
    return at_point(wanted, s.a, w, found.numbers);
  }
  const double beyond = along - whole, doubt = beyond_constant * (size + whole);
  if (beyond > doubt) {
    found.feature = {FeatureKind::vertex, 1};
    return at_point(wanted, s.b, difference(q, b), found.numbers);
  }
  if (!(along > along_constant * size && beyond < -doubt)) return false;
  found.feature = {FeatureKind::edge, 0};
  return on_line(wanted, {a, hn::Zero(D())}, w, d, hn::Zero(D()), along, whole, found.numbers);
}

/// y z x of x y z.
HWY_INLINE V turned(V v) {
  HWY_ALIGN static constexpr std::int64_t order[4] = {1, 2, 0, 3};
  return hn::TableLookupLanes(v, hn::SetTableIndices(D(), order));
}

/// Above a plane: p less t n, for the normal n = ab x ac and t = n.ap / n.n, where ap is off by `slack` at most.
bool on_face(Wanted wanted, V p, Pair ab, Pair ac, Pair ap, V slack, Numbers& to) {
  // The lanes of n are in the order z x y, and so are those of the point.
  const V other = turned(ac.h), own = turned(ab.h);
  const Pair left = product(ab.h, other), right = product(own, ac.h), m = difference(left.h, right.h);
  const V cross = MulAdd(ab.h, turned(ac.l), Mul(ab.l, other)), back = MulAdd(own, ac.l, Mul(turned(ab.l), ac.h));
  const V low = Add(Add(m.l, Sub(left.l, right.l)), Sub(cross, back));
  const V high = Add(m.h, low);
  const Pair n{high, Add(Sub(m.h, high), low)};
  const V size = Add(Abs(left.h), Abs(right.h));  // n is off by 32 u^2 of it
  const auto about = [](V v) { return turned(turned(v)); };
  const Pair w{about(ap.h), about(ap.l)};
  const Pair up = product(n.h, w.h), square = product(n.h, n.h);
  const plumb::Rounded g = total(up.h, Add(up.l, MulAdd(n.h, w.l, Mul(n.l, w.h))));
  const plumb::Rounded whole = total(square.h, MulAdd(Add(n.h, n.h), n.l, square.l));
  const double inverse = 1 / whole.value, t = g.value * inverse, away = std::fabs(t);
  if (!(away >= 0x1p-300)) return false;
  const double z = t * whole.value, z_error = __builtin_fma(t, whole.value, -z);
  const double change = (((g.value - z) - z_error) + (g.error - t * whole.error)) * inverse;
  const V reach = MulAdd(about(slack), set(0x1p100), Abs(w.h));
  const double doubt = 0x1p-97 * inverse * (total(Mul(size, reach)) + away * total(Mul(size, Abs(n.h))));
  bool certain = true;
  if (wanted != Wanted::distance) {
    const V way = set(t), at = about(p);
    const Pair down = product(way, n.h), h = difference(at, down.h);
    const V rest = Sub(h.l, MulAdd(set(change), n.h, MulAdd(way, n.l, down.l)));
    const V magnitude = MulAdd(set(away), size, Add(Abs(at), Abs(down.h)));
    const V bound = MulAdd(set(0x1p-100), magnitude, Mul(set(doubt), Abs(n.h)));
    Point3 q;
    certain = round(h.h, rest, bound, q);
    to.point = {q.y, q.z, q.x};
  }
  if (wanted != Wanted::point && certain) {
    const Parts r = root({whole.value, whole.error, 0});
    const double d = t * r.value, error = __builtin_fma(t, r.value, -d);
    const double rest = error + (t * r.rest + change * r.value), sign = t < 0 ? -1 : 1;
    certain = quick::round({sign * d, sign * rest, 2 * doubt * r.value}, to.distance);
  }
  return certain;
}

bool triangle(Wanted wanted, const Triangle3& s, const Point3& p, Quickly& found) {
  const V a = load(s.a), b = load(s.b), c = load(s.c), q = load(p), none = hn::Zero(D());
  const Pair ab = difference(b, a), ac = difference(c, a), ap = difference(q, a);
  const V bp = Sub(q, b), cp = Sub(q, c);
  const auto dot = [](V u, V v) { return total(Mul(u, v)); };
  const auto largest = [](V u, V v) { return hn::Max(Abs(u), Abs(v)); };
  const auto [lx, ly, lz] = lanes(hn::Max(largest(ab.h, ac.h), hn::Max(largest(ap.h, bp), Abs(cp))));
  const double l = std::max(std::max(lx, ly), lz), l2 = l * l;
  const double near = dot_constant * l2, side = within_constant * (l2 * l2);
  const double d1 = dot(ab.h, ap.h), d2 = dot(ac.h, ap.h), d3 = dot(ab.h, bp), d4 = dot(ac.h, bp), d5 = dot(ab.h, cp),
               d6 = dot(ac.h, cp);
  const double from_b = d4 - d3, from_c = d5 - d6;  // along bc and along cb
  if (!moderate(ab.h) || !moderate(ac.h) || !moderate(ap.h)) return false;
  const auto vertex = [&](std::uint32_t i, const Point3& corner, V at) {
    found.feature = {FeatureKind::vertex, i};
    return at_point(wanted, corner, difference(q, at), found.numbers);
  };
  if (d1 < -near && d2 < -near) return vertex(0, s.a, a);
  if (d3 > near && from_b < -4 * near) return vertex(1, s.b, b);
  if (d6 > near && from_c < -4 * near) return vertex(2, s.c, c);
  const double vc = d1 * d4 - d3 * d2, va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6;
  const auto edge = [&](std::uint32_t i, V from, Pair w, Pair d, double along) {
    found.feature = {FeatureKind::edge, i};
    return on_line(wanted, {from, none}, w, d, none, along, dot(d.h, d.h), found.numbers);
  };
  if (vc < -side && d1 > near && d3 < -near) return edge(0, a, ap, ab, d1);
  if (vb < -side && d2 > near && d6 < -near) return edge(2, a, ap, ac, d2);
  if (va < -side && from_b > 4 * near && from_c > 4 * near) {
    const Pair bc = difference(c, b), w = difference(q, b);
    return moderate(bc.h) && moderate(w.h) && edge(1, b, w, bc, from_b);
  }
  if (!(va > side && vb > side && vc > side)) return false;
  found.feature = {FeatureKind::face, 0};
  return on_face(wanted, q, ab, ac, ap, none, found.numbers);
}

bool box(Wanted wanted, const Aabb3& s, const Point3& p, Quickly& found) {
  const V min = load(s.min), max = load(s.max), at = load(p), q = hn::Min(hn::Max(at, min), max);
  const Pair w = difference(at, q);
  if (!hn::AllTrue(D(), hn::Le(min, max)) || !moderate(w.h)) return false;
  const auto bits = [](auto mask) {
    std::uint8_t all[8] = {};
    hn::StoreMaskBits(D(), mask, all);
    return all[0] & 7u;
  };
  const unsigned free = bits(hn::And(hn::Gt(at, min), hn::Lt(at, max)));
  const unsigned upper = bits(hn::And(hn::Ge(at, max), hn::Gt(max, min)));
  found.feature = box_features[free][upper];
  round(q, hn::Zero(D()), hn::Zero(D()), found.numbers.point);
  found.numbers.distance = 0;
  if (wanted == Wanted::point || hn::AllTrue(D(), hn::Eq(w.h, hn::Zero(D())))) return true;
  return quick::round(root(square(w.h, w.l, hn::Zero(D()))), found.numbers.distance);
}

/// A guess as if the axes were at right angles, then proved by the signs of voronoi_region.
bool parallelepiped(Wanted wanted, const Obb3& s, const Point3& p, Quickly& found) {
  const V center = load(s.center), at = load(p), none = hn::Zero(D());
  const auto axis_at = [&](std::size_t i) { return hn::MaskedLoad(hn::FirstN(D(), 3), D(), &s.axes[i].x); };
  const V axis[3] = {axis_at(0), axis_at(1), axis_at(2)};
  const double half[3] = {std::fabs(s.half.x), std::fabs(s.half.y), std::fabs(s.half.z)};
  const V way = Sub(at, center);
  const auto dot = [](V u, V v) { return total(Mul(u, v)); };
  double gram[3][3], along[3];
  std::uint32_t free = 0, upper = 0, count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!moderate(axis[i]) || !(half[i] >= 0x1p-60 && half[i] <= 0x1p60)) return false;
    for (std::size_t k = i; k < 3; ++k) gram[i][k] = gram[k][i] = dot(axis[i], axis[k]);
    along[i] = dot(way, axis[i]);
    const double reach = half[i] * gram[i][i];
    const bool within = std::fabs(along[i]) < reach;
    free |= static_cast<std::uint32_t>(within) << i, count += static_cast<std::uint32_t>(within);
    upper |= static_cast<std::uint32_t>(along[i] > 0 && !within) << i;
  }
  const auto largest = [](V v) {
    const auto [x, y, z] = lanes(Abs(v));
    return std::max(std::max(x, y), z);
  };
  const double a = largest(hn::Max(Abs(axis[0]), hn::Max(Abs(axis[1]), Abs(axis[2]))));
  const double l = largest(way) + a * (half[0] + half[1] + half[2]);
  const double near = box_along * a * l, side = box_across * (a * a) * (a * l), top = box_above * a * (a * l);
  if (!(l < 0x1p60)) return false;
  const auto end = [&](std::size_t i) { return (upper >> i & 1) != 0 ? half[i] : -half[i]; };
  const auto is_free = [&](std::size_t i) { return (free >> i & 1) != 0; };
  double left[3];  // along the axes, of the way from the fixed ends
  for (std::size_t i = 0; i < 3; ++i) {
    left[i] = along[i];
    for (std::size_t k = 0; k < 3; ++k) left[i] -= is_free(k) ? 0 : end(k) * gram[i][k];
  }
  Pair o{center, none};
  V size = Abs(center);
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_free(i)) continue;
    const Pair step = product(axis[i], set(end(i))), next = sum(o.h, step.h);
    o = {next.h, Add(o.l, Add(next.l, step.l))};
    size = Add(size, Abs(step.h));
  }
  const V slack = Mul(size, set(0x1p-100));
  Pair w = difference(at, o.h);
  w.l = Sub(w.l, o.l);
  const auto outward = [&](std::size_t i, double x) { return (upper >> i & 1) != 0 ? x : -x; };
  found.feature = box_features[free][upper];
  if (!moderate(w.h)) return false;
  if (count == 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(outward(i, left[i]) > near)) return false;
    }
    return (wanted == Wanted::distance || round(o.h, o.l, slack, found.numbers.point)) &&
           (wanted == Wanted::point || quick::round(root(square(w.h, w.l, slack)), found.numbers.distance));
  }
  if (count == 1) {
    const std::size_t u = is_free(0) ? 0 : is_free(1) ? 1 : 2;
    const double own = gram[u][u], reach = half[u] * own - near;
    if (!(std::fabs(left[u]) < reach)) return false;
    for (std::size_t v = 0; v < 3; ++v) {
      if (v != u && !(outward(v, own * left[v] - gram[u][v] * left[u]) > side)) return false;
    }
    return on_line(wanted, o, w, {axis[u], none}, slack, left[u], own, found.numbers);
  }
  // Along the normals, in lanes z x y, of two axes: the third, and the way from the center.
  const auto up = [&](std::size_t i, V v) {
    const V u = axis[(i + 1) % 3], other = axis[(i + 2) % 3];
    return dot(Sub(Mul(u, turned(other)), Mul(turned(u), other)), turned(turned(v)));
  };
  if (count == 3) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(std::fabs(up(i, way)) < half[i] * std::fabs(up(i, axis[i])) - top)) return false;
    }
    found.numbers = {{p.x + 0.0, p.y + 0.0, p.z + 0.0}, 0};
    return true;
  }
  const std::size_t n = is_free(0) ? is_free(1) ? 2 : 1 : 0, u = (n + 1) % 3, v = (n + 2) % 3;
  const auto between = [&](std::size_t i, std::size_t other) {
    const double own = gram[other][other], both = gram[i][other];
    const double reach = half[i] * (own * gram[i][i] - both * both);
    return std::fabs(own * left[i] - both * left[other]) < reach - side;
  };
  if (!between(u, v) || !between(v, u)) return false;
  const double volume = up(n, axis[n]), above = up(n, way) - end(n) * volume;
  if (!(std::fabs(volume) > box_above * a * (a * a) && outward(n, volume > 0 ? above : -above) > top)) return false;
  return on_face(wanted, at, {axis[u], none}, {axis[v], none}, w, slack, found.numbers);
}

#endif

// One entry a shape; where there are no lanes of pairs, nothing is told.
#if HWY_TARGET == HWY_AVX2
#define PLUMB_QUICK(shape) return shape(wanted, s, p, found)
#else
#define PLUMB_QUICK(shape) \
  return static_cast<void>(wanted), static_cast<void>(s), static_cast<void>(p), static_cast<void>(found), false
#endif
[[maybe_unused]] bool of_segment(Wanted wanted, const Segment3& s, const Point3& p, Quickly& found) {
  PLUMB_QUICK(segment);
}
[[maybe_unused]] bool of_triangle(Wanted wanted, const Triangle3& s, const Point3& p, Quickly& found) {
  PLUMB_QUICK(triangle);
}
[[maybe_unused]] bool of_obb(Wanted wanted, const Obb3& s, const Point3& p, Quickly& found) {
  PLUMB_QUICK(parallelepiped);
}
[[maybe_unused]] bool of_box(Wanted wanted, const Aabb3& s, const Point3& p, Quickly& found) { PLUMB_QUICK(box); }
#undef PLUMB_QUICK

}  // namespace
}  // namespace plumb::query::quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query {
// Not by Highway's dispatch, whose inline index counts the targets of all files: this one is compiled for fewer.
static bool has_lanes() {
  static const bool has = (hwy::SupportedTargets() & HWY_AVX2) != 0;
  return has;
}
#if HWY_TARGETS & HWY_AVX2
#define PLUMB_BY_LANES(shape) return has_lanes() && quick::N_AVX2::shape(wanted, s, p, found)
#else
#define PLUMB_BY_LANES(shape) return has_lanes() && quick::HWY_NAMESPACE::shape(wanted, s, p, found)
#endif
bool quickly(Wanted wanted, const Segment3& s, const Point3& p, Quickly& found) { PLUMB_BY_LANES(of_segment); }
bool quickly(Wanted wanted, const Triangle3& s, const Point3& p, Quickly& found) { PLUMB_BY_LANES(of_triangle); }
bool quickly(Wanted wanted, const Obb3& s, const Point3& p, Quickly& found) { PLUMB_BY_LANES(of_obb); }
bool quickly(Wanted wanted, const Aabb3& s, const Point3& p, Quickly& found) { PLUMB_BY_LANES(of_box); }
#undef PLUMB_BY_LANES
}  // namespace plumb::query
#endif
