// Does a ray slip through a closed mesh, aimed at its vertices and at the middles of its edges?  Generated meshes, and
// every closed one of the models.  And does each ray that passes exactly through a vertex or a middle of any model hit
// all that is there, from every side, also along edges, and do all verbs say so?
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

Vector3 toward(const Point3& from, const Point3& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

/// On a grid of 2^-30 of its size, so that the middle of an edge is a double: on the edge exactly.
TriangleMesh on_grid(TriangleMesh mesh) {
  double largest = 0;
  for (const Point3& p : mesh.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double unit = std::ldexp(1.0, std::ilogb(largest) - 30);
  const auto rounded = [&](double x) { return std::round(x / unit) * unit; };
  for (Point3& p : mesh.vertices) p = {rounded(p.x), rounded(p.y), rounded(p.z)};
  return mesh;
}

/// Segments end exactly on the surface and must hit; rays, whose direction is rounded, may pass beside a silhouette,
/// but what they pass, they pass as often in as out.
void expect_no_leaks(const TriangleMesh& given, const std::string& name) {
  const TriangleMesh mesh = on_grid(given);
  ASSERT_TRUE(is_closed(mesh)) << name;
  const Bvh bvh = build_bvh(mesh);
  Point3 low = mesh.vertices[0], high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double reach = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const std::array eyes{Point3{high.x + reach, high.y + 0.37 * reach, high.z + 0.61 * reach},
                        Point3{low.x - 1e5 * reach, low.y + 0.4 * reach, low.z}};
  std::vector<AnyRay> segments, rays;
  const auto aim = [&](const Point3& at) {
    const Point3& eye = eyes[segments.size() % 2];
    segments.emplace_back(Segment3{eye, at});
    if (segments.size() % 8 < 2) rays.emplace_back(Ray3{eye, toward(eye, at)});
  };
  std::vector<char> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if (used[t[k]]++ == 0) aim(a);
      if (t[k] < t[(k + 1) % 3]) aim({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
    }
  }
  std::vector<std::uint8_t> hit(segments.size());
  any_hit(bvh, segments, hit);
  const auto leaks = std::count(hit.begin(), hit.end(), 0);
  EXPECT_EQ(leaks, 0) << name;
  std::vector<std::size_t> crossed(rays.size());
  std::vector<std::uint32_t> first(rays.size());
  count_hits(bvh, rays, crossed, {.rule = HitRule::half_open});
  first_triangle(bvh, rays, first);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(crossed[i] % 2, 0u) << name << " ray " << i;
    EXPECT_TRUE(crossed[i] == 0 || first[i] != no_triangle) << name << " ray " << i;
  }
  std::printf("%s: %zu segments to vertices and edges, %zu leaks; %zu rays\n", name.c_str(), segments.size(),
              static_cast<std::size_t>(leaks), rays.size());
}

/// A point of the surface, in these triangles.
struct Target {
  Point3 at;
  std::vector<std::uint32_t> triangles;
  Vector3 edge{0, 0, 0};  // that it is the middle of, if it is one
};

/// Every vertex that a triangle has, and every middle of an edge.
std::vector<Target> targets_of(const TriangleMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, Target> all;  // a vertex is an edge from it to itself
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = t[k], w = t[(k + 1) % 3];
      const Point3 &a = mesh.vertices[v], &b = mesh.vertices[w];
      Target& vertex = all[{v, v}];
      vertex.at = a, vertex.triangles.push_back(i);
      if (v == w) continue;
      Target& middle = all[{std::min(v, w), std::max(v, w)}];
      middle.at = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, middle.triangles.push_back(i);
      middle.edge = toward(a, b);
    }
  }
  std::vector<Target> targets;
  for (auto& [ends, target] : all) targets.push_back(std::move(target));
  return targets;
}

/// A ray that is at the target exactly at t = at, and begins far outside.
struct Shot {
  AnyRay ray;
  double at;
  const Target* target;
};

Shot shot_at(const Target& target, const Vector3& d, double reach) {
  double at = 1;
  while (at * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 4 * reach) at *= 2;
  const Point3& p = target.at;
  const Ray3 ray{{p.x - at * d.x, p.y - at * d.y, p.z - at * d.z}, d};
  const auto is_exact = [&](double from, double way, double to) {
    return mpq_class(from) + mpq_class(at) * mpq_class(way) == mpq_class(to);
  };
  EXPECT_TRUE(is_exact(ray.origin.x, d.x, p.x) && is_exact(ray.origin.y, d.y, p.y) && is_exact(ray.origin.z, d.z, p.z));
  return {ray, at, &target};
}

bool is_hit_by_all_verbs(const Bvh& bvh, const Shot& shot, const std::vector<NumberedHit>& all) {
  const auto first = first_hit(bvh, shot.ray);
  return first && !all.empty() && *first == all[0] && first_triangle(bvh, shot.ray) == all[0].index &&
         any_hit(bvh, shot.ray) && count_hits(bvh, shot.ray) == all.size();
}

