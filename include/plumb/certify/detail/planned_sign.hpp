// How does a plan take a sign?  One formula over the words of a lattice, in one of the arithmetics of a plan.
//
// Laws: the sign of the exact value, for points that this lattice took in and an arithmetic that arithmetic_for says
// for its bits.  Points of another lattice throw OffLattice.
// Source: docs/plans.md, docs/proof.md "Lattices".
// Cost: that of the arithmetic, see there.
#pragma once

#include <new>
#include <tuple>

#include "plumb/certify/decide.hpp"
#include "plumb/certify/lattice_point.hpp"
#include "plumb/certify/plan.hpp"

namespace plumb {

template <Formula F>
using LatticeWords = std::array<std::uint64_t, arity<F>>;

namespace certify::planned {

template <Formula F, class Input>
constexpr auto over(const LatticeWords<F>& w) {
  return evaluate<F>([&](std::size_t i) { return Input{w[i]}; });
}

template <Formula F, std::size_t... N>
constexpr LatticeWords<F> words_of(const LatticePoint<N>&... p) {
  return std::apply([](auto... w) { return LatticeWords<F>{w...}; }, std::tuple_cat(p.words()...));
}

/// x, of which GCC forgets that it has read it: the arithmetics would share their loads, and bring doubles in by way of
/// integer registers.
template <class T>
[[gnu::always_inline]] inline const T& anew(const T& x) {
  return *std::launder(&x);
}

/// Of words up to 62 bits: the widest integers that they need, compiled into the library once for the classics.
template <Formula F>
[[gnu::noinline]] Sign long_word_sign(const LatticeWords<F>& w) {
  return over<F, WordAsInteger<arith::lattice_word::integer_bits + 1>>(w).sign();
}
extern template Sign long_word_sign<predicates::Orient2d>(const LatticeWords<predicates::Orient2d>&);
extern template Sign long_word_sign<predicates::Orient3d>(const LatticeWords<predicates::Orient3d>&);
extern template Sign long_word_sign<predicates::InCircle>(const LatticeWords<predicates::InCircle>&);
extern template Sign long_word_sign<predicates::InSphere>(const LatticeWords<predicates::InSphere>&);

/// action(coordinates) for what the filter sees of words: their integers, each of which is a double; beyond 62 bits the
/// doubles as given.  The action is compiled for each kind of words: arrays that meet again would go through memory,
/// and GCC would store words one by one to load them back in pairs, were they not opaque.
template <Formula F, class Action, std::size_t... N>
[[gnu::always_inline]] inline auto in_doubles(int bits, Action action, const LatticePoint<N>&... p) {
  const auto each = [&](auto make) {
    return std::apply([&](auto... w) { return Coordinates<F>{make(w)...}; }, words_of<F>(anew(p)...));
  };
  if (bits <= arith::lattice_word::double_bits)
    return action(each([](std::uint64_t w) { return opaque(WordAsDouble{w}); }));
  if (bits > arith::lattice_word::integer_bits)
    return action(each([](std::uint64_t w) { return opaque(arith::lattice_word::as_double(w)); }));
  return action(each([](std::uint64_t w) { return opaque(static_cast<double>(arith::lattice_word::integer(w))); }));
}

/// Where the filter is unsure, for a formula without an arithmetic of 128 bits.
template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign long_sign(int bits, const LatticePoint<N>&... p) {
  if constexpr (has_wide_stages<F>) {
    if (bits <= arith::lattice_word::integer_bits) return long_word_sign<F>(words_of<F>(p...));
  }
  return in_doubles<F>(
      bits, [](const Coordinates<F>& x) { return decide_exactly<F>(x).sign; }, p...);
}

/// Called with the points themselves, so that the inline part keeps its words in registers.
template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign two_word_sign(const LatticePoint<N>&... p) {
  return over<F, WordAsInteger<two_words<F> + 1>>(words_of<F>(p...)).sign();
}

/// Decided from the coordinates as they were given.
template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign given_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  const LatticeWords<F> w = words_of<F>(p...);
  Coordinates<F> x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = lattice.given(w[i]);
  return decide<F>(x);
}

/// The sign of F in one arithmetic.
template <Formula F, Arithmetic A, std::size_t... N>
[[gnu::always_inline]] inline Sign sign_in(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  if constexpr (A == Arithmetic::plain_double) {
    return sign_of_number(static_cast<double>(over<F, WordAsDouble>(words_of<F>(anew(p)...))));
  } else if constexpr (A == Arithmetic::one_word_factors) {
    return over<F, WordAsInteger<one_word_factors<F> + 1>>(words_of<F>(anew(p)...)).sign();
  } else if constexpr (A == Arithmetic::modulo_word || A == Arithmetic::two_words) {
    constexpr double bound = error<F>(A == Arithmetic::modulo_word ? modulo_word<F> : two_words<F>).root;
    const double value = over<F, WordAsDouble>(words_of<F>(anew(p)...));
    if (const int s = beyond(value, bound); s != 0) [[likely]]
      return static_cast<Sign>(s);
    if constexpr (A == Arithmetic::modulo_word) {
      return sign_of_number(over<F, WordModular>(words_of<F>(anew(p)...)).near_zero());
    } else {
      return two_word_sign<F>(p...);
    }
  } else if constexpr (is_homogeneous<F>) {
    const int bits = lattice.lattice().bits;
    const auto filtered = [](const Coordinates<F>& x) { return filter<F>(x); };
    if (const int s = in_doubles<F>(bits, filtered, p...); s != 0) [[likely]]
      return static_cast<Sign>(s);
    return long_sign<F>(bits, p...);
  } else {
    return given_sign<F>(lattice, p...);
  }
}

/// Calls action(std::integral_constant<Arithmetic, A>) for the arithmetic of a lattice of so many bits.
template <Formula F, class Action>
[[gnu::always_inline]] inline decltype(auto) dispatch(int bits, Action&& action) {
  if constexpr (is_homogeneous<F>) {
    constexpr int plain = certify::planned::plain_double<F>, one = certify::planned::one_word_factors<F>,
                  modulo = certify::planned::modulo_word<F>, two = certify::planned::two_words<F>;
    if (bits <= plain) return action(std::integral_constant<Arithmetic, Arithmetic::plain_double>{});
    if constexpr (one > plain) {
      if (bits <= one) return action(std::integral_constant<Arithmetic, Arithmetic::one_word_factors>{});
    }
    if constexpr (modulo > one && modulo > plain) {
      if (bits <= modulo) return action(std::integral_constant<Arithmetic, Arithmetic::modulo_word>{});
    }
    if constexpr (two > modulo && two > one && two > plain) {
      if (bits <= two) return action(std::integral_constant<Arithmetic, Arithmetic::two_words>{});
    }
  }
  return action(std::integral_constant<Arithmetic, Arithmetic::chain>{});
}

}  // namespace certify::planned

/// A formula with the arithmetic of a scene fixed: Kernel::with hands it out.  Refers to its kernel.
template <Formula F, Arithmetic A>
class PlannedPredicate {
 public:
  static constexpr Arithmetic arithmetic = A;

  explicit PlannedPredicate(const LatticeIntake& lattice) : lattice_(&lattice), stamp_(lattice.stamp()) {}

  /// The sign of F at points taken in, one for each argument.
  template <std::size_t... N>
  [[nodiscard]] PLUMB_CHECKABLE Sign operator()(const LatticePoint<N>&... p) const {
    static_assert((N + ...) == arity<F>, "Kernel: the formula takes another number of coordinates than these points");
    assert_sound_thread();
    if ((p.stamp() & ...) != stamp_) [[unlikely]]
      lattice_->refuse_stamp(F::name, std::array{p.stamp()...});
    return certify::planned::sign_in<F, A>(*lattice_, p...);
  }

 private:
  const LatticeIntake* lattice_;
  std::uint64_t stamp_;
};

}  // namespace plumb
