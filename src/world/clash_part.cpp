#include <algorithm>
#include <tuple>
#include <utility>

#include "plumb/predicates.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/solid/arrangement.hpp"
#include "plumb/surface/topology/components.hpp"
#include "surface/solid/face_pool.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "world/clash_surface.hpp"

namespace plumb {
namespace {

Aabb3 box_of_triangles(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  Aabb3 box{mesh.vertices[mesh.triangles[0][0]], mesh.vertices[mesh.triangles[0][0]]};
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t v : corners) {
      const Point3& p = mesh.vertices[v];
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
  }
  return box;
}

bool has_equal_points(std::vector<Point3> points) {
  const auto key = [](const Point3& p) { return std::tie(p.x, p.y, p.z); };
  std::ranges::sort(points, [&](const Point3& l, const Point3& r) { return key(l) < key(r); });
  return std::ranges::adjacent_find(points, [&](const Point3& l, const Point3& r) { return key(l) == key(r); }) !=
         points.end();
}

/// Do numbers of vertices alone say that it is closed, and that no two triangles cancel one another?
bool is_plainly_closed(const TriangleMesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 2 || uses[0].forward == uses[1].forward || uses[0].opposite == uses[1].opposite) return false;
  }
  return !has_equal_points(mesh.vertices);
}

/// A vertex of each component: a corner of its first triangle that has an area, or where it need not bound, of any.
ClashPart::Shells shells_by_number(const TriangleMesh& mesh, bool must_bound) {
  const Components all = connected_components(mesh);
  std::vector<std::uint32_t> number(all.count, ClashPart::no_shell);
  ClashPart::Shells shells;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& of = number[all.of[t]];
    if (of != ClashPart::no_shell) continue;
    const auto& [a, b, c] = mesh.triangles[t];
    if (must_bound && collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])) continue;
    of = static_cast<std::uint32_t>(shells.vertices.size());
    shells.vertices.push_back(a);
  }
  for (const std::uint32_t component : all.of) shells.of.push_back(number[component]);
  return shells;
}

/// Components of what is left where equal points are one and nothing cancels.
ClashPart::Shells shells_of_pool(const surface::FacePool& pool, const TriangleMesh& mesh) {
  surface::DisjointSets sets(pool.mesh.vertices.size());
  for (const auto& [a, b, c] : pool.mesh.triangles) sets.unite(a, b), sets.unite(b, c);
  std::vector<std::uint32_t> number(pool.mesh.vertices.size(), ClashPart::no_shell);
  ClashPart::Shells shells{std::vector<std::uint32_t>(mesh.triangles.size(), ClashPart::no_shell), {}};
  for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
    const std::uint32_t first = sets.find(pool.mesh.triangles[f][0]);
    if (number[first] == ClashPart::no_shell) {
      number[first] = static_cast<std::uint32_t>(shells.vertices.size());
      shells.vertices.push_back(mesh.triangles[pool.uses_of(f).front().face.triangle][0]);
    }
    for (const FacetSource& use : pool.uses_of(f)) shells.of[use.face.triangle] = number[first];
  }
  return shells;
}

/// Neighbors over edges, of a plainly closed mesh.
std::vector<std::array<std::uint32_t, 3>> neighbors_over_edges(const TriangleMesh& mesh, const MeshEdges& edges) {
  std::vector<std::array<std::uint32_t, 3>> all(mesh.triangles.size());
  const auto put = [&](const EdgeUse& use, std::uint32_t other) {
    const TriangleMesh::Triangle& t = mesh.triangles[use.face];
    const std::size_t opposite = t[0] == use.opposite ? 0 : t[1] == use.opposite ? 1 : 2;
    all[use.face][(opposite + 1) % 3] = other;
  };
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    put(uses[0], uses[1].face);
    put(uses[1], uses[0].face);
  }
  return all;
}

}  // namespace

bool ClashPart::is_simple() const {
  std::call_once(surface_->simple_asked, [this] {
    if (!surface_->plainly_closed) return;
    for (const auto& [a, b, c] : mesh_->triangles)
      if (collinear(mesh_->vertices[a], mesh_->vertices[b], mesh_->vertices[c])) return;
    const MeshEdges edges = find_edges(*mesh_);
    if (connected_components(*mesh_, edges, JoinedOver::manifold_edges).count != 1) return;
    if (any_intersecting_pair(bvh_, {.execution = Execution::serial})) return;
    surface_->neighbors = neighbors_over_edges(*mesh_, edges);
    surface_->simple = true;
  });
  return surface_->simple;
}

const std::vector<std::array<std::uint32_t, 3>>& ClashPart::neighbors() const { return surface_->neighbors; }

ClashPart::ClashPart(TriangleMesh mesh, Execution execution)
    : ClashPart(std::make_shared<const TriangleMesh>(std::move(mesh)), execution) {}

ClashPart::ClashPart(std::shared_ptr<const TriangleMesh> mesh, Execution execution)
    : mesh_(std::move(mesh)), surface_(std::make_shared<Surface>()) {
  bvh_ = build_bvh(*mesh_, {.execution = execution});  // which refuses what is no mesh
  box_ = box_of_triangles(*mesh_);
  if (empty()) return;
  if (is_plainly_closed(*mesh_)) {
    surface_->plainly_closed = solid_ = true;
    shells_ = shells_by_number(*mesh_, true);
    return;
  }
  try {
    const surface::FacePool pool = surface::pool_faces({mesh_.get(), 1});
    solid_ = !pool.mesh.triangles.empty();
    if (solid_) shells_ = shells_of_pool(pool, *mesh_);
  } catch (const UnbalancedEdge&) {
  }
  if (!solid_) shells_ = shells_by_number(*mesh_, false);
}

}  // namespace plumb
