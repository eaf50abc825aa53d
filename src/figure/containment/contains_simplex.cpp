// Triangles and tetrahedra.  Where one is flat, it is the union of its edges or faces.
#include "figure/containment/contains_input.hpp"
#include "plumb/certify/coplanar.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb {
namespace figure::containment {
namespace {

Sign orient2d(const Point2& a, const Point2& b, const Point2& c) { return sign_of(predicates::Orient2d{}, a, b, c); }
Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return sign_of(predicates::Orient3d{}, a, b, c, d);
}

/// Of three collinear points: is p between two of them?
template <class Point>
bool on_edges(const Point& a, const Point& b, const Point& c, const Point& p) {
  return are_ordered_along_line(a, p, b) || are_ordered_along_line(b, p, c) || are_ordered_along_line(c, p, a);
}

/// Of the signs of p to the sides of a simplex, each times that of the simplex.
template <std::size_t N>
Location within(const std::array<Sign, N>& sides) {
  Location all = Location::inside;
  for (const Sign s : sides) all = both(all, location(-s));
  return all;
}

}  // namespace

bool in_triangle(const Point3& a, const Point3& b, const Point3& c, const Point3& p) {
  if (orient3d(a, b, c, p) != Sign::zero) return false;
  const Sign turn = coplanar_orientation(a, b, c);
  if (turn == Sign::zero) return on_edges(a, b, c, p);
  const auto beyond = [&](const Point3& from, const Point3& to) {
    return coplanar_orientation(from, to, p) * turn == Sign::negative;
  };
  return !beyond(a, b) && !beyond(b, c) && !beyond(c, a);
}

}  // namespace figure::containment

using namespace figure::containment;

Location locate(const Triangle2& triangle, const Point2& p) {
  const auto& [a, b, c] = triangle;
  figure::require_sound("contains", triangle, part::place("p", p));
  const Sign turn = orient2d(a, b, c);
  if (turn == Sign::zero) return boundary_if(on_edges(a, b, c, p));
  return within(std::array{orient2d(a, b, p) * turn, orient2d(b, c, p) * turn, orient2d(c, a, p) * turn});
}

Location locate(const Triangle3& triangle, const Point3& p) {
  const auto& [a, b, c] = triangle;
  figure::require_sound("contains", triangle, part::place("p", p));
  return boundary_if(in_triangle(a, b, c, p));
}

Location locate(const Tetrahedron3& tetrahedron, const Point3& p) {
  const auto& [a, b, c, d] = tetrahedron;
  figure::require_sound("contains", tetrahedron, part::place("p", p));
  const Sign turn = orient3d(a, b, c, d);
  if (turn == Sign::zero) {  // two faces on a diagonal cover it, or one, or the three around a corner: never all four
    return boundary_if(in_triangle(a, b, c, p) || in_triangle(a, b, d, p) || in_triangle(b, c, d, p));
  }
  return within(std::array{orient3d(p, b, c, d) * turn, orient3d(a, p, c, d) * turn, orient3d(a, b, p, d) * turn,
                           orient3d(a, b, c, p) * turn});
}

}  // namespace plumb
