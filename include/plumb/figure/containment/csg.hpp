// Constructive solid geometry (CSG): where does a point lie to what is made of shapes by union, intersection,
// difference and complement?
//
//   const Csg3 nut = (csg(hexagon) & csg(chamfer)) - csg(bore);
//   if (const auto where = locate(nut, p)) ...
//
// contains and locate speak of the closed set of the tree: complements are taken down to the leaves (De Morgan), a
// leaf's complement is the closure of what is not in it, so that its boundary belongs to both; unions and intersections
// are those of the closed sets.  Hence shapes that touch still touch, and a - a is the boundary of a.
// locate_regularized speaks of the solid: of every result the closure of its interior, as modelers have it; two boxes
// side by side have no intersection, a - a is empty, and leaves without interior vanish.
// Laws: (1) contains is exact, for leaves of any kind.  (2) A location that is told is exact; locate tells none where
// two boundaries meet in a union, or where a point is on the boundary of the complement of a leaf that is not known to
// be regular: the leaves' locations do not tell there whether the point is on the boundary or inside.  Likewise
// locate_regularized: none where two boundaries meet, or at the boundary of a leaf not known to be regular.
// (3) contains is `locate is not outside`, whether told or not; locate never leaves that open.  (4) a | b, a & b do not
// depend on order, ~~a is a, ~(a | b) is ~a & ~b, a - b is a & ~b.
// A leaf is taken at its word, and looked at when it is made: NonFinite and InvalidShape are thrown then, by its
// locate.
// Source: RTCD 2.2.1; Requicha 1980 for regularized sets.
// Cost: each leaf is asked once; a tree is a value, and combining two copies their steps, not the shapes.  Nothing is
// searched.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/figure/containment/contains.hpp"

namespace plumb {

/// Is the shape known to be empty or the closure of its interior?  For types without an overload it is not known.
template <class Shape>
bool is_regular(const Shape&) {
  return false;
}
bool is_regular(const Plane3& plane);
bool is_regular(const Halfspace2& halfspace);
bool is_regular(const Halfspace3& halfspace);
bool is_regular(const Slab2& slab);
bool is_regular(const Slab3& slab);
bool is_regular(const HalfspaceIntersection2& intersection);
bool is_regular(const HalfspaceIntersection3& intersection);
bool is_regular(const Triangle2& triangle);
bool is_regular(const Tetrahedron3& tetrahedron);
bool is_regular(const Circle2& circle);
bool is_regular(const Sphere3& sphere);
bool is_regular(const Capsule2& capsule);
bool is_regular(const Capsule3& capsule);
bool is_regular(const Lozenge3& lozenge);
bool is_regular(const Cylinder3& cylinder);
bool is_regular(const Cone3& cone);
bool is_regular(const Ellipsoid3& ellipsoid);
bool is_regular(const Aabb2& box);
bool is_regular(const Aabb3& box);
bool is_regular(const AabbWidths3& box);
bool is_regular(const AabbCenter3& box);
bool is_regular(const Obb2& box);
bool is_regular(const Obb3& box);

template <class Point>
class Csg {
 public:
  /// A shape whose type the tree need not know.
  struct Leaf {
    std::shared_ptr<const void> shape;
    Location (*locate)(const void* shape, const Point& p);
    bool regular;
    const void* type = nullptr;  // figure::shape_tag of the shape
  };

  explicit Csg(Leaf leaf) : steps_{{Operation::leaf, 0}}, leaves_{std::move(leaf)} {}

  friend Csg operator|(Csg a, const Csg& b) {
    a.append(b, Operation::unite);
    return a;
  }
  friend Csg operator&(Csg a, const Csg& b) {
    a.append(b, Operation::intersect);
    return a;
  }
  friend Csg operator-(Csg a, const Csg& b) {
    a.append(~b, Operation::intersect);
    return a;
  }
  friend Csg operator~(Csg a) {
    a.complement();
    return a;
  }

  [[nodiscard]] std::size_t leaf_count() const { return leaves_.size(); }
  [[nodiscard]] const Leaf& leaf(std::size_t i) const { return leaves_[i]; }

  /// Does the tree hold what is_in(i, complemented) says of leaf i or of its complement?
  template <class IsIn>
  [[nodiscard]] bool holds_what(const IsIn& is_in) const {
    std::vector<char> stack;
    for (const Step& s : steps_) {
      if (s.operation == Operation::leaf || s.operation == Operation::complemented_leaf) {
        stack.push_back(is_in(s.leaf, s.operation == Operation::complemented_leaf) ? 1 : 0);
      } else {
        const char b = stack.back();
        stack.pop_back();
        stack.back() = s.operation == Operation::unite ? stack.back() | b : stack.back() & b;
      }
    }
    return stack.back() != 0;
  }

  /// What contains, locate and locate_regularized answer.
  [[nodiscard]] bool contains(const Point& p) const;
  [[nodiscard]] std::optional<Location> locate(const Point& p) const;
  [[nodiscard]] std::optional<Location> locate_regularized(const Point& p) const;

 private:
  enum class Operation : unsigned char { leaf, complemented_leaf, unite, intersect };
  struct Step {
    Operation operation;
    std::uint32_t leaf;
  };

  void append(const Csg& other, Operation operation);
  void complement();
  template <class Rules>
  [[nodiscard]] unsigned evaluate(const Point& p, Rules rules) const;

  std::vector<Step> steps_;  // operands before what combines them
  std::vector<Leaf> leaves_;
};
using Csg2 = Csg<Point2>;
using Csg3 = Csg<Point3>;
extern template class Csg<Point2>;
extern template class Csg<Point3>;

namespace figure {

/// Whose address tells the type.
template <class Shape>
inline const char shape_tag = 0;

template <class Point, class Shape>
Csg<Point> tree_of_leaf(Shape shape) {
  static_cast<void>(locate(shape, Point{}));
  const bool regular = is_regular(shape);
  return Csg<Point>({std::make_shared<const Shape>(std::move(shape)),
                     [](const void* s, const Point& p) { return locate(*static_cast<const Shape*>(s), p); }, regular,
                     &shape_tag<Shape>});
}

}  // namespace figure

/// The tree of one leaf: of any shape that locates points.
template <class Shape>
requires LocatesPoints<Shape, Point2> Csg2 csg(Shape shape) { return figure::tree_of_leaf<Point2>(std::move(shape)); }
template <class Shape>
requires LocatesPoints<Shape, Point3> Csg3 csg(Shape shape) { return figure::tree_of_leaf<Point3>(std::move(shape)); }

/// Does the closed set of the tree contain p?
inline bool contains(const Csg2& tree, const Point2& p) { return tree.contains(p); }
inline bool contains(const Csg3& tree, const Point3& p) { return tree.contains(p); }

/// Where p lies to the closed set of the tree, where the leaves tell.
inline std::optional<Location> locate(const Csg2& tree, const Point2& p) { return tree.locate(p); }
inline std::optional<Location> locate(const Csg3& tree, const Point3& p) { return tree.locate(p); }

/// Where p lies to the regularized set of the tree, where the leaves tell.
inline std::optional<Location> locate_regularized(const Csg2& tree, const Point2& p) {
  return tree.locate_regularized(p);
}
inline std::optional<Location> locate_regularized(const Csg3& tree, const Point3& p) {
  return tree.locate_regularized(p);
}

}  // namespace plumb
