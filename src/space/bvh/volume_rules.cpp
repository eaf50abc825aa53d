#include "plumb/space/bvh/volume_rules.hpp"

#include "plumb/figure/obb/fits.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/sphere/fits.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb {

Sphere3 VolumeRules<Sphere3>::around(std::span<const Point3> points, const VolumeOptions& options) {
  return options.fit == VolumeFit::tight ? minimum_sphere(points).sphere : fit_sphere_ritter(points);
}

Obb3 VolumeRules<Obb3>::around(std::span<const Point3> points, const VolumeOptions& options) {
  return options.fit == VolumeFit::tight ? minimum_obb(points) : fit_obb_principal(points);
}

}  // namespace plumb
