#include "surface/repair/junctions.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/surface/topology/defects.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "surface/repair/weld_groups.hpp"
#include "surface/topology/between.hpp"

namespace plumb::surface {
namespace {

constexpr double greatest = std::numeric_limits<double>::max();

double below(double x, double length) { return std::max(-greatest, std::nextafter(x - length, -greatest)); }
double above(double x, double length) { return std::min(greatest, std::nextafter(x + length, greatest)); }

/// A box that holds all within the length of a segment.
Aabb3 box_around(const Point3& a, const Point3& b, double length) {
  const auto [x, X] = std::minmax(a.x, b.x);
  const auto [y, Y] = std::minmax(a.y, b.y);
  const auto [z, Z] = std::minmax(a.z, b.z);
  if (length == 0) return {{x, y, z}, {X, Y, Z}};
  return {{below(x, length), below(y, length), below(z, length)},
          {above(X, length), above(Y, length), above(Z, length)}};
}

bool runs_by(const Point3& a, const Point3& p, const Point3& b, double length) {
  return p != a && p != b && angle_sign(p, a, b) == Sign::positive && angle_sign(p, b, a) == Sign::positive &&
         compare_distance_to_segment(a, b, p, length) != Sign::positive;
}

std::vector<std::uint8_t> named_vertices(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> named(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) named[v] = 1;
  return named;
}

/// Both ends of the edges of one triangle.
std::vector<std::uint8_t> open_ends(const TriangleMesh& mesh, const MeshEdges& edges) {
  std::vector<std::uint8_t> open(mesh.vertices.size());
  for (std::size_t e = 0; e < edges.edges.size(); ++e)
    if (edges.uses_of(e).size() == 1) open[edges.edges[e][0]] = open[edges.edges[e][1]] = 1;
  return open;
}

std::uint64_t open_edge_count(const MeshEdges& edges) {
  std::uint64_t count = 0;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) count += edges.uses_of(e).size() == 1;
  return count;
}

void note_junctions(RepairWork& work, const std::vector<EdgeDivision>& refused) {
  for (const EdgeDivision& d : refused) work.note(ChangeKind::kept_junction, d.vertex);
}

/// Of each vertex the first equal one, both being marked; else its own number.
std::vector<std::uint32_t> first_equal_among(std::span<const Point3> points, std::span<const std::uint8_t> among) {
  const std::vector<std::uint32_t> equal = first_equal(points);
  std::vector<std::uint32_t> first(points.size()), first_marked(points.size(), no_group);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    first[v] = v;
    if (among[v] == 0) continue;
    std::uint32_t& marked = first_marked[equal[v]];
    if (marked == no_group) marked = v;
    first[v] = marked;
  }
  return first;
}

/// Welds the ends of open edges within the tolerance.
void weld_open_ends(RepairWork& work) {
  const std::vector<std::uint8_t> open = open_ends(work.mesh, find_edges(work.mesh));
  const std::vector<std::uint32_t> first = first_equal_among(work.mesh.vertices, open);
  const RepairStep& s = work.step;
  const WeldOptions options{
      .tolerance = s.tolerance, .rule = s.rule, .turned_over = s.turned_over, .execution = work.execution};
  apply_weld(work, weld_into(work.mesh, first, weld_groups(work.mesh.vertices, first, open, options), s.turned_over));
}

}  // namespace

SoughtVertices::SoughtVertices(const TriangleMesh& mesh, std::span<const std::uint8_t> among, Execution execution)
    : mesh_(mesh) {
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < among.size(); ++v) {
    if (among[v] == 0) continue;
    vertex_.push_back(v);
    points.push_back(mesh.vertices[v]);
  }
  tree_ = build_kd_tree(points, {.execution = execution});
}

void SoughtVertices::near_edge(const std::array<std::uint32_t, 2>& edge, double length,
                               std::vector<EdgeDivision>& out) const {
  const Point3 &a = mesh_.vertices[edge[0]], &b = mesh_.vertices[edge[1]];
  found_ = in_box(tree_, box_around(a, b, length), {}, std::move(found_));
  for (const std::uint32_t i : found_) {
    const Point3& p = mesh_.vertices[vertex_[i]];
    if (length == 0 ? is_strictly_between(a, p, b) : runs_by(a, p, b, length)) out.push_back({edge, vertex_[i]});
  }
}

void junctions_step(RepairWork& work) {
  std::vector<EdgeDivision> divisions;
  {
    const MeshEdges edges = find_edges(work.mesh);
    for (const VertexOnEdge& on :
         vertices_on_edges(edges, build_bvh(work.mesh, {.execution = work.execution}), work.execution))
      divisions.push_back({edges.edges[on.edge], on.vertex});
  }
  if (divisions.empty()) return;
  const SoughtVertices vertices(work.mesh, named_vertices(work.mesh), work.execution);
  while (!divisions.empty()) {
    const Divided divided = divide_edges(work, std::move(divisions), OnEdge::exactly);
    note_junctions(work, divided.refused);
    divisions.clear();
    std::vector<std::array<std::uint32_t, 2>> edges;  // of the parts: others have been looked at
    for (const std::uint32_t t : divided.parts) {
      const auto& corners = work.mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = corners[k], to = corners[(k + 1) % 3];
        edges.push_back({std::min(from, to), std::max(from, to)});
      }
    }
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& edge : edges) vertices.near_edge(edge, 0, divisions);
    std::erase_if(divisions, [&](const EdgeDivision& d) { return std::ranges::binary_search(divided.refused, d); });
  }
}

void zip_step(RepairWork& work) {
  weld_open_ends(work);
  for (;;) {
    const MeshEdges edges = find_edges(work.mesh);
    const std::uint64_t before = open_edge_count(edges);
    if (before == 0) return;
    const SoughtVertices ends(work.mesh, open_ends(work.mesh, edges), work.execution);
    std::vector<EdgeDivision> divisions;
    for (std::size_t e = 0; e < edges.edges.size(); ++e)
      if (edges.uses_of(e).size() == 1) ends.near_edge(edges.edges[e], work.step.tolerance, divisions);
    if (divisions.empty()) return;
    RepairWork trial{work.mesh, work.step, work.execution, {}};
    const Divided divided = divide_edges(trial, std::move(divisions), OnEdge::nearly);
    if (open_edge_count(find_edges(trial.mesh)) >= before) return;  // nothing is closed by it
    work.mesh = std::move(trial.mesh);
    work.changes.insert(work.changes.end(), trial.changes.begin(), trial.changes.end());
    note_junctions(work, divided.refused);
  }
}

}  // namespace plumb::surface
