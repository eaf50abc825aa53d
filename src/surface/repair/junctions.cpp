#include "surface/repair/junctions.hpp"

#include <algorithm>

#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "plumb/surface/topology/defects.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "surface/repair/weld_groups.hpp"
#include "surface/topology/between.hpp"
#include "surface/topology/box_around.hpp"

namespace plumb::surface {
namespace {

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

namespace {

/// Divides edges at vertices exactly on them, until none is.  Returns those that cannot be divided.
std::vector<EdgeDivision> divide_exactly(RepairWork& work) {
  std::vector<EdgeDivision> divisions, left;
  {
    const MeshEdges edges = find_edges(work.mesh);
    for (const VertexOnEdge& on :
         vertices_on_edges(edges, build_bvh(work.mesh, {.execution = work.execution}), work.execution))
      divisions.push_back({edges.edges[on.edge], on.vertex});
  }
  if (divisions.empty()) return left;
  const SoughtVertices vertices(work.mesh, named_vertices(work.mesh), work.execution);
  while (!divisions.empty()) {
    const Divided divided = divide_edges(work, std::move(divisions), OnEdge::exactly);
    left.insert(left.end(), divided.refused.begin(), divided.refused.end());
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
  return left;
}

std::vector<EdgeDivision> near_divisions(const RepairWork& work) {
  const MeshEdges edges = find_edges(work.mesh);
  const Bvh bvh = build_bvh(work.mesh, {.execution = work.execution});
  std::vector<EdgeDivision> divisions;
  for (const VertexOnEdge& near : vertices_near_edges(edges, bvh, work.step.tolerance, work.execution))
    divisions.push_back({edges.edges[near.edge], near.vertex});
  std::ranges::sort(divisions);
  return divisions;
}

/// Divides edges at vertices within the tolerance, as long as that leaves fewer of them.  Returns those that are left.
std::vector<EdgeDivision> divide_nearly(RepairWork& work) {
  std::vector<EdgeDivision> divisions = near_divisions(work);
  while (!divisions.empty()) {
    RepairWork trial{work.mesh, work.step, work.execution, {}};
    divide_edges(trial, divisions, OnEdge::nearly);
    std::vector<EdgeDivision> left = near_divisions(trial);
    if (left.size() >= divisions.size()) break;
    work.mesh = std::move(trial.mesh);
    work.changes.insert(work.changes.end(), trial.changes.begin(), trial.changes.end());
    divisions = std::move(left);
  }
  return divisions;
}

}  // namespace

void junctions_step(RepairWork& work) {
  std::vector<EdgeDivision> left = divide_exactly(work);
  if (work.step.tolerance != 0) {
    const std::vector<EdgeDivision> near = divide_nearly(work);
    left.insert(left.end(), near.begin(), near.end());
    std::ranges::sort(left);
    left.erase(std::unique(left.begin(), left.end()), left.end());
  }
  note_junctions(work, left);
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
