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

}  // namespace

std::size_t embree_box_pairs(std::span<const Aabb3> boxes) {
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
    std::size_t count;
  } seen{&bounds, 0};
  rtcCollide(
      scene, scene,
      [](void* to, RTCCollision* pairs, unsigned n) {
        auto& s = *static_cast<Seen*>(to);
        for (unsigned i = 0; i < n; ++i) {
          const unsigned p = pairs[i].primID0, q = pairs[i].primID1;
          if (p >= q) continue;
          const RTCBounds &a = (*s.bounds)[p], &b = (*s.bounds)[q];
          s.count += a.lower_x <= b.upper_x && b.lower_x <= a.upper_x && a.lower_y <= b.upper_y &&
                     b.lower_y <= a.upper_y && a.lower_z <= b.upper_z && b.lower_z <= a.upper_z;
        }
      },
      &seen);
  rtcReleaseScene(scene);
  return seen.count;
}

}  // namespace plumb::bench
