// What of C++20's library the one of emscripten 3.1.6 (LLVM's, version 13) lacks and the signs use.  Included by the
// compiler's option before all else there, and nowhere else.
//
// Laws: as the standard says, for the arguments that occur.
// Source: ISO C++ 2020, [bit.cast], [alg.nonmodifying], [alg.copy], [alg.sort].
// Cost: none.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <version>

#ifndef __cpp_lib_bit_cast
namespace std {  // NOLINT: where it is missing
template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) constexpr To
    bit_cast(const From& x) noexcept {
  return __builtin_bit_cast(To, x);
}
}  // namespace std
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
namespace std::ranges {  // NOLINT
template <class Out>
struct WhereCopied {
  Out out;
};
template <class Range, class Out>
constexpr WhereCopied<Out> copy(Range&& from, Out to) {
  return {std::copy(std::begin(from), std::end(from), to)};
}
template <class Range, class Test>
constexpr bool all_of(Range&& of, Test test) {
  return std::all_of(std::begin(of), std::end(of), test);
}
template <class Range, class Value, class Part = identity>
constexpr auto find(Range&& in, const Value& value, Part part = {}) {
  return std::find_if(std::begin(in), std::end(in), [&](const auto& x) { return std::invoke(part, x) == value; });
}
template <class Range, class Value>
constexpr auto count(Range&& in, const Value& value) {
  return std::count(std::begin(in), std::end(in), value);
}
template <class One, class Other>
constexpr bool equal(One&& a, Other&& b) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b));
}
template <class Range, class Less = std::less<>, class Part = identity>
constexpr auto max_element(Range&& of, Less less_than = {}, Part part = {}) {
  return std::max_element(std::begin(of), std::end(of), [&](const auto& a, const auto& b) {
    return std::invoke(less_than, std::invoke(part, a), std::invoke(part, b));
  });
}
template <class Range, class Less = std::less<>, class Part = identity>
constexpr void sort(Range&& all, Less less_than = {}, Part part = {}) {
  std::sort(std::begin(all), std::end(all), [&](const auto& a, const auto& b) {
    return std::invoke(less_than, std::invoke(part, a), std::invoke(part, b));
  });
}
}  // namespace std::ranges
#endif
