// Which points may lie on the hull's boundary?  What is strictly inside a polygon of some of the points cannot.
//
// The corners of that polygon are good guesses, by rounded sums; that a point is inside is certain: by a comparison
// with a box whose corners are in the polygon exactly, or by a filter that is sure for every edge.

#include <algorithm>
#include <array>

#include "certify/batch/all_threads.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/hull/hull2_steps.hpp"
#include "plumb/certify/side.hpp"

namespace plumb::figure::hull2 {
namespace {

constexpr std::size_t block_size = 1 << 15;  // points of a step of the parallel loop
constexpr std::size_t worthwhile = 64;       // for fewer points the polygon costs more than it saves

/// The smallest of -x, x, -y, y and of the four sums of these, each with a point that has it.
struct Extremes {
  std::array<double, 8> value;
  std::array<std::uint32_t, 8> index;

  void take(const std::array<double, 8>& x, const std::array<std::uint32_t, 8>& i) {
    for (std::size_t k = 0; k < 8; ++k) {
      if (x[k] < value[k]) {
        value[k] = x[k];
        index[k] = i[k];
      }
    }
  }
};

std::array<double, 8> forms(const Point2& p) {
  const double sum = p.x + p.y, difference = p.x - p.y;
  return {p.x, -p.x, p.y, -p.y, sum, -sum, difference, -difference};
}

Extremes extremes(std::span<const Point2> points, std::size_t from, std::size_t to) {
  Extremes e{forms(points[from]), {}};
  e.index.fill(static_cast<std::uint32_t>(from));
  double poison = 0;  // becomes NaN where a coordinate is not finite
  for (std::size_t i = from; i < to; ++i) {
    const Point2& p = points[i];
    poison += (p.x - p.x) + (p.y - p.y);
    const double sum = p.x + p.y, difference = p.x - p.y;
    const auto lower = [&](std::size_t k, double x) {
      if (x < e.value[k]) {
        e.value[k] = x;
        e.index[k] = static_cast<std::uint32_t>(i);
      }
    };
    lower(0, p.x);
    lower(1, -p.x);
    lower(2, p.y);
    lower(3, -p.y);
    lower(4, sum);
    lower(5, -sum);
    lower(6, difference);
    lower(7, -difference);
  }
  if (poison != 0) figure::require_finite_points("convex_hull", "points", points);
  return e;
}

/// A convex polygon of some of the points, and a box in it.
class Inside {
 public:
  Inside() = default;
  Inside(std::span<const Point2> points, const Extremes& e) {
    std::vector<Indexed> corners;
    for (const std::uint32_t i : e.index) corners.push_back({points[i], i});
    sort_distinct(corners);
    const Hull2 hull = monotone_chain(corners, false);
    if (hull.dimension < 2) return;
    for (std::size_t i = 0; i < hull.vertices.size(); ++i)
      edges_.emplace_back(points[hull.vertices[i]], points[hull.vertices[(i + 1) % hull.vertices.size()]]);
    const Point2 &southwest = points[e.index[4]], &northeast = points[e.index[5]];
    const Point2 &northwest = points[e.index[6]], &southeast = points[e.index[7]];
    low_ = {std::max(southwest.x, northwest.x), std::max(southwest.y, southeast.y)};
    high_ = {std::min(southeast.x, northeast.x), std::min(northwest.y, northeast.y)};
    for (const Point2& corner : {low_, {high_.x, low_.y}, high_, {low_.x, high_.y}}) {
      for (const LineSide& edge : edges_) {
        if (edge(corner) == Sign::negative) high_ = low_;  // no box
      }
    }
  }

  [[nodiscard]] bool certain(const Point2& p) const {
    if (low_.x < p.x && p.x < high_.x && low_.y < p.y && p.y < high_.y) return true;
    for (const LineSide& edge : edges_) {
      if (edge.filter(p) <= 0) return false;
    }
    return !edges_.empty();
  }

 private:
  std::vector<LineSide> edges_;
  Point2 low_{0, 0}, high_{0, 0};
};

}  // namespace

std::vector<Indexed> candidates(std::span<const Point2> points, const Hull2Options& options) {
  if (points.empty()) return {};
  const std::size_t blocks = (points.size() + block_size - 1) / block_size;
  const auto each_block = [&](const auto& work) {
    certify::batch::for_each_part(options.execution, blocks, [&](std::size_t b) {
      work(b, b * block_size, std::min(points.size(), (b + 1) * block_size));
    });
  };
  std::vector<Extremes> found(blocks);
  each_block([&](std::size_t b, std::size_t from, std::size_t to) { found[b] = extremes(points, from, to); });
  for (const Extremes& e : found) found[0].take(e.value, e.index);

  const bool filtered = options.prefilter && points.size() >= worthwhile;
  const Inside inside = filtered ? Inside(points, found[0]) : Inside();
  std::vector<std::vector<Indexed>> kept(blocks);
  each_block([&](std::size_t b, std::size_t from, std::size_t to) {
    if (!filtered) kept[b].reserve(to - from);
    for (std::size_t i = from; i < to; ++i) {
      if (!filtered || !inside.certain(points[i])) kept[b].push_back({points[i], static_cast<std::uint32_t>(i)});
    }
  });
  std::vector<Indexed> all = std::move(kept[0]);
  for (std::size_t b = 1; b < blocks; ++b) all.insert(all.end(), kept[b].begin(), kept[b].end());
  return all;
}

}  // namespace plumb::figure::hull2
