#include "space/bsp/leaf_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "plumb/arith/rational.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/range/range_search.hpp"
#include "plumb/space/ray/inside.hpp"
#include "space/bsp/piece_list.hpp"

namespace plumb::space {
namespace {

using RationalPlace = std::array<Rational, 3>;

RationalPlace place(const ExactPoint3& p) {
  const RationalPoint3 r = rational_point(p);
  return {r.x, r.y, r.z};
}

/// With its coordinates' doubles, which are kept.
struct KeptPlace {
  explicit KeptPlace(const RationalPlace& p) : at(p), point(RationalPoint3{p[0], p[1], p[2]}) {}
  RationalPlace at;
  ExactPoint3 point;
};

Sign place_side(const BspTree& tree, const BspNode& node, const KeptPlace& p) {
  if (node.axis < 3) return (p.at[node.axis] - Rational(node.at)).sign();
  const auto& [a, b, c] = tree.planes[number_of_plane(node.plane)];
  return -orient3d(ExactPoint3(a), ExactPoint3(b), ExactPoint3(c), p.point);
}
Sign place_side(const BspTree& tree, const BspNode& node, const Point3& p) { return node_side(tree, node, p); }

/// Strictly in one leaf: which?
template <class Place>
std::optional<std::uint32_t> leaf_around(const BspTree& tree, const Place& p) {
  BspChild at = tree.root;
  while (!at.is_leaf()) {
    const BspNode& node = tree.nodes[at.index()];
    const Sign s = place_side(tree, node, p);
    if (s == Sign::zero) return {};
    at = s == Sign::positive ? node.front : node.back;
  }
  return at.index();
}

/// Guesses of the piece's center, by the doubles nearest to its corners.
Point3 guessed_center(std::span<const ExactPoint3> corners) {
  Point3 sum{0, 0, 0};
  const double part = 1 / static_cast<double>(corners.size());
  for (const ExactPoint3& c : corners) {
    const Point3 p = approximate(c);
    sum = {sum.x + part * p.x, sum.y + part * p.y, sum.z + part * p.z};
  }
  return sum;
}

double guessed_size(std::span<const ExactPoint3> corners, const Point3& center) {
  double size = 0;
  for (const ExactPoint3& c : corners) {
    const Point3 p = approximate(c);
    size = std::max({size, std::abs(p.x - center.x), std::abs(p.y - center.y), std::abs(p.z - center.z)});
  }
  return size;
}

/// A point in the leaf that is on this side of the piece's plane.
std::optional<Point3> double_in_leaf(const BspTree& tree, std::uint32_t leaf, std::uint32_t plane, double side,
                                     std::span<const ExactPoint3> corners) {
  const Point3 center = guessed_center(corners);
  const Vector3 normal = GuessedPlane(tree, plane).normal();
  double step = side * guessed_size(corners, center) / 8;
  for (int i = 0; i < 8; ++i, step /= 32) {
    const Point3 p{center.x + step * normal.x, center.y + step * normal.y, center.z + step * normal.z};
    if (!(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < std::numeric_limits<double>::max())) return {};
    if (leaf_around(tree, p) == leaf) return p;
  }
  return {};
}

RationalPlace rational_in_leaf(const BspTree& tree, std::uint32_t leaf, const std::array<Point3, 3>& plane, bool front,
                               std::span<const ExactPoint3> corners) {
  RationalPlace center{Rational(0), Rational(0), Rational(0)}, normal;
  for (const ExactPoint3& c : corners) {
    const RationalPlace p = place(c);
    for (std::size_t k = 0; k < 3; ++k) center[k] = center[k] + p[k];
  }
  for (Rational& x : center) x = x / Rational(static_cast<double>(corners.size()));
  const RationalPlace a = place(plane[0]), b = place(plane[1]), c = place(plane[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    normal[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    if (!front) normal[k] = -normal[k];
  }
  // A leaf without a double is some ulps thick.  Both steps are guesses; the descent proves the place.
  const Rational guessed_first_step(0x1p-80), guessed_shortening(0x1p-40);
  for (Rational& x : normal) x = x * guessed_first_step;
  for (;;) {
    RationalPlace p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = center[k] + normal[k];
    if (leaf_around(tree, KeptPlace(p)) == leaf) return p;
    for (Rational& x : normal) x = x * guessed_shortening;
  }
}

/// Counts the triangles that a ray along x crosses; it crosses an edge of which one end alone is beyond it.
bool is_inside(const TriangleMesh& mesh, const Bvh& bvh, const RationalPlace& p) {
  const double most = std::numeric_limits<double>::max();
  const Aabb3 ray{{p[0].rounded(Rounding::down), p[1].rounded(Rounding::down), p[2].rounded(Rounding::down)},
                  {most, p[1].rounded(Rounding::up), p[2].rounded(Rounding::up)}};
  bool inside = false;
  for (const std::uint32_t number : meeting(bvh, ray)) {
    const auto& t = mesh.triangles[number];
    std::array<RationalPlace, 3> v;
    bool crossed = false;
    for (std::size_t i = 0; i < 3; ++i) v[i] = place(mesh.vertices[t[i]]);
    for (std::size_t i = 0; i < 3; ++i) {
      const RationalPlace &a = v[i], &b = v[(i + 1) % 3];
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      if (a[2] + (p[1] - a[1]) / (b[1] - a[1]) * (b[2] - a[2]) > p[2]) crossed = !crossed;
    }
    if (!crossed) continue;
    RationalPlace n;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      n[k] = (v[1][i] - v[0][i]) * (v[2][j] - v[0][j]) - (v[1][j] - v[0][j]) * (v[2][i] - v[0][i]);
    }
    Rational height(0);
    for (std::size_t k = 0; k < 3; ++k) height = height + n[k] * (v[0][k] - p[k]);
    if (height.sign() * n[0].sign() == Sign::positive) inside = !inside;
  }
  return inside;
}

}  // namespace

void label_leaves(BspTree& tree, const TriangleMesh& mesh) {
  if (tree.nodes.empty()) return;
  const Bvh bvh = build_bvh(mesh);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    for (const bool front : {true, false}) {
      const BspChild child = front ? tree.nodes[i].front : tree.nodes[i].back;
      if (!child.is_leaf()) continue;
      const std::uint32_t plane = tree.nodes[i].plane;
      const std::vector<ExactPoint3> corners = tree.corners_of(tree.first_piece[i]);
      const auto found = double_in_leaf(tree, child.index(), plane, front ? 1 : -1, corners);
      bool is_solid = false;
      if (found) {
        is_solid = locate(bvh, *found) == Location::inside;
      } else {
        ++tree.report.leaves_by_rationals;
        is_solid =
            is_inside(mesh, bvh, rational_in_leaf(tree, child.index(), tree.points_of_plane(plane), front, corners));
      }
      if (!is_solid) continue;
      ++tree.report.solid_leaves;
      BspNode& node = tree.nodes[i];
      (front ? node.front : node.back).code |= BspChild::solid_bit;
    }
  }
}

}  // namespace plumb::space
