#include <cmath>
#include <map>
#include <optional>

#include "certify/batch/all_threads.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/figure/obb/minimum_obb.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

using Rows = py::array_t<std::int32_t>;

/// What SciPy's hull has, by the same names.
struct PointHull {
  py::array_t<double> points, equations;
  int dimension = -1;
  Rows vertices, simplices, neighbors;
  double volume = 0, area = 0;
};

/// A part of a vector of length 1, rounded once.
double unit_part(const Rational& part, const Rational& square) {
  const double root = rounded_root(Rounding::nearest, part * part / square);
  return part.sign() == Sign::negative ? -root : root;
}

std::array<double, 3> line_beyond(const Point2& a, const Point2& b) {
  const Rational x = Rational(b.y) - a.y, y = Rational(a.x) - b.x;
  const Rational square = x * x + y * y, offset = -(x * a.x + y * a.y);
  return {unit_part(x, square), unit_part(y, square), unit_part(offset, square)};
}
std::array<double, 4> plane_beyond(const Point3& a, const Point3& b, const Point3& c) {
  const std::array<Rational, 3> u{Rational(b.x) - a.x, Rational(b.y) - a.y, Rational(b.z) - a.z},
      v{Rational(c.x) - a.x, Rational(c.y) - a.y, Rational(c.z) - a.z};
  const Rational x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  const Rational square = x * x + y * y + z * z, offset = -(x * a.x + y * a.y + z * a.z);
  return {unit_part(x, square), unit_part(y, square), unit_part(z, square), unit_part(offset, square)};
}

template <std::size_t N>
Rows integer_rows(const std::vector<std::array<std::uint32_t, N>>& from) {
  Rows rows(std::vector<py::ssize_t>{static_cast<py::ssize_t>(from.size()), static_cast<py::ssize_t>(N)});
  std::int32_t* to = rows.mutable_data();
  for (const auto& row : from) {
    for (const std::uint32_t n : row) *to++ = static_cast<std::int32_t>(n);
  }
  return rows;
}

Rows integers_of(const std::vector<std::uint32_t>& from) {
  Rows all(static_cast<py::ssize_t>(from.size()));
  std::copy(from.begin(), from.end(), all.mutable_data());
  return all;
}

void fill(PointHull& hull, std::span<const Point2> points) {
  const Hull2 made = convex_hull(points);
  hull.dimension = made.dimension;
  const std::vector<std::uint32_t>& v = made.vertices;
  std::vector<std::array<std::uint32_t, 2>> edges, beside;
  std::vector<std::array<double, 3>> lines;
  const std::size_t n = made.dimension < 1 ? 0 : v.size();
  for (std::size_t i = 0; i < n; ++i) hull.area += distance(points[v[i]], points[v[(i + 1) % n]]);
  if (made.dimension == 2) {
    Polygon2 outline;
    for (std::size_t i = 0; i < n; ++i) {
      outline.vertices.push_back(points[v[i]]);
      edges.push_back({v[i], v[(i + 1) % n]});
      beside.push_back({static_cast<std::uint32_t>((i + 1) % n), static_cast<std::uint32_t>((i + n - 1) % n)});
      lines.push_back(line_beyond(points[v[i]], points[v[(i + 1) % n]]));
    }
    hull.volume = area(outline);
  }
  const py::gil_scoped_acquire held;
  hull.vertices = integers_of(v);
  hull.simplices = integer_rows(edges);
  hull.neighbors = integer_rows(beside);
  hull.equations = array_of<double>(std::span<const std::array<double, 3>>(lines));
}

using Corners = std::array<std::uint32_t, 3>;

/// The triangle beyond the edge opposite to each corner.
std::vector<Corners> neighbors_of(const std::vector<Corners>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> of_edge;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) of_edge[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
  }
  std::vector<Corners> beside(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      beside[t][k] = of_edge.at({triangles[t][(k + 2) % 3], triangles[t][(k + 1) % 3]});
  }
  return beside;
}

