// CGAL's algorithms over Epick and over our kernel.
#include "oracle/cgal_algorithms.hpp"

// Our kernel first, which specializes a template of the hull's header before that declares it.
// clang-format off
#include "plumb/certify/cgal_kernel.hpp"
// clang-format on

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>
#include <set>

namespace plumb::oracle {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbers = std::vector<std::uint32_t>;

/// The number of each point: one more than the place of the first equal one.
template <class Point>
std::map<Point, std::uint32_t> numbered(const std::vector<Point>& points) {
  std::map<Point, std::uint32_t> number;
  for (const Point& p : points) number.emplace(p, static_cast<std::uint32_t>(&p - points.data() + 1));
  return number;
}

template <class Point>
std::vector<Point> points_of(std::span<const double> c) {
  std::vector<Point> points;
  if constexpr (Point::Ambient_dimension::value == 2) {
    for (std::size_t i = 0; i + 1 < c.size(); i += 2) points.emplace_back(c[i], c[i + 1]);
  } else {
    for (std::size_t i = 0; i + 2 < c.size(); i += 3) points.emplace_back(c[i], c[i + 1], c[i + 2]);
  }
  return points;
}

template <class Kernel>
Numbers delaunay_2(std::span<const double> c) {
  const auto points = points_of<typename Kernel::Point_2>(c);
  const auto number = numbered(points);
  const CGAL::Delaunay_triangulation_2<Kernel> made(points.begin(), points.end());
  Numbers out{static_cast<std::uint32_t>(made.dimension() + 1)};
  for (auto face = made.all_faces_begin(); face != made.all_faces_end(); ++face) {
    for (int i = 0; i < 3; ++i) {
      out.push_back(made.is_infinite(face->vertex(i)) ? 0 : number.at(face->vertex(i)->point()));
    }
  }
  return out;
}

template <class Kernel>
Numbers delaunay_3(std::span<const double> c) {
  const auto points = points_of<typename Kernel::Point_3>(c);
  const auto number = numbered(points);
  const CGAL::Delaunay_triangulation_3<Kernel> made(points.begin(), points.end());
  Numbers out{static_cast<std::uint32_t>(made.dimension() + 1)};
  const auto& structure = made.tds();
  for (auto cell = structure.raw_cells_begin(); cell != structure.raw_cells_end(); ++cell) {
    for (int i = 0; i <= made.dimension(); ++i) {
      out.push_back(made.is_infinite(cell->vertex(i)) ? 0 : number.at(cell->vertex(i)->point()));
    }
  }
  return out;
}

// The order of a hull's faces, and how flat ones are cut into triangles, follow from addresses in memory.  What does
// not is which points of the input lie in the plane of each facet.  A hull that is flat comes in a fixed order.
template <class Kernel>
Numbers convex_hull_3(std::span<const double> c) {
  const auto points = points_of<typename Kernel::Point_3>(c);
  const auto number = numbered(points);
  CGAL::Surface_mesh<typename Kernel::Point_3> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  const auto judges = points_of<Epick::Point_3>(c);
  Numbers vertices;
  std::set<Numbers> facets;
  for (const auto v : hull.vertices()) vertices.push_back(number.at(hull.point(v)));
  for (const auto face : hull.faces()) {
    Numbers corners, facet;
    for (const auto v : CGAL::vertices_around_face(hull.halfedge(face), hull)) {
      corners.push_back(number.at(hull.point(v)));
    }
    const auto corner = [&](std::size_t i) { return judges[corners.at(i) - 1]; };
    for (const auto& [point, n] : number) {
      if (CGAL::coplanar(corner(0), corner(1), corner(2), judges[n - 1])) facet.push_back(n);
    }
    if (facet.size() == number.size()) return vertices;
    std::sort(facet.begin(), facet.end());
    facets.insert(facet);
  }
  Numbers out;
  for (const Numbers& facet : facets) {
    out.push_back(static_cast<std::uint32_t>(facet.size()));
    out.insert(out.end(), facet.begin(), facet.end());
  }
  return out;
}

template <class Kernel>
Numbers made_on(Algorithm algorithm, std::span<const double> c) {
  switch (algorithm) {
    case Algorithm::delaunay_2:
      return delaunay_2<Kernel>(c);
    case Algorithm::delaunay_3:
      return delaunay_3<Kernel>(c);
    case Algorithm::convex_hull_3:
      break;
  }
  return convex_hull_3<Kernel>(c);
}

template <class Kernel>
std::vector<Answer> answers_on(std::span<const double> c) {
  using Number = typename Kernel::FT;
  std::vector<typename Kernel::Point_2> a;
  std::vector<typename Kernel::Point_3> p;
  for (std::size_t i = 0; i < 15; i += 3) {
    a.emplace_back(Number(c[i]), Number(c[i + 1]));
    p.emplace_back(Number(c[i]), Number(c[i + 1]), Number(c[i + 2]));
  }
  const Kernel k;
  std::vector<Answer> out;
  const auto add = [&](const char* name, int sign) { out.push_back({name, sign}); };
  add("orientation_2", k.orientation_2_object()(a[0], a[1], a[2]));
  add("left_turn_2", k.left_turn_2_object()(a[0], a[1], a[2]) ? 1 : 0);
  add("side_of_oriented_circle_2", k.side_of_oriented_circle_2_object()(a[0], a[1], a[2], a[3]));
  if (k.orientation_2_object()(a[0], a[1], a[2]) != CGAL::ZERO) {
    add("side_of_bounded_circle_2", k.side_of_bounded_circle_2_object()(a[0], a[1], a[2], a[3]));
  }
  if ((a[1].x() <= a[0].x() && a[0].x() <= a[2].x()) || (a[2].x() <= a[0].x() && a[0].x() <= a[1].x())) {
    add("compare_y_at_x_2", k.compare_y_at_x_2_object()(a[0], typename Kernel::Segment_2(a[1], a[2])));
  }
  const CGAL::Orientation space = k.orientation_3_object()(p[0], p[1], p[2], p[3]);
  add("orientation_3", space);
  add("coplanar_3", k.coplanar_3_object()(p[0], p[1], p[2], p[3]) ? 1 : 0);
  add("side_of_oriented_sphere_3", k.side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]));
  if (space != CGAL::ZERO) {
    add("side_of_bounded_sphere_3", k.side_of_bounded_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]));
  }
  add("less_signed_distance_to_plane_3",
      !k.collinear_3_object()(p[0], p[1], p[2]) &&
              k.less_signed_distance_to_plane_3_object()(p[0], p[1], p[2], p[3], p[4])
          ? 1
          : 0);
  add("compare_distance_2", k.compare_distance_2_object()(a[0], a[1], a[2]));
  add("compare_distance_3", k.compare_distance_3_object()(p[0], p[1], p[2]));
  add("coplanar_orientation_3 of three", k.coplanar_orientation_3_object()(p[0], p[1], p[2]));
  if (space == CGAL::ZERO && !k.collinear_3_object()(p[0], p[1], p[2])) {
    add("coplanar_orientation_3", k.coplanar_orientation_3_object()(p[0], p[1], p[2], p[3]));
    add("coplanar_side_of_bounded_circle_3", k.coplanar_side_of_bounded_circle_3_object()(p[0], p[1], p[2], p[3]));
  }
  return out;
}

}  // namespace

std::vector<std::uint32_t> made_by(Algorithm algorithm, KernelChoice kernel, std::span<const double> c) {
  return kernel == KernelChoice::ours ? made_on<CgalKernel>(algorithm, c) : made_on<Epick>(algorithm, c);
}

std::vector<Answer> answers_of(KernelChoice kernel, std::span<const double> c) {
  return kernel == KernelChoice::ours ? answers_on<CgalKernel>(c) : answers_on<Epick>(c);
}

std::vector<Answer> exact_answers(std::span<const double> c) {
  return answers_on<CGAL::Simple_cartesian<CGAL::Gmpq>>(c);
}

}  // namespace plumb::oracle
