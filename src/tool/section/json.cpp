#include <nlohmann/json.hpp>

#include "tool/section/command.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

json point(const Point3& p) { return {p.x, p.y, p.z}; }

json plane_json(const NamedPlane& plane) {
  json said{{"name", plane.name}, {"exact", plane.exact}};
  if (const auto* const given = std::get_if<Plane3>(&plane.plane)) {
    said["normal"] = {given->normal.x, given->normal.y, given->normal.z};
    said["offset"] = given->offset;
  } else {
    const auto& [a, b, c] = std::get<ThreePointPlane3>(plane.plane);
    said["three_points"] = {point(a), point(b), point(c)};
  }
  return said;
}

std::string_view word(const Contour& c) {
  if (!c.closed) return "open";
  return c.turn == Sign::positive ? "outer" : c.turn == Sign::negative ? "hole" : "without area";
}

}  // namespace

json section_json(const SectionReport& report) {
  json planes = json::array();
  for (std::size_t i = 0; i < report.planes.size(); ++i) {
    const Section& section = report.sections[i];
    json contours = json::array();
    for (std::size_t k = 0; k < section.contours.size(); ++k) {
      const Contour& c = section.contours[k];
      json corners = json::array(), edges = json::array();
      for (const SectionCorner& corner : c.corners) {
        corners.push_back(point(corner.nearest));
        edges.push_back({corner.below, corner.above});
      }
      contours.push_back({{"kind", word(c)},
                          {"closed", c.closed},
                          {"parent", c.parent ? json(*c.parent) : json()},
                          {"depth", c.depth},
                          {"area", report.measured[i][k].area},
                          {"length", report.measured[i][k].length},
                          {"corners", std::move(corners)},
                          {"cut_edges", std::move(edges)}});
    }
    json said = plane_json(report.planes[i]);
    said.update({{"contours", std::move(contours)},
                 {"coplanar_triangles", section.coplanar_triangles},
                 {"cut_triangles", section.cut_triangles},
                 {"corners_on_vertices", section.corners_on_vertices},
                 {"touching_corners", section.touching_corners},
                 {"canceled_segments", section.canceled_segments}});
    planes.push_back(std::move(said));
  }
  const bool above = report.sections.empty() || report.sections.front().on_plane == OnPlane::above;
  json said = origin_json("plumb section");
  said.update({{"meshes",
                {{{"mesh", report.mesh_name},
                  {"vertices", report.mesh.vertices.size()},
                  {"triangles", report.mesh.triangles.size()}}}},
               {"vertices_in_a_plane_count_as", above ? "above" : "below"},
               {"planes", std::move(planes)}});
  return said;
}

}  // namespace plumb::tool
