// Pairs of straight shapes that make code fail: from points of every family, parallel, collinear, sharing corners.
//
// Laws: a case is made of its entropy alone; about a third are exactly parallel, collinear or coplanar, some are
// points.
#pragma once

#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "plumb/certify/sign_of.hpp"
#include "plumb/degenerate/moves.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/query/closest/pairs.hpp"

namespace plumb {

#ifdef PLUMB_LONG_TESTS
inline constexpr std::uint64_t straight_case_count = 20'000;
#else
inline constexpr std::uint64_t straight_case_count = 300;
#endif

/// How often each answer was seen.
class Tally {
 public:
  void add(const std::string& answer) { ++counts_[answer]; }
  [[nodiscard]] int count(const std::string& answer) const {
    const auto found = counts_.find(answer);
    return found == counts_.end() ? 0 : found->second;
  }

 private:
  std::map<std::string, int> counts_;
};

namespace straight {

/// The numbers that make up a pair: two points or a point and a direction each, or three points.
template <class S>
constexpr std::size_t points_of = requires(S s) {
  s.c;
}
? 3 : 2;

template <class S, class P, class V>
S shape_of(const std::vector<P>& p, std::size_t from) {
  const auto direction = [&] {
    V v{};
    if constexpr (requires { v.z; }) {
      v = {p[from + 1].x, p[from + 1].y, p[from + 1].z};
    } else {
      v = {p[from + 1].x, p[from + 1].y};
    }
    return v;
  };
  if constexpr (requires(S s) { s.direction; }) {
    return {p[from], direction()};
  } else if constexpr (points_of<S> == 3) {
    return {p[from], p[from + 1], p[from + 2]};
  } else {
    return {p[from], p[from + 1]};
  }
}

/// Small integers, shared often: parallel, collinear, touching, equal.
inline double small(Entropy& entropy) { return static_cast<double>(entropy.within(3)); }

template <class S>
inline constexpr bool directed = requires(S s) {
  s.direction;
};

}  // namespace straight

template <class A, class B>
std::pair<A, B> straight_case(Entropy& entropy) {
  using namespace straight;
  constexpr bool space = query::is_in_space<A>;
  constexpr std::size_t dimension = space ? 3 : 2, count = points_of<A> + points_of<B>, n = count * dimension;
  using P = std::conditional_t<space, Point3, Point2>;
  using V = std::conditional_t<space, Vector3, Vector2>;
  std::array<double, n> x{};
  const std::uint64_t kind = entropy.below(6);
  if (kind < 3) {
    fill_points(any_family(entropy), degeneracies[entropy.below(degeneracies.size())], static_cast<int>(dimension), x,
                entropy);
  } else {
    for (double& c : x) c = small(entropy);
  }
  // The second point or direction of b from that of a: parallel, exactly where the numbers are short.
  constexpr std::size_t b = points_of<A> * dimension;
  if (kind == 4) {
    const double factor = static_cast<double>(entropy.within(2)) * (entropy.coin() ? 1 : 0.5);
    for (std::size_t i = 0; i < dimension; ++i) {
      const double along = directed<A> ? x[dimension + i] : x[dimension + i] - x[i];
      x[b + dimension + i] = factor * along + (directed<B> ? 0 : x[b + i]);
    }
  }
  // On the line of a, besides.
  if (kind == 5) {
    const double at = small(entropy), factor = small(entropy);
    for (std::size_t i = 0; i < dimension; ++i) {
      const double along = directed<A> ? x[dimension + i] : x[dimension + i] - x[i];
      x[b + i] = x[i] + at * along;
      x[b + dimension + i] = factor * along + (directed<B> ? 0 : x[b + i]);
    }
  }
  if (entropy.below(8) == 0) repeat_points(x, static_cast<int>(dimension), entropy);
  if (entropy.below(16) == 0) move_by_ulps(x, 2, 3, entropy);
  if (entropy.below(16) == 0) scale_exactly(x, entropy);
  std::vector<P> p(count);
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (space) {
      p[i] = {x[3 * i], x[3 * i + 1], x[3 * i + 2]};
    } else {
      p[i] = {x[2 * i], x[2 * i + 1]};
    }
  }
  return {shape_of<A, P, V>(p, 0), shape_of<B, P, V>(p, points_of<A>)};
}

/// In hexadecimal, to be read again.
template <class S>
std::string shape_text(const S& s) {
  std::string text;
  const auto add = [&](const auto& part) {
    for (const double x : coordinates(part)) {
      std::array<char, 40> buffer{};
      std::snprintf(buffer.data(), buffer.size(), " %a", x);
      text.append(buffer.data());
    }
  };
  if constexpr (requires { s.point; }) {
    add(s.point), add(s.direction);
  } else if constexpr (requires { s.direction; }) {
    add(s.origin), add(s.direction);
  } else {
    add(s.a), add(s.b);
    if constexpr (requires { s.c; }) add(s.c);
  }
  return text;
}

}  // namespace plumb
