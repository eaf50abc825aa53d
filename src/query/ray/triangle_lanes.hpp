// Ray cast: what do lanes of doubles say of one ray against as many triangles?  The one statement of that test.
//
// What it proves is said in query/ray/triangle_passed.hpp, whose bounds are derived.
// Included once for each instruction set (foreach_target.h); hence no #pragma once.
#if defined(PLUMB_TRIANGLE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_TRIANGLE_LANES
#undef PLUMB_TRIANGLE_LANES
#else
#define PLUMB_TRIANGLE_LANES
#endif

#include <hwy/highway.h>

#include <limits>
#include <utility>

#include "certify/many_lanes.hpp"
#include "query/ray/batch_lanes.hpp"
#include "query/ray/triangle_passed.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
namespace many = certify::many_lanes::HWY_NAMESPACE;
using D = many::Lanes;
using V = hn::Vec<D>;
using many::Many, many::Truth;
using Passed = triangle_passed::HWY_NAMESPACE::TrianglePassed;
inline constexpr std::size_t lanes = hn::MaxLanes(D());

struct Lanes3 {
  V x, y, z;
};
struct Many3 {
  Many x, y, z;
  HWY_INLINE explicit Many3(const Lanes3& v) : x{v.x}, y{v.y}, z{v.z} {}
};

struct RayLanes {
  Lanes3 origin, direction;
  RayDoubts doubts;
  bool begins, ends;

  explicit RayLanes(const BatchRay& ray, const RayDoubts& in_doubt = {})
      : origin{hn::Set(D(), ray.origin[0]), hn::Set(D(), ray.origin[1]), hn::Set(D(), ray.origin[2])},
        direction{hn::Set(D(), ray.direction[0]), hn::Set(D(), ray.direction[1]), hn::Set(D(), ray.direction[2])},
        doubts(in_doubt),
        begins(ray.begins),
        ends(ray.ends) {}

  /// What is given, else what is derived.
  [[nodiscard]] HWY_INLINE Many doubt(double given, const Many& derived) const {
    return doubts.are_given ? many::of_all(given) : derived;
  }
};

/// Bit i is the triangle of lane i: hit it is not, it is, else nothing is told; and between which parameters it is hit
/// where it is, infinities where nothing is known of that.
struct TrianglesTold {
  unsigned no, yes;
  V least, most;
};

/// Triangles seen from an origin: all of the test that the direction has no part in, for who asks several rays from there.
struct TrianglesSeen {
  using World = many::Floats<Many, Passed::highest, Passed::scales>;
  using Numbers =
      decltype(Passed::seen(std::declval<World&>(), std::declval<const Many3&>(), std::declval<const Many3&>(),
                            std::declval<const Many3&>(), std::declval<const Many3&>()));
  World world;
  Numbers numbers;

  HWY_INLINE TrianglesSeen(const Lanes3& origin, const Lanes3& p, const Lanes3& q, const Lanes3& r)
      : numbers(Passed::seen(world, Many3(origin), Many3(p), Many3(q), Many3(r))) {}
};

/// Of a ray from the origin that they are seen from, one after another.
HWY_INLINE TrianglesTold tell(const RayLanes& ray, TrianglesSeen& seen) {
  const Many zero = many::of_all(0), infinity = many::of_all(std::numeric_limits<double>::infinity());
  TrianglesSeen::World& world = seen.world;
  const auto sides = Passed::sides(world, Many3(ray.direction), seen.numbers);
  const Many least = sides.least.value, most = sides.most.value;
  const Many doubt = ray.doubt(ray.doubts.edge, world.doubt<decltype(sides.least)::track>()), other = zero - doubt;
  const Truth real = world.in_range() & world.is_real(sides.sum);
  Truth no = above(most, doubt) & above(other, least) & real;
  if (many::all(no)) return {~0u, 0, zero.v, zero.v};  // most often so
  Truth yes = (above(least, doubt) | above(other, most)) & real;
  // Toward the plane: both with the sign of D, where that is known.
  const auto height = seen.numbers.height();
  const Truth forward = above(sides.sum.value, zero);
  const Many way = negated_unless(forward, height).value, speed = magnitude(sides.sum).value;
  if (ray.begins) {
    const Many off = ray.doubt(ray.doubts.plane, world.doubt<decltype(height)::track>());
    no = no | (yes & above(zero - off, way));
    Truth sure = above(way, off);
    if (ray.ends) {
      const auto beyond_end = negated_unless(forward, Passed::beyond_end(height, sides.sum));
      const Many far = ray.doubt(ray.doubts.end, world.doubt<decltype(beyond_end)::track>());
      no = no | (yes & above(beyond_end.value, far));
      sure = sure & above(zero - far, beyond_end.value);
    }
    yes = yes & sure;
  }
  const Many blur = ray.doubt(ray.doubts.sum, world.reach<decltype(sides.sum)::track>()),
             off = ray.doubt(ray.doubts.plane, world.reach<decltype(height)::track>());
  const Many slow = many::below(speed - blur), fast = many::beyond(speed + blur);
  const Many near = many::below(way - off), away = many::beyond(way + off);
  const Many low{hn::Div(near.v, chosen(above(zero, near), slow, fast).v)},
      high{hn::Div(away.v, chosen(above(away, zero), slow, fast).v)};
  const Truth known = above(slow, zero) & real;
  return {many::bits_of(no), many::bits_of(yes), chosen(known, many::below(low), zero - infinity).v,
          chosen(known, many::beyond(high), infinity).v};
}

HWY_INLINE TrianglesTold tell(const RayLanes& ray, const Lanes3& p, const Lanes3& q, const Lanes3& r) {
  TrianglesSeen seen(ray.origin, p, q, r);
  return tell(ray, seen);
}

}  // namespace plumb::query::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
