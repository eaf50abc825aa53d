// Sides of planes and distances from them as CGAL states them.
//
// Of a plane or line that its points do not span, the formulas give zero, and so do these.
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

using Line3 = Kernel::Line_3;
using Plane3 = Kernel::Plane_3;

Sign compare(const Number& a, const Number& b) { return of(CGAL::compare(a, b)); }

std::optional<Sign> by_normal(std::string_view predicate, Arguments p) {
  const bool line = predicate == "side_of_line" || predicate == "normal_distance_against2d";
  if (line) {
    const auto n = p.vector2();
    const Kernel::Line_2 l(n.x(), n.y(), -p.number());
    const auto x = p.point2();
    if (predicate == "side_of_line") return of(l.oriented_side(x));
    const Number d = p.number(), o = l.c();
    return n == CGAL::NULL_VECTOR ? of(o * o) : compare(CGAL::squared_distance(x, l), d * d);
  }
  const auto n = p.vector3();
  const Plane3 h(n.x(), n.y(), n.z(), -p.number());
  const auto x = p.point3();
  if (predicate == "side_of_plane") return of(h.oriented_side(x));
  const Number d = p.number(), o = h.d();
  return n == CGAL::NULL_VECTOR ? of(o * o) : compare(CGAL::squared_distance(x, h), d * d);
}

}  // namespace

std::optional<Sign> planes_by_cgal(std::string_view predicate, Arguments p) {
  if (predicate.starts_with("side_of_") || predicate.starts_with("normal_distance_against")) {
    return by_normal(predicate, p);
  }
  const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
  if (predicate == "plane_distance_against") {
    if (CGAL::collinear(a, b, c)) return Sign::zero;
    return compare(CGAL::squared_distance(d, Plane3(a, b, c)), CGAL::square(p.number()));
  }
  const auto e = p.point3();
  if (predicate == "signed_plane_distance") return of(CGAL::compare_signed_distance_to_plane(a, b, c, d, e));
  if (predicate == "plane_distance_sum") {  // against the distance of e's mirror image at a
    return of(CGAL::compare_signed_distance_to_plane(a, b, c, d, a - (e - a)));
  }
  const auto f = p.point3();
  if (predicate == "compare_point_plane") {
    if (CGAL::collinear(c, d, e)) return Sign::zero;
    return compare(CGAL::squared_distance(a, b), CGAL::squared_distance(f, Plane3(c, d, e)));
  }
  const auto g = p.point3();
  if (predicate == "compare_line_plane") {
    if (a == b || CGAL::collinear(d, e, f)) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line3(a, b)), CGAL::squared_distance(g, Plane3(d, e, f)));
  }
  const auto h = p.point3();
  if (predicate == "compare_plane_plane") {
    if (CGAL::collinear(a, b, c) || CGAL::collinear(e, f, g)) return Sign::zero;
    return compare(CGAL::squared_distance(d, Plane3(a, b, c)), CGAL::squared_distance(h, Plane3(e, f, g)));
  }
  return std::nullopt;
}

}  // namespace plumb::oracle
