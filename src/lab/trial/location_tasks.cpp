#include <algorithm>

#include "lab/trial/branching_methods.hpp"
#include "lab/trial/location_tests.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/figure/containment/polygon_location.hpp"
#include "plumb/query/ray/parity.hpp"

namespace plumb::lab::trial {
namespace {

struct InPolygon {
  Point2 p;
  Polygon2 polygon;
};
struct InMesh {
  Point3 p;
  TriangleMesh mesh;
};

/// A star about the origin: corner i at a random distance in direction i; the point on the same lattice.
void fill_star(std::span<double> q, Entropy& entropy, std::uint64_t size) {
  constexpr std::array<std::array<int, 2>, polygon_corners> directions{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  for (std::size_t k = 0; k < 2; ++k) q[k] = static_cast<double>(entropy.within(static_cast<std::int64_t>(size / 2)));
  for (std::size_t i = 0; i < polygon_corners; ++i) {
    const auto far = static_cast<double>(1 + entropy.below(size));
    for (std::size_t k = 0; k < 2; ++k) q[2 + 2 * i + k] = far * directions[i][k];
  }
}

void fill_solid(std::span<double> q, Entropy& entropy, std::uint64_t size) {
  std::ranges::fill(q, 0.0);
  for (std::size_t k = 0; k < 3; ++k) q[k] = static_cast<double>(entropy.within(static_cast<std::int64_t>(size / 2)));
  for (std::size_t corner = 0; corner < 6; ++corner) {
    const auto far = static_cast<double>(1 + entropy.below(size));
    q[3 + 3 * corner + corner / 2] = corner % 2 == 0 ? far : -far;
  }
}

/// Away from the origin and scaled by what is no power of two: every coordinate rounds.
void move_away(std::span<double> q) {
  for (double& x : q) x = 0.1 * x + 1.3;
}

std::vector<InputClass> lattice_classes(void (*fill)(std::span<double>, Entropy&, std::uint64_t)) {
  const auto moved = [fill](std::span<double> q, Entropy& entropy, std::uint64_t size) {
    fill(q, entropy, size);
    move_away(q);
  };
  return {
      {"touching", "integers to 4, the point often on the boundary",
       [fill](std::span<double> q, Entropy& e) { fill(q, e, 4); }},
      {"grid", "integers to a million", [fill](std::span<double> q, Entropy& e) { fill(q, e, 1'000'000); }},
      {"off_by_ulps", "as touching, scaled and moved, so that every coordinate rounds",
       [moved](std::span<double> q, Entropy& e) { moved(q, e, 4); }},
      {"moved", "as grid, scaled and moved, so that every coordinate rounds",
       [moved](std::span<double> q, Entropy& e) { moved(q, e, 1'000'000); }},
  };
}

std::vector<std::array<RationalVec, 3>> faces_of(std::span<const double> q) {
  std::vector<std::array<RationalVec, 3>> faces;
  for (const auto& [a, b, c] : octahedron_faces)
    faces.push_back({rational_vec(q, 1 + a), rational_vec(q, 1 + b), rational_vec(q, 1 + c)});
  return faces;
}

}  // namespace

Task point_in_polygon_task() {
  constexpr std::size_t numbers = std::tuple_size_v<PolygonNumbers>;
  Task task{"point-in-polygon", "is a point in a closed polygon?", numbers, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(2, {0, 2, 3, 4, 5, 6, 7, 8, 1}), reordered(2, {0, 8, 7, 6, 5, 4, 3, 2, 1})};
  task.classes = lattice_classes(fill_star);
  task.judge = [](std::span<const double> q) { return as_answer(in_polygon(q)); };
  task.methods = branching_methods<AnswerKind::decision, numbers>(PointInPolygon{});
  task.methods.push_back(each_made<numbers>(
      "exact", "ours, one at a time",
      [](const PolygonNumbers& q) {
        InPolygon question{{q[0], q[1]}, {}};
        for (std::size_t i = 2; i < numbers; i += 2) question.polygon.vertices.push_back({q[i], q[i + 1]});
        return question;
      },
      [](const InPolygon& q) { return contains(q.polygon, q.p); }));
  return task;
}

Task point_in_polyhedron_task() {
  Task task{"point-in-polyhedron", "is a point in a closed mesh?", 21, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(3, {0, 3, 4, 5, 6, 1, 2})};  // the axes in turn: the same solid
  task.classes = lattice_classes(fill_solid);
  task.judge = [](std::span<const double> q) { return as_answer(in_solid(rational_vec(q, 0), faces_of(q))); };
  task.methods = branching_methods<AnswerKind::decision, 21>(PointInPolyhedron{});
  task.methods.push_back(each_made<21>(
      "exact", "ours, one at a time",
      [](const std::array<double, 21>& q) {
        InMesh question{{q[0], q[1], q[2]}, {}};
        for (std::size_t i = 3; i < 21; i += 3) question.mesh.vertices.push_back({q[i], q[i + 1], q[i + 2]});
        for (const auto& f : octahedron_faces) {
          question.mesh.triangles.push_back(
              {static_cast<std::uint32_t>(f[0]), static_cast<std::uint32_t>(f[1]), static_cast<std::uint32_t>(f[2])});
        }
        return question;
      },
      [](const InMesh& q) { return contains(q.mesh, q.p); }));
  return task;
}

}  // namespace plumb::lab::trial
