// Which feature is nearest, by statements over doubles (query/closest/nearest_feature.hpp); then its numbers.
#include "query/closest/quick.hpp"

#include <concepts>
#include <limits>
#include <optional>

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/closest/quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef PLUMB_CLOSEST_QUICK_ONCE
#define PLUMB_CLOSEST_QUICK_ONCE
namespace plumb::query::quick {

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
#include "query/closest/nearest_feature.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::quick::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_AVX2

namespace feature = nearest_feature::HWY_NAMESPACE;

template <class Statement, class... Input>
HWY_INLINE auto told(const Input&... input) {
  using Floats = lanes::Floats<Three, Statement::highest, Statement::scales>;
  return lanes::told_by_worlds<Floats>(NoWorldRecorder{}, Statement{}, input...);
}

template <class To>
HWY_INLINE bool nearest(const Segment3& segment, const Point3& p, To& to) {
  const Three a = loaded(segment.a), b = loaded(segment.b), q = loaded(p);
  const Twofolds d = Twofolds::difference(b, a), w = Twofolds::difference(q, a);
  const Dots s = squares(w, d);
  const Approximate part = s.y.plain(), rest = s.z.plain() - part;
  if (part.certainly_negative()) {
    name_feature(to, {FeatureKind::vertex, 0});
    return at_corner(a, q, to);
  }
  if (rest.certainly_negative()) {
    name_feature(to, {FeatureKind::vertex, 1});
    return at_corner(b, q, to);
  }
  if (!part.certainly_positive() || !rest.certainly_positive()) return false;
  name_feature(to, {FeatureKind::edge, 0});
  return on_edge(segment.a, segment.b, p, w, d, s, to);
}

/// The feature of a triangle in one number, which stays in a register.
struct SpotOfTriangle : feature::OfTriangle {
  template <class W>
  HWY_INLINE unsigned operator()(W& w, const Triangle3& t, const Point3& p) const {
    const Feature f = feature::OfTriangle::operator()(w, t, p);
    return static_cast<unsigned>(f.kind) << 2 | f.index;
  }
};

template <class To>
HWY_INLINE bool nearest(const Triangle3& s, const Point3& p, To& to) {
  const std::optional<unsigned> found = told<SpotOfTriangle>(s, p);
  if (!found) return false;
  const FeatureKind kind{static_cast<unsigned char>(*found >> 2)};
  const unsigned index = *found & 3;
  name_feature(to, {kind, index});
  const Point3* const corners[4] = {&s.a, &s.b, &s.c, &s.a};
  const Point3* const* const from = corners + index;
  const Three a = loaded(**from), q = loaded(p);
  if (kind == FeatureKind::vertex) return at_corner(a, q, to);
  const Twofolds ap = Twofolds::difference(q, a), ab = Twofolds::difference(loaded(*from[1]), a);
  if (kind == FeatureKind::edge) return on_edge(**from, *from[1], p, ap, ab, squares(ap, ab), to);
  return on_face(q, ab, Twofolds::difference(loaded(s.c), a), ap, to);
}

template <class To>
HWY_INLINE bool nearest(const Aabb3& s, const Point3& p, To& to) {
  const Three min = loaded(s.min), max = loaded(s.max), at = loaded(p), q = smaller(larger(at, min), max);
  const Three most = lanes::of_all(std::numeric_limits<double>::infinity());
  if ((bits(above(most, size(at)) & above(most, max - min)) & ~bits(above(min, max))) != 7) return false;
  if constexpr (std::same_as<To, Closest>) {
    const unsigned above_min = bits(above(at, min)), below_max = bits(above(max, at)), wide = bits(above(max, min));
    name_feature(to, box_features[above_min & below_max][~below_max & wide]);
  }
  double d = 0;
  if constexpr (wants_distance<To>) {
    const Twofolds w = Twofolds::difference(at, q);
    const unsigned apart = ~bits(is_zero(w.high)) & 7U;
    if ((apart & (apart - 1)) == 0) {
      d = total(size(w.high));  // of one difference, or none
    } else if (!root_of_squares(square(w)).told(d)) {
      return false;
    }
  }
  return put(q, d, to);
}

/// Lane k has what lane k + by had.
HWY_INLINE Three turned_by(std::size_t by, const Three& a) {
  alignas(32) static constexpr int places[3][8] = {
      {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 4, 5, 0, 1, 6, 7}, {4, 5, 0, 1, 2, 3, 6, 7}};
  const __m256i at = _mm256_load_si256(reinterpret_cast<const __m256i*>(places[by]));
  return {_mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(a.v), at))};
}

