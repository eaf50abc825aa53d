// How is the smallest ball of points commonly found in floating point?  By Welzl's recursion, and by pivots: as long as
// a point lies outside, the farthest one joins those that hold the ball.
//
// Laws: none; they are on trial, and decide nothing of ours.  An epsilon is by how much the square of a distance may
// exceed the square of the radius.  Pivots may go round in a circle: their steps are bounded.
// Source: RTCD 4.3.5; Welzl 1991; Gaertner 1999.
// Cost: linear, with tens of operations a point.
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "lab/trial/vec.hpp"

namespace plumb::lab::trial {

template <class T>
struct BallInNumbers {
  Vec<T> center{};
  T square = -1;      // of the radius; negative: holds nothing
  bool ended = true;  // the search
};

/// The ball through one to four points whose center lies in their hull's plane; false where they span less.
template <class T>
bool through(std::span<const Vec<T>> p, Vec<T>& center, T& square) {
  center = p[0];
  if (p.size() == 2) {
    center = (p[0] + p[1]) * T(T(1) / T(2));
  } else if (p.size() == 3) {
    const Vec<T> u = p[1] - p[0], v = p[2] - p[0], n = cross(u, v);
    const T whole = 2 * dot(n, n);
    if (whole == 0) return false;
    center = p[0] + (cross(n, u) * dot(v, v) + cross(v, n) * dot(u, u)) * T(1 / whole);
  } else if (p.size() == 4) {
    const Vec<T> u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
    const T whole = 2 * dot(u, cross(v, w));
    if (whole == 0) return false;
    center = p[0] + (cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w)) * T(1 / whole);
  }
  const Vec<T> r = p[0] - center;
  square = dot(r, r);
  return true;
}

template <class T>
T square_to(const Vec<T>& p, const Vec<T>& center) {
  const Vec<T> d = p - center;
  return dot(d, d);
}

/// The smallest ball of the points on whose rim `held` lie.
template <class T>
BallInNumbers<T> welzl(std::span<const Vec<T>> points, std::vector<Vec<T>>& held, const T& epsilon) {
  BallInNumbers<T> ball;
  if (points.empty() || held.size() == 4) {
    for (std::size_t n = held.size(); n > 0; --n) {  // of points that span less, as many as can be
      if (through<T>(std::span<const Vec<T>>(held).first(n), ball.center, ball.square)) return ball;
    }
    return ball;
  }
  const Vec<T> last = points.back();
  ball = welzl(points.first(points.size() - 1), held, epsilon);
  if (square_to(last, ball.center) <= ball.square + epsilon && !(ball.square < 0)) return ball;
  held.push_back(last);
  ball = welzl(points.first(points.size() - 1), held, epsilon);
  held.pop_back();
  return ball;
}

/// The farthest point joins those that hold the ball, the others of which are chosen anew, until none is outside.
template <class T>
BallInNumbers<T> pivoted(std::span<const Vec<T>> points, const T& epsilon, int most_steps) {
  std::vector<Vec<T>> held{points[0]};
  BallInNumbers<T> ball{points[0], T(0), true};
  for (int step = 0; step < most_steps; ++step) {
    Vec<T> farthest = points[0];
    T most = 0;
    for (const Vec<T>& p : points) {
      const T square = square_to(p, ball.center);
      if (square > most) most = square, farthest = p;
    }
    if (!(most > ball.square + epsilon)) return ball;
    held.push_back(farthest);
    ball.square = -1;
    std::vector<Vec<T>> chosen;
    for (unsigned set = 1; set < 1U << held.size(); ++set) {
      const auto in_set = [set](std::size_t i) { return (set >> i & 1U) != 0; };
      std::vector<Vec<T>> some;
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (in_set(i)) some.push_back(held[i]);
      }
      Vec<T> center{};
      T square{};
      if (some.size() > 4 || !through<T>(some, center, square)) continue;
      bool holds = ball.square < 0 || square < ball.square;
      for (std::size_t i = 0; i < held.size() && holds; ++i)
        holds = in_set(i) || square_to(held[i], center) <= square + epsilon;
      if (holds) ball.center = center, ball.square = square, chosen = std::move(some);
    }
    if (chosen.empty()) break;
    held = std::move(chosen);
  }
  ball.ended = false;
  return ball;
}

}  // namespace plumb::lab::trial
