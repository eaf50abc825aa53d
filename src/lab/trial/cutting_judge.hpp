// What is true of triangles that a polygon was cut into?  Whether they keep its vertices, cover it, and nothing twice.
//
// Laws: in GMP's rationals; nothing of the library is asked.
// Source: RTCD 12.5.1.
// Cost: some 100 us for each question about a polygon of 16 corners.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "lab/trial/cut_polygons.hpp"
#include "lab/trial/ear_clipping.hpp"

namespace plumb::lab::trial {

/// What is true of a polygon.
class CuttingJudge {
 public:
  explicit CuttingJudge(const CutPolygon& q) {
    for (std::size_t i = 0; i < q.size(); i += 2) points_.push_back({mpq_class(q[i]), mpq_class(q[i + 1])});
  }
  /// Crosses an edge another between their ends?  Then it is no question.
  [[nodiscard]] bool crosses_itself() const {
    for (std::size_t i = 0; i < cut_corners; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Place<mpq_class>&a = points_[i], &b = points_[(i + 1) % cut_corners], &c = points_[k],
              &d = points_[(k + 1) % cut_corners];
        if (sgn(area(a, b, c)) * sgn(area(a, b, d)) < 0 && sgn(area(c, d, a)) * sgn(area(c, d, b)) < 0) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool lost(const EarTriangles& triangles) const {
    std::set<std::array<mpq_class, 2>> named;
    for (const auto& t : triangles)
      for (const std::uint32_t v : t) named.insert({points_[v].x, points_[v].y});
    return !std::ranges::all_of(points_, [&](const Place<mpq_class>& p) { return named.contains({p.x, p.y}); });
  }
  [[nodiscard]] bool other_area(const EarTriangles& triangles) const {
    mpq_class whole = 0, sum = 0;
    for (std::size_t i = 1; i + 1 < cut_corners; ++i) whole += area(points_[0], points_[i], points_[i + 1]);
    for (const auto& [a, b, c] : triangles) sum += abs(area(points_[a], points_[b], points_[c]));
    return sum != whole;
  }
  [[nodiscard]] bool flat(const EarTriangles& triangles) const {
    return std::ranges::any_of(triangles,
                               [&](const auto& t) { return area(points_[t[0]], points_[t[1]], points_[t[2]]) <= 0; });
  }
  /// Neither is beyond an edge of the other.
  [[nodiscard]] bool overlap(const EarTriangles& triangles) const {
    const auto parts = [&](const auto& s, const auto& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Place<mpq_class>&a = points_[s[k]], &b = points_[s[(k + 1) % 3]];
        if (std::ranges::all_of(t, [&](std::uint32_t v) { return area(a, b, points_[v]) <= 0; })) return true;
      }
      return false;
    };
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (!parts(triangles[i], triangles[k]) && !parts(triangles[k], triangles[i])) return true;
    return false;
  }

 private:
  std::vector<Place<mpq_class>> points_;
};

}  // namespace plumb::lab::trial