/// A guess as if the axes were at right angles; then its proof.
template <class To>
bool nearest(const Obb3& s, const Point3& p, To& to) {
  const Three center = loaded(s.center), at = loaded(p), half = size(loaded(s.half));
  const auto c = transposed(loaded(s.axes[0]), loaded(s.axes[1]), loaded(s.axes[2]));
  const Three guess = at - center;
  const Three along = lanes::along(c, lanes::spread<0>(guess), lanes::spread<1>(guess), lanes::spread<2>(guess));
  const lanes::Truth is_free = above(half * lanes::along(c, c.x, c.y, c.z), size(along)),
                     is_above = above(along, lanes::of_all(0));
  const unsigned free = bits(is_free), upper = bits(is_above) & ~free;
  if (!all(above(half, lanes::of_all(0)))) return false;  // what is flat has fewer features
  const auto count = static_cast<unsigned>(__builtin_popcount(free));
  // The axes in turn, from the one that is free alone, or fixed alone.
  const std::size_t first = count == 1 ? free >> 1 : count == 2 ? (~free & 7U) >> 1 : 0;
  const std::size_t turn[3] = {first, (first + 1) % 3, (first + 2) % 3};
  const std::array<const Vector3*, 3> axes{&s.axes[turn[0]], &s.axes[turn[1]], &s.axes[turn[2]]};
  const Three end = turned_by(first, chosen(is_free | is_above, half, Twofolds::negated(half)));
  const unsigned up = (upper >> first | upper << (3 - first)) & 7U;
  name_feature(to, box_features[free][upper]);
  if (count == 3) return told<feature::OfBox<3>>(p, s.center, axes, end, up) && put(at, 0, to);
  const Twofolds u = Twofolds::exact(loaded(*axes[0])), v = Twofolds::exact(loaded(*axes[1])),
                 n = Twofolds::exact(loaded(*axes[2]));
  const auto step = [&](const Twofolds& axis, const Three& by)
                        HWY_ATTR { return Twofolds::whole_product(axis, Twofolds::exact(by)); };
  const Twofolds way = Twofolds::difference(at, center);
  if (count == 2) {
    if (!told<feature::OfBox<2>>(p, s.center, axes, end, up)) return false;
    return on_face(at, v, n, way - step(u, lanes::spread<0>(end)), to);
  }
  const Twofolds sides = step(v, lanes::spread<1>(end)) + step(n, lanes::spread<2>(end));
  if (count == 1) {
    if (!told<feature::OfBox<1>>(p, s.center, axes, end, up)) return false;
    const Twofolds w = way - sides;
    Three q = center;
    double distance = 0;
    const Dots dots = apart(sums(w * w, w * u, u * u));
    return foot<To>(center, w, u, dots, q, distance, by_the_way, sides) && put(q, distance, to);
  }
  if (!told<feature::OfBox<0>>(p, s.center, axes, end, up)) return false;
  const Twofolds corner = sides + step(u, lanes::spread<0>(end)), w = way - corner;
  Three q = center;
  if (wants_point<To> && !(center + corner).told(q)) return false;
  double distance = 0;
  if (wants_distance<To> && !root_at_once(total(w.squared())).told(distance)) return false;
  return put(q, distance, to);
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
