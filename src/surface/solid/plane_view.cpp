#include "surface/solid/plane_view.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/predicates.hpp"

namespace plumb::surface {
namespace {

std::array<std::size_t, 2> axes_across(int axis) {
  const auto first = static_cast<std::size_t>(axis == 2 ? 0 : axis + 1);
  return {first, (first + 1) % 3};
}

Sign turn_along(const std::array<Point3, 3>& p, int axis) {
  return orient2d(shadow(p[0], axis), shadow(p[1], axis), shadow(p[2], axis));
}

}  // namespace

Point2 shadow(const Point3& p, int axis) {
  return axis == 2 ? Point2{p.x, p.y} : axis == 0 ? Point2{p.y, p.z} : Point2{p.z, p.x};
}

ExactPoint2 shadow(const ExactPoint3& p, int axis) {
  if (const auto* given = std::get_if<Point3>(&p.as())) return shadow(*given, axis);
  const auto [first, second] = axes_across(axis);
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

PlaneView::PlaneView(const std::array<Point3, 3>& points) : plane_{points} {
  for (const int axis : guessed_axes(points)) {
    const Sign turn = turn_along(points, axis);
    if (turn == Sign::zero) continue;
    axis_ = axis;
    if (turn == Sign::negative) std::swap(plane_.points[1], plane_.points[2]);
    break;
  }
}

ExactPoint2 PlaneView::seen(const ExactPoint3& p) const { return shadow(p, axis_); }

std::array<std::size_t, 2> PlaneView::seen_axes() const { return axes_across(axis_); }

Sign TurnedPlane::side(const ExactPoint3& p) const {
  if (const auto* given = std::get_if<Point3>(&p.as())) return side(*given);
  return -orient3d(ExactPoint3(points[0]), ExactPoint3(points[1]), ExactPoint3(points[2]), p);
}

Sign TurnedPlane::side(const Point3& p) const { return -orient3d(points[0], points[1], points[2], p); }

std::array<Sign, 3> TurnedPlane::normal_signs() const {
  return {turn_along(points, 0), turn_along(points, 1), turn_along(points, 2)};
}

}  // namespace plumb::surface
