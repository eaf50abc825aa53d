// Polygons instead of triangles are cut: windings by definition, volumes of voxels, and the same as what is merged after
// each triangle was cut.
#include "surface/solid/joined_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "plumb/surface/solid/round.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using solid_laws::expect_closed, solid_laws::expect_equal, solid_laws::expect_windings, solid_laws::volume_of;
using solid_laws::winding_by_definition;
using solids::box, solids::Cell, solids::heap;
using surface::FacePool, surface::join_coplanar_faces, surface::pool_faces;

/// Cells as large as `size`, at multiples of it and moved by `shift`.
TriangleMesh cells_of(const std::set<Cell>& cells, int size, const Cell& shift) {
  TriangleMesh made = solids::voxels(cells);
  for (Point3& p : made.vertices) p = {size * p.x + shift[0], size * p.y + shift[1], size * p.z + shift[2]};
  return made;
}

TriangleMesh slab(int n, int size, const Cell& shift) {
  std::set<Cell> cells;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y) cells.insert({x, y, 0});
  return cells_of(cells, size, shift);
}

/// The joined pool's faces, each as often as it is used: a mesh that winds as the mesh does.
TriangleMesh mesh_of(const FacePool& pool, std::uint32_t mesh) {
  TriangleMesh made{pool.mesh.vertices, {}};
  for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
    for (const FacetSource& use : pool.uses_of(f)) {
      auto corners = pool.mesh.triangles[f];
      if (use.opposite) std::swap(corners[1], corners[2]);
      if (use.face.mesh == mesh) made.triangles.push_back(corners);
    }
  }
  return made;
}

TEST(JoinedFaces, TwoSlabsAreTwoBoxesBeforeAnythingIsCut) {
  const std::vector<TriangleMesh> slabs{slab(12, 2, {0, 0, 0}), slab(12, 2, {1, 0, 0})};
  EXPECT_EQ(pool_faces(slabs).mesh.triangles.size(), 2U * 672U);
  const FacePool joined = join_coplanar_faces(pool_faces(slabs));
  EXPECT_EQ(joined.mesh.triangles.size(), 24U);  // so few have segments that are handed on
  const Arrangement all = arrange(slabs, Pieces::of_polygons);
  EXPECT_LT(all.facets.size(), 80U);
  const ExactMesh both = unite(slabs, WindingRule::positive, Pieces::of_polygons);
  EXPECT_EQ(both.triangles.size(), 12U);
  EXPECT_EQ(exact_volume(both), Rational(25 * 24 * 2));
  EXPECT_TRUE(round(both).sound);
}

TEST(JoinedFaces, WhereNoPolygonHasFewerTrianglesThePoolStays) {
  const std::vector<TriangleMesh> meshes{box({0, 0, 0}, {1, 1, 1}), box({3, 3, 3}, {5, 5, 5})};
  const FacePool pool = pool_faces(meshes), joined = join_coplanar_faces(pool);
  EXPECT_EQ(joined.mesh.triangles, pool.mesh.triangles);
  EXPECT_EQ(joined.uses, pool.uses);
  EXPECT_TRUE(join_coplanar_faces(pool_faces(std::vector<TriangleMesh>{})).mesh.triangles.empty());
}

