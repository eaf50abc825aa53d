#include "surface/solid/numbered_points.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/predicates.hpp"

namespace plumb::surface {

Sign NumberedPoints::order(std::uint32_t a, std::uint32_t b) const {
  if (is_given(a) && is_given(b)) return sign_of_number((a > b) - (a < b));  // as they ascend
  if (!is_given(a) && !is_given(b)) return compare_xyz(held[a - given.size()], held[b - given.size()]);
  return compare_xyz(at(a), at(b));
}

Sign NumberedPoints::orient(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
  if (is_given(a) && is_given(b) && is_given(c) && is_given(d)) [[likely]]
    return orient3d(given[a], given[b], given[c], given[d]);
  return orient3d(at(a), at(b), at(c), at(d));
}

bool NumberedPoints::is_straight(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if (is_given(a) && is_given(b) && is_given(c)) [[likely]]
    return collinear(given[a], given[b], given[c]);
  return collinear(at(a), at(b), at(c));
}

Sign NumberedPoints::turn_along(int axis, std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  if (is_given(a) && is_given(b) && is_given(c)) [[likely]]
    return orient2d(shadow(given[a], axis), shadow(given[b], axis), shadow(given[c], axis));
  return certify::turn_along(axis, at(a), at(b), at(c));
}

Point2 shadow(const Point3& p, int axis) {
  return axis == 2 ? Point2{p.x, p.y} : axis == 0 ? Point2{p.y, p.z} : Point2{p.z, p.x};
}

ExactPoint2 shadow(const ExactPoint3& p, int axis) {
  if (const auto* given = std::get_if<Point3>(&p.as())) return shadow(*given, axis);
  const auto first = static_cast<std::size_t>(axis == 2 ? 0 : axis + 1), second = (first + 1) % 3;
  const auto flat = [one = first, other = second](const RationalPoint3& exact) {
    const std::array<const Rational*, 3> x{&exact.x, &exact.y, &exact.z};
    return ExactPoint2(RationalPoint2{*x[one], *x[other]});
  };
  const auto* held = std::get_if<RationalPoint3>(&p.as());
  ExactPoint2 seen = held != nullptr ? flat(*held) : flat(rational_point(p));
  const auto& known = p.cache();
  if (known.is_known())
    seen.cache().keep({known.nearest(first), known.nearest(second)}, {known.is_exact(first), known.is_exact(second)});
  return seen;
}

// This is a guess; who takes an axis of it asks for the turn along it.
std::array<int, 3> guessed_axes(const std::array<Point3, 3>& p) {
  std::array<double, 3> size{};
  for (int axis = 0; axis < 3; ++axis) {
    const Point2 a = shadow(p[0], axis), b = shadow(p[1], axis), c = shadow(p[2], axis);
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    size[static_cast<std::size_t>(axis)] = area >= 0 ? area : 0;
  }
  std::array<int, 3> axes{2, 0, 1};
  std::ranges::stable_sort(
      axes, [&](int l, int r) { return size[static_cast<std::size_t>(l)] > size[static_cast<std::size_t>(r)]; });
  return axes;
}

}  // namespace plumb::surface
