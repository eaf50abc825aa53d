// The ball through some points in GMP rationals, written from its definition and independent of the library's formulas:
// the center is a combination of the points with weights that sum to one, equally far from all of them.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "plumb/certify/sign_of.hpp"

namespace plumb_test {

using Rationals = std::vector<mpq_class>;

template <class Point>
Rationals rationals(const Point& p) {
  Rationals all;
  for (const double x : plumb::coordinates(p)) all.emplace_back(x);
  return all;
}

inline mpq_class squared_distance(const Rationals& a, const Rationals& b) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

struct RationalBall {
  Rationals center, weights;
  mpq_class square;

  [[nodiscard]] bool holds(const Rationals& p) const { return squared_distance(center, p) <= square; }
  [[nodiscard]] bool is_optimal() const {
    for (const mpq_class& w : weights) {
      if (w <= 0) return false;
    }
    return true;
  }
};

/// Nothing for points that are not affinely independent.
inline std::optional<RationalBall> ball_through(std::span<const Rationals> points) {
  const std::size_t n = points.size() - 1, axes = points[0].size();
  // 2 sum_j (e_i . e_j) w_j = e_i . e_i for the edges e_i from the first point.
  std::vector<Rationals> rows(n, Rationals(n + 1));
  const auto dot = [&](std::size_t i, std::size_t j) {
    mpq_class sum = 0;
    for (std::size_t a = 0; a < axes; ++a) sum += (points[i][a] - points[0][a]) * (points[j][a] - points[0][a]);
    return sum;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = 2 * dot(i + 1, j + 1);
    rows[i][n] = dot(i + 1, i + 1);
  }
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpq_class factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  RationalBall ball{points[0], Rationals(n + 1), 0};
  ball.weights[0] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    ball.weights[i + 1] = rows[i][n] / rows[i][i];
    ball.weights[0] -= ball.weights[i + 1];
    for (std::size_t a = 0; a < axes; ++a) ball.center[a] += ball.weights[i + 1] * (points[i + 1][a] - points[0][a]);
  }
  ball.square = squared_distance(ball.center, points[0]);
  return ball;
}

/// The smallest ball of the points, by all choices of a support.
inline RationalBall smallest_ball(std::span<const Rationals> points) {
  const std::size_t most = points[0].size() + 1;
  std::optional<RationalBall> best;
  std::vector<Rationals> chosen;
  const auto extend = [&](const auto& self, std::size_t next) -> void {
    if (!chosen.empty()) {
      const auto ball = ball_through(chosen);
      if (!ball) return;
      bool all = !best || ball->square < best->square;
      for (std::size_t i = 0; i < points.size() && all; ++i) all = ball->holds(points[i]);
      if (all) best = ball;
    }
    if (chosen.size() == most) return;
    for (std::size_t i = next; i < points.size(); ++i) {
      chosen.push_back(points[i]);
      self(self, i + 1);
      chosen.pop_back();
    }
  };
  extend(extend, 0);
  return *best;
}

/// Whether x is the double nearest to the number: no neighbor is nearer.
inline bool is_nearest(double x, const mpq_class& number) {
  const mpq_class error = abs(mpq_class(x) - number);
  for (const double way : {-HUGE_VAL, HUGE_VAL}) {
    const double neighbor = std::nextafter(x, way);
    if (std::isfinite(neighbor) && abs(mpq_class(neighbor) - number) < error) return false;
  }
  return true;
}

/// Whether every point is within the radius of the center, exactly.
template <class Point>
bool encloses(const Point& center, double radius, std::span<const Point> points) {
  const Rationals c = rationals(center);
  const mpq_class r(radius), square = r * r;
  for (const Point& p : points) {
    if (squared_distance(c, rationals(p)) > square) return false;
  }
  return true;
}

}  // namespace plumb_test
