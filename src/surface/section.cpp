#include "plumb/surface/section.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

#include "figure/mesh_input.hpp"
#include "surface/cut_contours.hpp"
#include "surface/cut_nesting.hpp"
#include "surface/cut_segments.hpp"

namespace plumb {
namespace {

using surface::CutPlane;

void cut(const TriangleMesh& mesh, const CutPlane& plane, std::span<const std::uint32_t> triangles,
         std::span<const Sign> sides, Section& section) {
  const surface::CutSegments segments = surface::cut_segments(mesh, plane, triangles, sides, section);
  const surface::CutCorners corners(mesh, plane, segments.corners);
  const auto joined = surface::join_segments(segments, corners, section.touching_corners);
  std::vector<bool> is_used(segments.corners.size());
  for (const surface::CutContour& c : joined) {
    Contour& contour = section.contours.emplace_back();
    contour.closed = c.closed;
    for (const std::uint32_t corner : c.corners) {
      const SectionCorner& at = contour.corners.emplace_back(segments.corners[corner]);
      section.corners_on_vertices += at.below == at.above && !is_used[corner];
      is_used[corner] = true;
    }
  }
  surface::nest_contours(joined, corners, section.contours);
}

/// For planes of one coordinate, in ascending order: the triangles that reach each, ascending.
std::vector<std::vector<std::uint32_t>> triangles_at(const TriangleMesh& mesh, std::size_t axis,
                                                     const std::vector<double>& heights) {
  std::vector<std::vector<std::uint32_t>> reached(heights.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto at = [&](std::uint32_t v) { return surface::coordinate(mesh.vertices[v], axis); };
    const auto [low, high] = std::minmax({at(a), at(b), at(c)});
    for (auto h = std::lower_bound(heights.begin(), heights.end(), low); h != heights.end() && *h <= high; ++h)
      reached[static_cast<std::size_t>(h - heights.begin())].push_back(static_cast<std::uint32_t>(t));
  }
  return reached;
}

}  // namespace

std::vector<Section> sections(const TriangleMesh& mesh, std::span<const AnyPlane3> planes, OnPlane on_plane) {
  require_mesh("section", mesh);
  std::vector<Section> found(planes.size());
  std::vector<CutPlane> cuts;
  std::array<std::vector<std::size_t>, 3> flat;  // those of a coordinate
  std::vector<std::size_t> oblique;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    found[i].plane = planes[i];
    found[i].on_plane = on_plane;
    const surface::AxisPlane* const axis_plane = cuts.emplace_back(planes[i]).axis_plane();
    (axis_plane != nullptr ? flat[axis_plane->axis] : oblique).push_back(i);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<std::size_t>& order = flat[axis];
    if (order.empty()) continue;
    const auto height = [&](std::size_t i) { return cuts[i].axis_plane()->height; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
    std::vector<double> heights(order.size());
    std::transform(order.begin(), order.end(), heights.begin(), height);
    const auto triangles = triangles_at(mesh, axis, heights);
    tbb::parallel_for(std::size_t{0}, order.size(),
                      [&](std::size_t k) { cut(mesh, cuts[order[k]], triangles[k], {}, found[order[k]]); });
  }
  if (oblique.empty()) return found;
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  tbb::parallel_for(std::size_t{0}, oblique.size(), [&](std::size_t k) {
    const CutPlane& plane = cuts[oblique[k]];
    std::vector<Sign> sides(mesh.vertices.size());
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), sides.begin(),
                   [&](const Point3& p) { return plane.side(p); });
    cut(mesh, plane, all, sides, found[oblique[k]]);
  });
  return found;
}

Section section(const TriangleMesh& mesh, const AnyPlane3& plane, OnPlane on_plane) {
  return std::move(sections(mesh, {&plane, 1}, on_plane).front());
}

ExactPoint3 exact_corner(const TriangleMesh& mesh, const AnyPlane3& plane, const SectionCorner& corner) {
  const Point3 &p = mesh.vertices.at(corner.below), &q = mesh.vertices.at(corner.above);
  if (corner.below == corner.above) return p;
  return CutPlane(plane).exact(p, q);
}

}  // namespace plumb
