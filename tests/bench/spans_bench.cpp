// Which exact arithmetic is fastest for which span of exponents?  The exact stages of the chain beside expansions.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/measure.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/degenerate/coordinates.hpp"
#include "tool/trial/expansion.hpp"

namespace plumb::bench {
namespace {

constexpr std::array spans{53, 61, 100, 125, 160, 188, 250, 317, 400, 500, 800, 1600};

/// Coordinates of 53 bits whose exponents are spread over the span.
template <Formula F>
std::vector<Coordinates<F>> spread(int bits) {
  std::vector<Coordinates<F>> sets(cases);
  for (std::size_t k = 0; k < sets.size(); ++k) {
    Entropy entropy(77, k);
    for (double& x : sets[k]) {
      const auto down = static_cast<int>(entropy.below(static_cast<std::uint64_t>(bits - 52)));
      x = std::ldexp(signed_unit_coordinate(entropy), 60 - down);
    }
    sets[k][0] = std::ldexp(1 - 0x1p-53, 60);
    sets[k][1] = std::ldexp(1, 60 - bits);
  }
  return sets;
}

template <Formula F>
void register_predicate() {
  using C = Coordinates<F>;
  const auto add = [](int bits, const char* way, auto take) {
    add_each<F>(std::to_string(bits) + "_bits", way, spread<F>(bits), take);
  };
  for (const int bits : spans) {
    if (bits <= certify::integer::long_bits)
      add(bits, "integer", [](const C& p) { return answer(integer_sign<F>(p)); });
    if (bits <= certify::integer::widest<F>)
      add(bits, "wide-integer", [](const C& p) { return answer(wide_integer_sign<F>(p)); });
    if (bits * degree<F>() < 1900)
      add(bits, "expansion", [](const C& p) { return static_cast<int>(tool::trial::expansion_sign<F>(p)); });
    add(bits, "big-integer",
        [](const C& p) { return static_cast<int>(big_integer_sign(certify::tape::program<F>(), p)); });
  }
}

[[maybe_unused]] const bool registered = register_classics([]<Formula F>(F) { register_predicate<F>(); });

}  // namespace
}  // namespace plumb::bench
