#include <pybind11/stl.h>

#include "plumb/surface/parts/covering_parts.hpp"
#include "plumb/surface/planar/arrange_segments.hpp"
#include "plumb/surface/planar/convex_pieces.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"
#include "plumb/surface/planar/voronoi.hpp"
#include "python/figure_members.hpp"
#include "python/fractions.hpp"
#include "python/mesh.hpp"
#include "python/named.hpp"
#include "python/rooms.hpp"
#include "python/unlocked.hpp"

namespace plumb::python {
namespace {

WindingRule rule_named(const std::string& rule, const char* function) {
  return named<WindingRule>(
      {function, "rule"}, rule,
      {{"odd", WindingRule::odd}, {"nonzero", WindingRule::nonzero}, {"positive", WindingRule::positive}});
}

[[noreturn]] void refuse_polygon(const char* function, const char* kinds) {
  throw py::value_error(std::string(function) + ": polygon is no " + kinds);
}

/// None of the numbers is -1.
template <std::size_t n>
py::array_t<std::int32_t> rows_of_numbers(const std::vector<std::array<std::uint32_t, n>>& rows) {
  return array_of<std::int32_t>(std::span<const std::array<std::uint32_t, n>>(rows));
}

py::object triangulated(const py::object& polygon, const std::string& rule) {
  const AnyFigure& figure = figure_in(polygon, {"triangulate", "polygon"});
  const WindingRule by = rule_named(rule, "triangulate");
  const auto told = [by](const auto& is) { return rows_of_numbers(unlocked([&] { return triangulate(is, by); })); };
  if (const auto* is = get_if<Polygon2>(figure)) return told(*is);
  if (const auto* is = get_if<HoledPolygon2>(figure)) return told(*is);
  if (const auto* is = get_if<Polygon3>(figure)) return told(*is);
  if (const auto* is = get_if<HoledPolygon3>(figure)) return told(*is);
  refuse_polygon("triangulate", "Polygon2, HoledPolygon2, Polygon3 or HoledPolygon3");
}

py::list pieces_of(const py::object& polygon, const std::string& rule, bool fewest) {
  const AnyFigure& figure = figure_in(polygon, {"convex_pieces", "polygon"});
  const WindingRule by = rule_named(rule, "convex_pieces");
  std::vector<std::vector<std::uint32_t>> pieces;
  if (const auto* is = get_if<Polygon2>(figure)) {
    pieces = unlocked([&] { return fewest ? fewest_convex_pieces(*is) : convex_pieces(*is, by); });
  } else if (const auto* holed = get_if<HoledPolygon2>(figure); holed != nullptr && !fewest) {
    pieces = unlocked([&] { return convex_pieces(*holed, by); });
  } else {
    refuse_polygon("convex_pieces", fewest ? "Polygon2" : "Polygon2 or HoledPolygon2");
  }
  py::list out;
  for (const auto& piece : pieces) out.append(array_of<std::int32_t>(std::span<const std::uint32_t>(piece)));
  return out;
}

/// Rounded once, or a list of pairs of fractions.
py::object places_of(const std::vector<ExactPoint2>& points, bool exact) {
  if (exact) {
    py::list out;
    for (const ExactPoint2& p : points) out.append(fractions_of(rational_point(p)));
    return out;
  }
  std::vector<Point2> rounded;
  rounded.reserve(points.size());
  for (const ExactPoint2& p : points) rounded.push_back(approximate(p));
  return array_of<double>(std::span<const Point2>(rounded));
}

py::object arrangement_of(const py::object& segments, bool exact) {
  const py::array_t<double> rows = rows_of(segments, {"arrange_segments", "segments"}, 4);
  const std::span<const Segment2> all(reinterpret_cast<const Segment2*>(rows.data()),
                                      static_cast<std::size_t>(rows.shape(0)));
  const PlanarArrangement made = unlocked([&] { return arrange_segments(all); });
  const py::object windings =
      made.windings.empty() ? py::object(py::none()) : array_of<std::int32_t>(std::span(made.windings));
  return answer("Arrangement", places_of(made.vertices, exact), rows_of_numbers(made.ends), rows_of_numbers(made.edges),
                rows_of_numbers(made.sides), made.faces, windings, rows_of_numbers(made.triangles),
                array_of<std::int32_t>(std::span<const std::uint32_t>(made.face_of)));
}

py::object voronoi_of(const py::object& points, bool exact) {
  const py::array_t<double> rows = rows_of(points, {"voronoi", "points"}, 2);
  const std::span<const Point2> all = points_of<Point2>(rows);
  auto [made, centers] = unlocked([&] {
    PlanarTriangulation joined = delaunay(all);
    std::vector<ExactPoint2> found = voronoi_vertices(all, joined);
    return std::pair(std::move(joined), std::move(found));
  });
  return answer("Voronoi", places_of(centers, exact), rows_of_numbers(made.triangles), rows_of_numbers(made.neighbors));
}

py::object delaunay_of(const py::object& points, const py::object& segments) {
  const py::array_t<double> rows = rows_of(points, {"delaunay", "points"}, 2);
  const std::span<const Point2> all = points_of<Point2>(rows);
  std::vector<PlanarSegment> edges;
  if (!segments.is_none()) {
    for (const auto& [a, b] : segments.cast<std::vector<std::array<std::int64_t, 2>>>()) {
      for (const std::int64_t end : {a, b}) {
        if (end < 0 || static_cast<std::size_t>(end) >= all.size()) {
          throw py::value_error("delaunay: segments names point " + std::to_string(end) + " of " +
                                std::to_string(all.size()));
        }
      }
      edges.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    }
  }
  const PlanarTriangulation made = unlocked([&] { return delaunay(all, edges); });
  return answer("Delaunay", rows_of_numbers(made.triangles), rows_of_numbers(made.neighbors));
}

py::list parts_of(const TriangleMesh& mesh) {
  py::list out;
  const ConvexParts made = unlocked([&] { return convex_parts(mesh); });
  for (const ConvexPart& part : made.parts) {
    const PolygonMesh corners = rounded(part);
    py::list faces;
    for (std::size_t f = 0; f + 1 < corners.first.size(); ++f) {
      const std::span face(corners.corners.data() + corners.first[f], corners.first[f + 1] - corners.first[f]);
      faces.append(array_of<std::int32_t>(face));
    }
    out.append(answer("ConvexPart", array_of<double>(std::span<const Point3>(corners.vertices)), faces, part.is_exact,
                      fraction_of(exact_volume(part.solid))));
  }
  return out;
}

py::list covers_of(const TriangleMesh& mesh, double concavity, std::optional<std::uint32_t> most_parts) {
  const CoveringParts made =
      unlocked([&] { return covering_parts(mesh, {.concavity = concavity, .most_parts = most_parts}); });
  py::list out;
  for (const CoveringPart& part : made.parts) {
    out.append(answer("CoveringPart", array_of<double>(std::span<const Point3>(part.proxy.vertices)), part.concavity));
  }
  return out;
}

}  // namespace

void add_planar(py::module_& module) {
  module.def(
      "triangulate", triangulated, py::arg("polygon"), py::arg("rule") = "odd",
      "triangulate(polygon, rule='odd')\n--\n\nWhich triangles make up a polygon, with holes or without?\n\n"
      "Parameters\n----------\npolygon : Polygon2, HoledPolygon2, Polygon3 or HoledPolygon3\n"
      "rule : 'odd', 'nonzero' or 'positive': which winding numbers are inside\n\nReturns\n-------\n"
      "int32, shape (n, 3): indices of its vertices, then of its holes'; the constrained Delaunay triangulation");
  module.def(
      "convex_pieces", pieces_of, py::arg("polygon"), py::arg("rule") = "odd", py::kw_only(), py::arg("fewest") = false,
      "convex_pieces(polygon, rule='odd', *, fewest=False)\n--\n\nWhich convex polygons make up a polygon, "
      "without new points?\n\nParameters\n----------\npolygon : Polygon2 or HoledPolygon2\nrule : as of "
      "triangulate\nfewest : as few as there can be, of a Polygon2 that is simple; takes n^3\n\nReturns\n-------\n"
      "list of int32 arrays: indices of its vertices, counterclockwise");
  module.def(
      "delaunay", delaunay_of, py::arg("points"), py::arg("segments") = py::none(),
      "delaunay(points, segments=None)\n--\n\nWhich triangles join points of the plane, so that the circle of "
      "each holds no other point?\n\nParameters\n----------\npoints : array_like, shape (n, 2)\nsegments : "
      "array_like of integers, shape (m, 2): pairs of points that edges must join\n\nReturns\n-------\nDelaunay\n\n"
      "Raises\n------\nValueError\n    If two segments cross at no point of these; the text names both, and where.");
  module.def(
      "voronoi", voronoi_of, py::arg("points"), py::kw_only(), py::arg("exact") = false,
      "voronoi(points, *, exact=False)\n--\n\nWhich points of the plane are as far from three points as from no "
      "other?\n\nParameters\n----------\npoints : array_like, shape (n, 2)\nexact : vertices as pairs of Fraction, "
      "not rounded\n\nReturns\n-------\nVoronoi: a vertex for each triangle of the Delaunay triangulation; edges "
      "join those of neighbors");
  module.def(
      "arrange_segments", arrangement_of, py::arg("segments"), py::kw_only(), py::arg("exact") = false,
      "arrange_segments(segments, *, exact=False)\n--\n\nHow do segments divide the plane?\n\nParameters\n----------\n"
      "segments : array_like, shape (n, 4): x and y of an end, x and y of the other\nexact : vertices as pairs of "
      "Fraction, not rounded\n\nReturns\n-------\nArrangement: where they cross and overlap, the edges between, the "
      "faces and their winding numbers");
  module.def("convex_parts", parts_of, py::arg("mesh"),
             "convex_parts(mesh)\n--\n\nOf which convex polyhedra does a solid consist, exactly?\n\nParameters\n"
             "----------\nmesh : Mesh, closed and wound outward\n\nReturns\n-------\nlist of ConvexPart");
  module.def(
      "covering_parts", covers_of, py::arg("mesh"), py::arg("concavity") = 0.0, py::arg("most_parts") = py::none(),
      "covering_parts(mesh, concavity=0.0, most_parts=None)\n--\n\nWhich few convex hulls cover a solid, and how "
      "far do they reach beyond it?\n\nParameters\n----------\nmesh : Mesh, closed and wound outward\nconcavity : "
      "float, the length that hulls may reach beyond what they cover\nmost_parts : int\n\nReturns\n-------\n"
      "list of CoveringPart");
}

}  // namespace plumb::python
