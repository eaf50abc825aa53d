// The winding number of a section about points of its plane is that of the mesh: law 3, where much lies in the plane.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <random>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "surface/section/section_oracle.hpp"

namespace plumb {
namespace {

/// The point of the plane over the first two coordinates; the normal's last component is a power of two.
Point3 over(const Plane3& plane, double x, double y) {
  return {x, y, (plane.offset - plane.normal.x * x - plane.normal.y * y) / plane.normal.z};
}

// Coordinates are small integers and multiples of 2^-6: triangles pass over such a point at heights that are apart by
// far more than the step, so that the mesh winds alike all along it.
constexpr double step = 0x1p-36;

struct Seen {
  int points = 0, inside = 0, on_contours = 0, touching = 0, canceled = 0, coplanar = 0, several = 0;
};

void expect_winding(const TriangleMesh& mesh, const Plane3& plane, OnPlane on_plane, std::mt19937_64& random,
                    Seen& seen) {
  const oracle::Shown shown{0, 1, plane.normal.z < 0};
  const Section cut = section(mesh, plane, on_plane);
  oracle::expect_lawful(mesh, cut, shown);
  for (const Contour& c : cut.contours) EXPECT_TRUE(c.closed);
  const auto contours = oracle::flat_contours(mesh, cut, shown);
  TriangleMesh others = mesh;
  for (std::size_t i = cut.coplanar_triangles.size(); i-- > 0;)
    others.triangles.erase(others.triangles.begin() + cut.coplanar_triangles[i]);
  std::uniform_int_distribution<int> at(-4 * 64, 4 * 64);
  for (int i = 0; i < 40; ++i) {
    const Point3 p = over(plane, at(random) / 64.0, at(random) / 64.0);
    const auto turns = oracle::winding(contours, {p.x, p.y});
    ++seen.points;
    seen.on_contours += !turns;
    // A spike or ridge that only touches the plane is no contour, but the step leads into it.
    if (locate(others, p) == Location::boundary) continue;
    ASSERT_TRUE(turns);
    const double s = on_plane == OnPlane::above ? -step : step;
    const Vector3& n = plane.normal;
    const auto in_space = winding_number(mesh, {p.x + s * n.x, p.y + s * n.y, p.z + s * n.z});
    ASSERT_TRUE(in_space);
    ASSERT_EQ(shown.turned ? -*turns : *turns, *in_space);
    seen.inside += *turns != 0;
  }
  seen.touching += cut.touching_corners > 0;
  seen.canceled += cut.canceled_segments > 0;
  seen.coplanar += !cut.coplanar_triangles.empty();
  seen.several += cut.contours.size() > 1;
}

TEST(SectionWinding, OfHeapsOfTetrahedra) {
  std::mt19937_64 random(2026);
  Seen seen;
  const Vector3 normals[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 1}, {1, -1, 2}, {2, 1, -1}, {0, 1, 2}};
  const int rounds = battery::sanitized ? 20 : 600;
  for (int round = 0; round < rounds; ++round) {
    const TriangleMesh mesh = solids::heap(random, 1 + round % 7, 1 + round % 3);
    const Vector3& normal = normals[random() % std::size(normals)];
    const Plane3 plane{normal, double(int(random() % 5) - 2)};
    expect_winding(mesh, plane, random() % 2 == 0 ? OnPlane::above : OnPlane::below, random, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.inside * 50, seen.points);
  EXPECT_LT(seen.on_contours * 5, seen.points);
  EXPECT_GT(seen.touching * 20, rounds);
  EXPECT_GT(seen.coplanar * 50, rounds);
  EXPECT_GT(seen.canceled, 0);
  EXPECT_GT(seen.several * 4, rounds);
}

TEST(SectionWinding, OfVoxelsIsTheirLayer) {
  std::mt19937_64 random(3);
  Seen seen;
  for (int round = 0; round < (battery::sanitized ? 3 : 12); ++round) {
    std::set<solids::Cell> cells;
    for (int x = -3; x < 3; ++x) {
      for (int y = -3; y < 3; ++y) {
        for (int z = -2; z < 2; ++z) {
          if (random() % 2 == 0) cells.insert({x, y, z});
        }
      }
    }
    const TriangleMesh mesh = solids::voxels(cells);
    for (const OnPlane on_plane : {OnPlane::above, OnPlane::below}) {
      for (const double height : {-1.0, -0.5, 0.0, 1.0}) {
        const Plane3 plane{{0, 0, 1}, height};
        expect_winding(mesh, plane, on_plane, random, seen);
        if (HasFatalFailure()) return;
        const Section cut = section(mesh, plane, on_plane);
        const auto contours = oracle::flat_contours(mesh, cut, {0, 1, false});
        const int layer = static_cast<int>(std::floor(height == -0.5 ? height : height - (on_plane == OnPlane::above)));
        Rational area;
        int many = 0;
        for (const auto& loop : contours) area = area + oracle::doubled_area(loop);
        for (const solids::Cell& c : cells) {
          if (c[2] != layer) continue;
          ++many;
          EXPECT_EQ(oracle::winding(contours, {c[0] + 0.5, c[1] + 0.5}), 1);
        }
        EXPECT_EQ(area, Rational(2 * many));
        for (std::size_t i = 0; i < contours.size(); ++i) {  // outer contours and holes take turns inward
          const Contour& c = cut.contours[i];
          EXPECT_EQ(c.turn, c.depth % 2 == 0 ? Sign::positive : Sign::negative);
          if (!c.parent) continue;
          EXPECT_EQ(cut.contours[*c.parent].depth + 1, c.depth);
          for (const oracle::Flat& corner : contours[i])
            EXPECT_NE(oracle::winding(contours[*c.parent], corner).value_or(1), 0);
        }
      }
    }
  }
  EXPECT_GT(seen.touching, 0);
}

/// Of a mesh as files hold them: at three heights, the first of which is a vertex's.
void expect_winding_at_heights(const TriangleMesh& mesh, std::mt19937_64& random) {
  const bool closed = is_oriented_closed(mesh);
  Point3 low = mesh.vertices[0], high = low;
  for (const Point3& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  for (int i = 0; i < 3; ++i) {
    const double z = i == 0 ? mesh.vertices[random() % mesh.vertices.size()].z : low.z + (high.z - low.z) * i / 3.1;
    const Plane3 plane{{0, 0, 1}, z};
    const Section cut = section(mesh, plane);
    EXPECT_GT(cut.cut_triangles, 50U);
    if (!battery::sanitized && i == 0) oracle::expect_lawful(mesh, cut, {0, 1, false});
    if (!closed) {
      for (const Contour& c : cut.contours) EXPECT_TRUE(c.closed || !c.parent);
      continue;
    }
    const auto contours = oracle::flat_contours(mesh, cut, {0, 1, false});
    int inside = 0;
    for (int k = 0; k < 25; ++k) {
      std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y);
      const Point3 p{x(random), y(random), std::nextafter(z, low.z)};
      const auto in_space = winding_number(mesh, p);
      const auto turns = oracle::winding(contours, {p.x, p.y});
      ASSERT_TRUE(in_space && turns);
      EXPECT_EQ(*turns, *in_space);
      inside += *turns != 0;
    }
    EXPECT_GT(inside, 0);
  }
}

TEST(SectionWinding, OfTori) {
  std::mt19937_64 random(7);
  const TriangleMesh ring = solids::turned(solids::torus(3, 1, 48, 24));
  const TriangleMesh hollow = solids::turned(solids::hollow_torus(3, 1.5, 48, 24)), open = solids::torn(ring, 50);
  EXPECT_TRUE(is_oriented_closed(ring) && is_oriented_closed(hollow) && !is_oriented_closed(open));
  for (const TriangleMesh* const mesh : {&ring, &hollow, &open}) expect_winding_at_heights(*mesh, random);
}

TEST(SectionWinding, OfModels) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: there is no folder " << folder << "\n";
    return;
  }
  std::mt19937_64 random(7);
  for (const char* const name : {"cow.obj", "fandisk.obj", "spot.obj", "stanford-bunny.obj"}) {
    SCOPED_TRACE(name);
    expect_winding_at_heights(read_mesh(folder / name), random);
  }
}

}  // namespace
}  // namespace plumb
