#include "degenerate/own_call.hpp"

#include <algorithm>
#include <tuple>
#include <typeinfo>

#include "plumb/arith/error.hpp"

namespace plumb::degenerate {

namespace {

template <bool counted>
auto handed(const Passed& passed) {
  if constexpr (counted) {
    return std::tuple(passed.numbers, passed.count);
  } else {
    return std::tuple(passed.numbers);
  }
}

// Bit i of the mask: a count follows argument i.
template <class R, unsigned mask, std::size_t... i>
auto all_of(std::span<const Passed> passed, std::index_sequence<i...>) {
  return std::tuple_cat(handed<(mask >> i & 1U) != 0>(passed[i])...);
}

template <class R, unsigned mask, std::size_t arguments>
Answer call_with(ForeignFunction function, std::span<const Passed> passed) {
  return std::apply(
      [function](auto... given) -> Answer {
        const R answer = reinterpret_cast<R (*)(decltype(given)...)>(function)(given...);
        return std::is_same_v<R, int> ? (answer != 0 ? 1.0 : 0.0) : static_cast<double>(answer);
      },
      all_of<R, mask>(passed, std::make_index_sequence<arguments>()));
}

template <class R, class... A>
std::type_index type_of(const std::tuple<A...>*) {
  return typeid(R(A...));
}

template <class R, unsigned mask, std::size_t arguments>
OwnCall made() {
  using All = decltype(all_of<R, mask>({}, std::make_index_sequence<arguments>()));
  return {call_with<R, mask, arguments>, type_of<R>(static_cast<const All*>(nullptr))};
}

using Make = OwnCall (*)();

template <class R, std::size_t... less_one>
Make plain(std::size_t arguments, std::index_sequence<less_one...>) {
  constexpr std::array<Make, sizeof...(less_one)> all = {made<R, 0, less_one + 1>...};
  return all[arguments - 1];
}

template <class R, std::size_t arguments, std::size_t... mask>
Make masked(std::size_t wanted, std::index_sequence<mask...>) {
  constexpr std::array<Make, sizeof...(mask)> all = {made<R, mask, arguments>...};
  return all[wanted];
}

template <class R, std::size_t... less_one>
Make with_counts(std::size_t arguments, std::size_t mask, std::index_sequence<less_one...>) {
  Make found = nullptr;
  ((arguments == less_one + 1
        ? void(found = masked<R, less_one + 1>(mask, std::make_index_sequence<(1U << (less_one + 1))>()))
        : void()),
   ...);
  return found;
}

template <class R>
OwnCall call_of(std::size_t arguments, std::size_t mask) {
  return mask == 0 ? plain<R>(arguments, std::make_index_sequence<most_arguments>())()
                   : with_counts<R>(arguments, mask, std::make_index_sequence<most_with_counts>())();
}

}  // namespace

OwnCall own_call(const std::vector<bool>& counted, bool yes_no) {
  const bool any = std::ranges::find(counted, true) != counted.end();
  const std::size_t most = any ? most_with_counts : most_arguments;
  if (counted.empty() || counted.size() > most) {
    throw Error(std::string("own_kind: ")
                    .append(std::to_string(counted.size()))
                    .append(" arguments; a function takes 1 to ")
                    .append(std::to_string(most))
                    .append(any ? " where some have any number of points" : ""));
  }
  std::size_t mask = 0;
  for (std::size_t i = 0; i < counted.size(); ++i) mask |= counted[i] ? std::size_t{1} << i : 0;
  return yes_no ? call_of<int>(counted.size(), mask) : call_of<double>(counted.size(), mask);
}

}  // namespace plumb::degenerate
