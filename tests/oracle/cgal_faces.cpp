// The functions that compose several formulas, as CGAL states them, or from its squared distances.
//
// Shapes are closed sets here: a line or segment of two equal points is that point, a plane of collinear points a line.
#include <CGAL/squared_distance_2.h>
#include <CGAL/squared_distance_3.h>

#include "oracle/cgal_kernel.hpp"

namespace plumb::oracle {
namespace {

Number to_line(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& x) {
  return a == b ? CGAL::squared_distance(a, x) : CGAL::squared_distance(x, Kernel::Line_2(a, b));
}
Number to_line(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& x) {
  return a == b ? CGAL::squared_distance(a, x) : CGAL::squared_distance(x, Kernel::Line_3(a, b));
}

Number to_segment(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& x) {
  return a == b ? CGAL::squared_distance(a, x) : CGAL::squared_distance(x, Kernel::Segment_2(a, b));
}
Number to_segment(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& x) {
  return a == b ? CGAL::squared_distance(a, x) : CGAL::squared_distance(x, Kernel::Segment_3(a, b));
}

Number to_plane(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c,
                const Kernel::Point_3& x) {
  if (CGAL::collinear(a, b, c)) return to_line(a, a == b ? c : b, x);
  return CGAL::squared_distance(x, Kernel::Plane_3(a, b, c));
}

Sign against(const Number& squared, const Number& distance) {
  return distance < 0 ? Sign::positive : of(CGAL::compare(squared, distance * distance));
}

template <class Point, class Read>
std::optional<Sign> lines_and_segments(std::string_view face, Arguments p, Read point) {
  const Point a = point(p), b = point(p);
  if (face == "compare_distance_to_number") return against(CGAL::squared_distance(a, b), p.number());
  const Point c = point(p);
  const bool line = face.find("line") != face.npos;
  const auto distance = line ? [](const Point& f, const Point& g, const Point& x) { return to_line(f, g, x); }
                             : [](const Point& f, const Point& g, const Point& x) { return to_segment(f, g, x); };
  if (face == "line_to_number" || face == "segment_to_number") return against(distance(a, b, c), p.number());
  const Point d = point(p);
  if (face == "line" || face == "segment") return of(CGAL::compare(distance(a, b, c), distance(a, b, d)));
  const Point e = point(p), f = point(p);
  if (face == "lines" || face == "segments") return of(CGAL::compare(distance(a, b, c), distance(d, e, f)));
  return std::nullopt;
}

std::optional<Sign> planes(std::string_view face, Arguments p) {
  const auto a = p.point3(), b = p.point3(), c = p.point3(), d = p.point3();
  if (face == "plane_to_number") return against(to_plane(a, b, c, d), p.number());
  const auto e = p.point3();
  if (face == "plane") return of(CGAL::compare(to_plane(a, b, c, d), to_plane(a, b, c, e)));
  const auto f = p.point3(), g = p.point3(), h = p.point3();
  if (face == "planes") return of(CGAL::compare(to_plane(a, b, c, d), to_plane(e, f, g, h)));
  return std::nullopt;
}

// By normal and offset; with a zero normal everything, or nothing.
std::optional<Sign> normals(std::string_view face, Arguments p) {
  const bool in_plane = face == "normal2d_to_number";
  const Number nx = p.number(), ny = p.number(), nz = in_plane ? Number(0) : p.number(), offset = p.number();
  const Number x = p.number(), y = p.number(), z = in_plane ? Number(0) : p.number(), distance = p.number();
  if (nx == 0 && ny == 0 && nz == 0) return offset == 0 ? against(0, distance) : Sign::positive;
  return against(CGAL::squared_distance(Kernel::Point_3(x, y, z), Kernel::Plane_3(nx, ny, nz, -offset)), distance);
}

std::optional<Sign> spheres(std::string_view face, Arguments p) {
  if (face == "circle3") {
    const auto a = p.point2(), b = p.point2(), c = p.point2(), x = p.point2();
    if (!CGAL::collinear(a, b, c)) return of(CGAL::side_of_bounded_circle(a, b, c, x));
    if (a != b && b != c && c != a) return Sign::zero;
    return of(CGAL::side_of_bounded_circle(a, a == b ? c : b, x));
  }
  const auto a = p.point3(), b = p.point3(), c = p.point3(), x = p.point3();
  if (!CGAL::collinear(a, b, c)) return of(CGAL::side_of_bounded_sphere(a, b, c, x));
  if (a != b && b != c && c != a) return Sign::zero;
  return of(CGAL::side_of_bounded_sphere(a, a == b ? c : b, x));
}

}  // namespace

std::optional<Sign> face_by_cgal(std::string_view face, std::span<const double> coordinates) {
  const Arguments p(coordinates);
  if (face == "circle3" || face == "sphere3") return spheres(face, p);
  if (face.starts_with("normal")) return normals(face, p);
  if (face.starts_with("plane")) return planes(face, p);
  const std::string_view name = face.substr(0, face.size() - 2);  // without "2d" or "3d"
  return face.ends_with("2d") ? lines_and_segments<Kernel::Point_2>(name, p, [](Arguments& q) { return q.point2(); })
                              : lines_and_segments<Kernel::Point_3>(name, p, [](Arguments& q) { return q.point3(); });
}

}  // namespace plumb::oracle
