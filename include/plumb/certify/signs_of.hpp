// What are the signs of my polynomial for many cases at once?
//
//   signs_of(predicates::Orient2d{}, a, b, c, signs)                   // a, b, c: spans of points
//   signs_of([](auto x, auto y, auto r) { return r * r - x * x - y * y; }, points, 2.5, signs, Execution::parallel)
//
// The polynomial is one that sign_of takes for a single case.  Each argument is a contiguous range (a vector, a span)
// of points, vectors, numbers or std::array<double, N>, a view of coordinates that have arrays of their own, or one
// such thing for all cases; then the range of signs that is written, and if need be on how many threads.
//
// Laws: those of certify/batch.hpp.
// (1) out[i] is the sign of case i, the one that sign_of gives for it alone.
// (2) Unequal lengths throw UnequalLengths before anything is written.
// (3) A NaN or an infinity throws NonFinite, which names the first such item.
// (4) `out` must not overlap the coordinates.  There are up to 64 coordinates a case.
//
// Filter A runs over the vectors of the processor at hand, with its derived constant; what that leaves goes to the
// exact stages.  Both are compiled where they are asked, the filter for each width of vectors (certify/detail/block_filter.hpp).
// Source: RTCD 13.7; docs/batches.md.
// Cost: a fraction of that of sign_of in a loop; threads share the work.  In the library plumb::batch.
#pragma once

#include <span>
#include <tuple>

#include "plumb/certify/batch.hpp"
#include "plumb/certify/detail/block_filter.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

namespace certify::batch {

inline constexpr std::size_t most_coordinates = 64;

/// A coordinate of all cases: that of case i is at[i * stride].
struct Column {
  const double* at;
  std::size_t stride;  // 0: the same for all cases
  std::size_t length;  // how many cases there are of it, but where the stride is 0
  bool apart;          // in an array of its own, not beside the other coordinates of its argument
};

/// What the library is told of a formula; its stages are compiled by who asks.
struct BatchFormula {
  std::string_view name;
  std::span<const int> arguments;
  std::string_view axes;
  std::span<const std::string_view> argument_names;
  BlockFilters filters;
  Sign (*exactly)(const double* coordinates);
};

template <Formula F>
inline constexpr BatchFormula asked{
    F::name, arguments<F>, axes<F>, argument_names<F>, block_filters<F>(), [](const double* coordinates) {
      Coordinates<F> p;
      for (std::size_t k = 0; k < p.size(); ++k) p[k] = coordinates[k];
      return decide_exactly<F>(p).sign;
    }};

/// The signs of all cases, one column for each coordinate.
void decide_all(const BatchFormula& asked, std::span<const Column> columns, std::span<Sign> out, Execution execution);

/// A coordinate after the other in memory.
template <class T>
inline constexpr bool is_plain = false;
template <>
inline constexpr bool is_plain<double> = true;
template <>
inline constexpr bool is_plain<Point2> = true;
template <>
inline constexpr bool is_plain<Point3> = true;
template <>
inline constexpr bool is_plain<Vector2> = true;
template <>
inline constexpr bool is_plain<Vector3> = true;
template <std::size_t N>
inline constexpr bool is_plain<std::array<double, N>> = true;

/// What an argument gives to each case: itself, an item of the range, a point of the view; void where it gives nothing.
template <class Argument>
constexpr auto item_of() {
  if constexpr (HasCoordinates<Argument>) {
    return std::type_identity<std::conditional_t<is_plain<Argument>, Argument, void>>{};
  } else if constexpr (std::is_same_v<Argument, Points2View>) {
    return std::type_identity<Point2>{};
  } else if constexpr (std::is_same_v<Argument, Points3View>) {
    return std::type_identity<Point3>{};
  } else if constexpr (requires(const Argument& range) { std::span(range); }) {
    return std::type_identity<typename decltype(std::span(std::declval<const Argument&>()))::value_type>{};
  } else {
    return std::type_identity<void>{};
  }
}
template <class Argument>
using ItemOf = typename decltype(item_of<std::remove_cvref_t<Argument>>())::type;

template <class Argument>
Column* columns_of(const Argument& argument, Column* to) {
  if constexpr (requires { argument.x.data(); }) {
    *to++ = {argument.x.data(), 1, argument.x.size(), true};
    *to++ = {argument.y.data(), 1, argument.y.size(), true};
    if constexpr (requires { argument.z; }) *to++ = {argument.z.data(), 1, argument.z.size(), true};
  } else {
    constexpr std::size_t count = sizeof(ItemOf<Argument>) / sizeof(double);
    const bool repeated = HasCoordinates<Argument>;
    const double* first = nullptr;
    std::size_t length = 0;
    if constexpr (HasCoordinates<Argument>) {
      first = reinterpret_cast<const double*>(&argument);
    } else {
      const std::span items(argument);
      first = reinterpret_cast<const double*>(items.data());
      length = items.size();
    }
    for (std::size_t k = 0; k < count; ++k) *to++ = {first + k, repeated ? 0 : count, length, false};
  }
  return to;
}

/// How the arguments of a call are made up: ranges or single things, the signs to write, perhaps an Execution.
template <class... Arguments>
struct Call {
  static constexpr std::size_t count = sizeof...(Arguments);
  template <std::size_t I>
  using At = std::remove_cvref_t<std::tuple_element_t<I, std::tuple<Arguments..., void*, void*>>>;

