// Rectangles as what stands on them: boxes of height two, whose third axis is that of space.
#include "figure/basic/in_space.hpp"
#include "figure/obb/enclose.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb {
namespace {

constexpr Vector3 upward{0, 0, 1};

Obb3 raised(const Obb2& box) {
  return {
      in_space(box.center), {in_space(box.axes[0]), in_space(box.axes[1]), upward}, {box.half.x, box.half.y, upward.z}};
}

// What lies in the plane, of a box that stands on it: of three axes one is upright, and the others have no height.
Obb2 flattened(const Obb3& box) {
  const std::array half{box.half.x, box.half.y, box.half.z};
  const auto flat = [&](std::size_t i) { return Vector2{box.axes[i].x, box.axes[i].y}; };
  const std::size_t up = box.axes[2].z != 0 ? 2 : box.axes[1].z != 0 ? 1 : 0;
  const std::size_t first = up == 0 ? 1 : 0, second = up == 2 ? 1 : 2;
  return {{box.center.x, box.center.y}, {flat(first), flat(second)}, {half[first], half[second]}};
}

}  // namespace

Obb2 oriented_box(const Aabb2& box) {
  const Obb3 raised_box = oriented_box(Aabb3{{box.min.x, box.min.y, -upward.z}, {box.max.x, box.max.y, upward.z}});
  return flattened(raised_box);
}

// Of boxes of one height the volumes are as the areas.
Obb2 merge(const Obb2& a, const Obb2& b) { return flattened(merge(raised(a), raised(b))); }

Obb2 transform(const Obb2& box, PoseView2 pose) {
  figure::require_sound("transform", box);
  figure::require_sound("transform", pose);
  return flattened(figure::enclosing::transformed(raised(box), figure::CertainPose(pose)));
}

}  // namespace plumb
