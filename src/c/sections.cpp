#include <memory>

#include "c/figures.hpp"
#include "c/solids.hpp"
#include "plumb/surface/section/section.hpp"
#include "plumb/surface/solid/split.hpp"

using namespace plumb;
using c::guarded, c::need, c::need_size;

struct plumb_contours {
  std::vector<std::vector<Point3>> points;
  std::vector<plumb_contour> each;
};

namespace {

AnyPlane3 plane_in(const plumb_figure* given) {
  const AnyFigure figure = c::figure_of(given, "planes");
  if (!figure.is_posed()) {
    if (const auto* plane = get_if<Plane3>(figure)) return *plane;
    if (const auto* plane = get_if<ThreePointPlane3>(figure)) return *plane;
  }
  throw Unsupported("planes are of three points or of a normal, without a pose");
}

void add_contours(const Section& cut, std::size_t plane, plumb_contours& to) {
  const auto before = static_cast<std::int64_t>(to.each.size());
  for (const Contour& contour : cut.contours) {
    std::vector<Point3>& points = to.points.emplace_back();
    for (const SectionCorner& corner : contour.corners) points.push_back(corner.nearest);
    const std::int64_t parent = contour.parent ? before + *contour.parent : -1;
    to.each.push_back({reinterpret_cast<const double*>(points.data()), points.size(), plane, contour.depth, parent,
                       contour.closed, static_cast<std::int32_t>(contour.turn)});
  }
}

}  // namespace

extern "C" {

plumb_status plumb_mesh_sections(const plumb_mesh* mesh, const plumb_figure* planes, std::size_t count, int are_below,
                                 plumb_contours** contours) {
  return guarded("plumb_mesh_sections", [&] {
    need(mesh, "mesh");
    need(planes, count, "planes");
    need(contours, "contours");
    std::vector<AnyPlane3> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(plane_in(planes + i));
    auto made = std::make_unique<plumb_contours>();
    std::size_t plane = 0;
    for (const Section& cut : sections(mesh->mesh, all, are_below != 0 ? OnPlane::below : OnPlane::above))
      add_contours(cut, plane++, *made);
    *contours = made.release();
  });
}

plumb_status plumb_contours_of(const plumb_contours* contours, const plumb_contour** each, std::size_t* count) {
  return guarded("plumb_contours_of", [&] {
    need(contours, "contours");
    need(each, "each");
    need(count, "count");
    *each = contours->each.data();
    *count = contours->each.size();
  });
}

void plumb_contours_destroy(plumb_contours* contours) { delete contours; }

plumb_status plumb_mesh_split(const plumb_mesh* mesh, const plumb_figure* plane, plumb_mesh** above, plumb_mesh** below,
                              plumb_solid_report* of_above, plumb_solid_report* of_below) {
  return guarded("plumb_mesh_split", [&] {
    need(mesh, "mesh");
    need(plane, "plane");
    need(above, "above");
    need(below, "below");
    if (of_above != nullptr) need_size(of_above, "of_above");
    if (of_below != nullptr) need_size(of_below, "of_below");
    const SplitSolid halves = split(resolve(mesh->mesh), plane_in(plane));
    RoundedMesh upper = round(halves.above), lower = round(halves.below);
    std::unique_ptr<plumb_mesh> first(c::told_solid(std::move(upper), of_above));
    *below = c::told_solid(std::move(lower), of_below);
    *above = first.release();
  });
}

plumb_status plumb_mesh_resolve(const plumb_mesh* mesh, int rule, int merges, plumb_mesh** result,
                                plumb_solid_report* report) {
  return guarded("plumb_mesh_resolve", [&] {
    need(mesh, "mesh");
    need(result, "result");
    if (report != nullptr) need_size(report, "report");
    c::need_choice(rule, PLUMB_POSITIVE, "rule");
    RoundedMesh made = round(resolve(mesh->mesh, static_cast<WindingRule>(rule), c::pieces_of(merges)));
    *result = c::told_solid(std::move(made), report);
  });
}

}  // extern "C"
