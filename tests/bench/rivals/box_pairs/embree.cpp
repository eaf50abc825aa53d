#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <vector>

#include "bench/rivals/box_pairs/rival.hpp"

namespace plumb::bench {
namespace {

float float_below(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float float_above(double x) { return -float_below(-x); }

template <class To>
void embree_pairs(std::span<const Aabb3> boxes, To& to) {
  static const RTCDevice device = rtcNewDevice("threads=1");
  std::vector<RTCBounds> bounds(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto& [min, max] = boxes[i];
    bounds[i] = {float_below(min.x), float_below(min.y), float_below(min.z), 0,
                 float_above(max.x), float_above(max.y), float_above(max.z), 0};
  }
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, bounds.data());
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args) {
        *args->bounds_o = static_cast<const RTCBounds*>(args->geometryUserPtr)[args->primID];
      },
      nullptr);
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_LOW);
  rtcCommitGeometry(geometry);
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  struct Seen {
    const std::vector<RTCBounds>* bounds;
    To& to;
  } seen{&bounds, to};
  rtcCollide(
      scene, scene,
      [](void* held, RTCCollision* pairs, unsigned n) {
        auto& s = *static_cast<Seen*>(held);
        for (unsigned i = 0; i < n; ++i) {
          const unsigned p = pairs[i].primID0, q = pairs[i].primID1;
          if (p >= q) continue;
          const RTCBounds &a = (*s.bounds)[p], &b = (*s.bounds)[q];
          if (a.lower_x <= b.upper_x && b.lower_x <= a.upper_x && a.lower_y <= b.upper_y && b.lower_y <= a.upper_y &&
              a.lower_z <= b.upper_z && b.lower_z <= a.upper_z)
            s.to(p, q);
        }
      },
      &seen);
  rtcReleaseScene(scene);
}

}  // namespace

std::size_t embree_box_pairs(std::span<const Aabb3> boxes) {
  PairCount to;
  embree_pairs(boxes, to);
  return to.count;
}
ToldPairs embree_told_pairs(std::span<const Aabb3> boxes) {
  PairKeeper to;
  embree_pairs(boxes, to);
  return std::move(to.pairs);
}

}  // namespace plumb::bench
