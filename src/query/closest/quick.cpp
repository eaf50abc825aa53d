// Which feature is nearest, by statements over doubles (query/closest/nearest_feature.hpp); then its numbers.
#include "query/closest/quick.hpp"

#include <concepts>
#include <limits>

#include "certify/fused_lanes.hpp"
#include "query/closest/linear_pair.hpp"

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

struct Ends {
  bool starts = true, ends = true;
};

template <class To>
HWY_INLINE bool nearest(const Segment3& segment, const Point3& p, To& to) {
  const Three a = loaded(segment.a), b = loaded(segment.b), q = loaded(p);
  const Twofolds d = Twofolds::difference(b, a), w = Twofolds::difference(q, a);
  const Dots s = squares(w, d);
  CertainSigns ask;
  const SpotOnLine place = place_on(Ends(), s.y.plain(), s.z.plain(), ask);
  if (!ask.certain()) return false;
  if (place == SpotOnLine::inside) {
    name_feature(to, {FeatureKind::edge, 0});
    return on_line(a, w, d, s, to);
  }
  if (place == SpotOnLine::start) {
    name_feature(to, {FeatureKind::vertex, 0});
    return conclude(a, s.x, to);
  }
  name_feature(to, {FeatureKind::vertex, 1});
  return conclude(b, (s.x + s.z) - (s.y + s.y), to) || at_corner(segment.b, p, to);
}

template <class To>
HWY_INLINE bool nearest(const Triangle3& s, const Point3& p, To& to) {
  const auto found = told<feature::OfTriangle>(s, p);
  if (!found) return false;
  name_feature(to, *found);
  const Point3* const corners[4] = {&s.a, &s.b, &s.c, &s.a};
  const Point3* const* const from = corners + found->index;
  if (found->kind == FeatureKind::vertex) return at_corner(**from, p, to);
  const Three a = loaded(**from), q = loaded(p);
  const Twofolds ap = Twofolds::difference(q, a), ab = Twofolds::difference(loaded(*from[1]), a);
  if (found->kind == FeatureKind::edge) return on_line(a, ap, ab, squares(ap, ab), to);
  return on_face(q, ab, Twofolds::difference(loaded(s.c), a), ap, to);
}

template <class To>
HWY_INLINE bool nearest(const Aabb3& s, const Point3& p, To& to) {
  const Three min = loaded(s.min), max = loaded(s.max), at = loaded(p), q = smaller(larger(at, min), max);
  const Three most = lanes::of_all(std::numeric_limits<double>::infinity());
  if (!all(above(most, size(at)) & above(most, max - min)) || any(above(min, max))) return false;
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
    } else if (!root_at_once(square(w)).told(d)) {
      return false;
    }
  }
  return put(q, d, to);
}

/// A guess as if the axes were at right angles; then its proof.
template <class To>
bool nearest(const Obb3& s, const Point3& p, To& to) {
  const Three center = loaded(s.center), at = loaded(p), half = size(loaded(s.half));
  const auto c = transposed(loaded(s.axes[0]), loaded(s.axes[1]), loaded(s.axes[2]));
  const Three guess = at - center;
  const Three along = lanes::along(c, lanes::spread<0>(guess), lanes::spread<1>(guess), lanes::spread<2>(guess));
  const unsigned free = bits(above(half * lanes::along(c, c.x, c.y, c.z), size(along)));
  const unsigned upper = bits(above(along, lanes::of_all(0))) & ~free;
  if (!all(above(half, lanes::of_all(0)))) return false;  // what is flat has fewer features
  const auto count = static_cast<unsigned>(__builtin_popcount(free));
  // The axes in turn, from the one that is free alone, or fixed alone.
  const std::size_t first = count == 1 ? free >> 1 : count == 2 ? (~free & 7U) >> 1 : 0;
  const std::size_t turn[3] = {first, (first + 1) % 3, (first + 2) % 3};
  const std::array<const Vector3*, 3> axes{&s.axes[turn[0]], &s.axes[turn[1]], &s.axes[turn[2]]};
  const double halves[3] = {s.half.x, s.half.y, s.half.z};
  double end[3];
  unsigned up = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const unsigned bit = 1U << turn[i];
    end[i] = (bit & (upper | free)) != 0 ? std::fabs(halves[turn[i]]) : -std::fabs(halves[turn[i]]);
    up |= (upper & bit) != 0 ? 1U << i : 0U;
  }
  name_feature(to, box_features[free][upper]);
  const Vector3 ends{end[0], end[1], end[2]};
  if (count == 3) return told<feature::OfBox<3>>(p, s.center, axes, ends, up) && put(at, 0, to);
  const Twofolds u = Twofolds::exact(loaded(*axes[0])), v = Twofolds::exact(loaded(*axes[1])),
                 n = Twofolds::exact(loaded(*axes[2]));
  const auto step = [&](const Twofolds& axis, double by)
                        HWY_ATTR { return Twofolds::whole_product(axis, Twofolds::exact(lanes::of_all(by))); };
  const Twofolds way = Twofolds::difference(at, center);
  if (count == 2) {
    if (!told<feature::OfBox<2>>(p, s.center, axes, ends, up)) return false;
    return on_face(at, v, n, way - step(u, end[0]), to);
  }
  const Twofolds sides = step(v, end[1]) + step(n, end[2]);
  if (count == 1) {
    if (!told<feature::OfBox<1>>(p, s.center, axes, ends, up)) return false;
    const Twofolds w = way - sides;
    return on_line(center, w, u, apart(sums(w * w, w * u, u * u)), to, sides);
  }
  if (!told<feature::OfBox<0>>(p, s.center, axes, ends, up)) return false;
  const Twofolds corner = sides + step(u, end[0]), w = way - corner;
  Three q = center;
  if (wants_point<To> && !(center + corner).told(q)) return false;
  return conclude(q, total(w.squared()), to);
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
