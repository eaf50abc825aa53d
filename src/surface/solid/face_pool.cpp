#include "surface/solid/face_pool.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "arith/shortest_decimal.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "surface/solid/point_table.hpp"
#include "surface/solid/sort_by_first.hpp"

namespace plumb::surface {
namespace {

std::string place_text(const Point3& p) {
  std::string text;
  for (const double x : {p.x, p.y, p.z}) text.append(text.empty() ? "(" : ", ").append(arith::shortest_decimal(x));
  return text.append(")");
}

std::string triangle_text(std::uint32_t mesh, std::uint32_t triangle) {
  return "triangle " + std::to_string(triangle) + " of mesh " + std::to_string(mesh);
}

const TriangleMesh& mesh_at(const TriangleMesh& mesh) { return mesh; }
template <class Mesh>
const Mesh& mesh_at(const Mesh* mesh) {
  return *mesh;
}
const Point3* given_in(const Point3& p) { return &p; }
const Point3* given_in(const ExactPoint3& p) { return std::get_if<Point3>(&p.as()); }

/// What is constructed looks at its numbers itself.
void require_finite_point(const Point3* p, std::uint32_t mesh, std::uint32_t vertex) {
  if (p == nullptr || (p->x - p->x == 0 && p->y - p->y == 0 && p->z - p->z == 0)) return;
  throw NonFinite("arrange: vertex " + std::to_string(vertex) + " of mesh " + std::to_string(mesh) + " is " +
                  place_text(*p) + ", not a point; give finite coordinates");
}

template <class Meshes>
void require_points(const Meshes& meshes) {
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    const auto& mesh = mesh_at(meshes[m]);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t v : mesh.triangles[t]) {
        if (v >= mesh.vertices.size())
          throw InvalidShape("arrange: " + triangle_text(m, t) + " names vertex " + std::to_string(v) +
                             ", and there are " + std::to_string(mesh.vertices.size()));
        require_finite_point(given_in(mesh.vertices[v]), m, v);
      }
    }
  }
}

struct VertexOfMesh {
  std::uint32_t mesh, vertex;
};
using NumbersInPool = std::vector<std::vector<std::uint32_t>>;  // of each mesh's vertices

/// Puts those in the pool that no doubles hold, behind all others.
void pool_held(std::vector<std::pair<ExactPoint3, VertexOfMesh>> used, FacePool& pool, NumbersInPool& number) {
  std::ranges::sort(used, [](const auto& l, const auto& r) { return compare_xyz(l.first, r.first) == Sign::negative; });
  for (auto& [at, of] : used) {
    if (pool.held.empty() || pool.held.back() != at) {
      pool.mesh.vertices.push_back(approximate(at));
      pool.held.push_back(std::move(at));
    }
    number[of.mesh][of.vertex] = static_cast<std::uint32_t>(pool.mesh.vertices.size() - 1);
  }
}

/// Numbers in the pool for each mesh's vertices; those that no triangle names have none.
template <class Meshes>
NumbersInPool pool_vertices(const Meshes& meshes, FacePool& pool) {
  struct Use {
    Point3 at;
    VertexOfMesh of;
  };
  std::vector<Use> used;
  std::vector<std::pair<ExactPoint3, VertexOfMesh>> held;
  NumbersInPool number(meshes.size());
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    const auto& mesh = mesh_at(meshes[m]);
    number[m].assign(mesh.vertices.size(), 0);
    for (const auto& corners : mesh.triangles)
      for (const std::uint32_t v : corners) number[m][v] = 1;
    const auto add = [&](const Point3& p, std::uint32_t v) {
      used.push_back({{p.x + 0.0, p.y + 0.0, p.z + 0.0}, {m, v}});  // no zero has a sign
    };
    for (std::uint32_t v = 0; v < number[m].size(); ++v) {
      if (number[m][v] == 0) continue;
      if (const Point3* given = given_in(mesh.vertices[v]); given != nullptr) {
        add(*given, v);
        continue;
      }
      ExactPoint3 plain = in_plain_form(mesh.vertices[v]);
      if (const Point3* given = given_in(plain); given != nullptr)
        add(*given, v);
      else
        held.push_back({std::move(plain), {m, v}});
    }
  }
  const auto key = [](const Use& u) { return std::tie(u.at.x, u.at.y, u.at.z); };
  std::ranges::sort(used, [&](const Use& l, const Use& r) { return key(l) < key(r); });
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (i == 0 || key(used[i - 1]) != key(used[i])) pool.mesh.vertices.push_back(used[i].at);
    number[used[i].of.mesh][used[i].of.vertex] = static_cast<std::uint32_t>(pool.mesh.vertices.size() - 1);
  }
  pool_held(std::move(held), pool, number);
  return number;
}

