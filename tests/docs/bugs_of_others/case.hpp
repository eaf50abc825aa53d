// What does Plumb answer where other libraries were reported to be wrong?
//
// Laws: one Case for each row of docs/bugs_of_others.md, under the same heading and in the same order; what `answer`
// returns is the row's last cell, word for word.  A case expects, besides, what shows that the answer is right: a
// certificate, or the same number in rationals.
// Cost: microseconds a case, a few milliseconds where a tree is built.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::docs {

struct Case {
  std::string_view report;  // "CGAL/cgal#6777"
  std::string (*answer)();
};

struct Kind {
  std::string_view heading;
  std::span<const Case> cases;
};

std::span<const Case> crossing_cases();
std::span<const Case> hull_cases();
std::span<const Case> triangle_cases();
std::span<const Case> box_cases();
std::span<const Case> distance_cases();
std::span<const Case> ray_cases();
std::span<const Case> motion_cases();
std::span<const Case> inside_cases();
std::span<const Case> measure_cases();
std::span<const Case> tree_cases();
std::span<const Case> file_cases();

/// Answers as the page tells them: a double by as many digits as name it.
std::string told(Relation relation);
std::string told(Location location);
std::string told(double number);
std::string told(const Point2& p);
std::string told(const Point3& p);
std::string told(std::span<const std::uint32_t> numbers);

}  // namespace plumb::docs
