// What must be known of a bounding volume, so that trees of it can be built and asked?
//
//   VolumeRules<Sphere3>::around(points, options)       // a volume around these points
//   VolumeRules<Sphere3>::both(a, b)                    // around two volumes
//   VolumeRules<Sphere3>::meet(a, b)                    // may two meet?
//   VolumeRules<Sphere3>::size(a)                       // which of two is descended: a guess
//
// A volume of your own has rules once you specialize this struct; `around` may then take what you like.
// Laws: (1) around contains the points and both the two volumes, exactly.  (2) Where meet is false the two sets have no
// point in common.  Of spheres and axis-aligned boxes it is intersects; of k-DOPs it compares intervals, of oriented
// boxes it says what doubles prove: so it may be true of such as well.
// No points throw InvalidShape, a volume that no doubles hold BeyondDoubles.
// Source: RTCD 6.1.1, 6.5.
// Cost: docs/trees.md compares them.  Nothing is searched.
#pragma once

#include <span>

#include "plumb/certify/batch.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {

/// How spheres and oriented boxes are fitted.  Axis-aligned boxes and k-DOPs are the least in each of these ways.
enum class VolumeFit : unsigned char {
  quick,   // each to the points below it: Ritter's sphere, the box along the principal axes
  tight,   // the smallest sphere, the box of least volume
  merged,  // those of leaves to their points, the others around their children's (RTCD 6.5)
};

struct VolumeOptions {
  VolumeFit fit = VolumeFit::quick;
  int k = 14;  // of a k-DOP: as k_dop_directions takes it
  Execution execution = Execution::parallel;
};

template <class Volume>
struct VolumeRules;

namespace space {

/// Without a header of the standard's.
constexpr double largest_of(double x, double y, double z) {
  const double most = x > y ? x : y;
  return most > z ? most : z;
}

}  // namespace space

template <>
struct VolumeRules<Sphere3> {
  static Sphere3 around(std::span<const Point3> points, const VolumeOptions& options);
  static Sphere3 both(const Sphere3& a, const Sphere3& b) { return merge(a, b); }
  static bool meet(const Sphere3& a, const Sphere3& b) { return intersects(a, b); }
  static double size(const Sphere3& v) { return v.radius; }
};

template <>
struct VolumeRules<Aabb3> {
  static Aabb3 around(std::span<const Point3> points, const VolumeOptions&) { return fit_aabb(points); }
  static Aabb3 both(const Aabb3& a, const Aabb3& b) { return merge(a, b); }
  static bool meet(const Aabb3& a, const Aabb3& b) { return intersects(a, b); }
  static double size(const Aabb3& v) {
    return space::largest_of(v.max.x - v.min.x, v.max.y - v.min.y, v.max.z - v.min.z);
  }
};

template <>
struct VolumeRules<Obb3> {
  static Obb3 around(std::span<const Point3> points, const VolumeOptions& options);
  static Obb3 both(const Obb3& a, const Obb3& b) { return merge(a, b); }
  static bool meet(const Obb3& a, const Obb3& b);
  static double size(const Obb3& v) { return space::largest_of(v.half.x, v.half.y, v.half.z); }
};

template <>
struct VolumeRules<KDop3> {
  static KDop3 around(std::span<const Point3> points, const VolumeOptions& options) {
    return fit_k_dop(points, options.k);
  }
  static KDop3 both(const KDop3& a, const KDop3& b) { return merge(a, b); }
  static bool meet(const KDop3& a, const KDop3& b) { return intervals_overlap(a, b); }
  static double size(const KDop3& v) { return v.max[0] - v.min[0]; }
};

}  // namespace plumb
