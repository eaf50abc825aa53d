#include <algorithm>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/mesh_questions.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::bench {

using namespace lab::trial;

namespace {

/// Exactly, by products of integers that doubles hold: of other coordinates the classes make no triangle flat.
bool has_flat_triangle(const TriangleMesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const TriangleMesh::Triangle& t) {
    const Point3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    const Vec<double> u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z}, n = cross(u, v);
    return n.x == 0 && n.y == 0 && n.z == 0;
  });
}

}  // namespace

Method without_flat_triangles(Method method, std::size_t meshes) {
  const std::size_t numbers = meshes == 2 ? mesh_pair_numbers : 0;
  method.prepare = [prepare = method.prepare, meshes, numbers](std::span<const double> questions, const Scene& scene) {
    const auto q = questions;
    // Of one mesh all questions of a class name the same.
    const bool flat =
        meshes == 1 ? has_flat_triangle(mesh_of(key_of(q))) : has_flat_triangle(mesh_of(first_key(q.first(numbers))));
    return flat ? nullptr : prepare(questions, scene);
  };
  return method;
}

}  // namespace plumb::bench
