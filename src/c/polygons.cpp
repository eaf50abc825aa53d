#include <cstring>
#include <memory>

#include "c/figures.hpp"
#include "c/handles.hpp"
#include "c/loops.hpp"
#include "plumb/surface/parts/convex_parts.hpp"
#include "plumb/surface/planar/arrange_segments.hpp"
#include "plumb/surface/planar/convex_pieces.hpp"
#include "plumb/surface/planar/delaunay.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"
#include "plumb/surface/planar/voronoi.hpp"

using namespace plumb;
using c::guarded, c::items, c::need, c::need_size;

struct plumb_triangles {
  CornerTriangles triangles;
  bool is_delaunay = false;
  CornerTriangles neighbors;
  std::vector<Point2> points;  // whose Delaunay triangulation it is, without segments
};

struct plumb_arrangement {
  PlanarArrangement made;
  std::vector<Point2> places;
};

namespace {

CornerTriangles triangles_of(const AnyFigure& polygon, WindingRule rule) {
  if (polygon.is_posed()) throw Unsupported("triangulate takes polygons without a pose");
  if (const auto* is = get_if<Polygon2>(polygon)) return triangulate(*is, rule);
  if (const auto* is = get_if<HoledPolygon2>(polygon)) return triangulate(*is, rule);
  if (const auto* is = get_if<Polygon3>(polygon)) return triangulate(*is, rule);
  if (const auto* is = get_if<HoledPolygon3>(polygon)) return triangulate(*is, rule);
  query::refuse_figure("triangulate", polygon.figure());
}

std::vector<std::vector<std::uint32_t>> pieces_of(const AnyFigure& polygon, WindingRule rule, bool fewest) {
  if (polygon.is_posed()) throw Unsupported("convex_pieces takes polygons without a pose");
  if (const auto* is = get_if<Polygon2>(polygon)) return fewest ? fewest_convex_pieces(*is) : convex_pieces(*is, rule);
  if (const auto* is = get_if<HoledPolygon2>(polygon); is != nullptr && !fewest) return convex_pieces(*is, rule);
  query::refuse_figure(fewest ? "the fewest convex pieces" : "convex_pieces", polygon.figure());
}

template <std::size_t n>
const std::uint32_t* numbers_of(const std::vector<std::array<std::uint32_t, n>>& rows) {
  return rows.empty() ? nullptr : rows.front().data();
}

}  // namespace

