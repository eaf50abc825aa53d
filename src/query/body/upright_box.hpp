// Where are the faces of an axis-aligned box that stands or is moved without a turn?  Each at a sum of two numbers, which two
// doubles hold.
//
// Laws: exact; places compare as the sums do.
// Source: Knuth, TAOCP 4.2.2.
// Cost: six additions a face.
#pragma once

#include <array>
#include <compare>
#include <optional>

#include "plumb/arith/error_free.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb::query {

/// Where a face is: the sum of two numbers, in two doubles of which the first is the nearest to it.  Rounding keeps the
/// order, so the first ones tell it unless they are equal.
struct FacePlace {
  double nearest = 0, rest = 0;
  double given = 0, moved = 0;

  FacePlace() = default;
  FacePlace(double at, double by) : given(at), moved(by) {
    const Rounded sum = two_sum(at, by);
    nearest = sum.value, rest = sum.error;
  }
  [[nodiscard]] std::strong_ordering against(const FacePlace& other) const {
    const auto order = [](double x, double y) {
      return x == y ? std::strong_ordering::equal : x < y ? std::strong_ordering::less : std::strong_ordering::greater;
    };
    const auto first = order(nearest, other.nearest);
    return first != 0 ? first : order(rest, other.rest);
  }
  [[nodiscard]] bool is_finite() const { return nearest - nearest == 0; }
  template <class Maker>
  [[nodiscard]] auto number(const Maker& maker) const {
    return maker(given) + maker(moved);
  }
};

struct UprightBox {
  std::array<FacePlace, 3> low, high;
};

/// Nothing unless it is a box with an inside and finite numbers, not turned.
inline std::optional<UprightBox> upright_box(const PosedView& v) {
  if (v.figure.kind != FigureKind::aabb || v.figure.dimension != 3) return {};
  Vector3 by{0, 0, 0};
  if (!v.pose.stands()) {
    const auto* pose = std::get_if<const RigidPose*>(&v.pose.by);
    if (pose == nullptr) return {};
    const auto& [w, x, y, z] = (*pose)->turn;
    if (!(w - w == 0) || w == 0 || x != 0 || y != 0 || z != 0) return {};
    by = (*pose)->translation;
  }
  const auto& [low, high] = *static_cast<const Aabb3*>(v.figure.shape);
  const UprightBox box{{FacePlace{low.x, by.x}, {low.y, by.y}, {low.z, by.z}},
                       {FacePlace{high.x, by.x}, {high.y, by.y}, {high.z, by.z}}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!box.low[k].is_finite() || !box.high[k].is_finite() || box.low[k].against(box.high[k]) >= 0) return {};
  }
  return box;
}

}  // namespace plumb::query
