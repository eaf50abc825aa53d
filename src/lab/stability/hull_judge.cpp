#include "lab/stability/hull_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plumb::lab::stability {

using Index = std::uint32_t;

HullJudge::HullJudge(std::span<const Point2> points) {
  for (const Point2& p : points) points_.push_back({mpq_class(p.x), mpq_class(p.y)});
  std::vector<Index> order(points_.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, [this](Index a, Index b) { return points_[a] < points_[b]; });
  order.erase(std::unique(order.begin(), order.end(), [this](Index a, Index b) { return points_[a] == points_[b]; }),
              order.end());
  last_ = order.back();
  // Along each chain those that no two others, one on each side of it in this order, have on or below their segment.
  for (const int side : {1, -1}) {
    const auto begin = static_cast<std::ptrdiff_t>(corners_.size());
    for (const Index p : order) {
      const auto covered = [&] {
        const std::size_t n = corners_.size();
        return static_cast<std::ptrdiff_t>(n) - begin >= 2 &&
               side * sgn(area(corners_[n - 2], corners_[n - 1], p)) <= 0;
      };
      while (covered()) corners_.pop_back();
      corners_.push_back(p);
    }
    if (side < 0) {  // from the last to the first, which the other chain holds
      corners_.erase(corners_.begin() + begin);
      if (corners_.size() > static_cast<std::size_t>(begin)) corners_.pop_back();
      std::reverse(corners_.begin() + begin, corners_.end());
    }
  }
  const auto range = [this](auto of, mpq_class& least, mpq_class& extent) {
    least = of(corners_.front());
    mpq_class most = least;
    for (const Index c : corners_) {
      const mpq_class at = of(c);
      if (at < least) least = at;
      if (at > most) most = at;
    }
    extent = most - least;
  };
  range([this](Index p) { return along(p); }, least_along_, length_);
  range([this](Index p) { return across(p); }, least_across_, width_);
}

mpq_class HullJudge::area(Index a, Index b, Index c) const {
  const auto &p = points_[a], &q = points_[b], &r = points_[c];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

mpq_class HullJudge::along(Index p) const {
  const auto &a = points_[corners_.front()], &b = points_[last_], &c = points_[p];
  return (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
}

mpq_class HullJudge::across(Index p) const { return area(corners_.front(), last_, p); }

HullFlaws HullJudge::flaws(const std::vector<Index>& corners) const {
  HullFlaws flaws;
  const std::size_t n = corners.size();
  const auto next = [&](std::size_t i) { return corners[(i + 1) % n]; };
  const auto is_same = [this](Index a, Index b) { return points_[a] == points_[b]; };
  std::vector<bool> named(corners_.size());
  for (std::size_t i = 0; i < n; ++i) {
    const Index a = corners[i], b = next(i), c = corners[(i + 2) % n];
    flaws.not_convex = flaws.not_convex || sgn(area(a, b, c)) < 0;
    const auto truth = std::ranges::find_if(corners_, [&](Index t) { return is_same(t, a); });
    const auto place = static_cast<std::size_t>(truth - corners_.begin());
    if (truth == corners_.end() || named[place])
      flaws.no_corner = true;
    else
      named[place] = true;
    for (const Index p : corners_) {  // where any point lies outside, one of these does
      const mpq_class left = area(a, b, p);
      const bool out = n == 1 ? !is_same(a, p) : sgn(left) < 0;
      if (!out) continue;
      flaws.leaves_out = true;
      if (sgn(width_) == 0 || sgn(length_) == 0) continue;
      // In the stretched picture: there the area is the true one over the unit of both.
      const mpq_class u = (along(b) - along(a)) / length_, v = (across(b) - across(a)) / width_;
      const mpq_class pu = (along(p) - along(a)) / length_, pv = (across(p) - across(a)) / width_;
      const double edge = std::hypot(u.get_d(), v.get_d());
      const mpq_class stretched_area = u * pv - v * pu;
      if (edge > 0) flaws.worst_outside = std::max(flaws.worst_outside, std::fabs(stretched_area.get_d()) / edge);
    }
  }
  flaws.lost = std::ranges::find(named, false) != named.end();
  return flaws;
}

std::vector<std::array<double, 2>> HullJudge::stretched() const {
  std::vector<std::array<double, 2>> places;
  for (Index p = 0; p < points_.size(); ++p) {
    const mpq_class u = sgn(length_) == 0 ? mpq_class(0) : mpq_class((along(p) - least_along_) / length_);
    const mpq_class v = sgn(width_) == 0 ? mpq_class(0) : mpq_class((across(p) - least_across_) / width_);
    places.push_back({u.get_d(), v.get_d()});
  }
  return places;
}

double HullJudge::stretch() const { return sgn(width_) == 0 ? 1 : mpq_class(length_ / width_).get_d(); }

}  // namespace plumb::lab::stability