extern "C" {

plumb_status plumb_triangulate(const plumb_figure* polygon, int rule, plumb_triangles** triangles) {
  return guarded("plumb_triangulate", [&] {
    need(triangles, "triangles");
    c::need_choice(rule, PLUMB_POSITIVE, "rule");
    const AnyFigure figure = c::figure_of(polygon, "polygon");
    *triangles = new plumb_triangles{triangles_of(figure, static_cast<WindingRule>(rule)), false, {}, {}};
  });
}

plumb_status plumb_delaunay(const double* points, std::size_t count, const std::uint32_t* segments,
                            std::size_t segment_count, plumb_triangles** triangles) {
  return guarded("plumb_delaunay", [&] {
    need(triangles, "triangles");
    need(segments, segment_count, "segments");
    std::vector<PlanarSegment> edges;
    for (std::size_t i = 0; i < segment_count; ++i) edges.push_back({segments[2 * i], segments[2 * i + 1]});
    const std::span<const Point2> given = items<Point2>(points, count, "points");
    PlanarTriangulation made = delaunay(given, edges);
    std::vector<Point2> kept;
    if (edges.empty()) kept.assign(given.begin(), given.end());
    *triangles = new plumb_triangles{std::move(made.triangles), true, std::move(made.neighbors), std::move(kept)};
  });
}

plumb_status plumb_triangles_of(const plumb_triangles* triangles, const std::uint32_t** indices, std::size_t* count) {
  return guarded("plumb_triangles_of", [&] {
    need(triangles, "triangles");
    need(indices, "indices");
    need(count, "count");
    *indices = numbers_of(triangles->triangles);
    *count = triangles->triangles.size();
  });
}

void plumb_triangles_destroy(plumb_triangles* triangles) { delete triangles; }

plumb_status plumb_triangles_neighbors(const plumb_triangles* triangles, const std::uint32_t** neighbors,
                                       std::size_t* count) {
  return guarded("plumb_triangles_neighbors", [&] {
    need(triangles, "triangles");
    need(neighbors, "neighbors");
    need(count, "count");
    if (!triangles->is_delaunay)
      throw Unsupported("the triangles are a polygon's; neighbors are those of plumb_delaunay");
    *neighbors = numbers_of(triangles->neighbors);
    *count = triangles->neighbors.size();
  });
}

plumb_status plumb_voronoi_vertices(const plumb_triangles* triangles, double* vertices) {
  return guarded("plumb_voronoi_vertices", [&] {
    need(triangles, "triangles");
    need(vertices, triangles->triangles.size(), "vertices");
    if (!triangles->is_delaunay || (triangles->points.empty() && !triangles->triangles.empty()))
      throw Unsupported("the triangles are not those that plumb_delaunay makes of points without segments");
    const PlanarTriangulation joined{triangles->triangles, triangles->neighbors, {}, {}};
    std::vector<Point2> places;
    for (const ExactPoint2& p : voronoi_vertices(triangles->points, joined)) places.push_back(approximate(p));
    if (!places.empty()) std::memcpy(vertices, places.data(), places.size() * sizeof(Point2));
  });
}

plumb_status plumb_convex_pieces(const plumb_figure* polygon, int rule, int fewest, plumb_loops** pieces) {
  return guarded("plumb_convex_pieces", [&] {
    need(pieces, "pieces");
    c::need_choice(rule, PLUMB_POSITIVE, "rule");
    auto made = std::make_unique<plumb_loops>();
    for (auto& piece : pieces_of(c::figure_of(polygon, "polygon"), static_cast<WindingRule>(rule), fewest != 0))
      made->add(std::move(piece), true);
    *pieces = made.release();
  });
}

plumb_status plumb_arrange_segments(const double* segments, std::size_t count, plumb_arrangement** arrangement) {
  return guarded("plumb_arrange_segments", [&] {
    need(arrangement, "arrangement");
    auto made = std::make_unique<plumb_arrangement>();
    made->made = arrange_segments(items<Segment2>(segments, count, "segments"));
    for (const ExactPoint2& p : made->made.vertices) made->places.push_back(approximate(p));
    *arrangement = made.release();
  });
}

plumb_status plumb_arrangement_of(const plumb_arrangement* arrangement, plumb_arrangement_report* report) {
  return guarded("plumb_arrangement_of", [&] {
    need(arrangement, "arrangement");
    need_size(report, "report");
    const PlanarArrangement& a = arrangement->made;
    plumb_arrangement_report out{};
    out.vertices = reinterpret_cast<const double*>(arrangement->places.data());
    out.ends = numbers_of(a.ends);
    out.edges = numbers_of(a.edges);
    out.sides = numbers_of(a.sides);
    out.triangles = numbers_of(a.triangles);
    out.face_of = a.face_of.data();
    out.weights = a.weights.data();
    out.windings = a.windings.empty() ? nullptr : a.windings.data();
    out.vertex_count = arrangement->places.size();
    out.segment_count = a.ends.size();
    out.edge_count = a.edges.size();
    out.triangle_count = a.triangles.size();
    out.face_count = a.faces;
    c::write(report, out);
  });
}

void plumb_arrangement_destroy(plumb_arrangement* arrangement) { delete arrangement; }

plumb_status plumb_mesh_convex_parts(const plumb_mesh* mesh, int (*take)(const plumb_mesh* part, void* user),
                                     void* user) {
  return guarded("plumb_mesh_convex_parts", [&] {
    need(mesh, "mesh");
    if (take == nullptr) throw c::InvalidArgument("take is NULL");
    for (const ConvexPart& part : convex_parts(mesh->mesh).parts) {
      const plumb_mesh told{triangulate(rounded(part))};
      if (take(&told, user) == 0) return;
    }
  });
}

}  // extern "C"
