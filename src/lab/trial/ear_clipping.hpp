// How are polygons commonly triangulated?  Ear by ear, over any number.
//
// Laws: none; it is on trial, and decides nothing of ours.  An ear is a corner that turns left and whose triangle holds no
// other vertex; an epsilon is what a corner must turn by, and how far a vertex may be outside and still be within.  Where
// no ear is left, a corner without area is passed over; where there is none either, the search has failed.
// Source: RTCD 12.5.1; Eberly, Triangulation by ear clipping.
// Cost: n^3 at worst.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lab/trial/segment_tests.hpp"

namespace plumb::lab::trial {

using EarTriangles = std::vector<std::array<std::uint32_t, 3>>;

template <class T>
class EarClipping {
 public:
  EarClipping(const std::vector<Place<T>>& points, const T& epsilon) : points_(points), epsilon_(epsilon) {
    for (std::uint32_t i = 0; i < points.size(); ++i) ring_.push_back(i);
  }

  /// None where it is stuck.
  std::optional<EarTriangles> run() {
    EarTriangles triangles;
    while (ring_.size() > 3) {
      const std::optional<std::size_t> ear = find([this](std::size_t i) { return is_ear(i); });
      if (ear) triangles.push_back(corner(*ear));
      const auto gone = ear ? ear : find([this](std::size_t i) { return is_flat(corner(i)); });
      if (!gone) return std::nullopt;
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(*gone));
    }
    if (!is_flat(corner(0))) triangles.push_back(corner(0));
    return triangles;
  }

 private:
  [[nodiscard]] std::array<std::uint32_t, 3> corner(std::size_t i) const {
    const std::size_t n = ring_.size();
    return {ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]};
  }
  [[nodiscard]] T turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return area(points_[a], points_[b], points_[c]);
  }
  [[nodiscard]] bool is_flat(const std::array<std::uint32_t, 3>& t) const {
    const T x = turn(t[0], t[1], t[2]);
    return x <= epsilon_ && -x <= epsilon_;
  }
  [[nodiscard]] bool is_ear(std::size_t i) const {
    const auto [a, b, c] = corner(i);
    if (!(turn(a, b, c) > epsilon_)) return false;
    for (const std::uint32_t v : ring_) {
      if (is_one(v, a) || is_one(v, b) || is_one(v, c)) continue;
      if (turn(a, b, v) >= -epsilon_ && turn(b, c, v) >= -epsilon_ && turn(c, a, v) >= -epsilon_) return false;
    }
    return true;
  }
  [[nodiscard]] bool is_one(std::uint32_t v, std::uint32_t w) const {
    return points_[v].x == points_[w].x && points_[v].y == points_[w].y;
  }
  template <class Is>
  std::optional<std::size_t> find(Is is) const {
    for (std::size_t i = 0; i < ring_.size(); ++i)
      if (is(i)) return i;
    return std::nullopt;
  }

  const std::vector<Place<T>>& points_;
  const T epsilon_;
  std::vector<std::uint32_t> ring_;
};

}  // namespace plumb::lab::trial
