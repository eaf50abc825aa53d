// Cases on a lattice: coordinates that are integers of so many bits times a power of two, of every kind that is hard.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "certify/case_line.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/kernel.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::lattice_cases {

/// Coordinates by themselves, sums and products of them beside differences.
struct Mixed {
  static constexpr std::string_view name = "mixed";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return (p[0] + p[1]) * (p[2] + p[3]) * p[0] - p[0] * p[2] * p[3] - p[1] * (p[2] - p[3]) * p[0];
  }
};

/// On which side of a plane through the origin: arguments of different kinds.
struct PlaneSide {
  static constexpr std::string_view name = "plane_side";
  static constexpr std::array arguments{3, 3, 1, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return p[0] * p[3] + p[1] * p[4] + p[2] * p[5] - p[6] * p[7];
  }
};

/// Terms of unequal degree.
struct Paraboloid {
  static constexpr std::string_view name = "paraboloid";
  static constexpr std::array arguments{3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    return p[2] - p[0] * p[0] - p[1] * p[1];
  }
};

/// Of a degree whose values at 62 bits leave the doubles.
struct Power20 {
  static constexpr std::string_view name = "power20";
  static constexpr int points = 3, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    const auto a = p[0] - p[2], b = p[1] - p[2];
    const auto fifth = [](const auto& x) { return x * x * x * x * x; };
    return fifth(a) * fifth(a) * fifth(a) * fifth(b) - fifth(b) * fifth(b) * fifth(b) * fifth(a);
  }
};

/// One difference.
struct Order {
  static constexpr std::string_view name = "order";
  static constexpr int points = 2, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 2>& p) const {
    return p[0] - p[1];
  }
};

/// A multiple of 2^exponent below 2^(exponent + bits) in magnitude, nearest to where x lies within (-1, 1).
inline double snapped(double x, const Lattice& lattice) {
  const double most = std::ldexp(1.0, std::min(lattice.bits, 53)) - 1;
  const double m = std::clamp(std::round(x * most), -most, most);
  return std::ldexp(m, lattice.exponent + std::max(0, lattice.bits - 53));
}

/// An integer of the lattice: the extremes and their neighbors, small ones, long and short ones at any place.
inline double any_coordinate(Entropy& e, const Lattice& lattice) {
  const int width = std::min(lattice.bits, 53);
  const double most = std::ldexp(1.0, width) - 1;
  double m = 0;
  int shift = lattice.bits - width;
  switch (e.below(4)) {
    case 0:
      m = most - static_cast<double>(e.below(3));
      break;
    case 1:
      m = static_cast<double>(e.below(4));
      shift = 0;
      break;
    default:
      m = static_cast<double>(e.bits(width));
      shift = static_cast<int>(e.below(static_cast<std::uint64_t>(shift) + 1));
      break;
  }
  m = std::clamp(m, 0.0, most);
  return std::ldexp(e.coin() ? m : -m, lattice.exponent + shift);
}

/// Case i: in turn the families snapped to the lattice, exactly degenerate sets, equal coordinates, and extremes.
template <Formula F>
Coordinates<F> coordinates_on(const Lattice& lattice, std::uint64_t i) {
  Entropy e(2026, i);
  Coordinates<F> p{};
  const auto degeneracy = degeneracies[e.below(degeneracies.size())];
  constexpr int dimension = arity<F> % 3 == 0 ? 3 : 2;
  const int exact_bits = std::min(lattice.bits, 53);
  if (i % 3 == 0 && arity<F> % dimension == 0) {
    fill_points(any_family(e), degeneracy, dimension, p, e);
    double largest = 0;
    for (const double x : p) largest = std::max(largest, std::fabs(x));
    const int scale = largest == 0 ? 0 : std::ilogb(largest) + 1;
    for (double& x : p) x = snapped(std::ldexp(x, -scale), lattice);
  } else if (i % 3 == 1 && arity<F> % dimension == 0 && exact_bits >= least_exact_bits) {
    const bool flat_in_plane = dimension == 2 && degeneracy == Degeneracy::coplanar;
    fill_exact(flat_in_plane ? Degeneracy::collinear : degeneracy, dimension, exact_bits, p, e);
    const int shift = static_cast<int>(e.below(static_cast<std::uint64_t>(lattice.bits - exact_bits) + 1));
    for (double& x : p) x = std::ldexp(x, lattice.exponent + shift);
    if (e.coin()) p[e.below(p.size())] = any_coordinate(e, lattice);
  } else {
    for (double& x : p) x = any_coordinate(e, lattice);
    if (e.coin()) p[e.below(p.size())] = p[e.below(p.size())];
  }
  return p;
}

template <Formula F, std::size_t Argument>
constexpr std::size_t first_coordinate = [] {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < Argument; ++i) sum += static_cast<std::size_t>(arguments<F>[i]);
  return sum;
}();

template <Formula F, std::size_t Argument>
auto argument(const Coordinates<F>& p) {
  std::array<double, static_cast<std::size_t>(arguments<F>[Argument])> x{};
  std::copy_n(p.begin() + first_coordinate<F, Argument>, x.size(), x.begin());
  return x;
}

/// The sign by points that were taken in.
template <Formula F>
Sign sign_of_points(const Kernel& kernel, const Coordinates<F>& p) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return kernel.sign<F>(kernel.point(argument<F, I>(p))...); }
  (std::make_index_sequence<arguments<F>.size()>{});
}

/// The same, with the arithmetic chosen beforehand.
template <Formula F>
Sign sign_with(const Kernel& kernel, const Coordinates<F>& p) {
  return kernel.with<F>([&]<class Planned>(const Planned& sign) {
    EXPECT_EQ(Planned::arithmetic, plan(kernel.lattice()).template arithmetic<F>());
    return [&]<std::size_t... I>(std::index_sequence<I...>) { return sign(kernel.point(argument<F, I>(p))...); }
    (std::make_index_sequence<arguments<F>.size()>{});
  });
}

/// The sign by coordinates as given, one argument after the other.
template <Formula F>
Sign sign_as_given(const Kernel& kernel, const Coordinates<F>& p) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) { return kernel.sign<F>(argument<F, I>(p)...); }
  (std::make_index_sequence<arguments<F>.size()>{});
}

/// A line that says all: the lattice and the case line.
template <Formula F>
std::string described(const Lattice& lattice, const Coordinates<F>& p) {
  std::ostringstream s;
  s << "lattice 2^" << lattice.exponent << ", " << lattice.bits
    << " bits: " << to_string(CaseLine{std::string(F::name), {p.begin(), p.end()}, Unsure{decide<F>(p)}});
  return s.str();
}

}  // namespace plumb::lattice_cases
