#include "surface/section/cut_corners.hpp"

#include <cmath>
#include <limits>

namespace plumb::surface {
namespace {

/// Twice the area that the points go around, seen from the first.
template <class Loop, class At>
auto doubled_area(const Loop& loop, const At& at) {
  const auto x0 = at(loop[0], 0), y0 = at(loop[0], 1);
  auto x1 = at(loop[1], 0) - x0, y1 = at(loop[1], 1) - y0;
  auto sum = x0 - x0;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    const auto x2 = at(loop[i], 0) - x0, y2 = at(loop[i], 1) - y0;
    sum = sum + (x1 * y2 - x2 * y1);
    x1 = x2, y1 = y2;
  }
  return sum;
}

}  // namespace

bool CutCorners::is_given(std::uint32_t corner, std::size_t k) const {
  const SectionCorner& c = corners_[corner];
  const std::size_t axis = plane_.shown()[k];
  return coordinate(mesh_.vertices[c.below], axis) == coordinate(mesh_.vertices[c.above], axis);
}

Interval CutCorners::between(std::uint32_t corner, std::size_t k) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double x = nearest(corner, k);
  if (is_given(corner, k)) return Interval(x);
  return {std::nextafter(x, -infinity), std::nextafter(x, infinity)};
}

const RationalPoint2& CutCorners::rational(std::uint32_t corner) const {
  const auto at = rational_.find(corner);
  if (at != rational_.end()) return at->second;
  const SectionCorner& c = corners_[corner];
  const Point3 &p = mesh_.vertices[c.below], &q = mesh_.vertices[c.above];
  const RationalPoint3 point = rational_point(c.below == c.above ? ExactPoint3(p) : plane_.exact(p, q));
  const std::array coordinates{&point.x, &point.y, &point.z};
  const auto [u, v] = plane_.shown();
  return rational_.emplace(corner, RationalPoint2{*coordinates[u], *coordinates[v]}).first->second;
}

Sign CutCorners::compare(std::uint32_t a, std::uint32_t b, std::size_t k) const {
  const double x = nearest(a, k), y = nearest(b, k);
  if (x != y) return x < y ? Sign::negative : Sign::positive;
  if (a == b || (is_given(a, k) && is_given(b, k))) return Sign::zero;
  const RationalPoint2 &p = rational(a), &q = rational(b);
  return k == 0 ? (p.x - q.x).sign() : (p.y - q.y).sign();
}

bool CutCorners::equal(std::uint32_t a, std::uint32_t b) const {
  const auto ends = [&](std::uint32_t corner) {
    return std::array{mesh_.vertices[corners_[corner].below], mesh_.vertices[corners_[corner].above]};
  };
  return ends(a) == ends(b) || (compare(a, b, 0) == Sign::zero && compare(a, b, 1) == Sign::zero);
}

Sign CutCorners::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return a == b || b == c || c == a ? Sign::zero : turn(std::array{a, b, c});
}

Sign CutCorners::turn(std::span<const std::uint32_t> loop) const {
  const auto between_doubles = [this](std::uint32_t corner, std::size_t k) { return between(corner, k); };
  const auto exactly = [this](std::uint32_t corner, std::size_t k) -> const Rational& {
    return k == 0 ? rational(corner).x : rational(corner).y;
  };
  const Unsure<Sign> quick = doubled_area(loop, between_doubles).sign();
  return quick.certain() ? quick.value() : doubled_area(loop, exactly).sign();
}

}  // namespace plumb::surface
