// What was derived from my polynomial?  Its degree, its size, the error bound of its filter, the bits of its value: in
// numbers, and in words.
//
//   to_string(bound_report<predicates::Orient2d>())
//   to_string(bound_report([](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; }, x, y, z, f))
//
// Laws: all of it is read from the formula's tape, but for the constant, which is the one that the filter compares
// with; no coordinate is looked at.
// Source: docs/proof.md.
// Cost: microseconds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "plumb/certify/detail/tape.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

struct BoundReport {
  std::string_view name;
  int degree;              // of the terms of the highest degree
  bool homogeneous;        // all terms have that degree
  std::size_t operations;  // + - *
  double terms;            // products of differences, or of coordinates, that the formula adds up
  double constant;         // the error is less than this times the sum of the terms' magnitudes
  int value_bits;          // the exact value is below 2^this when coordinates are integers below 2^53
};

/// Throws Error from 2^32 terms on.
BoundReport bound_report(std::string_view name, const certify::tape::Program& program, double constant);

template <Formula F>
BoundReport bound_report() {
  return bound_report(F::name, certify::tape::program<F>(), filter_constant<F>());
}

/// Of the formula that sign_of takes this polynomial for, given arguments of these types.
template <class Polynomial, class... Arguments>
BoundReport bound_report(Polynomial, const Arguments&...) {
  static_assert(accepts<Polynomial, Arguments...>());
  using F = typename FormulaOf<Polynomial, Arguments...>::Type;
  static_assert(is_polynomial<F>());
  return bound_report<F>();
}

/// Three lines: degree and size; the constant in units of 2^-53, rounded up, and as it is; the bits of the value.
std::string to_string(const BoundReport& report);

}  // namespace plumb