/// Each triangle at the target is hit there, or before where the ray comes along it, as the triangle alone says.
bool has_all_at_target(std::span<const Triangle3> triangles, const Shot& shot, const std::vector<NumberedHit>& all) {
  return std::ranges::all_of(shot.target->triangles, [&](std::uint32_t triangle) {
    const auto found = std::ranges::find(all, triangle, &NumberedHit::index);
    return found != all.end() && found->hit.t <= shot.at && first_hit(shot.ray, triangles[triangle]) == found->hit;
  });
}

/// Tells how many rays were judged.
std::size_t expect_hits_everywhere(const TriangleMesh& given, const std::string& name) {
  const TriangleMesh mesh = on_grid(given);
  const Bvh bvh = build_bvh(mesh);
  std::vector<Triangle3> triangles;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  const TriangleBatch every(triangles);
  const std::vector<Target> targets = targets_of(mesh);
  double reach = 0;
  for (const Point3& p : mesh.vertices) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double unit = std::ldexp(1.0, std::ilogb(reach) - 30);
  std::vector<Shot> shots;
  const std::size_t step = targets.size() / static_cast<std::size_t>(battery::fitting(1500)) + 1;
  for (std::size_t i = 0; i < targets.size(); i += step) {
    for (const auto& [x, y, z] : {Vector3{1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1}, Vector3{3, -2, 1},
                                  Vector3{-1, 2, 5}, Vector3{-4, -1, -3}})
      shots.push_back(shot_at(targets[i], {x * unit, y * unit, z * unit}, reach));
    const auto& [x, y, z] = targets[i].edge;
    if (x != 0 || y != 0 || z != 0) shots.push_back(shot_at(targets[i], targets[i].edge, reach));
  }
  std::vector<AnyRay> rays;
  for (const Shot& shot : shots) rays.push_back(shot.ray);
  std::vector<std::vector<NumberedHit>> all(rays.size());
  std::vector<std::size_t> crossed(rays.size());
  hits(bvh, rays, all);
  count_hits(bvh, rays, crossed, {.rule = HitRule::half_open});
  const bool closed = is_closed(mesh);
  long apart = 0, missing = 0, odd = 0, other = 0;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    apart += !is_hit_by_all_verbs(bvh, shots[i], all[i]);
    missing += !has_all_at_target(triangles, shots[i], all[i]);
    odd += closed && crossed[i] % 2 != 0;
    if (i % 97 != 0) continue;
    std::vector<std::uint32_t> numbers;
    for (const NumberedHit& hit : all[i]) numbers.push_back(hit.index);
    std::ranges::sort(numbers);
    other += numbers != all_hits(rays[i], every);
  }
  EXPECT_EQ(apart, 0) << name << ": rays of which the verbs say different things";
  EXPECT_EQ(missing, 0) << name << ": rays that do not hit all that is at a vertex or a middle";
  EXPECT_EQ(odd, 0) << name << ": rays that go in and not out";
  EXPECT_EQ(other, 0) << name << ": rays that hit something else than every triangle alone says";
  std::printf("%s: %zu rays through every %zu of %zu vertices and middles, %s\n", name.c_str(), shots.size(), step,
              targets.size(), closed ? "closed" : "open");
  return shots.size();
}

TEST(Watertight, GeneratedMeshes) {
  expect_no_leaks(meshes::ring(24), "ring");
  expect_no_leaks(solids::torus(3, 1, 32, 16), "torus");
  expect_no_leaks(solids::turned(solids::hollow_torus(3, 1, 24, 12)), "hollow torus");
}

/// f(mesh, name) of each model; false where there are none.
template <class F>
bool with_models(const F& f) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::printf("skipped: there is no %s\n", folder.c_str());
    return false;
  }
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() == ".md") continue;
    const TriangleMesh mesh = read_mesh(file.path());
    if (battery::sanitized && mesh.triangles.size() > 6000) continue;  // there is no time for them
    f(mesh, file.path().filename().string());
  }
  return true;
}

TEST(Watertight, TheClosedModels) {
  int closed = 0;
  const bool are_there = with_models([&](const TriangleMesh& mesh, const std::string& name) {
    if (mesh.triangles.empty() || !is_closed(mesh)) {
      std::printf("%s is open\n", name.c_str());
      return;
    }
    ++closed;
    expect_no_leaks(mesh, name);
  });
  if (are_there) {
    EXPECT_GT(closed, battery::sanitized ? 1 : 2);
  }
}

TEST(Watertight, RaysThroughVerticesAndMiddles) {
  EXPECT_GT(expect_hits_everywhere(solids::torus(3, 1, 32, 16), "torus"), battery::sanitized ? 500u : 5000u);
  std::size_t rays = 0;
  const bool are_there = with_models(
      [&](const TriangleMesh& mesh, const std::string& name) { rays += expect_hits_everywhere(mesh, name); });
  if (are_there) {
    EXPECT_GT(rays, battery::sanitized ? 1000u : 50000u);
  }
}

}  // namespace
}  // namespace plumb
