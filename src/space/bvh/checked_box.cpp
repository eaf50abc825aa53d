#include "space/bvh/checked_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"

namespace plumb::space {

bool is_sound(const Aabb3& box) {
  // A NaN fails every comparison.
  constexpr double most = std::numeric_limits<double>::max();
  const auto within = [](double from, double to) { return -most <= from && from <= to && to <= most; };
  return within(box.min.x, box.max.x) && within(box.min.y, box.max.y) && within(box.min.z, box.max.z);
}

void check_box(const std::string& function, const std::string& name, const Aabb3& box) {
  if (is_sound(box)) return;
  const std::string min = name + ".min", max = name + ".max";
  figure::require_finite_parts<Point3, Point3>(function, {min, max}, box.min, box.max);
  throw InvalidShape(function + ": " + name + " is empty; leave it out");
}

void check_options(const std::string& function, const BvhOptions& options) {
  if (options.most_in_leaf < 1 || options.most_in_leaf > 255) {
    throw InvalidShape(function + ": options.most_in_leaf is " + std::to_string(options.most_in_leaf) +
                       ", but it must lie from 1 to 255");
  }
  if (!(options.item_cost > 0 && options.item_cost <= 1e6F)) {
    throw InvalidShape(function + ": options.item_cost is " + std::to_string(options.item_cost) +
                       ", but it must be positive and at most 1e6");
  }
  if (!(options.split_share >= 0 && options.split_share <= 16)) {
    throw InvalidShape(function + ": options.split_share is " + std::to_string(options.split_share) +
                       ", but it must lie from 0 to 16");
  }
}

double magnitude(const Point3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

}  // namespace plumb::space
