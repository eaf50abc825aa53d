// Does a ray slip through a closed mesh, aimed at its vertices and at the middles of its edges?  Generated meshes, and
// every closed one of the models.  And does each ray that passes exactly through a vertex or a middle of any model hit
// all that is there, from several origins, also along edges, do all verbs say so, and does a judge with rationals of
// his own find the same order and the same parameters?  A sample of the models' vertices and edges is asked; with
// PLUMB_LONG_TESTS every one.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <span>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "space/bvh/meshes.hpp"

namespace plumb {
namespace {

Vector3 toward(const Point3& from, const Point3& to) { return {to.x - from.x, to.y - from.y, to.z - from.z}; }

#if defined(PLUMB_LONG_TESTS)
const std::size_t most_targets = std::numeric_limits<std::size_t>::max();
#else
const auto most_targets = static_cast<std::size_t>(battery::fitting(160));
#endif

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
void expect_no_leaks(const TriangleMesh& given, const std::string& name,
                     std::size_t most = std::numeric_limits<std::size_t>::max()) {
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
  const std::size_t step = 2 * mesh.triangles.size() / most + 1;  // three edges and a vertex for two triangles
  std::size_t aims = 0;
  const auto aim = [&](const Point3& at) {
    if (aims++ % step != 0) return;
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

/// Some of the vertices that triangles have and of the middles of their edges, at even steps, and how many there are.
struct Targets {
  std::vector<Target> some;
  std::size_t all = 0;
};
Targets targets_of(const TriangleMesh& mesh, std::size_t most) {
  std::vector<std::array<std::uint32_t, 3>> rows;  // two ends and a triangle; a vertex is an edge from it to itself
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = t[k], w = t[(k + 1) % 3];
      rows.push_back({v, v, i});
      if (v != w) rows.push_back({std::min(v, w), std::max(v, w), i});
    }
  }
  std::ranges::sort(rows);
  const auto begins = [&](std::size_t r) {
    return r == 0 || rows[r][0] != rows[r - 1][0] || rows[r][1] != rows[r - 1][1];
  };
  Targets targets;
  for (std::size_t r = 0; r < rows.size(); ++r) targets.all += begins(r) ? 1 : 0;
  const std::size_t step = (targets.all - 1) / most + 1;
  for (std::size_t r = 0, n = 0; r < rows.size(); ++r) {
    if (begins(r) && n++ % step == 0) {
      const Point3 &a = mesh.vertices[rows[r][0]], &b = mesh.vertices[rows[r][1]];
      targets.some.push_back({{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2}, {}, toward(a, b)});
    }
    if ((n - 1) % step == 0) targets.some.back().triangles.push_back(rows[r][2]);
  }
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

using Rational3 = std::array<mpq_class, 3>;
Rational3 exactly(const Point3& p) { return {p.x, p.y, p.z}; }
Rational3 exactly(const Vector3& v) { return {v.x, v.y, v.z}; }
Rational3 minus(const Rational3& a, const Rational3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational3 crossed(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpq_class dotted(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// By rationals, of a triangle in whose plane the ray does not run: where does it hit?
struct Judged {
  bool crosses, hits;
  mpq_class t;
};
Judged judged(const AnyRay& ray, const Triangle3& triangle) {
  const Rational3 o = exactly(ray.origin), d = exactly(ray.direction);
  const Rational3 a = minus(exactly(triangle.a), o), b = minus(exactly(triangle.b), o),
                  c = minus(exactly(triangle.c), o);
  const Rational3 normal = crossed(minus(b, a), minus(c, a));
  const mpq_class slope = dotted(d, normal);
  if (slope == 0) return {false, false, 0};
  const int way = sgn(slope);
  bool inside = true;
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)})
    inside = inside && sgn(dotted(d, crossed(*p, *q))) * way >= 0;
  const mpq_class t = dotted(a, normal) / slope;
  return {true, inside && t >= 0, t};
}
bool is_nearest(double x, const mpq_class& t) {
  const double up = std::nextafter(x, 1e300), down = std::nextafter(x, -1e300);
  return 2 * t <= mpq_class(x) + mpq_class(up) && 2 * t >= mpq_class(x) + mpq_class(down);
}

/// What rationals cross is hit, at the double nearest to the exact parameter, in that order and then by number.
bool are_as_judged(std::span<const Triangle3> triangles, const Shot& shot, const std::vector<NumberedHit>& all) {
  std::optional<std::pair<mpq_class, std::uint32_t>> last;
  for (const NumberedHit& hit : all) {
    Judged here = judged(shot.ray, triangles[hit.index]);
    if (!here.crosses) {
      last = {};
      continue;
    }
    if (!here.hits || !is_nearest(hit.hit.t, here.t)) return false;
    const std::pair place(std::move(here.t), hit.index);
    if (last && place < *last) return false;
    last = place;
  }
  return true;
}

/// Tells how many rays were judged.
std::size_t expect_hits_everywhere(const TriangleMesh& given, const std::string& name) {
  const TriangleMesh mesh = on_grid(given);
  const Bvh bvh = build_bvh(mesh);
  std::vector<Triangle3> triangles;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  const TriangleBatch every(triangles);
  const auto [targets, there] = targets_of(mesh, most_targets);
  double reach = 0;
  for (const Point3& p : mesh.vertices) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double unit = std::ldexp(1.0, std::ilogb(reach) - 30);
  std::vector<Shot> shots;
  const std::array ways{Vector3{1, 0, 0},  Vector3{3, -2, 1}, Vector3{0, -1, 0},
                        Vector3{-1, 2, 5}, Vector3{0, 0, 1},  Vector3{-4, -1, -3}};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {  // along an axis, and askew
      const auto& [x, y, z] = ways[(2 * i + k) % ways.size()];
      shots.push_back(shot_at(targets[i], {x * unit, y * unit, z * unit}, reach));
    }
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
  long apart = 0, missing = 0, odd = 0, other = 0, wrong = 0;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    apart += !is_hit_by_all_verbs(bvh, shots[i], all[i]);
    missing += !has_all_at_target(triangles, shots[i], all[i]);
    odd += closed && crossed[i] % 2 != 0;
    wrong += !are_as_judged(triangles, shots[i], all[i]);
    if (i % 97 != 0) continue;
    std::vector<std::uint32_t> numbers;
    for (const NumberedHit& hit : all[i]) numbers.push_back(hit.index);
    std::ranges::sort(numbers);
    other += numbers != all_hits(rays[i], every);
  }
  EXPECT_EQ(apart, 0) << name << ": rays of which the verbs say different things";
  EXPECT_EQ(missing, 0) << name << ": rays that do not hit all that is at a vertex or a middle";
  EXPECT_EQ(odd, 0) << name << ": rays that go in and not out";
  EXPECT_EQ(wrong, 0) << name << ": rays that rationals judge in another way";
  EXPECT_EQ(other, 0) << name << ": rays that hit something else than every triangle alone says";
  std::printf("%s: %zu rays through %zu of %zu vertices and middles, %s\n", name.c_str(), shots.size(), targets.size(),
              there, closed ? "closed" : "open");
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
    expect_no_leaks(mesh, name, most_targets);
  });
  if (are_there) {
    EXPECT_GT(closed, battery::sanitized ? 1 : 2);
  }
}

TEST(Watertight, RaysThroughVerticesAndMiddles) {
  EXPECT_GT(expect_hits_everywhere(solids::torus(3, 1, 32, 16), "torus"), battery::sanitized ? 40u : 400u);
  std::size_t rays = 0;
  const bool are_there = with_models(
      [&](const TriangleMesh& mesh, const std::string& name) { rays += expect_hits_everywhere(mesh, name); });
  if (are_there) {
    EXPECT_GT(rays, battery::sanitized ? 100u : 5000u);
  }
}

}  // namespace
}  // namespace plumb
