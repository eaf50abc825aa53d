#include <algorithm>
#include <cmath>

#include "lab/trial/branching_methods.hpp"
#include "lab/trial/location_tests.hpp"
#include "lab/trial/rational_judge.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/query/ray/batch.hpp"

namespace plumb::lab::trial {
namespace {

/// Origin and direction of a ray, and the six corners of the solid of octahedron_faces.
constexpr std::size_t ray_mesh_size = 24, corners_at = 6;

/// One triangle after the other.
struct RayAgainstMesh {
  template <class T>
  bool operator()(const std::array<T, ray_mesh_size>& q, T epsilon) const {
    return std::ranges::any_of(octahedron_faces, [&](const std::array<std::size_t, 3>& face) {
      std::array<T, 15> one{};
      std::copy_n(q.begin(), corners_at, one.begin());
      for (std::size_t i = 0; i < 9; ++i) one[corners_at + i] = q[corners_at + 3 * face[i / 3] + i % 3];
      return RayAgainstTriangle<false>{}(one, epsilon);
    });
  }
};

struct RayAndMesh {
  Ray3 ray;
  TriangleMesh mesh;
};
RayAndMesh ray_and_mesh(const std::array<double, ray_mesh_size>& q) {
  RayAndMesh made{{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}}, {}};
  for (std::size_t i = corners_at; i < ray_mesh_size; i += 3) made.mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
  for (const auto& face : octahedron_faces) {
    TriangleMesh::Triangle corners{};
    std::ranges::transform(face, corners.begin(), [](std::size_t i) { return static_cast<std::uint32_t>(i); });
    made.mesh.triangles.push_back(corners);
  }
  return made;
}

/// An octahedron about the origin, and a ray from near there to a corner, or the middle of an edge or of a face.
void fill_leak(std::span<double> q, Entropy& entropy) {
  constexpr double parts = 6;  // of an edge and a face, so that their middles are integers
  std::ranges::fill(q, 0.0);
  for (std::size_t corner = 0; corner < 6; ++corner) {
    const auto far = parts * static_cast<double>(1 + entropy.below(8));
    q[corners_at + 3 * corner + corner / 2] = corner % 2 == 0 ? far : -far;
  }
  const auto& face = octahedron_faces[entropy.below(octahedron_faces.size())];
  const std::size_t among = 1 + entropy.below(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < among; ++k) q[3 + axis] += q[corners_at + 3 * face[k] + axis];
    q[axis] = static_cast<double>(entropy.within(2));
    q[3 + axis] = q[3 + axis] / static_cast<double>(among) - q[axis];
  }
}

}  // namespace

Task ray_mesh_task() {
  Task task{"ray-mesh", "does a ray hit a closed mesh?", ray_mesh_size, AnswerKind::decision, {}, {}, {}, {}, 4};
  task.symmetries = {reordered(3, {0, 1, 4, 5, 6, 7, 2, 3})};  // the axes in turn: the same solid
  task.classes = refilled(shape_classes(3), [](std::span<double> q) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double way = q[3 + axis] - q[axis];
      if (std::isfinite(way)) q[3 + axis] = way;
    }
  });
  task.classes.push_back(
      {"leaks", "integers, a ray from within to a corner, or to the middle of an edge or of a face", fill_leak});
  task.classes.push_back({"leaks_moved", "as leaks, scaled and moved, so that every coordinate rounds",
                          [](std::span<double> q, Entropy& entropy) {
                            fill_leak(q, entropy);
                            for (std::size_t i = 0; i < q.size(); ++i)
                              q[i] = 0.1 * q[i] + (i < 3 || i >= corners_at ? 1.3 : 0.0);
                          }});
  task.judge = [](std::span<const double> q) {
    return as_answer(std::ranges::any_of(octahedron_faces, [&](const std::array<std::size_t, 3>& face) {
      Generated triangle;
      for (const std::size_t i : face) triangle.points.push_back(rational_vec(q, 2 + i));
      return meet({{rational_vec(q, 0)}, {rational_vec(q, 1)}}, triangle);
    }));
  };
  task.methods = branching_methods<AnswerKind::decision, ray_mesh_size>(RayAgainstMesh{});
  task.methods.push_back(
      each_made<ray_mesh_size>("exact", "ours, one at a time", ray_and_mesh,
                               [](const RayAndMesh& q) { return first_hit(q.ray, q.mesh).has_value(); }));
  return task;
}

}  // namespace plumb::lab::trial
