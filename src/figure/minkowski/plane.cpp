#include <algorithm>

#include "figure/basic/finite_parts.hpp"
#include "figure/minkowski/edges.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/minkowski/minkowski.hpp"

namespace plumb {
namespace {

struct Corner {
  Point2 p;
  std::uint32_t index;
};

/// Strictly convex, counterclockwise from the lexicographically smallest corner; two ends of a segment, or one point.
using Chain = std::vector<Corner>;

bool before(const Corner& a, const Corner& b) { return compare_lexicographically(a.p, b.p) == Sign::negative; }

/// Of a polygon that is convex or lies on one line.
Chain chain_of(const Polygon2& polygon, const char* function, const char* part) {
  const PolygonConvexity shape = convexity(polygon);
  Chain all;
  for (std::uint32_t i = 0; i < polygon.vertices.size(); ++i) all.push_back({polygon.vertices[i], i});
  if (shape.kind == PolygonKind::degenerate) {
    const auto [least, most] = std::ranges::minmax_element(all, before);
    if (least->p == most->p) return {all[0]};
    return {*least, *std::ranges::find_if(all, [p = most->p](const Corner& c) { return c.p == p; })};
  }
  if (!shape.is_convex()) {
    throw InvalidShape(std::string(function).append(": ").append(part).append(
        " is not a convex polygon; give a convex one, or its vertices as a span for their hull"));
  }
  if (shape.orientation == Sign::negative) std::ranges::reverse(all);
  std::rotate(all.begin(), std::ranges::min_element(all, before), all.end());
  Chain strict;
  const auto straight = [](const Corner& a, const Corner& b, const Corner& c) {
    return sign_of(predicates::Orient2d{}, a.p, b.p, c.p) == Sign::zero;
  };
  for (const Corner& next : all) {
    const auto same = [&](Corner& c) {
      if (!(c.p == next.p)) return false;
      c.index = std::min(c.index, next.index);
      return true;
    };
    if (!strict.empty() && (same(strict.back()) || same(strict.front()))) continue;
    while (strict.size() >= 2 && straight(strict[strict.size() - 2], strict.back(), next)) strict.pop_back();
    strict.push_back(next);
  }
  // Ends before the last three, for not all corners are on one line.
  while (straight(strict[strict.size() - 2], strict.back(), strict.front())) strict.pop_back();
  return strict;
}

Chain chain_of(std::span<const Point2> points, const char* function, const char* part) {
  figure::require_finite_points(function, part, points);
  Chain chain;
  for (const std::uint32_t i : convex_hull(points).vertices) chain.push_back({points[i], i});
  return chain;
}

Chain negated(Chain chain) {
  for (Corner& c : chain) c.p = {-c.p.x, -c.p.y};
  if (!chain.empty()) std::rotate(chain.begin(), std::ranges::min_element(chain, before), chain.end());
  return chain;
}

/// The edges of a chain in turn: first those that ascend in the lexicographic order, then those that descend.
class Edges {
 public:
  explicit Edges(const Chain& chain) : chain_(chain), left_(chain.size() == 1 ? 0 : chain.size()) {}
  [[nodiscard]] bool done() const { return left_ == 0; }
  [[nodiscard]] const Corner& from() const { return chain_[at_]; }
  [[nodiscard]] const Corner& to() const { return chain_[(at_ + 1) % chain_.size()]; }
  [[nodiscard]] bool ascends() const { return at_ + 1 < chain_.size() && before(from(), to()); }
  void next() {
    at_ = (at_ + 1) % chain_.size();
    --left_;
  }

 private:
  const Chain& chain_;
  std::size_t at_ = 0, left_;
};

/// Positive when the edge of a comes first.
Sign order(const Edges& a, const Edges& b) {
  if (a.done() || b.done()) return a.done() ? Sign::negative : Sign::positive;
  if (a.ascends() != b.ascends()) return a.ascends() ? Sign::positive : Sign::negative;
  return sign_of(figure::minkowski::EdgesTurn{}, a.from().p, a.to().p, b.from().p, b.to().p);
}

MinkowskiSum2 sum(const Chain& a, const Chain& b) {
  MinkowskiSum2 made;
  if (a.empty() || b.empty()) return made;
  Edges x(a), y(b);
  do {
    made.vertices.push_back({x.from().p, y.from().p, x.from().index, y.from().index});
    const Sign s = order(x, y);
    if (x.done() && y.done()) break;
    if (s != Sign::negative) x.next();
    if (s != Sign::positive) y.next();
  } while (!x.done() || !y.done());
  made.dimension = static_cast<int>(std::min<std::size_t>(made.vertices.size(), 3)) - 1;
  return made;
}

}  // namespace

MinkowskiSum2 minkowski_sum(const Polygon2& a, const Polygon2& b) {
  return sum(chain_of(a, "minkowski_sum", "a"), chain_of(b, "minkowski_sum", "b"));
}
MinkowskiSum2 minkowski_sum(std::span<const Point2> a, std::span<const Point2> b) {
  return sum(chain_of(a, "minkowski_sum", "a"), chain_of(b, "minkowski_sum", "b"));
}
MinkowskiSum2 minkowski_difference(const Polygon2& a, const Polygon2& b) {
  return sum(chain_of(a, "minkowski_difference", "a"), negated(chain_of(b, "minkowski_difference", "b")));
}
MinkowskiSum2 minkowski_difference(std::span<const Point2> a, std::span<const Point2> b) {
  return sum(chain_of(a, "minkowski_difference", "a"), negated(chain_of(b, "minkowski_difference", "b")));
}

}  // namespace plumb
