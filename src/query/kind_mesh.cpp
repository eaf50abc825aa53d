#include "query/kind_mesh.hpp"

#include "plumb/figure/mesh.hpp"
#include "plumb/query/ray.hpp"
#include "plumb/query/ray_parity.hpp"

namespace plumb::degenerate {

namespace {

/// From the count of vertices on.
TriangleMesh mesh_from(std::span<const double> q) {
  TriangleMesh mesh;
  const std::size_t end = 1 + 3 * static_cast<std::size_t>(q[0]);
  for (std::size_t i = 1; i < end; i += 3) mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
  for (std::size_t i = end + 1; i < q.size(); i += 3) {
    mesh.triangles.push_back(
        {static_cast<std::uint32_t>(q[i]), static_cast<std::uint32_t>(q[i + 1]), static_cast<std::uint32_t>(q[i + 2])});
  }
  return mesh;
}

}  // namespace

Answer exact_mesh_hit(std::span<const double> q) {
  const Ray3 ray{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}};
  const TriangleMesh mesh = mesh_from(q.subspan(6));
  // Rounding keeps the order: the least of the rounded parameters is the least one, rounded.
  Answer first = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto hit = first_hit(ray, Triangle3{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    if (hit && (first.numbers[0] == 0 || hit->t < first.numbers[1])) first.numbers = {1.0, hit->t};
  }
  return first;
}

Answer exact_in_mesh(std::span<const double> q) {
  return contains(mesh_from(q.subspan(3)), Point3{q[0], q[1], q[2]}) ? 1.0 : 0.0;
}

}  // namespace plumb::degenerate
