// Comparisons of distances from points and lines as CGAL states them, or from its squared distances.
//
// Of a line whose two points are one, the formulas give zero, and so do these.
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

using Line2 = Kernel::Line_2;
using Line3 = Kernel::Line_3;

Sign compare(const Number& a, const Number& b) { return of(CGAL::compare(a, b)); }

std::optional<Sign> in_plane(std::string_view predicate, Arguments& p) {
  const auto a = p.point2(), b = p.point2();
  if (predicate == "distance_against2d") return of(CGAL::compare_squared_distance(a, b, CGAL::square(p.number())));
  const auto c = p.point2();
  if (predicate == "compare_distance_from2d") return of(Kernel().compare_distance_2_object()(a, b, c));
  if (predicate == "line_distance_against2d") {
    if (a == b) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line2(a, b)), CGAL::square(p.number()));
  }
  const auto d = p.point2();
  if (predicate == "compare_distance2d") return of(Kernel().compare_distance_2_object()(a, b, c, d));
  if (predicate == "signed_line_distance") return of(CGAL::compare_signed_distance_to_line(a, b, c, d));
  if (predicate == "line_distance_sum") {  // against the distance of d's mirror image at a
    return of(CGAL::compare_signed_distance_to_line(a, b, c, a - (d - a)));
  }
  const auto e = p.point2();
  if (predicate == "compare_point_line2d") {
    if (c == d) return Sign::zero;
    return compare(CGAL::squared_distance(a, b), CGAL::squared_distance(e, Line2(c, d)));
  }
  const auto f = p.point2();
  if (predicate == "compare_line_line2d") {
    if (a == b || d == e) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line2(a, b)), CGAL::squared_distance(f, Line2(d, e)));
  }
  return std::nullopt;
}

std::optional<Sign> in_space(std::string_view predicate, Arguments& p) {
  const auto a = p.point3(), b = p.point3();
  if (predicate == "distance_against3d") return of(CGAL::compare_squared_distance(a, b, CGAL::square(p.number())));
  const auto c = p.point3();
  if (predicate == "compare_distance_from3d") return of(Kernel().compare_distance_3_object()(a, b, c));
  if (predicate == "line_distance_against3d") {
    if (a == b) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line3(a, b)), CGAL::square(p.number()));
  }
  const auto d = p.point3();
  if (predicate == "compare_distance3d") return of(Kernel().compare_distance_3_object()(a, b, c, d));
  if (predicate == "compare_line_distance") {
    if (a == b) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line3(a, b)), CGAL::squared_distance(d, Line3(a, b)));
  }
  const auto e = p.point3();
  if (predicate == "compare_point_line3d") {
    if (c == d) return Sign::zero;
    return compare(CGAL::squared_distance(a, b), CGAL::squared_distance(e, Line3(c, d)));
  }
  const auto f = p.point3();
  if (predicate == "compare_line_line3d") {
    if (a == b || d == e) return Sign::zero;
    return compare(CGAL::squared_distance(c, Line3(a, b)), CGAL::squared_distance(f, Line3(d, e)));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Sign> distances_by_cgal(std::string_view predicate, Arguments p) {
  Arguments again = p;
  const auto sign = in_plane(predicate, p);
  return sign ? sign : in_space(predicate, again);
}

}  // namespace plumb::oracle
