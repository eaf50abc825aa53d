// Which meshes are rays shot at, and what is true of them?  By asking every triangle exactly.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "plumb/space.hpp"
#include "query/ray/cases.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb::mesh_rays {

using ray_cases::Material, ray_cases::on_shapes, ray_cases::ray_of, ray_cases::text_of;

/// Triangles of any shape; rays of the material are aimed at them.
inline TriangleMesh drawn_mesh(Material& m, std::size_t most) {
  TriangleMesh mesh;
  for (std::size_t n = m.below(most + 1); n-- > 0;) {
    const auto t = m.shape<Triangle3>();
    const auto at = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.triangles.push_back({at, at + 1, at + 2});
    if (m.below(8) == 0) mesh.triangles.push_back({at + 1, at + 2, at});  // the same once more
  }
  return mesh;
}

inline Triangle3 triangle_of(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

struct TrueHit {
  std::uint32_t index;
  RayParameter t;
};

/// All that are hit, in order.
inline std::vector<TrueHit> true_hits(const AnyRay& ray, const TriangleMesh& mesh, HitRule rule) {
  std::vector<TrueHit> all;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (auto t = first_hit_parameter(ray, triangle_of(mesh, i), rule)) all.push_back({i, std::move(*t)});
  }
  std::stable_sort(all.begin(), all.end(), [](const TrueHit& a, const TrueHit& b) { return a.t < b.t; });
  return all;
}

/// Any tree will do.
inline BvhOptions any_options(Material& m) {
  return {.method = bvh_methods[m.below(bvh_methods.size())],
          .most_in_leaf = static_cast<std::uint32_t>(1 + m.below(12)),
          .execution = Execution::serial};
}

}  // namespace plumb::mesh_rays
