#include "surface/solid/point_table.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "surface/planar/triangles.hpp"

namespace plumb::surface {

ExactPoint3 in_plain_form(const ExactPoint3& p) {
  if (const auto* given = std::get_if<Point3>(&p.as())) return Point3{given->x + 0.0, given->y + 0.0, given->z + 0.0};
  const Point3 nearest = approximate(p);
  if (std::holds_alternative<RationalPoint3>(p.as())) {  // of which it is known now which coordinates are doubles
    const auto& known = p.cache();
    if (known.is_exact(0) && known.is_exact(1) && known.is_exact(2))
      return Point3{nearest.x + 0.0, nearest.y + 0.0, nearest.z + 0.0};
    return p;
  }
  RationalPoint3 exact = rational_point(p);
  const std::array<bool, 3> is_double{exact.x == Rational(nearest.x), exact.y == Rational(nearest.y),
                                      exact.z == Rational(nearest.z)};
  if (is_double[0] && is_double[1] && is_double[2]) return Point3{nearest.x + 0.0, nearest.y + 0.0, nearest.z + 0.0};
  ExactPoint3 plain(std::move(exact));
  plain.cache().keep({nearest.x, nearest.y, nearest.z}, is_double);  // so that its copies have them
  return plain;
}

PointTable::PointTable(const NumberedPoints& points)
    : given_(points.given), made_(points.held.begin(), points.held.end()) {
  for (std::uint32_t i = 0; i < made_.size(); ++i)
    number_.emplace(made_[i], static_cast<std::uint32_t>(given_.size()) + i);
}

std::uint32_t PointTable::given_number(const Point3& p) const {
  const auto key = [](const Point3& q) { return std::tie(q.x, q.y, q.z); };
  const auto at =
      std::ranges::lower_bound(given_, p, [&](const Point3& l, const Point3& r) { return key(l) < key(r); });
  return at != given_.end() && key(*at) == key(p) ? static_cast<std::uint32_t>(at - given_.begin()) : none;
}

std::uint32_t PointTable::given_before(const ExactPoint3& point) const {
  const auto at = std::ranges::partition_point(
      given_, [&](const Point3& p) { return compare_xyz(ExactPoint3(p), point) == Sign::negative; });
  return static_cast<std::uint32_t>(at - given_.begin());
}

std::uint32_t PointTable::number_of(const ExactPoint3& point) {
  if (const auto* p = std::get_if<Point3>(&point.as()))
    if (const std::uint32_t number = given_number(*p); number != none) return number;
  const auto [at, is_new] = number_.try_emplace(point, static_cast<std::uint32_t>(size()));
  if (!is_new) return at->second;
  const ExactPoint3 plain = in_plain_form(point);
  if (const auto* p = std::get_if<Point3>(&plain.as()))
    if (const std::uint32_t number = given_number(*p); number != none) return at->second = number;
  made_.push_back(plain);
  return at->second;
}

}  // namespace plumb::surface
