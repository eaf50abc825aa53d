// Do the tables of a mesh agree with one another, with their definitions over all pairs, and whatever the order of what went
// in?
#include <map>
#include <numeric>
#include <tuple>

#include "plumb/arith/rational.hpp"
#include "plumb/surface/topology/adjacency.hpp"
#include "plumb/surface/topology/components.hpp"
#include "plumb/surface/topology/defects.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "plumb/surface/topology/shells.hpp"
#include "triangle_heap.hpp"

namespace plumb::fuzz {
namespace {

bool names(const TriangleMesh::Triangle& t, std::uint32_t v) { return std::ranges::count(t, v) != 0; }
bool is_repeated(const TriangleMesh::Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

void ask_tables(const TriangleMesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  const HalfEdges half = half_edges(mesh, edges);
  for (std::uint32_t h = 0; h < half.twin.size(); ++h)
    if (half.twin[h] != no_half_edge && half.twin[half.twin[h]] != h) fail("a twin's twin is another");
  std::size_t in_loops = 0;
  for (const BoundaryLoop& loop : boundary_loops(mesh, edges)) in_loops += loop.vertices.size() - (loop.closed ? 0 : 1);
  if (in_loops != half.boundary.size()) fail("the loops are not the boundary");
  std::uint64_t faces = 0;
  for (const SurfaceKind& kind : surface_kinds(mesh, edges)) {
    faces += kind.faces;
    if (kind.edges != 0 && kind.genus() < 0) fail("a negative genus");
  }
  if (faces != mesh.triangles.size()) fail("a triangle is in no surface");
}

void ask_vertices(const TriangleMesh& mesh) {
  const FacesAtVertices at = faces_at_vertices(mesh);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f)
      if (names(mesh.triangles[f], v)) all.push_back(f);
    if (!std::ranges::equal(at[v], all)) fail("the triangles at a vertex are others");
  }
}

/// The triangles that `joined` joins, pair by pair, numbered by their first.
template <class Joined>
std::vector<std::uint32_t> joined_by_definition(const TriangleMesh& mesh, Joined joined) {
  std::vector<std::uint32_t> of(mesh.triangles.size());
  std::iota(of.begin(), of.end(), 0U);
  for (std::uint32_t f = 0; f < of.size(); ++f) {
    for (std::uint32_t g = 0; g < f; ++g) {
      if (of[f] == of[g] || !joined(f, g)) continue;
      const std::uint32_t from = std::max(of[f], of[g]), to = std::min(of[f], of[g]);
      std::ranges::replace(of, from, to);
    }
  }
  std::map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t& c : of) c = numbers.emplace(c, static_cast<std::uint32_t>(numbers.size())).first->second;
  return of;
}

void ask_components(const TriangleMesh& mesh, const MeshEdges& edges) {
  const auto over_vertices = [&](std::uint32_t f, std::uint32_t g) {
    return std::ranges::any_of(mesh.triangles[f], [&](std::uint32_t v) { return names(mesh.triangles[g], v); });
  };
  const auto over_edges = [&](bool manifold) {
    return [&, manifold](std::uint32_t f, std::uint32_t g) {
      if (is_repeated(mesh.triangles[f]) || is_repeated(mesh.triangles[g])) return false;
      for (std::size_t e = 0; e < edges.edges.size(); ++e) {
        const auto uses = edges.uses_of(e);
        const auto is_of = [&](std::uint32_t t) { return std::ranges::count(uses, t, &EdgeUse::face) != 0; };
        if (is_of(f) && is_of(g) && (!manifold || uses.size() == 2)) return true;
      }
      return false;
    };
  };
  if (connected_components(mesh).of != joined_by_definition(mesh, over_vertices)) fail("components over vertices");
  if (connected_components(mesh, edges, JoinedOver::vertices).of != connected_components(mesh).of)
    fail("components over vertices, with edges");
  if (connected_components(mesh, edges, JoinedOver::edges).of != joined_by_definition(mesh, over_edges(false)))
    fail("components over edges");
  if (connected_components(mesh, edges, JoinedOver::manifold_edges).of != joined_by_definition(mesh, over_edges(true)))
    fail("components over manifold edges");
}

