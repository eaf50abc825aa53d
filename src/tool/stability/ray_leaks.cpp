// Rays through the vertices and edges of closed meshes.
#include <algorithm>
#include <map>
#include <optional>
#include <span>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/query/ray_hits.hpp"
#include "plumb/query/ray_parity.hpp"
#include "tool/stability/float_ways.hpp"
#include "tool/stability/question_figures.hpp"
#include "tool/stability/sample_meshes.hpp"
#include "tool/trial/triangle_tests.hpp"

namespace plumb::tool::stability {
namespace {

using Question = std::array<double, 15>;

Question question_of(const Ray3& r, const TriangleMesh& mesh, std::uint32_t triangle) {
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
    const Point3 middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2};
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
    const Point3 p{low.x + x * (high.x - low.x), low.y + y * (high.y - low.y), low.z + z * (high.z - low.z)};
    if (locate(mesh, p) == Location::inside) return p;
  }
  return {};
}

Findings leaks(const TriangleMesh& mesh, const Settings& settings) {
  Findings findings;
  const std::optional<Point3> inside = is_closed(mesh) ? inner_point(mesh, settings.seed) : std::nullopt;
  const Point3 corner = mesh.vertices[0];
  const Point3 origin = inside.value_or(Point3{corner.x + 1, corner.y - 2, corner.z + 3});
  const std::vector<Target> targets = thinned(targets_of(mesh), settings.quick ? 2'000 : 50'000);
  const auto ray_to = [&](const Point3& p) { return Ray3{origin, {p.x - origin.x, p.y - origin.y, p.z - origin.z}}; };
  // Rounding the direction may turn a ray off a silhouette: only what is truly there can be missed.
  std::vector<bool> there;
  for (const Target& t : targets) {
    there.push_back(std::ranges::any_of(t.around, [&](std::uint32_t i) {
      return hits(ray_to(t.at), triangle_at(&question_of(ray_to(t.at), mesh, i)[6]));
    }));
  }
  const std::size_t tests = settings.quick ? 1'000'000 : 20'000'000;
  const std::size_t through = inside ? std::min(targets.size(), tests / mesh.triangles.size() + 1) : 0;

  auto ways = float_ways<15>(trial::RayAgainstTriangle<false>{});
  ways.push_back(exact_way<15>([](const Question& q) { return hits(ray_at(q.data()), triangle_at(&q[6])); }));
  findings.outcomes = outcomes_of(ways, [&](const Way<15>& way) {
    Count slipped{"rays at a shared edge or corner that hit none of its triangles"};
    Count leaked{"rays out of the closed mesh that hit nothing"};
    Count miscounted{"rays from inside that cross the surface an even number of times"};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (!there[i]) continue;
      const Ray3 ray = ray_to(targets[i].at);
      ++slipped.of;
      if (std::ranges::none_of(targets[i].around, [&](std::uint32_t t) { return way.ask(question_of(ray, mesh, t)); }))
        ++slipped.failures;
    }
    for (std::size_t i = 0; i < through; ++i) {
      const Ray3 ray = ray_to(targets[i * targets.size() / through].at);
      std::size_t hit = 0, crossed = 0;
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Question q = question_of(ray, mesh, t);
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
  return findings;
}

}  // namespace

Experiment leak_experiment() {
  return {"ray-leaks", "does a ray slip through a closed mesh where two triangles meet?", "RTCD 11.3.3, 5.3.6",
          [](const Settings& settings) {
            std::vector<Scene> scenes;
            for (const NamedMesh& mesh : sample_meshes(settings)) {
              scenes.push_back({mesh.name, "rays from inside at every vertex and every edge's middle of " + mesh.about,
                                [mesh, settings] { return leaks(mesh.make(), settings); }});
            }
            return scenes;
          }};
}

}  // namespace plumb::tool::stability