TEST(JoinedFaces, ASourceIsTheLeastOfItsPolygonThatTurnsAsTheMeshDoes) {
  TriangleMesh twice = slab(3, 1, {0, 0, 0});
  const TriangleMesh one = twice;
  solids::append(twice, one);
  solids::append(twice, one, true);  // winds once: two triangles outward, one inward
  for (const TriangleMesh& mesh : {one, twice}) {
    const FacePool joined = join_coplanar_faces(pool_faces({&mesh, 1}));
    ASSERT_EQ(joined.mesh.triangles.size(), 12U);
    for (std::uint32_t f = 0; f < 12; ++f) {
      ASSERT_EQ(joined.uses_of(f).size(), 1U);
      EXPECT_LT(joined.uses_of(f)[0].face.triangle, one.triangles.size());
    }
    std::vector<TriangleMesh> meshes{mesh};
    const ExactMesh same = unite(meshes, WindingRule::positive, Pieces::of_polygons);
    std::map<std::uint32_t, int> of_source;
    for (const SourceFace& s : same.sources) ++of_source[s.triangle];
    EXPECT_EQ(of_source.size(), 6U);
    for (std::size_t t = 0; t < 12; ++t) {
      // In the plane of its source.
      const auto& corners = one.triangles[same.sources[t].triangle];
      for (const std::uint32_t v : same.triangles[t]) {
        const ExactPoint3 p = same.vertices[v];
        EXPECT_EQ(orient3d(ExactPoint3(one.vertices[corners[0]]), ExactPoint3(one.vertices[corners[1]]),
                           ExactPoint3(one.vertices[corners[2]]), p),
                  Sign::zero);
      }
    }
  }
}

/// Blobs of cells, some of them twice, some inside out, on lattices of different cells; how often each unit cell is wound.
struct Blobs {
  TriangleMesh mesh;
  std::map<Cell, int> winding;
};

Blobs random_blobs(std::mt19937_64& random) {
  Blobs made;
  const auto number = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  for (int blobs = number(1, 3); blobs > 0; --blobs) {
    const int size = number(1, 3), most = 6 / size;
    const Cell shift{number(0, 2), number(0, 2), number(0, 1)};
    std::set<Cell> cells;
    for (int i = number(2, 12); i > 0; --i) cells.insert({number(0, most - 1), number(0, most - 1), number(0, 1)});
    const int times = number(0, 3) == 0 ? 2 : 1;
    const bool inside_out = number(0, 3) == 0;
    for (int i = 0; i < times; ++i) solids::append(made.mesh, cells_of(cells, size, shift), inside_out);
    for (const Cell& c : cells)
      for (int x = 0; x < size; ++x)
        for (int y = 0; y < size; ++y)
          for (int z = 0; z < size; ++z)
            made.winding[{size * c[0] + shift[0] + x, size * c[1] + shift[1] + y, size * c[2] + shift[2] + z}] +=
                inside_out ? -times : times;
  }
  return made;
}

bool is_in(int winding, WindingRule rule) {
  return rule == WindingRule::positive ? winding > 0 : rule == WindingRule::odd ? winding % 2 != 0 : winding != 0;
}

TEST(JoinedFaces, BlobsOfCellsAgainstVoxels) {
  std::size_t fewer = 0, wound_otherwise = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::array<Blobs, 3> blobs{random_blobs(random), random_blobs(random), random_blobs(random)};
    std::vector<TriangleMesh> meshes;
    std::set<Cell> cells;
    for (const Blobs& b : blobs) {
      meshes.push_back(b.mesh);
      for (const auto& [cell, w] : b.winding) {
        cells.insert(cell);
        wound_otherwise += w < 0 || w > 1 ? 1 : 0;
      }
    }
    const FacePool joined = join_coplanar_faces(pool_faces(meshes));
    for (std::uint32_t m = 0; m < 3; ++m) EXPECT_EQ(volume_of(mesh_of(joined, m)), volume_of(meshes[m]));
    fewer += pool_faces(meshes).mesh.triangles.size() - joined.mesh.triangles.size();
    const WindingRule rule = std::array{WindingRule::positive, WindingRule::nonzero, WindingRule::odd}[seed % 3];
    const auto of_all = [&](ExactMesh (*operation)(std::span<const TriangleMesh>, WindingRule, Pieces),
                            const std::function<bool(const std::array<bool, 3>&)>& inside) {
      const ExactMesh made = operation(meshes, rule, Pieces::of_polygons);
      expect_closed(made);
      std::size_t count = 0;
      for (const Cell& cell : cells) {
        std::array<bool, 3> in{};
        for (std::size_t m = 0; m < 3; ++m)
          if (const auto at = blobs[m].winding.find(cell); at != blobs[m].winding.end())
            in[m] = is_in(at->second, rule);
        const bool is_inside = inside(in);
        count += is_inside ? 1 : 0;
        if (random() % 40 != 0) continue;
        const Rational half(1, 2);
        const RationalPoint3 middle{Rational(cell[0]) + half, Rational(cell[1]) + half, Rational(cell[2]) + half};
        EXPECT_EQ(winding_by_definition(made, middle), is_inside ? 1 : 0);
      }
      EXPECT_EQ(exact_volume(made), Rational(count));
      // Not fewer and not more corners than where each triangle was cut.
      const ExactMesh after = merge_pieces(operation(meshes, rule, Pieces::of_triangles));
      EXPECT_EQ(made.vertices, after.vertices);
      EXPECT_EQ(made.triangles.size(), after.triangles.size());
      expect_equal(merge_pieces(made), made);
    };
    of_all(&unite, [](const auto& in) { return in[0] || in[1] || in[2]; });
    of_all(&intersect, [](const auto& in) { return in[0] && in[1] && in[2]; });
    of_all(&subtract, [](const auto& in) { return in[0] && !in[1] && !in[2]; });
    of_all(&symmetric_difference, [](const auto& in) { return (in[0] != in[1]) != in[2]; });
    if (HasFailure()) return;
  }
  EXPECT_GT(fewer, 500U);
  EXPECT_GT(wound_otherwise, 300U);
}

