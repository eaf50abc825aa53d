// The page of a repair.  Pictures are in rounded numbers: what is drawn is near to what was decided.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "tool/check/surface.hpp"
#include "tool/drawing/chart.hpp"
#include "tool/drawing/drawn_mesh.hpp"
#include "tool/drawing/mesh_view.hpp"
#include "tool/drawing/report_page.hpp"
#include "tool/repair/command.hpp"
#include "tool/repair/page_view.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

/// Larger meshes are drawn about the changes alone, and thinned elsewhere.
constexpr std::size_t most_drawn = 100'000;

using Corners = std::array<std::array<double, 3>, 3>;

/// From the least point on, with +0 for -0.
Corners drawn_corners(const TriangleMesh& mesh, const TriangleMesh::Triangle& t) {
  Corners c;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3& p = mesh.vertices[t[k]];
    c[k] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
  }
  std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  return c;
}

std::vector<Corners> sorted_triangles(const TriangleMesh& mesh) {
  std::vector<Corners> all;
  all.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) all.push_back(drawn_corners(mesh, t));
  std::sort(all.begin(), all.end());
  return all;
}

/// Marks the triangles that the other mesh does not have as often.
std::vector<std::uint8_t> not_in(const TriangleMesh& mesh, const TriangleMesh& other) {
  const std::vector<Corners> others = sorted_triangles(other);
  std::vector<std::size_t> met(others.size());  // how often the first of equal ones was
  std::vector<std::uint8_t> marked(mesh.triangles.size());
  for (std::size_t t = 0; t < marked.size(); ++t) {
    const auto [first, last] = std::equal_range(others.begin(), others.end(), drawn_corners(mesh, mesh.triangles[t]));
    marked[t] = first == last ||
                ++met[static_cast<std::size_t>(first - others.begin())] > static_cast<std::size_t>(last - first);
  }
  return marked;
}

/// Which triangles are drawn: all, or those that were changed and some rings about them, and every so many of the rest.
std::vector<std::uint32_t> drawn(const TriangleMesh& mesh, const std::vector<std::uint8_t>& changed) {
  std::vector<std::uint8_t> near(mesh.vertices.size());
  const std::size_t n = mesh.triangles.size();
  if (n > most_drawn) {
    for (std::size_t t = 0; t < n; ++t)
      if (changed[t] != 0)
        for (const std::uint32_t v : mesh.triangles[t]) near[v] = 1;
    for (std::uint8_t ring = 1; ring < 4; ++ring)
      for (const auto& t : mesh.triangles)
        if (std::ranges::any_of(t, [&](std::uint32_t v) { return near[v] == ring; }))
          for (const std::uint32_t v : t)
            if (near[v] == 0) near[v] = ring + 1;
  }
  const std::size_t stride = n / most_drawn + 1;
  std::vector<std::uint32_t> all;
  for (std::uint32_t t = 0; t < n; ++t)
    if (t % stride == 0 || std::ranges::any_of(mesh.triangles[t], [&](std::uint32_t v) { return near[v] != 0; }))
      all.push_back(t);
  return all;
}

/// A mesh for the script: points and triangles in a row, which triangles changed, and the edges that are wrong.
json part_of(const TriangleMesh& mesh, const std::vector<std::uint8_t>& changed, const DrawnCube& cube) {
  DrawnMesh made(mesh, cube);
  std::vector<std::uint32_t> altered, open, crowded;
  for (const std::uint32_t t : drawn(mesh, changed)) {
    if (changed[t] != 0) altered.push_back(static_cast<std::uint32_t>(made.triangles().size() / 3));
    made.add(t);
  }
  const MeshEdges edges = find_edges(mesh);
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const std::size_t uses = edges.uses_of(e).size();
    if (uses == 2) continue;
    for (const std::uint32_t v : edges.edges[e]) (uses == 1 ? open : crowded).push_back(made.number_of(v));
  }
  return {{"points", made.points()},
          {"triangles", made.triangles()},
          {"changed", altered},
          {"open", open},
          {"crowded", crowded}};
}

std::string row_of(const RepairChange& c, std::size_t mesh) {
  std::string about = c.count != 1 ? grouped(c.count) : "";
  if (c.distance != 0) about = fmt::format("{} away", c.distance);
  return fmt::format(
      "<tr data-mesh=\"{}\" data-change=\"{}\"><td><button type=\"button\">{}</button></td><td>{}</td><td>{}</td><td>{}"
      "</td><td>{}</td><td>{}</td></tr>\n",
      mesh, escaped(text_of(c.kind)), escaped(text_of(c.kind)), name_of(c.step), c.place.x, c.place.y, c.place.z,
      about);
}

}  // namespace

void RepairPage::add(const TriangleMesh& before, const MendedMesh& m) {
  const DrawnCube cube({&before, 1});
  json places = json::array(), left = json::array();
  std::string rows;
  const std::size_t count = std::min(m.done.changes.size(), most_places);
  for (std::size_t i = 0; i < count; ++i) {
    const RepairChange& c = m.done.changes[i];
    places.push_back(json(cube.of(c.place)));
    left.push_back(is_left(c.kind));
    rows += row_of(c, scenes_.size());
    kinds_[static_cast<std::size_t>(c.kind)] = true;
  }
  std::string more;
  if (count < m.done.changes.size())
    more = fmt::format("<p>and {} more changes, which the pictures show.</p>", grouped(m.done.changes.size() - count));
  if (std::max(before.triangles.size(), m.done.mesh.triangles.size()) > most_drawn)
    more += "<p>So large a mesh is drawn whole about the changes alone; elsewhere triangles are missing.</p>";
  body_ += fmt::format(
      "<article><h3>{}</h3>\n<p>was {}<br>is {}</p>\n<div class=\"counts\"><table><thead><tr><th scope=\"col\">change"
      "</th><th scope=\"col\">step</th><th scope=\"col\">x</th><th scope=\"col\">y</th><th scope=\"col\">z</th><th "
      "scope=\"col\">how many, how far</th></tr></thead>\n<tbody>\n{}</tbody></table></div>{}</article>\n",
      escaped(printable(m.name)), escaped(surface_verdict(m.before)), escaped(surface_verdict(m.done.faults)),
      rows.empty() ? "<tr><td colspan=\"6\">nothing was changed</td></tr>\n" : rows, more);
  scenes_.push_back({{"name", printable(m.name)},
                     {"was", surface_verdict(m.before)},
                     {"is", surface_verdict(m.done.faults)},
                     {"places", std::move(places)},
                     {"left", std::move(left)},
                     {"before", part_of(before, not_in(before, m.done.mesh), cube)},
                     {"after", part_of(m.done.mesh, not_in(m.done.mesh, before), cube)}});
}

std::string RepairPage::text() const {
  PageFilter changes{"change", "Changes", {}};
  for (std::size_t k = 0; k < change_kinds; ++k)
    if (kinds_[k]) changes.names.emplace_back(text_of(static_cast<ChangeKind>(k)));
  ReportPage page{"Repair: before and after",
                  "Repair: before and after",
                  plural(scenes_.size(), "mesh", "meshes"),
                  "What was wrong with each mesh, what was changed, and what is left. Coordinates are rounded for the "
                  "pictures alone.",
                  {},
                  fmt::format("<section><article class=\"script\" hidden id=\"stage\">{}</article>\n{}</section>\n{}{}",
                              repair_stage, body_, mesh_view_script, repair_script)};
  if (!changes.names.empty()) page.filters.push_back(std::move(changes));
  json raw = origin_json("plumb repair");
  raw["scenes"] = scenes_;
  return report_page(page, raw);
}

}  // namespace plumb::tool
