#include "surface/solid/plane_view.hpp"

#include <utility>

namespace plumb::surface {

PlaneView::PlaneView(const NumberedPoints& points, const TriangleMesh::Triangle& corners) : plane_{corners} {
  const auto& [a, b, c] = corners;
  for (const int axis : guessed_axes({points.nearest(a), points.nearest(b), points.nearest(c)})) {
    const Sign turn = points.turn_along(axis, a, b, c);
    if (turn == Sign::zero) continue;
    axis_ = axis;
    if (turn == Sign::negative) std::swap(plane_.corners[1], plane_.corners[2]);
    break;
  }
}

ExactPoint2 PlaneView::seen(const ExactPoint3& p) const { return shadow(p, axis_); }

std::array<std::size_t, 2> PlaneView::seen_axes() const {
  const auto first = static_cast<std::size_t>(axis_ == 2 ? 0 : axis_ + 1);
  return {first, (first + 1) % 3};
}

Sign TurnedPlane::side(const NumberedPoints& points, std::uint32_t p) const {
  return -points.orient(corners[0], corners[1], corners[2], p);
}

std::array<Sign, 3> TurnedPlane::normal_signs(const NumberedPoints& points) const {
  const auto& [a, b, c] = corners;
  return {points.turn_along(0, a, b, c), points.turn_along(1, a, b, c), points.turn_along(2, a, b, c)};
}

}  // namespace plumb::surface
