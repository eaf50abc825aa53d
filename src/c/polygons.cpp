#include <algorithm>

#include "c/figures.hpp"
#include "c/handles.hpp"
#include "plumb/surface/parts/convex_parts.hpp"
#include "plumb/surface/planar/delaunay.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "plumb/surface/planar/triangulate_polygon.hpp"

using namespace plumb;
using c::guarded, c::items, c::need;

struct plumb_triangles {
  CornerTriangles triangles;
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

}  // namespace

extern "C" {

plumb_status plumb_triangulate(const plumb_figure* polygon, int rule, plumb_triangles** triangles) {
  return guarded("plumb_triangulate", [&] {
    need(triangles, "triangles");
    if (rule != PLUMB_ODD && rule != PLUMB_NONZERO && rule != PLUMB_POSITIVE)
      throw c::InvalidArgument("rule " + std::to_string(rule) + " is none");
    const AnyFigure figure = c::figure_of(polygon, "polygon");
    *triangles = new plumb_triangles{triangles_of(figure, static_cast<WindingRule>(rule))};
  });
}

plumb_status plumb_delaunay(const double* points, std::size_t count, const std::uint32_t* segments,
                            std::size_t segment_count, plumb_triangles** triangles) {
  return guarded("plumb_delaunay", [&] {
    need(triangles, "triangles");
    need(segments, segment_count, "segments");
    std::vector<PlanarSegment> edges;
    for (std::size_t i = 0; i < segment_count; ++i) edges.push_back({segments[2 * i], segments[2 * i + 1]});
    *triangles = new plumb_triangles{delaunay(items<Point2>(points, count, "points"), edges).triangles};
  });
}

plumb_status plumb_triangles_of(const plumb_triangles* triangles, const std::uint32_t** indices, std::size_t* count) {
  return guarded("plumb_triangles_of", [&] {
    need(triangles, "triangles");
    need(indices, "indices");
    need(count, "count");
    *indices = triangles->triangles.empty() ? nullptr : triangles->triangles.front().data();
    *count = triangles->triangles.size();
  });
}

void plumb_triangles_destroy(plumb_triangles* triangles) { delete triangles; }

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
