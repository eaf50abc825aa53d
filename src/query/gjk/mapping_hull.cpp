#include "query/gjk/mapping_hull.hpp"

#include "arith/rounded_radical.hpp"
#include "arith/shortest_decimal.hpp"
#include "plumb/arith/error.hpp"
#include "query/body/figure_input.hpp"

namespace plumb::query {
namespace {

using BigVec = arith::Vec<BigDyadic>;

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}
/// With the fewest digits that tell it from its neighbors.
std::string text_of(double x) { return arith::shortest_decimal(x); }
std::string text_of(std::string_view what, double x, double y, double z) {
  return joined({what, " (", text_of(x), ", ", text_of(y), ", ", text_of(z), ")"});
}
std::string text_of(const Point3& p) { return text_of("point", p.x, p.y, p.z); }
std::string text_of(const Vector3& v) { return text_of("direction", v.x, v.y, v.z); }

}  // namespace

BigDyadic square_of(const Vector3& v) {
  const BigVec n = arith::vec<BigDyadic>(v);
  return dot(n, n);
}

const Point3& MappingHull::ask(const Vector3& direction) {
  const Point3 p = mapping_(direction);
  if (!is_real(sum_of(p))) {
    throw NonFinite(joined({function_, ": ", name_, " tells ", text_of(p), " for ", text_of(direction),
                            "; a support mapping tells a point of finite numbers"}));
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    require_no_farther(direction, points_[i], p, "which is less far along it than", points_[i]);
    require_no_farther(directions_[i], p, points_[i], "but earlier, along " + text_of(directions_[i]) + ",",
                       points_[i]);
  }
  points_.push_back(p), directions_.push_back(direction);
  return points_.back();
}

/// Both are off by as much as the rounding.
void MappingHull::require_no_farther(const Vector3& along, const Point3& one, const Point3& than,
                                     const std::string& how, const Point3& other) const {
  const BigVec way = arith::vec<BigDyadic>(one) - arith::vec<BigDyadic>(than);
  const BigDyadic ahead = dot(arith::vec<BigDyadic>(along), way), slack = BigDyadic(rounding_) + BigDyadic(rounding_);
  if (ahead.sign() != Sign::positive || (ahead * ahead - slack * slack * square_of(along)).sign() != Sign::positive)
    return;
  throw InvalidShape(
      joined({function_, ": ", name_, " contradicts itself: it tells ", text_of(&other == &one ? than : one), ", ", how,
              " ", text_of(other), "; state its rounding, if it is no more than that"}));
}

Vector3 told_direction(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  const BigDyadic square = dot(n.way, n.way);
  const auto part = [&](const BigDyadic& x) {  // of a vector of length one
    return rounded_radical(Rounding::nearest, BigDyadic(0.0), x, square, square);
  };
  return {part(n.way.x), part(n.way.y), part(n.way.z)};
}

void require_length(std::string_view function, std::string_view name, double x) {
  if (!is_real(x))
    throw NonFinite(joined({function, ": options.", name, " is ", text_of(x), "; give a finite double"}));
  if (x < 0) throw InvalidShape(joined({function, ": options.", name, " is negative; give one that is not"}));
}

}  // namespace plumb::query
