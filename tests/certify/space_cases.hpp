// Which points and vectors in space must every function on them get right?  Case after case, with the truth at hand.
//
// Laws: case number i of a family is the same on every machine; a failure is told by the coordinates in hexadecimal.
// Small grids come first: with coordinates of a few units zeros of every kind are frequent.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certify/case_line.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::space_cases {

#if defined(PLUMB_LONG_TESTS)
inline constexpr std::uint64_t more = 100;
#else
inline constexpr std::uint64_t more = 1;
#endif

/// The sign of the formula in rationals.
template <Formula F>
Sign in_rationals(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).sign();
}

inline Vector3 vector(const Point3& p) { return {p.x, p.y, p.z}; }
inline std::array<double, 3> numbers(const Point3& p) { return {p.x, p.y, p.z}; }

/// The coordinates of points and vectors, one after another.
template <Formula F, class... Triples>
Coordinates<F> gathered(const Triples&... triples) {
  Coordinates<F> all{};
  std::size_t i = 0;
  const auto add = [&](const auto& t) {
    for (const double x : {t.x, t.y, t.z}) all.at(i++) = x;
  };
  (add(triples), ...);
  return all;
}

inline std::string shown(std::span<const Point3> points) {
  std::string text;
  for (const Point3& p : points) {
    for (const double x : numbers(p)) text.append(" ").append(hexadecimal(x));
  }
  return text;
}

/// Points with integer coordinates of magnitude up to `most`.
inline std::vector<Point3> grid_points(std::size_t count, std::int64_t most, Entropy& entropy) {
  const auto coordinate = [&] { return static_cast<double>(entropy.within(most)); };
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {coordinate(), coordinate(), coordinate()};
  return points;
}

/// Calls check(points) for `cases` grids (fitting() of them) of magnitude up to 1, 2 and 4, in turn.
template <class Check>
void on_grids(std::size_t count, std::uint64_t cases, Check check) {
  for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(cases * more); ++i) {
    Entropy entropy(31, i);
    check(grid_points(count, std::int64_t{1} << i % 3, entropy));
  }
}

/// Calls check(points) for `cases` cases (fitting() of them) of every family, with every degeneracy in turn.
template <class Check>
void on_families(std::size_t count, std::uint64_t cases, Check check) {
  for (const FamilyInfo& info : families) {
    for (std::uint64_t i = 0; i < battery::fitting<std::uint64_t>(cases * more); ++i) {
      Entropy entropy(32, i);
      check(points3(info.family, degeneracies[i % degeneracies.size()], count, entropy));
    }
  }
}

/// How often each sign came up.
struct Shares {
  std::array<std::uint64_t, 3> count{};

  Sign operator()(Sign s) {
    ++count[static_cast<std::size_t>(static_cast<int>(s) + 1)];
    return s;
  }
  [[nodiscard]] double of(Sign s) const {
    return static_cast<double>(count[static_cast<std::size_t>(static_cast<int>(s) + 1)]) /
           static_cast<double>(count[0] + count[1] + count[2]);
  }
  [[nodiscard]] double least() const { return std::min({of(Sign::negative), of(Sign::zero), of(Sign::positive)}); }
};

}  // namespace plumb::space_cases
