#include "tool/drawing/label_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace plumb::tool {
namespace {

struct Side {
  double x, y, cost;
};

// Beside first, then above and below, then the corners and what lies between: how a reader looks for a name.
constexpr double kCorner = 0.7071, kMore = 0.9239, kLess = 0.3827;
constexpr std::array<Side, 16> kSides{{{1, 0, 0},
                                       {-1, 0, 2},
                                       {0, -1, 3},
                                       {0, 1, 4},
                                       {kCorner, -kCorner, 5},
                                       {kCorner, kCorner, 5},
                                       {-kCorner, -kCorner, 6},
                                       {-kCorner, kCorner, 6},
                                       {kMore, -kLess, 7},
                                       {kMore, kLess, 7},
                                       {-kMore, -kLess, 8},
                                       {-kMore, kLess, 8},
                                       {kLess, -kMore, 8},
                                       {kLess, kMore, 8},
                                       {-kLess, -kMore, 9},
                                       {-kLess, kMore, 9}}};
constexpr double kGap = 4, kStep = 12;       // pixels
constexpr double kAway = 80, kTangle = 150;  // costs, in the unit of kSides

/// Does the segment meet the open box?  Clipping against the four sides (Liang and Barsky).
bool crosses(const LabelPlace& p, const Box& box) {
  double enter = 0, leave = 1;
  const auto clip = [&](double start, double by, double low, double high) {
    if (by == 0) return start > low && start < high;
    const double s = (low - start) / by, t = (high - start) / by;
    enter = std::max(enter, std::min(s, t));
    leave = std::min(leave, std::max(s, t));
    return true;
  };
  return clip(p.from_x, p.to_x - p.from_x, box.left, box.right) &&
         clip(p.from_y, p.to_y - p.from_y, box.top, box.bottom) && enter < leave;
}

Box marker_box(const LabelRequest& r, double radius) {
  return {r.x - radius, r.y - radius, r.x + radius, r.y + radius};
}

LabelPlace place_at(const LabelRequest& r, const Side& side, double radius, int steps) {
  const double away = radius + kGap + steps * kStep;
  const auto half = [](double s) { return s > 0.5 ? 0.5 : s < -0.5 ? -0.5 : 0.0; };
  const double x = r.x + side.x * away + half(side.x) * r.width, y = r.y + side.y * away + half(side.y) * r.height;
  LabelPlace p{{x - r.width / 2, y - r.height / 2, x + r.width / 2, y + r.height / 2}, steps > 0, 0, 0, 0, 0};
  p.to_x = std::clamp(r.x, p.box.left, p.box.right);
  p.to_y = std::clamp(r.y, p.box.top, p.box.bottom);
  const double dx = p.to_x - r.x, dy = p.to_y - r.y, length = std::max(1.0, std::hypot(dx, dy));
  p.from_x = r.x + dx / length * (radius + 1);
  p.from_y = r.y + dy / length * (radius + 1);
  return p;
}

class Placement {
 public:
  Placement(std::span<const LabelRequest> requests, const Box& area, double radius)
      : requests_(requests), area_(area), radius_(radius) {}

  /// Total cost of placing one after the other, infinite where one finds no room.
  double place(const std::vector<std::size_t>& order, std::vector<LabelPlace>& places) const {
    std::vector<std::size_t> done;
    double total = 0;
    for (const std::size_t i : order) {
      const int far = static_cast<int>((area_.right - area_.left + area_.bottom - area_.top) / kStep);
      double best = std::numeric_limits<double>::infinity();
      for (int steps = 0; steps < far && 10 * steps < best; ++steps) {
        for (const Side& side : kSides) {
          const LabelPlace p = place_at(requests_[i], side, radius_, steps);
          const double cost = 10 * steps + side.cost + (requests_[i].home.contains(p.box) ? 0 : kAway);
          if (cost >= best || !area_.contains(p.box) || covers_marker(p.box)) continue;
          if (const double tangle = tangles(p, i, places, done); cost + tangle < best) {
            best = cost + tangle;
            places[i] = p;
          }
        }
      }
      total += best;
      done.push_back(i);
      if (!std::isfinite(best)) break;
    }
    return total;
  }

 private:
  [[nodiscard]] bool covers_marker(const Box& box) const {
    return std::any_of(requests_.begin(), requests_.end(),
                       [&](const LabelRequest& r) { return box.overlaps(marker_box(r, radius_)); });
  }

  /// What standing here costs for lines run over names and markers; infinite where two names would overlap.
  [[nodiscard]] double tangles(const LabelPlace& p, std::size_t self, const std::vector<LabelPlace>& places,
                               const std::vector<std::size_t>& done) const {
    double cost = 0;
    for (const std::size_t j : done) {
      if (p.box.overlaps(places[j].box)) return std::numeric_limits<double>::infinity();
      if (p.leader && crosses(p, places[j].box)) cost += kTangle;
      if (places[j].leader && crosses(places[j], p.box)) cost += kTangle;
    }
    for (std::size_t j = 0; p.leader && j < requests_.size(); ++j) {
      if (j != self && crosses(p, marker_box(requests_[j], radius_))) cost += kTangle / 2;
    }
    return cost;
  }

  std::span<const LabelRequest> requests_;
  Box area_;
  double radius_;
};

}  // namespace

std::optional<std::vector<LabelPlace>> place_labels(std::span<const LabelRequest> requests, const Box& area,
                                                    double marker_radius) {
  const Placement placement(requests, area, marker_radius);
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<LabelPlace> best(requests.size()), places(requests.size());
  double best_cost = std::numeric_limits<double>::infinity();
  // Each order in turn puts another point first, which gets the best place; a crowd gets fewer turns.
  const std::size_t attempts = std::clamp<std::size_t>(400 / std::max<std::size_t>(requests.size(), 1), 1, 16);
  for (std::size_t attempt = 0; attempt < std::clamp<std::size_t>(requests.size(), 1, attempts); ++attempt) {
    const double cost = placement.place(order, places);
    if (cost < best_cost) {
      best_cost = cost;
      best = places;
    }
    std::rotate(order.begin(), order.begin() + (order.empty() ? 0 : 1), order.end());
  }
  if (!std::isfinite(best_cost)) return std::nullopt;
  return best;
}

}  // namespace plumb::tool
