#include "plumb/space/bsp/bsp_motion.hpp"

#include <algorithm>

#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"
#include "plumb/space/bsp/bsp_point.hpp"
#include "space/bsp/plane_side.hpp"

namespace plumb {
namespace {

/// A box around all that the shape passes, rounded outward.
Aabb3 swept_box(const Aabb3& box, const Vector3& by) {
  const auto low = [](double x, double d) { return std::min(x, Interval::sum_down(x, d)); };
  const auto high = [](double x, double d) { return std::max(x, Interval::sum_up(x, d)); };
  return {{low(box.min.x, by.x), low(box.min.y, by.y), low(box.min.z, by.z)},
          {high(box.max.x, by.x), high(box.max.y, by.y), high(box.max.z, by.z)}};
}

/// Which sides of a node's plane have points of the box?
struct BoxSides {
  bool front = false, back = false;
};

BoxSides sides_of(const BspTree& tree, const BspNode& node, const Aabb3& box) {
  BoxSides sides;
  for (int i = 0; i < 8 && !(sides.front && sides.back); ++i) {
    const Point3 corner{(i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                        (i & 4) != 0 ? box.max.z : box.min.z};
    const Sign s = space::node_side(tree, node, corner);
    sides.front |= s != Sign::negative;
    sides.back |= s != Sign::positive;
  }
  return sides;
}

bool box_meets_face(const BspTree& tree, std::uint32_t face, const Aabb3& box) {
  const std::uint32_t count = tree.mesh.first[face + 1] - tree.mesh.first[face];
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    bool below = true, above = true;
    for (std::uint32_t i = 0; i < count; ++i) {
      const double x = space::along_axis(tree.vertex(face, i), axis);
      below &= x < space::along_axis(box.min, axis);
      above &= x > space::along_axis(box.max, axis);
    }
    if (below || above) return false;
  }
  return true;
}

/// Those that may have a point in the box, ascending.
std::vector<std::uint32_t> faces_meeting(const BspTree& tree, const Aabb3& box) {
  std::vector<std::uint32_t> faces;
  std::vector<BspChild> todo{tree.root};
  while (!todo.empty()) {
    const BspChild at = todo.back();
    todo.pop_back();
    if (at.is_leaf()) continue;
    const BspNode& node = tree.nodes[at.index()];
    const BoxSides sides = sides_of(tree, node, box);
    if (sides.front) todo.push_back(node.front);
    if (sides.back) todo.push_back(node.back);
    if (!sides.front || !sides.back) continue;
    for (std::uint32_t i = tree.first_piece[at.index()]; i < tree.first_piece[at.index() + 1]; ++i) {
      if (box_meets_face(tree, tree.pieces[i].face, box)) faces.push_back(tree.pieces[i].face);
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

template <class Shape>
Aabb3 box_of(const Shape& shape) {
  return fit_aabb(shape);
}
Aabb3 box_of(const Aabb3& box) { return box; }

Point3 point_of(const Sphere3& s) { return s.center; }
Point3 point_of(const Capsule3& s) { return s.a; }
Point3 point_of(const Aabb3& s) { return s.min; }
Point3 point_of(const ConvexPolyhedron3& s) { return s.mesh.vertices.front(); }

template <class Shape>
std::optional<BspTouch> touch_of(const BspTree& tree, const Translating<Shape>& moving) {
  if (tree.kind != BspKind::solid_leaf)
    throw InvalidShape("first_touch: the tree has no solid leaves; build_bsp with BspKind::solid_leaf");
  const auto at_rest = first_contact(moving, moving.shape);  // looks whether it is a shape that moves
  if (!at_rest) throw InvalidShape("first_touch: the shape is empty");
  std::optional<Root> first;
  std::uint32_t nearest = 0xffffffff;
  Triangle3 there{};
  for (const std::uint32_t f : faces_meeting(tree, swept_box(box_of(moving.shape), moving.by))) {
    const std::uint32_t count = tree.mesh.first[f + 1] - tree.mesh.first[f];
    for (std::uint32_t k = 1; k + 1 < count; ++k) {
      const Triangle3 triangle{tree.vertex(f, 0), tree.vertex(f, k), tree.vertex(f, k + 1)};
      const auto time = first_contact_time(moving, triangle);
      if (!time || (first && !(*time < *first))) continue;
      first = time;
      nearest = f;
      there = triangle;
    }
  }
  // Where it touches no face at first, it is within as a whole, or outside.
  const bool touches_at_once = first && !(*first > Rational(0));
  if (!touches_at_once && locate(tree, point_of(moving.shape)) == Location::inside)
    return BspTouch{0xffffffff, {0, {}, {}}, true};
  if (!first) return {};
  return BspTouch{nearest, *first_contact(moving, there), false};
}

}  // namespace

std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Sphere3>& moving) {
  return touch_of(tree, moving);
}
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Capsule3>& moving) {
  return touch_of(tree, moving);
}
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<Aabb3>& moving) {
  return touch_of(tree, moving);
}
std::optional<BspTouch> first_touch(const BspTree& tree, const Translating<ConvexPolyhedron3>& moving) {
  return touch_of(tree, moving);
}

}  // namespace plumb
