// Slab test, swept bounding boxes: during which part of [0, 1] can the boxes around two features meet, one of them
// moving?
//
// Laws: outside of [from, to] their distance is more than the reach: from exact doubles or bounds of them, rounded
// outward.
// Source: RTCD 5.5.8.
// Cost: three quotients' worth of products.
#pragma once

#include <algorithm>
#include <vector>

#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {

struct FeatureBox {
  std::array<double, 3> low, high;
};

inline FeatureBox box_of(const Vec3<Running>& v) {
  return {{v.x.lower(), v.y.lower(), v.z.lower()}, {v.x.upper(), v.y.upper(), v.z.upper()}};
}
inline FeatureBox joined(FeatureBox a, const FeatureBox& b) {
  for (std::size_t k = 0; k < 3; ++k)
    a.low[k] = std::min(a.low[k], b.low[k]), a.high[k] = std::max(a.high[k], b.high[k]);
  return a;
}

struct FeatureBoxes {
  explicit FeatureBoxes(const MovingBody<Running>& body) : FeatureBoxes(body, box_of) {}
  /// Of what is around each vertex.
  FeatureBoxes(const MovingBody<Running>& body, const auto& around) {
    constexpr double all = Interval::infinity;
    vertices.reserve(body.vertices.size()), edges.reserve(body.edges.size()), faces.reserve(body.faces.size());
    for (const auto& v : body.vertices) vertices.push_back(around(v));
    for (const auto& e : body.edges) edges.push_back(joined(vertices[e.ends[0]], vertices[e.ends[1]]));
    for (const auto& f : body.faces) {
      FeatureBox box{{all, all, all}, {-all, -all, -all}};
      for (const std::uint32_t c : f.corners) box = joined(box, vertices[c]);
      faces.push_back(f.corners.empty() ? FeatureBox{{-all, -all, -all}, {all, all, all}} : box);
    }
  }
  std::vector<FeatureBox> vertices, edges, faces;
};

/// Around all that a point in motion passes from one time to another, and what is within reach of it.
class SweptBox {
 public:
  SweptBox(const Vec3<Running>& velocity, double reach, double from, double to) {
    const std::array<const Running*, 3> by{&velocity.x, &velocity.y, &velocity.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval way = Interval{by[k]->lower(), by[k]->upper()} * Interval{from, to};
      low_[k] = Interval::sum_down(way.lower, -reach), high_[k] = Interval::sum_up(way.upper, reach);
    }
  }
  FeatureBox operator()(const Vec3<Running>& v) const {
    FeatureBox box = box_of(v);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = Interval::sum_down(box.low[k], low_[k]), box.high[k] = Interval::sum_up(box.high[k], high_[k]);
    }
    return box;
  }

 private:
  std::array<double, 3> low_{}, high_{};
};
inline bool boxes_meet(const FeatureBox& a, const FeatureBox& b) {
  bool meet = true;
  for (std::size_t k = 0; k < 3; ++k) meet &= a.low[k] <= b.high[k] && b.low[k] <= a.high[k];
  return meet;
}

/// The motion of the first, seen from the second, and how far both reach.
class Slabs {
 public:
  Slabs(const Vec3<Running>& velocity, const Running& reach)
      : slow_{velocity.x.lower(), velocity.y.lower(), velocity.z.lower()},
        fast_{velocity.x.upper(), velocity.y.upper(), velocity.z.upper()},
        reach_(reach.upper()) {}

  /// From later than to: never.
  [[nodiscard]] std::pair<double, double> times(const FeatureBox& a, const FeatureBox& b) const {
    double from = 0, to = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double ahead = below(b.low[k], a.high[k]), behind = below(a.low[k], b.high[k]);
      if (slow_[k] > 0) {
        meet(ahead, fast_[k], from);
        part(-behind, slow_[k], to);
      } else if (fast_[k] < 0) {
        meet(behind, -slow_[k], from);
        part(-ahead, -fast_[k], to);
      } else if (ahead > fast_[k] || behind > -slow_[k]) {
        return {1, 0};
      }
    }
    return {from, to};
  }

 private:
  /// No more than x - y - reach.
  [[nodiscard]] double below(double x, double y) const { return ((Running(x) - Running(y)) - Running(reach_)).lower(); }
  static void meet(double gap, double speed, double& from) {
    if (gap > 0) from = std::max(from, quotient_down(gap, speed));
  }
  static void part(double way, double speed, double& to) {
    to = way < 0 ? -1 : std::min(to, -quotient_down(-way, speed));
  }
  /// As if it were rounded upward.
  static double quotient_down(double a, double b) { return Interval::down(a / b, -1); }

  std::array<double, 3> slow_, fast_;
  double reach_;
};

}  // namespace plumb::query
