// Does no piece hide one that is told before it, whichever way one looks?
#include "plumb/space/bsp/bsp_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "certify/sanitized.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/bsp/build_bsp.hpp"
#include "space/bsp/closed_meshes.hpp"

namespace plumb {
namespace {

using namespace bsp_cases;
using Exact = std::array<Rational, 3>;

Exact operator-(const Exact& a, const Exact& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Exact exact(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

struct Seen {
  std::vector<Exact> corners;
  Exact center, normal;
};

Seen seen(const BspTree& tree, std::uint32_t piece) {
  Seen s{{}, {Rational(0), Rational(0), Rational(0)}, {}};
  for (const ExactPoint3& c : tree.corners_of(piece)) {
    const RationalPoint3 r = rational_point(c);
    s.corners.push_back({r.x, r.y, r.z});
    for (std::size_t k = 0; k < 3; ++k) s.center[k] = s.center[k] + s.corners.back()[k];
  }
  for (Rational& x : s.center) x = x / Rational(static_cast<double>(s.corners.size()));
  const auto& [a, b, c] = tree.planes[tree.pieces[piece].face];
  s.normal = cross(exact(b) - exact(a), exact(c) - exact(a));
  return s;
}

/// Is the center seen through an inner point of the piece?
bool hides(const Seen& piece, const Exact& center, const Exact& eye) {
  const Exact way = center - eye;
  const Rational slope = dot(piece.normal, way), ahead = dot(piece.normal, piece.center - eye);
  if (slope.sign() == Sign::zero) return false;
  const Rational t = ahead / slope;
  if (t <= Rational(0) || t >= Rational(1)) return false;
  const Exact at{eye[0] + t * way[0], eye[1] + t * way[1], eye[2] + t * way[2]};
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    const Exact &p = piece.corners[i], &q = piece.corners[(i + 1) % piece.corners.size()];
    if (dot(cross(q - p, at - p), piece.normal).sign() != Sign::positive) return false;
  }
  return true;
}

TEST(BspOrder, NoPieceHidesOneBeforeIt) {
  std::size_t hidden = 0;
  for (const NamedMesh& m : closed_meshes()) {
    if (m.name != "box" && m.name != "voxels" && m.name != "crossing" && m.name != "pillars") continue;
    for (const BspKind kind : {BspKind::node_storing, BspKind::leaf_storing}) {
      const BspTree tree = build_bsp(m.mesh, {.kind = kind, .leaf_size = 1});
      std::vector<Seen> pieces;
      for (std::uint32_t i = 0; i < tree.piece_count(); ++i) pieces.push_back(seen(tree, i));
      std::vector<std::size_t> leaf_of(tree.piece_count());
      for (std::size_t k = 0; k + 1 < tree.first_piece.size(); ++k) {
        for (std::uint32_t i = tree.first_piece[k]; i < tree.first_piece[k + 1]; ++i) leaf_of[i] = k;
      }
      std::vector<Point3> eyes = points_about(m.mesh, 97, battery::fitting(4u));
      eyes.push_back({-9, -8, 7});
      for (const Point3& from : eyes) {
        const Exact eye = exact(from);
        const std::vector<std::uint32_t> order = front_to_back(tree, from);
        std::vector<std::uint32_t> sorted = order;
        std::sort(sorted.begin(), sorted.end());
        ASSERT_EQ(sorted.size(), tree.piece_count());
        EXPECT_TRUE(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
        for (std::size_t i = 0; i < order.size(); ++i) {
          for (std::size_t j = i + 1; j < order.size(); ++j) {
            if (kind == BspKind::leaf_storing && leaf_of[order[i]] == leaf_of[order[j]]) continue;
            ASSERT_FALSE(hides(pieces[order[j]], pieces[order[i]].center, eye)) << m.name;
            hidden += hides(pieces[order[i]], pieces[order[j]].center, eye) ? 1 : 0;
          }
        }
      }
    }
  }
  EXPECT_GT(hidden, battery::fitting(300u));
}

TEST(BspOrder, SaysWhatItRefuses) {
  const BspTree tree = build_bsp(solids::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_THROW((void)front_to_back(tree, {0, std::nan(""), 0}), NonFinite);
  EXPECT_TRUE(front_to_back(build_bsp(TriangleMesh{}), {0, 0, 0}).empty());
}

}  // namespace
}  // namespace plumb
