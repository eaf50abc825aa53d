#include "surface/solid/plane_view.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/predicates.hpp"

namespace plumb::surface {
namespace {

Sign turn_along(const std::array<Point3, 3>& p, int axis) {
  return orient2d(shadow(p[0], axis), shadow(p[1], axis), shadow(p[2], axis));
}

}  // namespace

Point2 shadow(const Point3& p, int axis) {
  return axis == 2 ? Point2{p.x, p.y} : axis == 0 ? Point2{p.y, p.z} : Point2{p.z, p.x};
}

ExactPoint2 shadow(const ExactPoint3& p, int axis) {
  if (const auto* given = std::get_if<Point3>(&p.as())) return shadow(*given, axis);
  const RationalPoint3 exact = rational_point(p);
  if (axis == 2) return RationalPoint2{exact.x, exact.y};
  return axis == 0 ? RationalPoint2{exact.y, exact.z} : RationalPoint2{exact.z, exact.x};
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

PlaneView::PlaneView(const std::array<Point3, 3>& points) : points_(points) {
  for (const int axis : guessed_axes(points)) {
    const Sign turn = turn_along(points, axis);
    if (turn == Sign::zero) continue;
    axis_ = axis;
    turned_ = turn == Sign::negative;
    break;
  }
  if (turned_) std::swap(points_[1], points_[2]);
}

ExactPoint2 PlaneView::seen(const ExactPoint3& p) const { return shadow(p, axis_); }

Sign PlaneView::side(const ExactPoint3& p) const {
  if (const auto* given = std::get_if<Point3>(&p.as())) return side(*given);
  return -orient3d(ExactPoint3(points_[0]), ExactPoint3(points_[1]), ExactPoint3(points_[2]), p);
}

Sign PlaneView::side(const Point3& p) const { return -orient3d(points_[0], points_[1], points_[2], p); }

std::array<Sign, 3> PlaneView::normal_signs() const {
  return {turn_along(points_, 0), turn_along(points_, 1), turn_along(points_, 2)};
}

}  // namespace plumb::surface
