// Which formula decides for points of these kinds?  Formulas generated from a predicate and the kinds of its points.
//
// Mixed<Predicate, Kinds...> takes the numbers of all arguments one after the other; its value is the predicate's times
// powers of the weights.  Weight<Kind> is the weight by itself.  Both are formulas like any other (formula.hpp):
// filter, tape and bound are derived from them.
// Laws: a point without offset and weight is the pivot if there is one, else one without weight, so that for points as
// given the classic formula is what remains.  Arguments change places for that in pairs or in a circle: the sign stays.
// Source: docs/proof.md, "Weights".
// Cost: compile time; what a mix is asked, no more.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

#include "plumb/predicates/homogeneous.hpp"

namespace plumb {

/// A formula's arguments with the pivot at the end, by an even permutation.
template <class... Kinds>
inline constexpr auto pivot_last = [] {
  constexpr std::size_t n = sizeof...(Kinds);
  constexpr std::array<int, n> price{(predicates::has_weight<Kinds>       ? 2
                                      : Kinds::numbers > Kinds::dimension ? 1
                                                                          : 0)...};
  std::size_t pivot = n - 1;
  for (std::size_t i = n; i-- > 0;) pivot = price[i] < price[pivot] ? i : pivot;
  std::array<std::size_t, n> order{};
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  if (n > 2 && pivot != n - 1) {
    const std::size_t other = pivot == 0 ? 1 : 0;  // moves along, so that an even number of points change places
    order[n - 1] = pivot;
    order[pivot] = other;
    order[other] = n - 1;
  }
  return order;
}();

template <class Predicate, class... Kinds>
struct Mixed {
  static constexpr std::string_view name = Predicate::name;
  static constexpr std::array arguments{Kinds::numbers...};
  // With a parameter or a pose the terms differ in degree.  Without them they do not, but their integers would be so
  // wide that compiling a stage for each mix costs more than it saves: the last stage serves all.
  static constexpr bool homogeneous = false;

  template <class T, std::size_t N>
  constexpr auto operator()(const std::array<T, N>& p) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return Predicate{}(located<pivot_last<Kinds...>[I]>(p.data())...);
    }
    (std::make_index_sequence<sizeof...(Kinds)>{});
  }

 private:
  template <std::size_t Argument, class T>
  static constexpr auto located(const T* p) {
    constexpr std::size_t first = [] {
      std::size_t sum = 0;
      for (std::size_t i = 0; i < Argument; ++i) sum += static_cast<std::size_t>(arguments[i]);
      return sum;
    }();
    using Kind = std::tuple_element_t<Argument, std::tuple<Kinds...>>;
    return Kind::at(p + first);
  }
};

template <class Kind>
struct Weight {
  static constexpr std::string_view name = "weight";
  static constexpr std::array arguments{Kind::numbers};
  static constexpr bool homogeneous = false;
  template <class T, std::size_t N>
  constexpr auto operator()(const std::array<T, N>& p) const {
    return Kind::at(p.data()).weight;
  }
};

}  // namespace plumb
