#include "plumb/query/convex/location.hpp"

#include <algorithm>
#include <array>

#include "figure/basic/chain_input.hpp"
#include "plumb/figure/basic/convexity.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

bool before(const Point2& a, const Point2& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Without what lies between its neighbors; of points that turn to the left and do not go back.
void drop_straight(std::vector<Point2>& chain) {
  std::vector<Point2> kept;
  for (const Point2& p : chain) {
    if (!kept.empty() && kept.back() == p) continue;
    while (kept.size() > 1 && orient2d(kept[kept.size() - 2], kept.back(), p) == Sign::zero) kept.pop_back();
    kept.push_back(p);
  }
  chain = std::move(kept);
}

}  // namespace

ConvexLocator2::ConvexLocator2(const Polygon2& polygon) {
  require_chain<Point2>("ConvexLocator2", "polygon.vertices", polygon.vertices);
  const PolygonConvexity c = convexity(polygon);
  std::vector<Point2> v = polygon.vertices;
  const auto [least, most] = std::minmax_element(v.begin(), v.end(), before);
  if (!c.is_convex()) {
    if (c.kind != PolygonKind::degenerate)
      throw InvalidShape("ConvexLocator2: polygon is not convex; ask locate(polygon, p)");
    lower_ = {*least, *most};
    if (*least == *most) lower_.pop_back();
    upper_ = lower_;
    return;
  }
  const Point2 first = *least, last = *most;
  if (c.orientation == Sign::negative) std::reverse(v.begin(), v.end());
  std::rotate(v.begin(), std::find(v.begin(), v.end(), first), v.end());
  const auto turning = std::find(v.begin(), v.end(), last);
  lower_.assign(v.begin(), turning + 1);
  upper_.assign(turning, v.end());
  upper_.push_back(first);
  drop_straight(lower_);
  drop_straight(upper_);
  std::reverse(upper_.begin(), upper_.end());
}

std::vector<Point2> ConvexLocator2::corners() const {
  std::vector<Point2> all = lower_;
  for (std::size_t i = upper_.size(); i-- > 2;) all.push_back(upper_[i - 1]);
  return all;
}

Location ConvexLocator2::locate(const Point2& p) const {
  require_finite_parts("ConvexLocator2", std::array<std::string_view, 1>{"p"}, p);
  const Point2 &first = lower_.front(), &last = lower_.back();
  if (before(p, first) || before(last, p)) return Location::outside;
  if (p == first || p == last) return Location::boundary;
  // Now first < p < last.  Of each chain the edge from the last corner that is not after p to the next.
  const auto side = [&p](const std::vector<Point2>& chain) {
    const auto next = std::upper_bound(chain.begin(), chain.end(), p, before);
    return orient2d(*(next - 1), *next, p);
  };
  // Which chain can p be beyond?  The diagonal tells, and p cannot be beyond both.
  const Sign above = orient2d(first, last, p);
  if (above == Sign::zero) {
    if (lower_.size() > 2 && upper_.size() > 2) return Location::inside;
    return Location::boundary;
  }
  const std::vector<Point2>& chain = above == Sign::positive ? upper_ : lower_;
  return static_cast<Location>(-static_cast<int>(side(chain) * above));
}

}  // namespace plumb
