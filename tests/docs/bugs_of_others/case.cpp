#include "docs/bugs_of_others/case.hpp"

#include <charconv>

namespace plumb::docs {

std::string told(Relation relation) {
  return relation == Relation::disjoint ? "disjoint" : relation == Relation::touching ? "touching" : "overlapping";
}

std::string told(Location location) {
  return location == Location::inside ? "inside" : location == Location::boundary ? "boundary" : "outside";
}

std::string told(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string told(const Point2& p) { return "(" + told(p.x) + ", " + told(p.y) + ")"; }

std::string told(const Point3& p) { return "(" + told(p.x) + ", " + told(p.y) + ", " + told(p.z) + ")"; }

std::string told(std::span<const std::uint32_t> numbers) {
  std::string all;
  for (const std::uint32_t n : numbers) all += (all.empty() ? "" : " ") + std::to_string(n);
  return all;
}

}  // namespace plumb::docs
