// Do the pieces of a BSP tree cover their polygons, each in its plane and in its leaf, and is the tree as deep as it says?
#include "plumb/space/bsp/build_bsp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "space/bsp/closed_meshes.hpp"

namespace plumb {
namespace {

using namespace bsp_cases;
using Exact = std::array<Rational, 3>;

Exact exact(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {r.x, r.y, r.z};
}

/// Twice the vector area of a polygon.
Exact area_of(const std::vector<ExactPoint3>& corners) {
  Exact sum{Rational(0), Rational(0), Rational(0)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Exact p = exact(corners[i]), q = exact(corners[(i + 1) % corners.size()]);
    for (std::size_t k = 0; k < 3; ++k)
      sum[k] = sum[k] + p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
  }
  return sum;
}

/// Positive in front, by rational numbers alone.
Sign side_of(const std::array<Point3, 3>& plane, const Exact& p) {
  const Exact a = exact(plane[0]), b = exact(plane[1]), c = exact(plane[2]);
  Rational sum(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    sum = sum + (p[k] - a[k]) * ((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]));
  }
  return sum.sign();
}

std::uint32_t plane_of(const BspNode& node) {
  return (node.axis < 3 ? BspCorner::axis_plane : BspCorner::face_plane) | node.plane;
}

struct Side {
  std::array<Point3, 3> plane;
  Sign sign;
};

struct Checked {
  std::size_t depth = 0, leaves = 0, pieces = 0, solid = 0;
};

void check_pieces(const BspTree& tree, std::size_t from, const std::vector<Side>& above, std::vector<Exact>& covered,
                  Checked& checked) {
  for (std::size_t i = tree.first_piece[from]; i < tree.first_piece[from + 1]; ++i) {
    ++checked.pieces;
    const std::uint32_t face = tree.pieces[i].face;
    const std::vector<ExactPoint3> corners = tree.corners_of(i);
    ASSERT_GE(corners.size(), 3u);
    const Exact area = area_of(corners);
    for (std::size_t k = 0; k < 3; ++k) covered[face][k] = covered[face][k] + area[k];
    for (const ExactPoint3& c : corners) {
      const Exact p = exact(c);
      EXPECT_EQ(side_of(tree.planes[face], p), Sign::zero);
      for (const Side& s : above) EXPECT_NE(side_of(s.plane, p) * s.sign, Sign::negative);
    }
  }
}

void check_below(const BspTree& tree, BspChild at, std::vector<Side>& above, std::vector<Exact>& covered,
                 Checked& checked) {
  if (at.is_leaf()) {
    ++checked.leaves;
    checked.solid += at.is_solid() ? 1 : 0;
    checked.depth = std::max(checked.depth, above.size());
    if (tree.kind == BspKind::leaf_storing) check_pieces(tree, at.index(), above, covered, checked);
    return;
  }
  const BspNode& node = tree.nodes[at.index()];
  const auto plane = tree.points_of_plane(plane_of(node));
  if (tree.kind != BspKind::leaf_storing) {
    check_pieces(tree, at.index(), above, covered, checked);
    for (std::size_t i = tree.first_piece[at.index()]; i < tree.first_piece[at.index() + 1]; ++i) {
      for (const ExactPoint3& c : tree.corners_of(i)) EXPECT_EQ(side_of(plane, exact(c)), Sign::zero);
    }
  }
  for (const Sign s : {Sign::positive, Sign::negative}) {
    above.push_back({plane, s});
    check_below(tree, s == Sign::positive ? node.front : node.back, above, covered, checked);
    above.pop_back();
  }
}

void check(const BspTree& tree) {
  const std::size_t faces = tree.mesh.first.size() - 1;
  std::vector<Exact> covered(faces, Exact{Rational(0), Rational(0), Rational(0)});
  std::vector<Side> above;
  Checked checked;
  check_below(tree, tree.root, above, covered, checked);
  for (std::uint32_t f = 0; f < faces; ++f) {
    std::vector<ExactPoint3> corners;
    for (std::uint32_t i = 0; i < tree.mesh.first[f + 1] - tree.mesh.first[f]; ++i)
      corners.emplace_back(tree.vertex(f, i));
    EXPECT_EQ(covered[f], area_of(corners)) << "face " << f;
  }
  EXPECT_EQ(checked.depth, tree.report.depth);
  EXPECT_EQ(checked.leaves, tree.report.leaves);
  EXPECT_EQ(checked.pieces, tree.report.pieces);
  EXPECT_EQ(checked.solid, tree.report.solid_leaves);
  EXPECT_EQ(tree.report.nodes, tree.nodes.size());
  EXPECT_EQ(tree.report.leaves, tree.report.nodes + 1);
}

TEST(BuildBsp, PiecesCoverTheirPolygonsExactly) {
  std::size_t splits = 0;
  for (const NamedMesh& m : closed_meshes()) {
    SCOPED_TRACE(m.name);
    for (const BspKind kind : {BspKind::node_storing, BspKind::leaf_storing, BspKind::solid_leaf}) {
      const auto planes = kind == BspKind::node_storing ? BspPlanes::faces : BspPlanes::faces_and_axes;
      const BspTree tree = build_bsp(m.mesh, {.kind = kind, .planes = planes});
      check(tree);
      splits += tree.report.splits;
      if (testing::Test::HasFailure()) return;
      if (battery::sanitized) break;
    }
  }
  EXPECT_GT(splits, 1000u / (battery::sanitized ? 3 : 1));
}

TEST(BuildBsp, OfPolygonSoups) {
  for (std::uint64_t i = 0; i < battery::fitting(40u); ++i) {
    Entropy e(8, i);
    PolygonMesh mesh;
    const auto number = [&] { return static_cast<double>(e.within(4)); };
    for (std::size_t f = 0; f < 6; ++f) {  // parallelograms, some of them flat
      const Point3 p{number(), number(), number()};
      const Vector3 u{number(), number(), number()}, v{number(), number(), number()};
      const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        mesh.vertices.push_back({p.x + s * u.x + t * v.x, p.y + s * u.y + t * v.y, p.z + s * u.z + t * v.z});
      for (std::uint32_t k = 0; k < 4; ++k) mesh.corners.push_back(n + k);
      mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    SCOPED_TRACE("Entropy(8, " + std::to_string(i) + ")");
    check(build_bsp(mesh, {.kind = BspKind::node_storing}));
    check(build_bsp(mesh, {.kind = BspKind::leaf_storing, .split_weight = 1, .leaf_size = 1}));
    if (HasFailure()) return;
  }
}

TEST(BuildBsp, AxesAvoidTheChainOfAConvexMesh) {
  const TriangleMesh sphere = bsp_cases::sphere(32, 15);
  const BspReport chain = build_bsp(sphere, {.planes = BspPlanes::faces}).report;
  const BspReport tree = build_bsp(sphere).report;
  EXPECT_GT(chain.depth, 400u);
  EXPECT_GT(chain.longest_chain, 50u);
  EXPECT_LT(tree.depth, 50u);
  EXPECT_LT(tree.longest_chain, 33u);  // of the 32 triangles about a pole
}

TEST(BuildBsp, NothingOfNothing) {
  const BspTree tree = build_bsp(TriangleMesh{});
  EXPECT_TRUE(tree.root.is_leaf());
  EXPECT_FALSE(tree.root.is_solid());
  EXPECT_EQ(tree.report.leaves, 1u);
  const TriangleMesh flat{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 0}}};
  const BspTree none = build_bsp(flat, {.kind = BspKind::node_storing});
  EXPECT_EQ(none.report.faces_left_out, 2u);
  EXPECT_EQ(none.report.nodes, 0u);
}

TEST(BuildBsp, SaysWhatItRefuses) {
  TriangleMesh open = solids::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_bsp(open); }), testing::HasSubstr("not closed"));
  EXPECT_EQ(build_bsp(open, {.kind = BspKind::node_storing}).report.pieces >= 11, true);
  const PolygonMesh bent{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {0, 1, 2, 3}, {0, 4}};
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_bsp(bent, {.kind = BspKind::node_storing}); }),
              testing::HasSubstr("face 0 is not planar"));
  const PolygonMesh dented{{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, {0, 1, 2, 3}, {0, 4}};
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_bsp(dented, {.kind = BspKind::node_storing}); }),
              testing::HasSubstr("face 0 is not convex"));
  open.vertices[0].x = std::nan("");
  EXPECT_THROW((void)build_bsp(open), NonFinite);
  open.triangles[0][0] = 99;
  EXPECT_THROW((void)build_bsp(open), InvalidShape);
}

}  // namespace
}  // namespace plumb
