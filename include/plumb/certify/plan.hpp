// Fixed precision: which arithmetic is already exact for every input of this lattice?  The cheapest one, for each
// formula.
//
//   const Plan scene = plan(lattice_of(coordinates));
//   scene.arithmetic<predicates::Orient3d>()   // Arithmetic::plain_double, say
//
// Laws: what a plan says follows from the formula's own growth (LatticeError, WidthGrowth) and holds for every set of
// coordinates of the lattice; more bits never mean a cheaper arithmetic.  None is planned that decide outruns, but for
// exact zeros of insphere (docs/plans.md).  Kernel (certify/kernel.hpp) takes the signs.
// A lattice on which no double but 0 lies throws Error.
// Source: RTCD 11.4, 11.5.1, docs/plans.md.
// Cost: constants of a formula, found when compiled.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/arith/lattice.hpp"
#include "plumb/arith/lattice_error.hpp"
#include "plumb/arith/lattice_word.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb {

/// In the order of cost.
enum class Arithmetic : std::uint8_t {
  plain_double,      // every value is exact; only the last sum may round, which keeps its sign
  one_word_factors,  // integers of at most 128 bits whose products multiply single words
  modulo_word,       // doubles with the lattice's bound; within it, integers modulo 2^64
  two_words,         // doubles with the lattice's bound; within it, integers of at most 128 bits
  bounded_chain,     // doubles with the lattice's bound; within it, the chain
  chain,             // the filter and the exact stages of decide; formulas whose terms differ in degree have no other
};
inline constexpr std::size_t arithmetic_count = 6;

/// The most bits of coordinates for which a formula has each of them but the chain, in order; -1 where it has none.
using PlannedBits = std::array<int, arithmetic_count - 1>;

/// "plain double", "integers to 128 bits", ...
std::string_view to_string(Arithmetic a);

namespace certify::planned {

/// The most bits up to `limit` for which `holds`, which more bits do not mend; -1 when there are none.
template <class Holds>
consteval int most_bits(int limit, Holds holds) {
  int low = -1, high = limit + 1;
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// The largest integer of so many bits.
constexpr double largest_of(int bits) {
  double power = 1;
  for (int i = 0; i < bits; ++i) power *= 2;
  return power - 1;
}

template <Formula F>
constexpr LatticeError error(int bits) {
  return evaluate<F>([bits](std::size_t) { return LatticeError::coordinate(largest_of(bits)); });
}

template <Formula F>
constexpr WidthGrowth growth(int bits) {  // a difference has one more
  return evaluate<F>([bits](std::size_t) { return WidthGrowth::Input{bits + 1}; });
}

template <Formula F>
inline constexpr int plain_double = most_bits(arith::lattice_word::double_bits,
                                              [](int b) { return error<F>(b).root == 0; });

/// Grids have no more bits, and ask for exact zeros often, which integers tell without doubles before them; from here on
/// zeros are rare and doubles with a bound come first.  Below degree 3 they do so always: such integers take longer than
/// decide's filter (docs/plans.md).
inline constexpr int grid_bits = 20;

template <Formula F>
constexpr bool factors_are_words(int bits) {
  const WidthGrowth g = growth<F>(bits);
  return degree<F>() >= 3 && g.bits <= 127 && g.widest_factor <= 63;
}
template <Formula F>
inline constexpr int one_word_factors = most_bits(grid_bits, factors_are_words<F>);

// |computed| <= root leaves |exact| <= 2 root < 2^63, which its remainder modulo 2^64 tells.
template <Formula F>
inline constexpr int modulo_word = most_bits(arith::lattice_word::double_bits,
                                             [](int b) { return error<F>(b).root < 0x1p62; });

template <Formula F>
inline constexpr int two_words = most_bits(arith::lattice_word::integer_bits,
                                           [](int b) { return growth<F>(b).bits <= 127; });

/// The last step of the chain for lattices of so few bits: integers of four words, without a look for a lattice of
/// each question's own.
template <Formula F>
inline constexpr int several_words = most_bits(arith::lattice_word::integer_bits,
                                               [](int b) { return growth<F>(b).bits <= 255; });

/// More bits than any lattice has.
inline constexpr int unbounded = 1 << 20;

/// Does one bound for all points of a lattice tell most signs?  The values that scenes ask about are as many powers of
/// small differences as the formula's degree; up to this one nearly all stay beyond it (docs/plans.md).
template <Formula F>
constexpr bool bounded = TakesPoints<F>&& is_homogeneous<F>&& degree<F>() <= 4;

}  // namespace certify::planned

/// The arithmetic that F needs on a lattice of so many bits.
template <Formula F>
constexpr Arithmetic arithmetic_for(int bits) {
  if constexpr (!is_homogeneous<F>) {
    return Arithmetic::chain;
  } else {
    if (bits <= certify::planned::plain_double<F>) return Arithmetic::plain_double;
    if (bits <= certify::planned::one_word_factors<F>) return Arithmetic::one_word_factors;
    if (bits <= certify::planned::modulo_word<F>) return Arithmetic::modulo_word;
    if (bits <= certify::planned::two_words<F>) return Arithmetic::two_words;
    return certify::planned::bounded<F> ? Arithmetic::bounded_chain : Arithmetic::chain;
  }
}

class Plan {
 public:
  explicit Plan(const Lattice& lattice);

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  template <Formula F>
  [[nodiscard]] Arithmetic arithmetic() const {
    return arithmetic_for<F>(lattice_.bits);
  }
  friend bool operator==(const Plan&, const Plan&) = default;

 private:
  Lattice lattice_;
};

/// Throws Error for an exponent below -1074 or coordinates beyond the largest double.
inline Plan plan(const Lattice& lattice) { return Plan(lattice); }

}  // namespace plumb
