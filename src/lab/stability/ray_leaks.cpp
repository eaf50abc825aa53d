// Rays through the vertices and edges of closed meshes.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/stability/sample_meshes.hpp"
#include "lab/trial/tasks.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "plumb/query/ray/hits.hpp"
#include "plumb/query/ray/parity.hpp"

namespace plumb::lab::stability {
namespace {

using RayQuestion = std::array<double, 15>;

RayQuestion question_of(const Ray3& r, const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [i, j, k] = mesh.triangles[triangle];
  const Point3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
  return {r.origin.x, r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z, a.x, a.y,
          a.z,        b.x,        b.y,        b.z,           c.x,           c.y,           c.z};
}
/// A vertex or the middle of an edge, and the triangles around it.
struct Target {
  Point3 at;
  std::vector<std::uint32_t> around;
};

std::vector<Target> targets_of(const TriangleMesh& mesh) {
  std::vector<Target> vertices(mesh.vertices.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      vertices[a].around.push_back(t);
      edges[std::minmax(a, b)].push_back(t);
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].at = mesh.vertices[i];
  std::erase_if(vertices, [](const Target& v) { return v.around.empty(); });
  for (auto& [ends, around] : edges) {
    const Point3 a = mesh.vertices[ends.first], b = mesh.vertices[ends.second];
    const Point3 middle{std::midpoint(a.x, b.x), std::midpoint(a.y, b.y), std::midpoint(a.z, b.z)};
    if (around.size() == 2) vertices.push_back({middle, std::move(around)});
  }
  return vertices;
}

/// Every one of them, or so many, evenly.
std::vector<Target> thinned(std::vector<Target> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<Target> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(std::move(all[i * all.size() / most]));
  return some;
}

/// A place strictly inside, exactly; nothing where a thousand throws of dice find none.
std::optional<Point3> inner_point(const TriangleMesh& mesh, std::uint64_t start) {
  Point3 low = mesh.vertices[0], high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Entropy entropy(start);
  for (int i = 0; i < 1000; ++i) {
    const double x = unit_coordinate(entropy), y = unit_coordinate(entropy), z = unit_coordinate(entropy);
    const Point3 p{std::lerp(low.x, high.x, x), std::lerp(low.y, high.y, y), std::lerp(low.z, high.z, z)};
    if (locate(mesh, p) == Location::inside) return p;
  }
  return {};
}

/// Where rays start: inside of a closed mesh, or beside one that is open.
Findings leaks(const TriangleMesh& mesh, const Settings& settings) {
  const std::optional<Point3> inside = is_closed(mesh) ? inner_point(mesh, settings.seed) : std::nullopt;
  const Point3 corner = mesh.vertices[mesh.triangles[0][0]];
  const Point3 origin = inside.value_or(Point3{corner.x + 1, corner.y - 2, corner.z + 3});
  const auto ray_to = [&](const Point3& p) { return Ray3{origin, {p.x - origin.x, p.y - origin.y, p.z - origin.z}}; };
  std::vector<Target> targets = thinned(targets_of(mesh), settings.quick ? 2'000 : 50'000);
  // Rounding the direction may turn a ray off a silhouette: only what is truly there can be missed.
  const trial::Task task = trial::ray_triangle_task();
  std::erase_if(targets, [&](const Target& t) {
    const Vector3 d = ray_to(t.at).direction;
    return !std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z) ||
           std::ranges::none_of(t.around,
                                [&](std::uint32_t i) { return task.judge(question_of(ray_to(t.at), mesh, i)) == 1; });
  });
  const std::size_t tests = settings.quick ? 1'000'000 : 20'000'000;
  const std::size_t through = inside ? std::min(targets.size(), tests / mesh.triangles.size() + 1) : 0;

  auto ways = float_ways<15>(trial::RayAgainstTriangle<false>{});
  ways.push_back(exact_way<15>([](const RayQuestion& q) { return hits(ray_at(q.data()), triangle_at(&q[6])); }));
  const auto outcomes = outcomes_of(ways, [&](const Way<15>& way) {
    Count slipped{"rays at a shared edge or corner that hit none of its triangles"};
    Count leaked{"rays out of the closed mesh that hit nothing"};
    Count miscounted{"rays from inside that cross the surface an even number of times"};
    for (const Target& target : targets) {
      const Ray3 ray = ray_to(target.at);
      ++slipped.of;
      if (std::ranges::none_of(target.around, [&](std::uint32_t t) { return way.ask(question_of(ray, mesh, t)); }))
        ++slipped.failures;
    }
    for (std::size_t i = 0; i < through; ++i) {
      const Ray3 ray = ray_to(targets[i * targets.size() / through].at);
      std::size_t hit = 0, crossed = 0;
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const RayQuestion q = question_of(ray, mesh, t);
        const bool one = way.ask(q);
        hit += one ? 1 : 0;
        // Ours has a rule for counting, by which an edge belongs to one of its triangles; the others have just this.
        crossed += way.exact ? (one && hits(ray, triangle_at(&q[6]), HitRule::half_open) ? 1 : 0) : (one ? 1 : 0);
      }
      ++leaked.of, ++miscounted.of;
      if (hit == 0) ++leaked.failures;
      if (crossed % 2 == 0) ++miscounted.failures;
    }
    return std::vector{slipped, leaked, miscounted};
  });
  return {outcomes, {}};
}

}  // namespace

Experiment leak_experiment() {
  return {"ray-leaks", "does a ray slip through a closed mesh where two triangles meet?", "RTCD 11.3.3, 5.3.6",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            const auto add = [&](const std::vector<NamedMesh>& meshes, const std::string& about) {
              for (const NamedMesh& mesh : meshes)
                scenes.push_back({mesh.name, about + mesh.about, [=] { return leaks(mesh.make(), settings); }});
            };
            add(generated_meshes(settings.quick), "rays from inside at every vertex and every edge's middle of ");
            if (settings.models)
              add(real_meshes(*settings.models),
                  "rays from inside, or beside where it is open, at vertices and edges of ");
            return scenes;
          }};
}

}  // namespace plumb::lab::stability
