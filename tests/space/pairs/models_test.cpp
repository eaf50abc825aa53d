// Are the pairs of real meshes those of a sweep along one axis, asked without a tree: alone, against themselves, mirrored,
// and on a lattice moved by one of its steps?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "certify/sanitized.hpp"
#include "plumb/query.hpp"
#include "plumb/space.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb {
namespace {

using Pairs = std::vector<TrianglePair>;

struct Placed {
  Triangle3 triangle;
  std::uint32_t number;
  Point3 low, high;
};

std::vector<Placed> placed(const TriangleMesh& mesh) {
  std::vector<Placed> all;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [k, l, m] = mesh.triangles[i];
    const Point3 &a = mesh.vertices[k], &b = mesh.vertices[l], &c = mesh.vertices[m];
    all.push_back({{a, b, c},
                   i,
                   {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                   {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
  }
  std::ranges::sort(all, {}, [](const Placed& p) { return p.low.x; });
  return all;
}

/// Calls meet(a, b) of all whose boxes do, by sweep and prune along x.
template <class Meet>
void sweep(const std::vector<Placed>& as, const std::vector<Placed>& bs, const Meet& meet) {
  std::size_t first = 0;
  double widest = 0;
  for (const Placed& b : bs) widest = std::max(widest, b.high.x - b.low.x);
  for (const Placed& a : as) {
    while (first < bs.size() && bs[first].low.x < a.low.x - 2 * widest) ++first;
    for (std::size_t i = first; i < bs.size() && bs[i].low.x <= a.high.x; ++i) {
      const Placed& b = bs[i];
      if (b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y || a.high.z < b.low.z || b.high.z < a.low.z) {
        continue;
      }
      meet(a, b);
    }
  }
}

void add(Pairs& pairs, std::uint32_t a, std::uint32_t b, Relation relation) {
  if (relation != Relation::disjoint) pairs.push_back({a, b, relation});
}

Pairs sorted(Pairs pairs) {
  std::ranges::sort(pairs, {}, [](const TrianglePair& p) { return std::pair{p.a, p.b}; });
  return pairs;
}

Pairs by_sweep(const TriangleMesh& a, const TriangleMesh& b) {
  Pairs pairs;
  sweep(placed(a), placed(b),
        [&](const Placed& s, const Placed& t) { add(pairs, s.number, t.number, relate(s.triangle, t.triangle)); });
  return sorted(pairs);
}

Pairs by_sweep(const TriangleMesh& mesh) {
  Pairs pairs;
  const std::vector<Placed> all = placed(mesh);
  sweep(all, all, [&](const Placed& s, const Placed& t) {
    if (t.number <= s.number) return;
    add(pairs, s.number, t.number, relate_in_mesh(mesh.vertices, mesh.triangles[s.number], mesh.triangles[t.number]));
  });
  return sorted(pairs);
}

template <class Move>
TriangleMesh moved(TriangleMesh mesh, const Move& move) {
  for (Point3& p : mesh.vertices) p = move(p);
  return mesh;
}

/// On a lattice of some 300 steps across.
TriangleMesh on_lattice(const TriangleMesh& mesh, double& step) {
  double largest = 0;
  for (const Point3& p : mesh.vertices) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  step = std::exp2(std::ilogb(largest) - 7);
  return moved(mesh, [&](const Point3& p) {
    return Point3{std::round(p.x / step) * step, std::round(p.y / step) * step, std::round(p.z / step) * step};
  });
}

TEST(IntersectingPairsOfModels, AreThoseOfASweep) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no models";
  std::size_t found = 0;
  for (const char* name : {"suzanne.obj", "beetle.obj", "cow.obj", "spot.obj", "teapot.obj", "fandisk.obj"}) {
    const TriangleMesh mesh = read_mesh((folder / name).string());
    if (battery::sanitized && mesh.triangles.size() > 3000) continue;
    const Bvh bvh = build_bvh(mesh);
    const Pairs own = intersecting_pairs(bvh);
    EXPECT_EQ(own, by_sweep(mesh)) << name;
    std::cout << name << ": " << mesh.triangles.size() << " triangles, " << own.size() << " pairs of its own\n";
    const auto check = [&](const TriangleMesh& a, const TriangleMesh& b, const char* about) {
      const Pairs pairs = intersecting_pairs(build_bvh(a), build_bvh(b));
      EXPECT_EQ(pairs, by_sweep(a, b)) << name << " " << about;
      found += pairs.size();
    };
    check(mesh, mesh, "by nothing");
    check(mesh, moved(mesh, [](const Point3& p) { return Point3{-p.x, p.y, p.z}; }), "mirrored");
    double step = 0;
    const TriangleMesh lattice = on_lattice(mesh, step);
    EXPECT_EQ(intersecting_pairs(build_bvh(lattice)), by_sweep(lattice)) << name;
    check(lattice, moved(lattice, [&](const Point3& p) { return Point3{p.x, p.y + step, p.z}; }), "by a step");
  }
  EXPECT_GT(found, battery::sanitized ? 20'000u : 200'000u);
}

}  // namespace
}  // namespace plumb
