// Which coordinates does a formula multiply with which, and how often?  A number that remembers, when compiled.
//
// Laws: no term of the expanded polynomial has a higher power of coordinate i than degree[i], and none holds both i and
// another coordinate k unless k is in beside[i].  Terms that cancel are counted all the same: these are upper bounds.
// Cost: none at run time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Of a formula of N coordinates, 64 at the most.
template <std::size_t N>
struct Occurrence {
  static_assert(N <= 64);

  std::array<std::uint8_t, N> degree{};
  std::array<std::uint64_t, N> beside{};  // bit k: coordinate k

  static constexpr Occurrence coordinate(std::size_t i) {
    Occurrence r;
    r.degree[i] = 1;
    return r;
  }

  friend constexpr Occurrence operator+(const Occurrence& a, const Occurrence& b) {
    Occurrence r;
    for (std::size_t i = 0; i < N; ++i) {
      r.degree[i] = a.degree[i] > b.degree[i] ? a.degree[i] : b.degree[i];
      r.beside[i] = a.beside[i] | b.beside[i];
    }
    return r;
  }
  friend constexpr Occurrence operator-(const Occurrence& a, const Occurrence& b) { return a + b; }
  friend constexpr Occurrence operator*(const Occurrence& a, const Occurrence& b) {
    Occurrence r = a + b;
    const std::uint64_t in_a = a.coordinates(), in_b = b.coordinates();
    for (std::size_t i = 0; i < N; ++i) {
      const unsigned sum = unsigned{a.degree[i]} + b.degree[i];
      r.degree[i] = static_cast<std::uint8_t>(sum < 255 ? sum : 255);
      if (a.degree[i] != 0) r.beside[i] |= in_b;
      if (b.degree[i] != 0) r.beside[i] |= in_a;
      r.beside[i] &= ~(std::uint64_t{1} << i);
    }
    return r;
  }

 private:
  [[nodiscard]] constexpr std::uint64_t coordinates() const {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < N; ++i) mask |= std::uint64_t{degree[i] != 0} << i;
    return mask;
  }
};

}  // namespace plumb