  static constexpr bool threads = std::is_same_v<At<count == 0 ? 0 : count - 1>, Execution>;
  static constexpr std::size_t before_out = count < (threads ? 3 : 2) ? 0 : count - (threads ? 2 : 1);
  static constexpr bool has_out =
      before_out > 0 &&
      std::is_convertible_v<std::tuple_element_t<before_out, std::tuple<Arguments..., void*>>, std::span<Sign>>;
  template <std::size_t... I>
  static constexpr auto items(std::index_sequence<I...>) {
    return std::type_identity<std::tuple<ItemOf<At<I>>...>>{};
  }
  using Items = decltype(items(std::make_index_sequence<before_out>{}));  // of the arguments

  template <class... Item>
  static constexpr bool plain(std::type_identity<std::tuple<Item...>>) {
    return (is_plain<Item> && ...);
  }
  static constexpr bool are_plain = plain(Items{});

  template <class Polynomial, class... Item>
  static auto formula(std::type_identity<std::tuple<Item...>>)
      -> std::type_identity<typename FormulaOf<Polynomial, Item...>::Type>;
};

template <class F, class Given, std::size_t... I>
void ask(std::index_sequence<I...>, const Given& given, std::span<Sign> out, Execution execution) {
  if constexpr (!std::is_same_v<F, NoFormula>) {
    std::array<Column, arity<F>> columns;
    Column* next = columns.data();
    ((next = columns_of(std::get<I>(given), next)), ...);
    decide_all(asked<F>, columns, out, execution);
  }
}

}  // namespace certify::batch

/// The signs for many cases: the arguments, the signs to write, and perhaps an Execution.
template <class Polynomial, class... Arguments>
void signs_of(Polynomial, Arguments&&... arguments) {
  using Call = certify::batch::Call<Arguments&&...>;
  static_assert(Call::has_out,
                "plumb: signs_of takes after the arguments a span of Sign to write to, and last perhaps an Execution");
  static_assert(
      !Call::has_out || Call::are_plain,
      "plumb: signs_of takes ranges and views of points, vectors, doubles and std::array<double, N>, or one of "
      "these for all cases");
  if constexpr (Call::has_out && Call::are_plain) {
    static_assert(accepts<Polynomial>(typename Call::Items{}));
    using F = typename decltype(Call::template formula<Polynomial>(typename Call::Items{}))::type;
    static_assert(is_polynomial<F>());
    static_assert(use_all_coordinates<F>());
    static_assert(arity<F> <= certify::batch::most_coordinates, "plumb: signs_of takes up to 64 coordinates a case");
    const auto given = std::forward_as_tuple(arguments...);
    Execution execution = Execution::serial;
    if constexpr (Call::threads) execution = std::get<Call::count - 1>(given);
    certify::batch::ask<F>(std::make_index_sequence<Call::before_out>{}, given, std::get<Call::before_out>(given),
                           execution);
  }
}

}  // namespace plumb
