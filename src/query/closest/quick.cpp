// Which feature is nearest, by signs of plain doubles with the constants that the formulas derive.
#include "query/closest/quick.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "certify/fused_lanes.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/quick.cpp"
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
// Of three products of numbers up to a largest one, and of twice nine products of four.
constexpr double dot_constant = 3 * along_constant, within_constant = 18 * 2 * filter_constant<Within>();

// For axes up to a, with |p - c| and the sum of half axes up to l: of 3 a l, 18 a^3 l and 6 a^2 l.
constexpr double box_along = 3 * 2 * filter_constant<AlongAxis>(), box_across = 18 * 2 * filter_constant<AcrossAxis>(),
                 box_above = 6 * 2 * filter_constant<AboveAxes>();

/// Pays for underflow, where no factor is above 2^200.
constexpr double guard = 0x1p-800;

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

}  // namespace plumb::query::quick
#endif

#include "query/closest/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

template <class To>
HWY_INLINE bool nearest(const Segment3& segment, const Point3& p, To& to) {
  const V a = load(segment.a), b = load(segment.b), q = load(p);
  const Pair d = difference(b, a), w = difference(q, a);
  const Dots s = dots<To>(w, d);
  const double unsure = __builtin_fma(0x1p-48, s.ww + s.dd, guard), beyond = s.wd - s.dd;
  V at = a;
  Square square{};
  if (s.wd < -unsure) {
    name_feature(to, {FeatureKind::vertex, 0});
    square = square_from_start(s);
  } else if (beyond > unsure) {
    name_feature(to, {FeatureKind::vertex, 1});
    at = b;
    square = square_from_end(s);
    if (wants_distance<To> && square.is_lost()) [[unlikely]]
      return near_corner(segment.b, p, to);
  } else if (s.wd > unsure && beyond < -unsure) {
    name_feature(to, {FeatureKind::edge, 0});
    return between_ends(segment.a, segment.b, p, a, d, s, to);
  } else {
    return false;
  }
  return conclude(at, square, to);
}

template <class To>
HWY_INLINE bool nearest(const Triangle3& s, const Point3& p, To& to) {
  const V a = load(s.a), b = load(s.b), c = load(s.c), q = load(p), none = hn::Zero(D());
  const Pair ab = difference(b, a), ac = difference(c, a), ap = difference(q, a);
  const V bp = Sub(q, b), cp = Sub(q, c);
  const auto largest = [](V u, V v) { return hn::Max(Abs(u), Abs(v)); };
  const auto [lx, ly, lz] = lanes(hn::Max(largest(ab.h, ac.h), hn::Max(largest(ap.h, bp), Abs(cp))));
  const double l = std::max(std::max(lx, ly), lz), l2 = l * l;
  const double near = __builtin_fma(dot_constant, l2, guard), side = __builtin_fma(within_constant, l2 * l2, guard);
  const auto [d1, d2, d3, d4] = totals(Mul(ab.h, ap.h), Mul(ac.h, ap.h), Mul(ab.h, bp), Mul(ac.h, bp));
  const auto [d5, d6, e5, e6] = totals(Mul(ab.h, cp), Mul(ac.h, cp), none, none);
  const double from_b = d4 - d3, from_c = d5 - d6;  // along bc and along cb
  if (!(l > 0x1p-100 && l < 0x1p100)) return false;
  const bool at_a = d1 < -near && d2<-near, at_b = d3> near && from_b < -4 * near;
  if (at_a || at_b || (d6 > near && from_c < -4 * near)) {
    name_feature(to, {FeatureKind::vertex, at_a ? 0u : at_b ? 1u : 2u});
    return near_corner(at_a ? s.a : at_b ? s.b : s.c, p, to);
  }
  const double vc = d1 * d4 - d3 * d2, va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6;
  const bool on_ab = vc < -side && d1 > near && d3 < -near, on_ac = vb < -side && d2 > near && d6 < -near;
  if (on_ab || on_ac || (va < -side && from_b > 4 * near && from_c > 4 * near)) {
    const V from = on_ab || on_ac ? a : b;
    const Pair w = on_ab || on_ac ? ap : difference(q, b), d = on_ab ? ab : on_ac ? ac : difference(c, b);
    name_feature(to, {FeatureKind::edge, on_ab ? 0u : on_ac ? 2u : 1u});
    return between_ends(on_ab || on_ac ? s.a : s.b, on_ab ? s.b : s.c, p, from, d, dots<To>(w, d), to);
  }
  if (!(va > side && vb > side && vc > side && moderate(ab.h) && moderate(ac.h) && moderate(ap.h))) return false;
  name_feature(to, {FeatureKind::face, 0});
  return on_face(q, ab, ac, ap, none, to);
}

