// How does a plan take a sign?  One formula over the words of a lattice, in the arithmetic that arithmetic_for names.
//
// Laws: the sign of the exact value, for the words that this lattice took in.  Which arithmetic is taken depends on the
// lattice alone, so that its branches are predicted; a constant threshold is one comparison.
// Source: docs/plans.md, docs/proof.md "Lattices"; cost: that of the arithmetic, see there.
#pragma once

#include <cassert>

#include "plumb/certify/decide.hpp"
#include "plumb/certify/lattice_point.hpp"
#include "plumb/certify/plan.hpp"

namespace plumb {

template <Formula F>
using LatticeWords = std::array<std::uint64_t, arity<F>>;

namespace planned {

template <Formula F, class Input>
constexpr auto over(const LatticeWords<F>& w) {
  return evaluate<F>([&](std::size_t i) { return Input{w[i]}; });
}

template <Formula F>
double value_in_doubles(const LatticeWords<F>& w, double from) {
  return evaluate<F>([&](std::size_t i) { return WordAsDouble{lattice_word::as_double(w[i]), from}; });
}

/// Do the bounds of the widest words stay finite?  Formulas of very high degree have the filters of decide alone.
template <Formula F>
inline constexpr bool has_threshold = error<F>(lattice_word::integer_bits).root < 0x1p1000;

/// For lattices of words without an arithmetic of 128 bits: bounds shrink with the bits at least as fast as the value.
template <Formula F>
double word_threshold(int bits) {
  const int exponent = degree<F>() * (bits - lattice_word::integer_bits);
  return error<F>(lattice_word::integer_bits).root *
         std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// For coordinates as given, none of whose differences exceeds `largest`: filter B's.  Infinite where some intermediate
/// value could overflow.
template <Formula F>
double given_threshold(double largest) {
  constexpr double terms =
      LargestMagnitude(evaluate<F>([](std::size_t) { return LargestMagnitude::Input{1}; })).magnitude;
  return power<degree<F>()>(largest < largest_floor<F> ? largest_floor<F> : largest) * terms * filter_constant<F>();
}

template <Formula F>
Coordinates<F> given(const LatticeWords<F>& w, const LatticeIntake& lattice) {
  Coordinates<F> p{};
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = lattice.given(w[i]);
  return p;
}

template <Formula F, std::size_t... N>
constexpr LatticeWords<F> words_of(const LatticePoint<N>&... p) {
  return std::apply([](auto... w) { return LatticeWords<F>{w...}; }, std::tuple_cat(p.words()...));
}

/// Keeps what follows from sharing its loads with the other arithmetics, which would bring doubles in by way of integer
/// registers.
[[gnu::always_inline]] inline void load_anew() {
#if defined(__GNUC__)
  __asm__ volatile("" ::: "memory");
#endif
}

/// For words of up to 62 bits: the widest integers that words need, compiled into the library once.
template <Formula F>
[[gnu::noinline]] Sign long_word_sign(const LatticeWords<F>& w) {
  return over<F, WordAsInteger<lattice_word::integer_bits + 1>>(w).sign();
}
extern template Sign long_word_sign<predicates::Orient2d>(const LatticeWords<predicates::Orient2d>&);
extern template Sign long_word_sign<predicates::Orient3d>(const LatticeWords<predicates::Orient3d>&);
extern template Sign long_word_sign<predicates::InCircle>(const LatticeWords<predicates::InCircle>&);
extern template Sign long_word_sign<predicates::InSphere>(const LatticeWords<predicates::InSphere>&);

// What follows is called, with the points themselves, so that the inline part keeps its words in registers.

/// Where doubles do not tell the sign.
template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign near_zero_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  const LatticeWords<F> w = words_of<F>(p...);
  const int bits = lattice.lattice().bits;
  constexpr int widest = two_words<F>;
  if constexpr (widest > one_word_factors<F>) {
    if (bits <= widest) return over<F, WordAsInteger<widest + 1>>(w).sign();
  }
  if constexpr (has_wide_stages<F>) {
    if (bits <= lattice_word::integer_bits) return long_word_sign<F>(w);
  }
  return decide_exactly<F>(given<F>(w, lattice)).sign;
}

template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign unplanned_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  return decide<F>(given<F>(words_of<F>(p...), lattice));
}

/// The bound of the doubles' error where plain doubles are not exact.
template <Formula F>
double threshold(const LatticeIntake& lattice) {
  const int bits = lattice.lattice().bits;
  if (modulo_word<F> >= 0 && bits <= modulo_word<F>) return error<F>(modulo_word<F>).root;
  if (two_words<F> >= 0 && bits <= two_words<F>) return error<F>(two_words<F>).root;
  if (bits <= lattice_word::integer_bits) return word_threshold<F>(bits);
  return given_threshold<F>(lattice.largest_difference());
}

}  // namespace planned

/// The sign of F at points that this lattice took in.
template <Formula F, std::size_t... N>
[[gnu::always_inline]] inline Sign planned_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  assert(environment::thread_is_sound() &&
         "plumb: this thread does not round to nearest, or flushes subnormals; see check_environment()");
  if constexpr (!is_homogeneous<F>) {
    return planned::unplanned_sign<F>(lattice, p...);
  } else {
    constexpr int plain = planned::plain_double<F>, one_word = planned::one_word_factors<F>,
                  modulo = planned::modulo_word<F>;
    const int bits = lattice.lattice().bits;
    const auto value = [&] {
      planned::load_anew();
      return planned::value_in_doubles<F>(planned::words_of<F>(p...), lattice.counted_from());
    };
    if (bits <= plain) return sign_of_number(value());
    if constexpr (one_word > plain) {
      if (bits <= one_word) {
        planned::load_anew();
        return planned::over<F, WordAsInteger<one_word + 1>>(planned::words_of<F>(p...)).sign();
      }
    }
    if constexpr (!planned::has_threshold<F>) {
      return planned::unplanned_sign<F>(lattice, p...);
    } else {
      const auto rounded = [&]() -> double {
        planned::load_anew();
        return planned::over<F, WordAsRoundedDouble>(planned::words_of<F>(p...));
      };
      const double v = bits > lattice_word::double_bits && bits <= lattice_word::integer_bits ? rounded() : value();
      if (const int s = beyond(v, planned::threshold<F>(lattice)); s != 0) [[likely]]
        return static_cast<Sign>(s);
      if constexpr (modulo > one_word) {
        if (bits <= modulo) {
          planned::load_anew();
          return sign_of_number(planned::over<F, WordModular>(planned::words_of<F>(p...)).near_zero());
        }
      }
      return planned::near_zero_sign<F>(lattice, p...);
    }
  }
}

}  // namespace plumb
