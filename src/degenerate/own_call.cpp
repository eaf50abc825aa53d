#include "degenerate/own_call.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <typeinfo>

#include "plumb/arith/error.hpp"

namespace plumb::degenerate {

namespace {

/// What a function is handed: of slot i the argument, and whether it is that one's count.
template <unsigned mask, std::size_t arguments>
struct Slots {
  static constexpr std::size_t size = arguments + static_cast<std::size_t>(std::popcount(mask));
  static constexpr std::size_t argument(std::size_t slot) { return found(slot) / 2; }
  static constexpr bool is_count(std::size_t slot) { return found(slot) % 2 != 0; }

 private:
  // Bit i of the mask: a count follows argument i.
  static constexpr std::size_t found(std::size_t slot) {
    std::size_t argument = 0;
    for (std::size_t before = 0;; ++argument) {
      if (before == slot) return 2 * argument;
      const bool counted = (mask >> argument & 1U) != 0;
      if (counted && before + 1 == slot) return 2 * argument + 1;
      before += counted ? 2 : 1;
    }
  }
};

template <bool is_count>
auto handed(const Passed& passed) {
  if constexpr (is_count) {
    return passed.count;
  } else {
    return passed.numbers;
  }
}
template <bool is_count>
using Handed = decltype(handed<is_count>({}));

// Packs of slots, and no tuples of them: there are 138 of these.
template <class R, class Of, std::size_t... slot>
Answer call_with(ForeignFunction function, std::span<const Passed> passed) {
  using Function = R (*)(Handed<Of::is_count(slot)>...);
  const R answer = reinterpret_cast<Function>(function)(handed<Of::is_count(slot)>(passed[Of::argument(slot)])...);
  return std::is_same_v<R, int> ? (answer != 0 ? 1.0 : 0.0) : static_cast<double>(answer);
}

template <class R, class Of, std::size_t... slot>
OwnCall made_of(std::index_sequence<slot...>) {
  return {call_with<R, Of, slot...>, typeid(R(Handed<Of::is_count(slot)>...))};
}

template <class R, unsigned mask, std::size_t arguments>
OwnCall made() {
  using Of = Slots<mask, arguments>;
  return made_of<R, Of>(std::make_index_sequence<Of::size>());
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
