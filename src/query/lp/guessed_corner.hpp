// A guess, in doubles: which planes make the best corner of a linear program, or contradict one another?  The dual
// simplex method, the constraint that is violated most first.
//
// Laws: none of its answers is proved, and it holds no bound; a guess is a corner's planes, or those of a
// contradiction, for someone to prove, or nothing.  It is the same on every machine.
// Source: Lemke 1954; Chvatal, Linear Programming, 1983, chapter 10; RTCD 9.4.
// Cost: some ten to twenty steps, each with a pass over the constraints: of many over one in so many first, so that few
// steps pass over all.
#pragma once

#include "query/lp/corner.hpp"

namespace plumb::query {

template <std::size_t D>
struct GuessedCorner {
  enum class Kind : unsigned char { none, corner, contradiction };
  Kind kind = Kind::none;
  std::array<std::uint32_t, D + 1> constraints{};  // D of a corner, D + 1 of a contradiction
};

template <std::size_t D, class Halfspace>
GuessedCorner<D> guess_corner(const Numbers<D>& direction, std::span<const Halfspace> constraints,
                              const Numbers<D>& most, double most_limit) {
  constexpr int most_steps = 64;
  constexpr double off = 0x1p-40;  // a guess, as all here: of what a constraint is violated by
  GuessedCorner<D> guess;
  double size = 0;
  for (const double x : most) size = std::max(size, x);
  if (!(size > 0)) return guess;
  constexpr double beyond_limits = 0x1p24;  // a guess: the box in which the search starts, as parts of the limits
  const double far = beyond_limits * (1 + most_limit / size);
  std::array<Numbers<D>, D> inverse{};  // its columns
  Numbers<D> at{}, weight{};
  for (std::size_t k = 0; k < D; ++k) {
    const double side = direction[k] > 0 ? 1 : -1;
    inverse[k][k] = side;
    at[k] = side * far;
    weight[k] = magnitude_of(direction[k]);
    guess.constraints[k] = no_constraint;
  }
  constexpr std::size_t some = 64;  // a guess: of so many constraints first
  std::size_t stride = std::max<std::size_t>(1, constraints.size() / some);
  for (int step = 0; step < most_steps; ++step) {
    double reach = most_limit;
    for (const double x : at) reach += size * magnitude_of(x);
    double worst = off * reach;
    std::size_t next = constraints.size();
    for (std::size_t i = 0; i < constraints.size(); i += stride) {
      const double v = dot_of(numbers_of(constraints[i].normal), at) - constraints[i].offset;
      if (v > worst) worst = v, next = i;
    }
    if (next == constraints.size() && stride > 1) {
      stride = std::max<std::size_t>(1, stride / 8);
      continue;
    }
    if (next == constraints.size()) {
      for (std::size_t k = 0; k < D; ++k) {
        if (guess.constraints[k] == no_constraint) return guess;
      }
      guess.kind = GuessedCorner<D>::Kind::corner;
      return guess;
    }
    Numbers<D> part{};
    std::size_t out = D;
    for (std::size_t k = 0; k < D; ++k) {
      part[k] = dot_of(numbers_of(constraints[next].normal), inverse[k]);
      if (part[k] > off * size * magnitude_of(inverse[k][0]) &&
          (out == D || weight[k] * part[out] < weight[out] * part[k]))
        out = k;
    }
    if (out == D) {
      guess.constraints[D] = static_cast<std::uint32_t>(next);
      for (std::size_t k = 0; k < D; ++k) {
        if (guess.constraints[k] == no_constraint) return guess;
      }
      guess.kind = GuessedCorner<D>::Kind::contradiction;
      return guess;
    }
    guess.constraints[out] = static_cast<std::uint32_t>(next);
    for (double& x : inverse[out]) x /= part[out];
    weight[out] /= part[out];
    for (std::size_t k = 0; k < D; ++k) {
      at[k] -= worst * inverse[out][k];
      if (k == out) continue;
      weight[k] -= part[k] * weight[out];
      for (std::size_t i = 0; i < D; ++i) inverse[k][i] -= part[k] * inverse[out][i];
    }
  }
  return guess;
}

}  // namespace plumb::query
