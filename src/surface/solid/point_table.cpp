#include "surface/solid/point_table.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "surface/planar/triangles.hpp"

namespace plumb::surface {

ExactPoint3 in_plain_form(ExactPoint3 p) {
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
  plain.cache().keep_exact(is_double);
  if (const auto* place = p.cache().place(); place != nullptr) plain.cache().keep(certify::shared(place));
  return plain;
}

PointTable::PointTable(const NumberedPoints& points)
    : given_(points.given), made_(points.held.begin(), points.held.end()) {
  for (std::uint32_t i = 0; i < made_.size(); ++i) places_.insert(i);
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

std::uint32_t PointTable::number_of(ExactPoint3 point) {
  const auto* construction = std::get_if<LinePlanePoint3>(&point.as());
  if (construction == nullptr) return number_of_place(std::move(point));
  const auto [at, is_new] = constructions_.try_emplace(*construction, none);
  if (is_new) at->second = number_of_place(std::move(point));
  return at->second;
}

void PointTable::note_line(std::uint32_t number, const std::array<std::uint32_t, 2>& line) {
  if (is_given(number)) return;
  constexpr std::array<std::uint32_t, 2> free{none, none};
  const std::size_t place = number - given_.size();
  if (lines_.size() <= place) lines_.resize(place + 1, TwoLines{free, free});
  for (auto& of : lines_[place]) {
    if (of == line) return;
    if (of != free) continue;
    of = line;
    return;
  }
}

std::uint32_t PointTable::number_of_place(ExactPoint3 point) {
  if (const auto* p = std::get_if<Point3>(&point.as()))
    if (const std::uint32_t number = given_number(*p); number != none) return number;
  const auto number_of_made = [this](std::uint32_t place) { return static_cast<std::uint32_t>(given_.size()) + place; };
  if (const auto at = places_.find(point); at != places_.end()) return number_of_made(*at);
  ExactPoint3 plain = in_plain_form(std::move(point));
  if (const auto* p = std::get_if<Point3>(&plain.as()))
    if (const std::uint32_t number = given_number(*p); number != none) return number;
  const auto place = static_cast<std::uint32_t>(made_.size());
  made_.push_back(std::move(plain));
  places_.insert(place);
  return number_of_made(place);
}

std::size_t PointTable::HashOfConstruction::operator()(const LinePlanePoint3& p) const {
  std::size_t hash = 0;
  for (const Point3* at : {&p.p, &p.q, &p.a, &p.b, &p.c})
    for (const double x : {at->x, at->y, at->z}) hash = (hash ^ std::hash<double>{}(x)) * 0x9e3779b97f4a7c15U;
  return hash ^ hash >> 32;
}

}  // namespace plumb::surface
