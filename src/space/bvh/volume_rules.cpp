#include "plumb/space/bvh/volume_rules.hpp"

#include "figure/obb/quick.hpp"
#include "plumb/figure/obb/fits.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/sphere/fits.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb {
namespace space {
namespace {

/// Are its numbers such that doubles prove what is not near?
bool is_of_usual_size(const Obb3& box) {
  constexpr double least = 0x1p-50, greatest = 0x1p90;  // guesses of what is usual
  const double size = VolumeRules<Obb3>::size(box);
  return size > least && size < greatest && magnitude_of(box.center.x) < greatest &&
         magnitude_of(box.center.y) < greatest && magnitude_of(box.center.z) < greatest;
}

}  // namespace
}  // namespace space

Sphere3 VolumeRules<Sphere3>::around(std::span<const Point3> points, const VolumeOptions& options) {
  return options.fit == VolumeFit::tight ? minimum_sphere(points).sphere : fit_sphere_ritter(points);
}

Obb3 VolumeRules<Obb3>::around(std::span<const Point3> points, const VolumeOptions& options) {
  return options.fit == VolumeFit::tight ? minimum_obb(points) : fit_obb_principal(points);
}

/// Boxes of coplanar triangles are flat, and those of neighbors touch: what is exact about these takes microseconds, the
/// tests below them nanoseconds.
bool VolumeRules<Obb3>::meet(const Obb3& a, const Obb3& b) {
  if (const std::optional<Relation> sure = quick_relation(a, b)) return *sure != Relation::disjoint;
  return (space::is_of_usual_size(a) && space::is_of_usual_size(b)) || intersects(a, b);
}

}  // namespace plumb