struct Exact {
  Rational x, y, z;
};
Exact between(const Point3& p, const Point3& q) {
  return {Rational(q.x) - Rational(p.x), Rational(q.y) - Rational(p.y), Rational(q.z) - Rational(p.z)};
}
Rational dot(const Exact& a, const Exact& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The vertices that triangles name, within `length` of edges and strictly between their ends; those of length 0 are on
/// them, and others in no triangle at the edge.
std::vector<VertexOnEdge> by_edges(const TriangleMesh& mesh, const MeshEdges& edges, double length) {
  std::vector<VertexOnEdge> all;
  const FacesAtVertices at = faces_at_vertices(mesh);
  const Rational zero(0), most = Rational(length) * Rational(length);
  for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    if (at[v].empty()) continue;
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e) {
      const auto [a, b] = edges.edges[e];
      const Exact along = between(mesh.vertices[a], mesh.vertices[b]), to = between(mesh.vertices[a], mesh.vertices[v]);
      const Rational far = dot(along, to), whole = dot(along, along);
      if (!(zero < far) || !(far < whole) || most * whole < dot(to, to) * whole - far * far) continue;
      if (length != 0 && std::ranges::count(edges.uses_of(e), v, &EdgeUse::opposite) != 0) continue;
      all.push_back({v, e});
    }
  }
  return all;
}

void ask_defects(const TriangleMesh& mesh, const MeshEdges& edges) {
  const Bvh bvh = build_bvh(mesh, {.execution = Execution::serial});
  if (vertices_on_edges(edges, bvh, Execution::serial) != by_edges(mesh, edges, 0)) fail("vertices on edges");
  for (const double length : {0.5, 1.0}) {
    if (vertices_near_edges(edges, bvh, length, Execution::serial) != by_edges(mesh, edges, length))
      fail("vertices near edges");
  }
  std::map<std::set<std::array<double, 3>>, std::uint32_t> first;
  std::vector<std::array<std::uint32_t, 2>> coincident, said;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    std::set<std::array<double, 3>> points;
    for (const std::uint32_t v : mesh.triangles[f]) {
      const Point3& p = mesh.vertices[v];
      points.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
    }
    if (points.size() < 3) continue;
    const auto [with, is_new] = first.emplace(points, f);
    if (!is_new) coincident.push_back({f, with->second});
  }
  for (const CoincidentTriangle& c : coincident_triangles(mesh)) said.push_back({c.triangle, c.first});
  if (said != coincident) fail("coincident triangles");
}

using ShellTold = std::tuple<std::uint32_t, bool, bool, bool, bool, bool, Sign, std::uint32_t>;
std::multiset<ShellTold> shells_of(const TriangleMesh& mesh) {
  std::multiset<ShellTold> all;
  for (const Shell& s : find_shells(mesh, {.execution = Execution::serial}).shells)
    all.insert({s.triangles, s.closed, s.oriented, s.meets, s.crosses, s.wall, s.volume_sign, s.depth});
  return all;
}

void ask_order(const TriangleMesh& mesh) {
  const TriangleMesh other = turned_round(mesh);
  if (shells_of(mesh) != shells_of(other)) fail("the order of the input changes the shells");
  const SurfaceFaults here = find_faults(mesh, {.execution = Execution::serial}),
                      there = find_faults(other, {.execution = Execution::serial});
  if (here.any() != there.any() || here.closed != there.closed || here.oriented != there.oriented ||
      here.open_edges != there.open_edges || here.vertices_on_edges != there.vertices_on_edges ||
      here.non_manifold_vertices != there.non_manifold_vertices || here.non_manifold_edges != there.non_manifold_edges)
    fail("the order of the input changes the faults");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const TriangleMesh mesh = fuzz::heap_from(entropy);
  const MeshEdges edges = find_edges(mesh);
  fuzz::ask_tables(mesh);
  fuzz::ask_vertices(mesh);
  fuzz::ask_components(mesh, edges);
  fuzz::ask_defects(mesh, edges);
  fuzz::ask_order(mesh);
  return 0;
}
