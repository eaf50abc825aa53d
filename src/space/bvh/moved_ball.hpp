// Where are many balls under one pose?  Rounded outward.
//
// Laws: a moved ball contains the exact image, whatever the matrix; its center is within the doubles around the image's.
// Source: RTCD 4.3, 6.5.2.
// Cost: some 100 ns a ball.
#pragma once

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

/// Moves balls; `transform` of one finds the stretch anew each time, which is most of its work.
class BallMover {
 public:
  BallMover(const char* function, const MeshPose& pose)
      : function_(function), pose_(pose), stretch_(pose.matrix() != nullptr ? largest_stretch(*pose.matrix()) : 1) {}

  Sphere3 operator()(const Sphere3& ball) const {
    const Aabb3 at = around(pose_, ball.center);
    const auto middle = [](double low, double high) { return std::clamp(low / 2 + high / 2, low, high) + 0.0; };
    const Point3 center{middle(at.min.x, at.max.x), middle(at.min.y, at.max.y), middle(at.min.z, at.max.z)};
    const auto off = [](double low, double high, double c) {
      const Interval d = Interval(low, high) - Interval(c);
      const Interval most(std::max(-d.lower, d.upper));
      return most * most;
    };
    const Interval square =
        off(at.min.x, at.max.x, center.x) + off(at.min.y, at.max.y, center.y) + off(at.min.z, at.max.z, center.z);
    const double radius = Interval::sum_up(root(square).upper, Interval::product_up(stretch_, ball.radius));
    return {center, figure::within_doubles(radius, function_, "radius")};
  }

 private:
  const char* function_;
  MeshPose pose_;
  double stretch_;
};

}  // namespace plumb::space
