// Which cases are asked, by which predicate, and who answers?  The driver of all batches, free of vectors.
//
// Laws: case i's coordinate k is at[k][i * stride[k]]; a stride of 0 is one point for all cases.  Cases are done in
// chunks; each is filtered by vectors and what is left goes to the exact stages.  The first bad case is the one
// reported, however many threads there are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "plumb/certify/signs_of.hpp"

namespace plumb::certify::batch {

struct Cases {
  std::array<const double*, most_coordinates> at{};
  std::array<std::size_t, most_coordinates> stride{};
};

/// Filters n cases from their first coordinates on: writes their signs, lists the numbers of those that are unsure, and
/// returns how many they are.  `given` is a Side, AskedColumns or nothing.
using Filter = std::size_t (*)(const void* given, const double* const* at, std::size_t n, signed char* out,
                               std::uint32_t* unsure);

/// What signs_of is asked.
struct AskedColumns {
  const BatchFormula* asked;
  std::span<const Column> columns;
};

struct BatchQuestion {
  std::string_view name;
  std::span<const int> arguments;
  std::size_t arity;
  Sign (*exactly)(const double* coordinates);
  std::string_view axes = "xyz";
  std::span<const std::string_view> argument_names = {};
};

template <Formula F>
inline constexpr BatchQuestion question{F::name, arguments<F>, arity<F>, asked<F>.exactly};

/// Decides all of them; out.size() is their number.
void decide_cases(const BatchQuestion& question, const Cases& cases, Filter filter, const void* given,
                  std::span<Sign> out, Execution execution);

/// Throws UnequalLengths: "orient3d: c has 7 points, but a has 8; give spans of equal length".
[[noreturn]] void throw_unequal(std::string_view formula, std::string_view name, std::size_t length,
                                std::string_view other, std::size_t other_length);

}  // namespace plumb::certify::batch