template <class To>
HWY_INLINE bool nearest(const Aabb3& s, const Point3& p, To& to) {
  const V min = load(s.min), max = load(s.max), at = load(p), q = hn::Min(hn::Max(at, min), max);
  const V infinity = set(std::numeric_limits<double>::infinity());
  const auto finite = hn::And(hn::Lt(Abs(at), infinity), hn::Lt(Sub(max, min), infinity));
  if (!hn::AllTrue(D(), hn::And(hn::Le(min, max), finite))) return false;
  const auto bits = [](auto mask) {
    std::uint8_t all[8] = {};
    hn::StoreMaskBits(D(), mask, all);
    return all[0] & 7u;
  };
  if constexpr (std::same_as<To, Closest>) {
    const unsigned free = bits(hn::And(hn::Gt(at, min), hn::Lt(at, max)));
    const unsigned upper = bits(hn::And(hn::Ge(at, max), hn::Gt(max, min)));
    name_feature(to, box_features[free][upper]);
  }
  double d = 0;
  if constexpr (wants_distance<To>) {
    const Pair w = difference(at, q);
    const unsigned apart = bits(hn::Ne(w.h, hn::Zero(D())));
    if ((apart & (apart - 1)) == 0) {
      d = total(Abs(w.h));  // of one difference, or none
    } else if (!length(w.h, w.l, d)) {
      return false;
    }
  }
  return put(q, d, to);
}

/// A guess as if the axes were at right angles, then proved by the signs of voronoi_region.
template <class To>
bool nearest(const Obb3& s, const Point3& p, To& to) {
  const V center = load(s.center), at = load(p), none = hn::Zero(D());
  const V axis[3] = {load(s.axes[0]), load(s.axes[1]), load(s.axes[2])};
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
  name_feature(to, box_features[free][upper]);
  if (!moderate(w.h)) return false;
  if (count == 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(outward(i, left[i]) > near)) return false;
    }
    V q = none;
    double d = 0;
    if (wants_point<To> && !round(o.h, o.l, slack, q)) return false;
    if (wants_distance<To> && !length(w.h, w.l, slack, d)) return false;
    return put(q, d, to);
  }
  if (count == 1) {
    const std::size_t u = is_free(0) ? 0 : is_free(1) ? 1 : 2;
    const double own = gram[u][u], reach = half[u] * own - near;
    if (!(std::fabs(left[u]) < reach)) return false;
    for (std::size_t v = 0; v < 3; ++v) {
      if (v != u && !(outward(v, own * left[v] - gram[u][v] * left[u]) > side)) return false;
    }
    const double size = total(Abs(Mul(w.h, axis[u]))) + std::fabs(left[u]);
    return on_line(Nearly{o.h, o.l, slack}, w, {axis[u], none}, left[u], own, size, to);
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
    return put(at, 0, to);
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
  return on_face(at, {axis[u], none}, {axis[v], none}, w, slack, to);
}

#endif

// One entry a shape and question; where there are no lanes of pairs, nothing is told.
template <class Shape, class To>
bool nearest_of(const Shape& s, const Point3& p, To& to) {
#if HWY_TARGET == HWY_AVX2
  return nearest(s, p, to);
#else
  return static_cast<void>(s), static_cast<void>(p), static_cast<void>(to), false;
#endif
}

}  // namespace
}  // namespace plumb::query::quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query {

template <class Shape, class To>
bool quickly(const Shape& s, const Point3& p, To& to) {
  return PLUMB_BY_LANES(quick, nearest_of(s, p, to));
}

#define PLUMB_QUICKLY(Shape)                                      \
  template bool quickly(const Shape&, const Point3&, Point3& to); \
  template bool quickly(const Shape&, const Point3&, double& to); \
  template bool quickly(const Shape&, const Point3&, Closest& to);
PLUMB_QUICKLY(Segment3)
PLUMB_QUICKLY(Triangle3)
PLUMB_QUICKLY(Aabb3)
PLUMB_QUICKLY(Obb3)
#undef PLUMB_QUICKLY

}  // namespace plumb::query
#endif
