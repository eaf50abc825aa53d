// Each node's location is a set of those that its leaves leave possible: one bit for each.
#include "plumb/figure/containment/csg.hpp"

#include <algorithm>
#include <array>

#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {
namespace {

constexpr unsigned out = 1, on = 2, in = 4;

constexpr unsigned only(Location where) { return 1u << (static_cast<int>(where) + 1); }

constexpr std::optional<Location> told(unsigned possible) {
  if (possible == out) return Location::outside;
  if (possible == on) return Location::boundary;
  if (possible == in) return Location::inside;
  return {};
}

/// What results from any of these and any of those, given what does from two boundaries.
constexpr unsigned united(unsigned a, unsigned b, unsigned boundaries) {
  unsigned possible = 0;
  if (((a | b) & in) != 0) possible |= in;
  if ((a & out) != 0) possible |= b;
  if ((b & out) != 0) possible |= a;
  if ((a & b & on) != 0) possible |= boundaries;
  return possible;
}
/// Inside for outside and the other way around.
constexpr unsigned mirrored(unsigned a) { return (a & on) | ((a & out) << 2) | ((a & in) >> 2); }
constexpr unsigned intersected(unsigned a, unsigned b, unsigned boundaries) {
  return mirrored(united(mirrored(a), mirrored(b), mirrored(boundaries)));
}

/// Of closed sets.  Interiors of an intersection are interior to both, but two closed sets may cover a point between
/// them.
struct ClosedRules {
  static unsigned leaf(unsigned where, bool) { return where; }
  static unsigned complement(unsigned where, bool regular) {
    return where == on && !regular ? on | in : mirrored(where);
  }
  static unsigned unite(unsigned a, unsigned b) { return united(a, b, on | in); }
  static unsigned intersect(unsigned a, unsigned b) { return intersected(a, b, on); }
};

/// Of regularized sets.
struct RegularizedRules {
  static unsigned leaf(unsigned where, bool regular) { return where == on && !regular ? out | on : where; }
  static unsigned complement(unsigned where, bool regular) { return mirrored(leaf(where, regular)); }
  static unsigned unite(unsigned a, unsigned b) { return united(a, b, on | in); }
  static unsigned intersect(unsigned a, unsigned b) { return intersected(a, b, on | out); }
};

}  // namespace

template <class Point>
void Csg<Point>::append(const Csg& other, Operation operation) {
  const auto start = static_cast<std::uint32_t>(leaves_.size());
  leaves_.insert(leaves_.end(), other.leaves_.begin(), other.leaves_.end());
  for (const Step& s : other.steps_) steps_.push_back({s.operation, s.leaf + start});
  steps_.push_back({operation, 0});
}

template <class Point>
void Csg<Point>::complement() {
  constexpr std::array opposite{Operation::complemented_leaf, Operation::leaf, Operation::intersect, Operation::unite};
  for (Step& s : steps_) s.operation = opposite[static_cast<std::size_t>(s.operation)];
}

template <class Point>
template <class Rules>
unsigned Csg<Point>::evaluate(const Point& p, Rules) const {
  std::vector<unsigned> stack;
  for (const Step& s : steps_) {
    if (s.operation == Operation::leaf || s.operation == Operation::complemented_leaf) {
      const Leaf& leaf = leaves_[s.leaf];
      const unsigned where = only(leaf.locate(leaf.shape.get(), p));
      stack.push_back(s.operation == Operation::leaf ? Rules::leaf(where, leaf.regular)
                                                     : Rules::complement(where, leaf.regular));
    } else {
      const unsigned b = stack.back();
      stack.pop_back();
      unsigned& a = stack.back();
      a = s.operation == Operation::unite ? Rules::unite(a, b) : Rules::intersect(a, b);
    }
  }
  return stack.back();
}

template <class Point>
bool Csg<Point>::contains(const Point& p) const {
  return evaluate(p, ClosedRules{}) != out;
}
template <class Point>
std::optional<Location> Csg<Point>::locate(const Point& p) const {
  return told(evaluate(p, ClosedRules{}));
}
template <class Point>
std::optional<Location> Csg<Point>::locate_regularized(const Point& p) const {
  return told(evaluate(p, RegularizedRules{}));
}

template class Csg<Point2>;
template class Csg<Point3>;

namespace {

bool is_zero(const Vector2& v) { return v == Vector2{0, 0}; }
bool is_zero(const Vector3& v) { return v == Vector3{0, 0, 0}; }
bool independent(const std::array<Vector3, 3>& axes) {
  return determinant_sign(Rows<3>{coordinates(axes[0]), coordinates(axes[1]), coordinates(axes[2])}) != Sign::zero;
}
bool no_zero(const Vector3& v) { return v.x != 0 && v.y != 0 && v.z != 0; }

bool is_regular_slab(const auto& slab) { return is_zero(slab.normal) || slab.min != slab.max; }
bool is_regular_box(const auto& box) {
  const auto min = coordinates(box.min), max = coordinates(box.max);
  bool empty = false, flat = false;
  for (std::size_t i = 0; i < min.size(); ++i) {
    empty = empty || min[i] > max[i];
    flat = flat || min[i] == max[i];
  }
  return empty || !flat;
}

}  // namespace

bool is_regular(const Plane3& plane) { return is_zero(plane.normal); }
bool is_regular(const Halfspace2&) { return true; }
bool is_regular(const Halfspace3&) { return true; }
bool is_regular(const Slab2& slab) { return is_regular_slab(slab); }
bool is_regular(const Slab3& slab) { return is_regular_slab(slab); }
bool is_regular(const HalfspaceIntersection2& intersection) { return intersection.halfspaces.size() <= 1; }
bool is_regular(const HalfspaceIntersection3& intersection) { return intersection.halfspaces.size() <= 1; }
bool is_regular(const Triangle2& t) { return !collinear(t.a, t.b, t.c); }
bool is_regular(const Tetrahedron3& t) { return sign_of(predicates::Orient3d{}, t.a, t.b, t.c, t.d) != Sign::zero; }
bool is_regular(const Circle2& circle) { return circle.radius > 0; }
bool is_regular(const Sphere3& sphere) { return sphere.radius > 0; }
bool is_regular(const Capsule2& capsule) { return capsule.radius > 0; }
bool is_regular(const Capsule3& capsule) { return capsule.radius > 0; }
bool is_regular(const Lozenge3& lozenge) { return lozenge.radius > 0; }
bool is_regular(const Cylinder3& cylinder) { return cylinder.radius > 0; }
bool is_regular(const Cone3& cone) { return cone.radius > 0; }
bool is_regular(const Ellipsoid3& ellipsoid) { return no_zero(ellipsoid.half) && independent(ellipsoid.axes); }
bool is_regular(const Aabb2& box) { return is_regular_box(box); }
bool is_regular(const Aabb3& box) { return is_regular_box(box); }
bool is_regular(const AabbWidths3& box) { return no_zero(box.widths); }
bool is_regular(const AabbCenter3& box) { return no_zero(box.half); }
bool is_regular(const Obb2& box) { return box.half.x != 0 && box.half.y != 0 && !parallel(box.axes[0], box.axes[1]); }
bool is_regular(const Obb3& box) { return no_zero(box.half) && independent(box.axes); }

}  // namespace plumb
