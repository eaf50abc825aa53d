#include "plumb/surface/planar/convex_pieces.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "surface/planar/ring_points.hpp"
#include "surface/planar/triangles.hpp"

namespace plumb {
namespace {

using surface::none;
using ConvexPieces = std::vector<std::vector<std::uint32_t>>;

// Keeps the borders of pieces: half-edges 3 t + k of triangles, linked around each piece.
class Borders {
 public:
  Borders(std::span<const Point2> points, const CornerTriangles& triangles)
      : points_(points), origin_(3 * triangles.size()), next_(origin_.size()), previous_(origin_.size()) {
    for (std::uint32_t e = 0; e < origin_.size(); ++e) {
      origin_[e] = triangles[e / 3][e % 3];
      next_[e] = e % 3 == 2 ? e - 2 : e + 1;
      previous_[e] = e % 3 == 0 ? e + 2 : e - 1;
    }
    gone_.assign(origin_.size(), false);
  }

  // Takes out every edge without which both ends stay convex, one after the other.
  void join() {
    struct Side {
      std::uint32_t low, high, edge;
    };
    std::vector<Side> sides;
    sides.reserve(origin_.size());
    for (std::uint32_t e = 0; e < origin_.size(); ++e) {
      const std::uint32_t a = origin_[e], b = origin_[next_[e]];
      sides.push_back({std::min(a, b), std::max(a, b), e});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
      return l.low != r.low ? l.low < r.low : l.high != r.high ? l.high < r.high : l.edge < r.edge;
    });
    for (std::size_t k = 0; k + 1 < sides.size(); ++k)
      if (sides[k].low == sides[k + 1].low && sides[k].high == sides[k + 1].high)
        open(sides[k].edge, sides[k + 1].edge);
  }

  [[nodiscard]] ConvexPieces pieces() const {
    ConvexPieces all;
    std::vector<bool> seen = gone_;
    for (std::uint32_t first = 0; first < origin_.size(); ++first) {
      if (seen[first]) continue;
      all.emplace_back();
      for (std::uint32_t e = first; !seen[e]; e = next_[e]) {
        seen[e] = true;
        all.back().push_back(origin_[e]);
      }
    }
    return all;
  }

 private:
  // Does the border turn left from edge `in` to edge `out`, or go straight on?
  [[nodiscard]] bool is_convex(std::uint32_t in, std::uint32_t out) const {
    const Point2 &from = points_[origin_[in]], &at = points_[origin_[out]], &to = points_[origin_[next_[out]]];
    const Sign turn = orient2d(from, at, to);
    return turn == Sign::positive || (turn == Sign::zero && compare_xy(from, at) == compare_xy(at, to));
  }

  void open(std::uint32_t e, std::uint32_t twin) {
    if (!is_convex(previous_[e], next_[twin]) || !is_convex(previous_[twin], next_[e])) return;
    link(previous_[e], next_[twin]);
    link(previous_[twin], next_[e]);
    gone_[e] = gone_[twin] = true;
  }
  void link(std::uint32_t in, std::uint32_t out) {
    next_[in] = out;
    previous_[out] = in;
  }

  std::span<const Point2> points_;
  std::vector<std::uint32_t> origin_, next_, previous_;
  std::vector<bool> gone_;
};

}  // namespace

ConvexPieces convex_pieces(std::span<const Point2> points, const CornerTriangles& triangles) {
  Borders borders(points, triangles);
  borders.join();
  return borders.pieces();
}

ConvexPieces convex_pieces(const Polygon2& polygon, WindingRule rule) {
  return convex_pieces(polygon.vertices, triangulate(polygon, rule));
}

ConvexPieces convex_pieces(const HoledPolygon2& polygon, WindingRule rule) {
  const auto [points, first] = surface::ring_points<Point2>(polygon);
  return convex_pieces(points, triangulate(points, first, rule));
}

}  // namespace plumb