void fill(PointHull& hull, std::span<const Point3> points) {
  const Hull3 made = convex_hull(points, {.triangulate = true});
  hull.dimension = made.dimension;
  std::vector<Corners> triangles, beside;
  std::vector<std::array<double, 4>> planes;
  if (made.dimension == 3) {
    TriangleMesh mesh{{points.begin(), points.end()}, {}};
    for (std::size_t f = 0; f < made.face_count(); ++f) {
      const auto face = made.face(f);
      triangles.push_back({face[0], face[1], face[2]});
      mesh.triangles.push_back({face[0], face[1], face[2]});
    }
    beside = neighbors_of(triangles);
    planes.resize(triangles.size());
    constexpr std::size_t part = 64;
    certify::batch::for_each_part(Execution::parallel, (planes.size() + part - 1) / part, [&](std::size_t number) {
      for (std::size_t i = number * part; i < std::min(planes.size(), (number + 1) * part); ++i)
        planes[i] = plane_beyond(points[triangles[i][0]], points[triangles[i][1]], points[triangles[i][2]]);
    });
    hull.volume = volume(mesh);
    hull.area = surface_area(mesh);
  } else if (made.dimension == 2) {
    Polygon3 outline;
    const Hull3 whole = convex_hull(points);
    for (const std::uint32_t v : whole.corners) outline.vertices.push_back(points[v]);
    hull.area = 2 * area(outline);
  }
  const py::gil_scoped_acquire held;
  hull.vertices = integers_of(made.vertices);
  hull.simplices = integer_rows(triangles);
  hull.neighbors = integer_rows(beside);
  hull.equations = array_of<double>(std::span<const std::array<double, 4>>(planes));
}

PointHull hull_of(const py::object& points) {
  PointHull hull;
  hull.points = rows_of_plane_or_space(points, {"ConvexHull", "points"}).attr("copy")().cast<py::array_t<double>>();
  const bool in_plane = hull.points.shape(1) == 2;
  const std::span<const Point2> flat = points_of<Point2>(hull.points);
  const std::span<const Point3> solid = points_of<Point3>(hull.points);
  const py::gil_scoped_release released;
  if (in_plane) {
    fill(hull, flat);
  } else {
    fill(hull, solid);
  }
  return hull;
}

py::object smallest_ball(const py::object& points) {
  const py::array_t<double> rows = rows_of_plane_or_space(points, {"minimum_sphere", "points"});
  const auto shown = [](const AnyFigure& ball, const std::vector<std::uint32_t>& support) {
    return answer("MinimumSphere", object_of(ball), integers_of(support));
  };
  if (rows.shape(1) == 2) {
    const MinimumCircle found = unlocked([&] { return minimum_circle(points_of<Point2>(rows)); });
    return shown(found.circle, found.support);
  }
  const MinimumSphere found = unlocked([&] { return minimum_sphere(points_of<Point3>(rows)); });
  return shown(found.sphere, found.support);
}

py::object smallest_box(const py::object& points) {
  const py::array_t<double> rows = rows_of_plane_or_space(points, {"minimum_obb", "points"});
  const AnyFigure box = unlocked([&]() -> AnyFigure {
    if (rows.shape(1) == 2) return minimum_obb(points_of<Point2>(rows));
    return minimum_obb(points_of<Point3>(rows));
  });
  return object_of(box);
}

/// Boxes as rows of min and max one after the other.
struct BoxRows {
  py::array_t<double> rows;
  py::ssize_t dimension;
};
BoxRows boxes_of(const py::object& given, const Asked& asked) {
  const py::array numbers = numbers_of(given, asked);
  if (numbers.ndim() != 3 || numbers.shape(1) != 2 || (numbers.shape(2) != 2 && numbers.shape(2) != 3))
    refuse(asked, py::array::ensure(given), "shape (n, 2, 2) or (n, 2, 3), of each box min and max");
  const py::ssize_t d = numbers.shape(2);
  return {rows_of(numbers.attr("reshape")(numbers.shape(0), 2 * d), asked, 2 * d), d};
}

