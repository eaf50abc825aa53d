// Constructs points as CGAL does: intersections of its lines and planes, its vectors, its affine transformations.
#include <CGAL/Aff_transformation_2.h>
#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

#include "oracle/constructed.hpp"

namespace plumb::oracle {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Numbers = std::span<const double>;
using CGAL::Gmpq;

Sign of(int cgal) { return static_cast<Sign>((cgal > 0) - (cgal < 0)); }

Kernel::Point_2 point2(Numbers p, std::size_t i) { return {Gmpq(p[i]), Gmpq(p[i + 1])}; }
Kernel::Point_3 point3(Numbers p, std::size_t i) { return {Gmpq(p[i]), Gmpq(p[i + 1]), Gmpq(p[i + 2])}; }

std::optional<Kernel::Plane_3> plane(Numbers p, std::size_t i) {
  const auto a = point3(p, i), b = point3(p, i + 3), c = point3(p, i + 6);
  if (CGAL::collinear(a, b, c)) return {};
  return Kernel::Plane_3(a, b, c);
}

template <class Point, class Intersection>
std::optional<Point> as_point(const Intersection& i) {
  if (!i) return {};
  const Point* p = boost::get<Point>(&*i);
  return p == nullptr ? std::nullopt : std::optional(*p);
}

std::optional<Kernel::Point_2> construct2(const Constructed& c) {
  const Numbers p = c.numbers;
  switch (c.by) {
    case Construction::explicit2:
      return point2(p, 0);
    case Construction::line_line2: {
      const auto a = point2(p, 0), b = point2(p, 2), d = point2(p, 4), e = point2(p, 6);
      if (a == b || d == e) return {};
      return as_point<Kernel::Point_2>(CGAL::intersection(Kernel::Line_2(a, b), Kernel::Line_2(d, e)));
    }
    case Construction::segment2:
      return point2(p, 0) + Gmpq(p[4]) * (point2(p, 2) - point2(p, 0));
    case Construction::posed2: {
      const auto m = [&](std::size_t row, std::size_t column) { return Gmpq(p[2 * column + 2 + row]); };
      const CGAL::Aff_transformation_2<Kernel> pose(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2));
      return point2(p, 0).transform(pose);
    }
    default:
      return {};
  }
}

std::optional<Kernel::Point_3> construct3(const Constructed& c) {
  const Numbers p = c.numbers;
  switch (c.by) {
    case Construction::explicit3:
      return point3(p, 0);
    case Construction::line_plane3: {
      const auto a = point3(p, 0), b = point3(p, 3);
      const auto abc = plane(p, 6);
      if (a == b || !abc) return {};
      return as_point<Kernel::Point_3>(CGAL::intersection(Kernel::Line_3(a, b), *abc));
    }
    case Construction::three_plane3: {
      const auto first = plane(p, 0), second = plane(p, 9), third = plane(p, 18);
      if (!first || !second || !third) return {};
      return as_point<Kernel::Point_3>(CGAL::intersection(*first, *second, *third));
    }
    case Construction::segment3:
      return point3(p, 0) + Gmpq(p[6]) * (point3(p, 3) - point3(p, 0));
    case Construction::posed3: {
      const auto m = [&](std::size_t row, std::size_t column) { return Gmpq(p[3 * column + 3 + row]); };
      const CGAL::Aff_transformation_3<Kernel> pose(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2),
                                                    m(1, 3), m(2, 0), m(2, 1), m(2, 2), m(2, 3));
      return point3(p, 0).transform(pose);
    }
    default:
      return {};
  }
}

template <class Point, class Make>
std::optional<std::vector<Point>> all(std::span<const Constructed> points, Make make) {
  std::vector<Point> made;
  for (const Constructed& c : points) {
    const auto p = make(c);
    if (!p) return {};
    made.push_back(*p);
  }
  return made;
}

}  // namespace

std::optional<Sign> cgal_sign(Question question, std::span<const Constructed> points) {
  if (points[0].by < Construction::explicit3) {
    const auto p = all<Kernel::Point_2>(points, construct2);
    if (!p) return {};
    const auto& q = *p;
    if (question == Question::orient) return of(CGAL::orientation(q.at(0), q.at(1), q.at(2)));
    return of(CGAL::side_of_oriented_circle(q.at(0), q.at(1), q.at(2), q.at(3)));
  }
  // CGAL calls a tetrahedron positive that the literature of robust predicates calls negative.
  const auto p = all<Kernel::Point_3>(points, construct3);
  if (!p) return {};
  const auto& q = *p;
  if (question == Question::orient) return -of(CGAL::orientation(q.at(0), q.at(1), q.at(2), q.at(3)));
  return -of(CGAL::side_of_oriented_sphere(q.at(0), q.at(1), q.at(2), q.at(3), q.at(4)));
}

}  // namespace plumb::oracle
