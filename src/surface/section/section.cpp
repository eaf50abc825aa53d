#include "plumb/surface/section/section.hpp"

#include <algorithm>

#include "certify/batch/all_threads.hpp"
#include "figure/basic/mesh_input.hpp"
#include "surface/section/cut_contours.hpp"
#include "surface/section/cut_nesting.hpp"
#include "surface/section/cut_segments.hpp"
#include "surface/section/plane_sweep.hpp"

namespace plumb {
namespace {

using surface::CutPlane;

void cut(const TriangleMesh& mesh, const CutPlane& plane, const surface::PlaneSweep& sweep, std::size_t place,
         Section& section) {
  const surface::CutSegments segments = surface::cut_segments(mesh, plane, sweep, place, section);
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

}  // namespace

std::vector<Section> sections(const TriangleMesh& mesh, std::span<const AnyPlane3> planes, OnPlane on_plane) {
  require_mesh("section", mesh);
  std::vector<Section> found(planes.size());
  std::vector<CutPlane> cuts;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    found[i].plane = planes[i];
    found[i].on_plane = on_plane;
    cuts.emplace_back(planes[i]);
  }
  const std::vector<std::vector<std::uint32_t>> runs = surface::planes_by_normal(planes);
  certify::batch::for_each_part(Execution::parallel, runs.size(), [&](std::size_t r) {
    std::vector<const CutPlane*> run;
    for (const std::uint32_t i : runs[r]) run.push_back(&cuts[i]);
    const surface::PlaneSweep sweep(mesh, run);
    certify::batch::for_each_part(Execution::parallel, run.size(),
                                  [&](std::size_t k) { cut(mesh, *run[k], sweep, k, found[runs[r][k]]); });
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
