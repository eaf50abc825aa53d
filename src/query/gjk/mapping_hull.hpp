// Support mapping: what has a black box told so far, and does it contradict itself?
//
// Laws: a point of numbers that are not finite throws NonFinite, one that contradicts an earlier one beyond the rounding
// InvalidShape, with the points and the direction.
// Source: RTCD 9.5.3.
// Cost: two signs of integers for each point that was told before.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/query/gjk/support_mapping.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query {

class MappingHull {
 public:
  /// `function` and `name`: how a text calls who asks, and the body.
  MappingHull(std::string_view function, std::string_view name, const SupportCall& mapping, double rounding)
      : mapping_(mapping), function_(function), name_(name), rounding_(rounding) {}

  const Point3& ask(const Vector3& direction);
  [[nodiscard]] const std::vector<Point3>& points() const { return points_; }

 private:
  void require_no_farther(const Vector3& along, const Point3& one, const Point3& than, const std::string& how,
                          const Point3& other) const;

  SupportCall mapping_;
  std::string function_, name_;
  double rounding_;
  std::vector<Point3> points_;
  std::vector<Vector3> directions_;
};

/// Options that are lengths: finite, and not negative.
void require_length(std::string_view function, std::string_view name, double x);

BigDyadic square_of(const Vector3& v);

/// Of length one but for rounding, from the nearest point of the corners' affine hull.
Vector3 told_direction(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners);

}  // namespace plumb::query