/// Throws for an edge along which a mesh runs more often one way than the other.
void require_closed(const FacePool& pool, std::span<const PooledTriangle> all) {
  struct Run {
    std::uint32_t mesh, from, to, triangle;
    bool forward;
  };
  std::vector<Run> runs;
  runs.reserve(3 * all.size());
  for (const auto& [corners, source] : all) {
    if (pool.is_sheet(source.face.mesh)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      runs.push_back(
          {source.face.mesh, std::min(a, b), std::max(a, b), source.face.triangle, (a < b) != source.opposite});
    }
  }
  const auto key = [](const Run& r) { return std::tie(r.mesh, r.from, r.to); };
  sort_by_first(
      runs, pool.mesh.vertices.size(), [](const Run& r) { return r.from; },
      [](const Run& l, const Run& r) {
        return std::tie(l.from, l.mesh, l.to, l.triangle) < std::tie(r.from, r.mesh, r.to, r.triangle);
      });
  const Run* found = nullptr;  // the first by its mesh, then by its ends
  bool is_open = false;
  for (std::size_t i = 0, next = 0; i < runs.size(); i = next) {
    int flow = 0;
    for (next = i; next < runs.size() && key(runs[next]) == key(runs[i]); ++next) flow += runs[next].forward ? 1 : -1;
    if (flow == 0 || (found != nullptr && key(*found) < key(runs[i]))) continue;
    found = &runs[i];
    is_open = (next - i) % 2 != 0;
  }
  if (found == nullptr) return;
  const std::array<Point3, 2> ends{pool.mesh.vertices[found->from], pool.mesh.vertices[found->to]};
  const std::string where = "the edge from " + place_text(ends[0]) + " to " + place_text(ends[1]) + ", of " +
                            triangle_text(found->mesh, found->triangle);
  throw UnbalancedEdge(is_open ? "arrange: the mesh is open at " + where + "; close it, or repair it"
                               : "arrange: triangles run against each other along " + where + "; repair winds them",
                       {found->mesh, found->triangle}, ends, is_open);
}

/// Do as many uses turn one way as the other, in each mesh, and none of them in a sheet?
bool is_canceled(std::span<const FacetSource> uses, const FacePool& pool) {
  if (pool.is_sheet(uses.back().face.mesh)) return false;
  int flow = 0;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    flow += uses[i].opposite ? -1 : 1;
    const bool is_last = i + 1 == uses.size() || uses[i + 1].face.mesh != uses[i].face.mesh;
    if (is_last && flow != 0) return false;
  }
  return true;
}

template <class Meshes>
FacePool pooled(const Meshes& meshes, bool must_be_closed, std::uint32_t sheets = 0) {
  require_points(meshes);
  FacePool pool;
  pool.meshes = static_cast<std::uint32_t>(meshes.size());
  pool.sheets = sheets;
  const auto number = pool_vertices(meshes, pool);
  std::vector<PooledTriangle> all;
  for (std::uint32_t m = 0; m < meshes.size(); ++m) {
    const auto& triangles = mesh_at(meshes[m]).triangles;
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      const auto& given = triangles[t];
      const std::uint32_t a = number[m][given[0]], b = number[m][given[1]], c = number[m][given[2]];
      if (a == b || b == c || c == a) continue;  // its edges cancel one another
      TriangleMesh::Triangle corners{a, b, c};
      std::ranges::sort(corners);
      const bool turns = (a < b) + (b < c) + (c < a) == 2;
      all.push_back({corners, {{m, t}, !turns}});
    }
  }
  if (must_be_closed) require_closed(pool, all);
  add_faces(pool, std::move(all));
  return pool;
}

}  // namespace

FacePool pool_faces(std::span<const TriangleMesh> meshes) { return pooled(meshes, true); }
FacePool pool_faces(std::span<const ExactMesh* const> meshes) { return pooled(meshes, true); }
FacePool pool_faces(std::span<const TriangleMesh* const> meshes, std::uint32_t sheets) {
  return pooled(meshes, true, sheets);
}
FacePool pool_open_faces(std::span<const TriangleMesh> meshes) { return pooled(meshes, false); }

void add_faces(FacePool& pool, std::vector<PooledTriangle> all) {
  sort_by_first(
      all, pool.mesh.vertices.size(), [](const PooledTriangle& t) { return t.corners[0]; },
      [](const PooledTriangle& l, const PooledTriangle& r) {
        return std::tie(l.corners, l.source) < std::tie(r.corners, r.source);
      });
  const NumberedPoints points = pool.points();
  for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
    const std::size_t first = pool.uses.size();
    for (next = i; next < all.size() && all[next].corners == all[i].corners; ++next)
      pool.uses.push_back(all[next].source);
    const auto& [a, b, c] = all[i].corners;
    if (is_canceled(std::span(pool.uses).subspan(first), pool) || points.is_straight(a, b, c)) {
      pool.uses.resize(first);
      continue;
    }
    pool.mesh.triangles.push_back(all[i].corners);
    pool.first_use.push_back(static_cast<std::uint32_t>(pool.uses.size()));
  }
}

}  // namespace plumb::surface