py::object pairs_of_boxes(const py::object& boxes, const py::object& others, bool touching) {
  const BoxRows a = boxes_of(boxes, {"overlapping_pairs", "boxes"});
  const std::optional<BoxRows> b =
      others.is_none() ? std::nullopt : std::optional(boxes_of(others, {"overlapping_pairs", "others"}));
  if (b && b->dimension != a.dimension) throw py::value_error("overlapping_pairs: others are of another dimension");
  const BroadPhaseOptions options{.touching = touching};
  const auto found = [&]<class Box>(std::type_identity<Box>) {
    if (b) return overlapping_pairs(points_of<Box>(a.rows), points_of<Box>(b->rows), options);
    return overlapping_pairs(points_of<Box>(a.rows), options);
  };
  const std::vector<BoxPair> pairs = unlocked([&] {
    std::vector<BoxPair> all =
        a.dimension == 2 ? found(std::type_identity<Aabb2>{}) : found(std::type_identity<Aabb3>{});
    std::ranges::sort(all);
    return all;
  });
  Rows rows(std::vector<py::ssize_t>{static_cast<py::ssize_t>(pairs.size()), 2});
  std::int32_t* to = rows.mutable_data();
  for (const BoxPair& p : pairs) *to++ = static_cast<std::int32_t>(p.a), *to++ = static_cast<std::int32_t>(p.b);
  return rows;
}

}  // namespace

void add_hull(py::module_& module) {
  py::class_<PointHull>(
      module, "ConvexHull",
      "ConvexHull(points)\n--\n\nThe convex hull of points, exactly, by the names of "
      "scipy.spatial.ConvexHull.\n\nPoints "
      "may be repeated, collinear, coplanar: where the hull is flat, it has vertices but no simplices.\n\nParameters\n"
      "----------\npoints : array_like, shape (n, 2) or (n, 3)\n\nRaises\n------\nValueError\n    If the shape is "
      "another, or a number is not finite.")
      .def(py::init(&hull_of), py::arg("points"))
      .def_readonly("points", &PointHull::points, "float64, shape (n, m)")
      .def_readonly(
          "vertices", &PointHull::vertices,
          "int32, shape (k,): the extreme points; in the plane counterclockwise, in space ascending; of equal "
          "points the first.")
      .def_readonly("simplices", &PointHull::simplices,
                    "int32, shape (f, m): edges or triangles, counterclockwise seen from outside; points of each.")
      .def_readonly("neighbors", &PointHull::neighbors,
                    "int32, shape (f, m): the simplex opposite to each point of a simplex.")
      .def_readonly("equations", &PointHull::equations,
                    "float64, shape (f, m + 1): normal of length 1, outward, and offset; each rounded once.")
      .def_readonly("volume", &PointHull::volume, "float: the volume, or the area in the plane; rounded once.")
      .def_readonly(
          "area", &PointHull::area,
          "float: the surface, of a flat hull that of both its sides; in the plane the length of its outline.")
      .def_readonly("dimension", &PointHull::dimension, "int: -1 of no points, 0 of equal ones, up to m.")
      .def("__repr__",
           [](const PointHull& self) {
             return "ConvexHull(" + std::to_string(self.points.shape(0)) + " points, " +
                    std::to_string(self.vertices.size()) + " vertices, " + std::to_string(self.simplices.shape(0)) +
                    " simplices)";
           })
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self), py::make_tuple(self.attr("points")));
      });
  module.def(
      "minimum_sphere", smallest_ball, py::arg("points"),
      "minimum_sphere(points)\n--\n\nThe smallest ball or disk that holds all points.\n\nParameters\n----------\n"
      "points : array_like, shape (n, 2) or (n, 3), of one at least\n\nReturns\n-------\nMinimumSphere: a Circle2 "
      "or Sphere3, and the points that it is the smallest ball of");
  module.def(
      "minimum_obb", smallest_box, py::arg("points"),
      "minimum_obb(points)\n--\n\nA box of least area or volume, at any angle, that holds all points.\n\n"
      "Parameters\n----------\npoints : array_like, shape (n, 2) or (n, 3), of one at least\n\nReturns\n-------\n"
      "Obb2 or Obb3; docs/bounding_volumes.md says how near to the least");
  module.def(
      "overlapping_pairs", pairs_of_boxes, py::arg("boxes"), py::arg("others") = py::none(), py::kw_only(),
      py::arg("touching") = true,
      "overlapping_pairs(boxes, others=None, *, touching=True)\n--\n\nWhich boxes overlap, of one set or of "
      "two?\n\nParameters\n----------\nboxes, others : array_like, shape (n, 2, 2) or (n, 2, 3): of each box min "
      "and max\ntouching : bool; False leaves out what only touches\n\nReturns\n-------\nint32, shape (k, 2), "
      "ascending; of one set the lower number first\n\nRaises\n------\nValueError\n    If a box is empty, a number "
      "is not finite, or a shape is another.");
}

}  // namespace plumb::python
