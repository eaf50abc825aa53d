#include "space/bvh/pruned_cover.hpp"

#include <algorithm>
#include <queue>

#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/sphere/fits.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/build.hpp"
#include "plumb/space/bvh/descend.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {
namespace {

using PieceNumbers = std::vector<std::uint32_t>;

/// Of each candidate the pieces that it holds.
std::vector<PieceNumbers> held_by(std::span<const Sphere3> candidates, const std::vector<std::vector<Point3>>& points) {
  std::vector<Aabb3> boxes;
  for (const auto& of_piece : points) boxes.push_back(fit_aabb(of_piece));
  const BoxTree tree = build_box_tree(boxes);
  std::vector<PieceNumbers> held(candidates.size());
  for_blocks(Execution::parallel, candidates.size(), 16, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c) {
      const Sphere3& ball = candidates[c];
      const auto may_hold = [&](const BoxNode& node) {
        return relate(ball, tree.frame.outside(node.box())) != Relation::disjoint;
      };
      descend(tree, may_hold, [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
          const std::uint32_t piece = tree.items[slot];
          const auto in_ball = [&](const Point3& p) { return contains(ball, p); };
          if (std::ranges::all_of(points[piece], in_ball)) held[c].push_back(piece);
        }
      });
      std::ranges::sort(held[c]);
    }
  });
  return held;
}

struct Offer {
  std::size_t pieces;
  std::uint32_t candidate;
  bool operator<(const Offer& other) const {
    return pieces != other.pieces ? pieces < other.pieces : candidate > other.candidate;
  }
};

/// Takes candidates into `chosen` as long as they hold pieces that none has; says which pieces none of them holds.
PieceNumbers choose(std::span<const Sphere3> candidates, const std::vector<std::vector<Point3>>& points,
                    std::vector<Sphere3>& chosen) {
  const std::vector<PieceNumbers> held = held_by(candidates, points);
  std::priority_queue<Offer> offers;
  for (std::uint32_t c = 0; c < held.size(); ++c) offers.push({held[c].size(), c});
  std::vector<char> is_held(points.size(), 0);
  while (!offers.empty()) {
    const Offer best = offers.top();
    offers.pop();
    PieceNumbers left;
    for (const std::uint32_t piece : held[best.candidate]) {
      if (is_held[piece] == 0) left.push_back(piece);
    }
    if (left.empty()) continue;
    if (left.size() < best.pieces) {
      offers.push({left.size(), best.candidate});
      continue;
    }
    std::vector<Point3> around;
    for (const std::uint32_t piece : left) {
      is_held[piece] = 1;
      around.insert(around.end(), points[piece].begin(), points[piece].end());
    }
    const Sphere3 fitted = fit_sphere_ritter(around);
    chosen.push_back(fitted.radius < candidates[best.candidate].radius ? fitted : candidates[best.candidate]);
  }
  PieceNumbers missed;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (is_held[i] == 0) missed.push_back(i);
  }
  return missed;
}

}  // namespace

std::vector<Sphere3> pruned_cover(const CoveredPieces& covered, std::span<const Sphere3> candidates, double radius) {
  std::vector<std::vector<Point3>> points;
  for (const SurfacePiece& piece : covered.pieces) points.push_back(piece.points());
  std::vector<Sphere3> chosen, others;
  std::vector<std::vector<Point3>> missed;
  for (const std::uint32_t piece : choose(candidates, points, chosen)) {
    const Sphere3& own = covered.spheres[piece];
    others.push_back({own.center, std::max(own.radius, radius)});
    missed.push_back(std::move(points[piece]));
  }
  choose(others, missed, chosen);  // each holds its own
  return chosen;
}

}  // namespace plumb::space
