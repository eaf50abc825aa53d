#include "query/kinds/kind_mesh.hpp"

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/query/ray/parity.hpp"
#include "query/kinds/kind_hit.hpp"

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

Answer exact_mesh_hit(std::span<const double> q, const Convention& convention) {
  const Ray3 ray{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}};
  const TriangleMesh mesh = mesh_from(q.subspan(6));
  // Rounding keeps the order: the least of the rounded parameters is the least one, rounded.
  Answer first = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Answer hit = first_hit_under(ray, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, convention);
    if (hit.numbers[0] != 0 && (first.numbers[0] == 0 || hit.numbers[1] < first.numbers[1])) first = hit;
  }
  return first;
}

Location locate_in_mesh(std::span<const double> q) { return locate(mesh_from(q.subspan(3)), Point3{q[0], q[1], q[2]}); }

}  // namespace plumb::degenerate