TEST(JoinedFaces, WindingsByDefinition) {
  std::size_t facets = 0, unlucky = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::vector<TriangleMesh> meshes{random_blobs(random).mesh, random_blobs(random).mesh};
    TriangleMesh skew = slab(3, 2, {0, 0, 0});
    for (Point3& p : skew.vertices) p = {p.x + p.z, p.y - p.z, p.x + 2 * p.z};
    meshes.push_back(skew);
    meshes.push_back(heap(random, 2, 2));
    const Arrangement all = arrange(meshes, Pieces::of_polygons);
    unlucky += expect_windings(meshes, all, 5);
    facets += all.facets.size();
    if (HasFailure()) return;
  }
  EXPECT_GT(facets, 1000U);
  EXPECT_LT(20 * unlucky, facets);
}

TEST(JoinedFaces, TheOrderOfTheInputChangesNothing) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::vector<TriangleMesh> meshes{random_blobs(random).mesh, random_blobs(random).mesh, heap(random, 2, 2)};
    const ExactMesh one = unite(meshes, WindingRule::nonzero, Pieces::of_polygons);
    std::ranges::reverse(meshes);
    for (TriangleMesh& mesh : meshes) std::ranges::shuffle(mesh.triangles, random);
    expect_equal(unite(meshes, WindingRule::nonzero, Pieces::of_polygons), one);
    if (HasFailure()) return;
  }
}

TEST(JoinedFaces, AFaceWithAHoleATipInItAndAVertexAtAVertex) {
  // The frame's faces have holes; a tip touches one from above, the corner of a box another's corner.
  std::set<Cell> frame;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      if (x == 0 || y == 0 || x == 4 || y == 4) frame.insert({x, y, 0});
  const TriangleMesh tip{{{0.5, 2.25, 1}, {0, 2, 2}, {1, 2, 2}, {0.5, 3, 2}},
                         {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  const std::vector<TriangleMesh> meshes{cells_of(frame, 1, {0, 0, 0}), tip, box({5, 5, 1}, {6, 6, 2})};
  const FacePool joined = join_coplanar_faces(pool_faces(meshes));
  EXPECT_EQ(joined.mesh.triangles.size(), 32U + 4U + 12U);  // twice 8 + 2 - 2 around the hole, and eight rectangles
  const ExactMesh both = unite(meshes, WindingRule::positive, Pieces::of_polygons);
  expect_closed(both);
  EXPECT_EQ(exact_volume(both), Rational(16) + volume_of(tip) + Rational(1));
  EXPECT_EQ(both.triangles.size(), 32U + 2U + 4U + 12U);  // two more around the tip
  EXPECT_TRUE(round(both).sound);
}

}  // namespace
}  // namespace plumb
