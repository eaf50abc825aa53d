#include <array>

#include "figure/basic/chain_convexity.hpp"
#include "figure/basic/chain_input.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/certify/coplanar.hpp"

namespace plumb {
namespace {

bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// What happens along a chain.
struct Course {
  bool left = false, right = false;  // it turns
  bool straight = false;             // it passes a vertex without turning
  bool back = false;                 // it turns about, by 180 degrees
  bool repeated = false;             // a vertex is equal to the one before it
  int changes = 0;                   // between going up and going down in the lexicographic order

  void pass(const Point2& a, const Point2& b, const Point2& c) {
    const bool change = before(a, b) != before(b, c);
    changes += change;
    switch (orient2d(a, b, c)) {
      case Sign::positive:
        left = true;
        break;
      case Sign::negative:
        right = true;
        break;
      case Sign::zero:
        (change ? back : straight) = true;
    }
  }
};

Course course_of(std::span<const Point2> chain) {
  Course course;
  std::size_t last = chain.size() - 1;  // the last vertex that is not equal to the first
  while (last > 0 && chain[last] == chain[0]) --last;
  course.repeated = last + 1 < chain.size();
  if (last == 0) return course;
  Point2 a = chain[last], b = chain[0];
  for (std::size_t i = 1; i <= last; ++i) {
    if (chain[i] == b) {
      course.repeated = true;
      continue;
    }
    course.pass(a, b, chain[i]);
    a = b;
    b = chain[i];
  }
  course.pass(a, b, chain[0]);
  return course;
}

}  // namespace

PolygonConvexity chain_convexity(std::span<const Point2> chain) {
  const Course course = course_of(chain);
  if (!course.left && !course.right) return {PolygonKind::degenerate, Sign::zero, 0};
  if (course.back || (course.left && course.right))
    return {PolygonKind::concave, figure::signed_sums::area_sign(chain), 0};
  const Sign side = course.left ? Sign::positive : Sign::negative;
  const int turns = course.changes / 2;
  if (turns > 1) return {PolygonKind::self_winding, side, turns};
  return {course.straight || course.repeated ? PolygonKind::convex : PolygonKind::strictly_convex, side, turns};
}

namespace {

QuadrilateralKind kind_of(const std::array<Point2, 4>& q) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Sign turn = orient2d(q[i], q[(i + 1) % 4], q[(i + 2) % 4]);
    left += turn == Sign::positive;
    right += turn == Sign::negative;
  }
  if (left + right == 0) return QuadrilateralKind::degenerate;
  if (left + right < 4) return QuadrilateralKind::three_collinear;
  if (left == 4 || right == 4) return QuadrilateralKind::convex;
  return left == right ? QuadrilateralKind::bowtie : QuadrilateralKind::concave;
}

template <class Quadrilateral>
void require_corners(std::string_view function, const Quadrilateral& q) {
  require_finite_parts(
      function,
      std::array<std::string_view, 4>{"quadrilateral.a", "quadrilateral.b", "quadrilateral.c", "quadrilateral.d"}, q.a,
      q.b, q.c, q.d);
}

/// For points of one plane that are not all on one line; else nothing.
std::optional<Look> look_at(std::span<const Point3> points, const PlaneOfPoints& plane) {
  if (plane.dimension != 2) return {};
  return look_at_plane(points[plane.span[0]], points[plane.span[1]], points[plane.span[2]]);
}

}  // namespace

QuadrilateralKind quadrilateral_kind(const Quadrilateral2& q) {
  require_corners("quadrilateral_kind", q);
  return kind_of({q.a, q.b, q.c, q.d});
}

QuadrilateralKind quadrilateral_kind(const Quadrilateral3& q) {
  require_corners("quadrilateral_kind", q);
  const std::array corners{q.a, q.b, q.c, q.d};
  const PlaneOfPoints plane = plane_of_points(corners);
  if (plane.dimension == 3) return QuadrilateralKind::not_planar;
  const auto look = look_at(corners, plane);
  if (!look) return QuadrilateralKind::degenerate;
  return kind_of({projected(*look, q.a), projected(*look, q.b), projected(*look, q.c), projected(*look, q.d)});
}

bool is_convex(const Quadrilateral2& q) { return quadrilateral_kind(q) == QuadrilateralKind::convex; }
bool is_convex(const Quadrilateral3& q) { return quadrilateral_kind(q) == QuadrilateralKind::convex; }

bool diagonals_part(const Quadrilateral3& q) {
  require_corners("diagonals_part", q);
  return coplanar_orientation(q.b, q.d, q.a, q.c) == Sign::negative &&
         coplanar_orientation(q.a, q.c, q.b, q.d) == Sign::negative;
}

PolygonConvexity convexity(const Polygon2& polygon) {
  require_chain<Point2>("convexity", "polygon.vertices", polygon.vertices);
  return chain_convexity(polygon.vertices);
}

PolygonConvexity convexity(const Polygon3& polygon) {
  require_chain<Point3>("convexity", "polygon.vertices", polygon.vertices);
  const PlaneOfPoints plane = plane_of_points(polygon.vertices);
  if (plane.dimension == 3) return {PolygonKind::not_planar, Sign::zero, 0};
  const auto look = look_at(polygon.vertices, plane);
  if (!look) return {PolygonKind::degenerate, Sign::zero, 0};
  std::vector<Point2> flat;
  flat.reserve(polygon.vertices.size());
  for (const Point3& v : polygon.vertices) flat.push_back(projected(*look, v));
  return chain_convexity(flat);
}

bool is_convex(const Polygon2& polygon) { return convexity(polygon).is_convex(); }
bool is_convex(const Polygon3& polygon) { return convexity(polygon).is_convex(); }

bool is_planar(const Quadrilateral3& q) {
  require_corners("is_planar", q);
  return orient3d(q.a, q.b, q.c, q.d) == Sign::zero;
}

bool is_planar(const Polygon3& polygon) {
  require_chain<Point3>("is_planar", "polygon.vertices", polygon.vertices);
  return plane_of_points(polygon.vertices).dimension < 3;
}

Sign orientation(const Polygon2& polygon) {
  require_chain<Point2>("orientation", "polygon.vertices", polygon.vertices);
  return figure::signed_sums::area_sign(polygon.vertices);
}

}  // namespace plumb
