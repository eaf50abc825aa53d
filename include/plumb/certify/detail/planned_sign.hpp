// How does a plan take a sign?  One formula over the words of a lattice, in one of the arithmetics of a plan.
//
// Laws: the sign of the exact value, for points that this lattice took in and an arithmetic that arithmetic_for says
// for its bits.  Points of another lattice throw OffLattice.
// Source: docs/plans.md, docs/proof.md "Lattices".
// Cost: that of the arithmetic, see there.
#pragma once

#include <bit>
#include <new>
#include <tuple>

#include "plumb/certify/decide.hpp"
#include "plumb/certify/lattice_point.hpp"
#include "plumb/certify/plan.hpp"

namespace plumb {

template <Formula F>
using LatticeWords = std::array<std::uint64_t, arity<F>>;

namespace certify::planned {

/// How the points of a lattice keep their coordinates.
enum class Words : bool { of_integers, of_doubles };

/// What answered: an arithmetic without a filter, the bound of the lattice, the filter of decide, or what is exact for
/// all.
enum class PlanStage : std::uint8_t { whole, bound, filter, exact };

/// Recorder policy: is told where every decision was taken.  This one does nothing and costs nothing.
struct NoPlanRecorder {
  static constexpr void decided(PlanStage) {}
};

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

/// What the filters see of words: doubles as given, or numbers that differ in doubles.  Words of integers are multiples
/// of the lattice's unit, which changes no sign, and where only differences are asked, doubles far from the origin.
template <Formula F, Words W, std::size_t... N>
[[gnu::always_inline]] inline auto seen(const LatticePoint<N>&... p) {
  return std::apply(
      [](auto... w) {
        if constexpr (W == Words::of_doubles || certify::integer::enters_by_differences<F>) {
          return std::array{arith::lattice_word::as_double(w)...};
        } else {
          return std::array{WordAsDouble{w}...};
        }
      },
      words_of<F>(anew(p)...));
}

/// A coordinate itself of those.
template <Words W>
constexpr double coordinate(double x) {
  return W == Words::of_integers ? x - arith::lattice_word::center : x;
}
template <Words W>
constexpr double coordinate(WordAsDouble x) {
  return x;
}

/// Over integers of the lattice, of two words or more; of up to several_words bits.
template <Formula F, int Bits>
[[gnu::always_inline]] inline Sign integer_sign_of(LatticeWords<F> w, Words kept, const LatticeIntake& lattice) {
  if (kept == Words::of_doubles) {
    for (std::uint64_t& x : w) x = arith::lattice_word::of(lattice.integer(std::bit_cast<double>(x)));
  }
  return over<F, WordAsInteger<Bits + 1>>(w).sign();
}

// GCC gathers limbs in vectors from the words that they were just stored in, and waits for each of them.
#if defined(__GNUC__) && !defined(__clang__)
#define PLUMB_OF_LIMBS gnu::noinline, gnu::flatten, gnu::optimize("no-tree-slp-vectorize")
#else
#define PLUMB_OF_LIMBS gnu::noinline, gnu::flatten
#endif

// What follows is called with the points themselves, so that the inline part keeps neither their words nor copies.

template <Formula F, Words W, std::size_t... N>
[[PLUMB_OF_LIMBS]] Sign several_word_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  return integer_sign_of<F, several_words<F>>(words_of<F>(p...), W, lattice);
}

/// What is exact where the filter of decide is not sure: the integers of the lattice if they have so few bits, or else
/// the stages of decide.  For those, stored in pairs, as they load them: a load of what two stores wrote waits for both.
template <Formula F, Words W, std::size_t... N>
[[gnu::noinline]] Sign chain_sign([[maybe_unused]] const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  if constexpr (several_words<F> != two_words<F>) {
    if (lattice.lattice().bits <= several_words<F>) return several_word_sign<F, W>(lattice, p...);
  }
  using Pair [[gnu::vector_size(16)]] = double;
  const auto x = seen<F, W>(p...);
  Coordinates<F> given{};
  for (std::size_t i = 0; i + 1 < arity<F>; i += 2) {
    const Pair pair{opaque(coordinate<W>(x[i])), opaque(coordinate<W>(x[i + 1]))};
    __builtin_memcpy(&given[i], &pair, sizeof pair);
  }
  if constexpr (arity<F> % 2 != 0) given[arity<F> - 1] = opaque(coordinate<W>(x[arity<F> - 1]));
  return decide_exactly<F>(given).sign;
}

template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign modulo_word_sign(const LatticePoint<N>&... p) {
  return sign_of_number(over<F, WordModular>(words_of<F>(p...)).near_zero());
}

template <Formula F, Words W, std::size_t... N>
[[PLUMB_OF_LIMBS]] Sign two_word_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  return integer_sign_of<F, two_words<F>>(words_of<F>(p...), W, lattice);
}

#undef PLUMB_OF_LIMBS

/// Decided from the coordinates as they were given.
template <Formula F, std::size_t... N>
[[gnu::noinline]] Sign given_sign(const LatticeIntake& lattice, const LatticePoint<N>&... p) {
  const LatticeWords<F> w = words_of<F>(p...);
  Coordinates<F> x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = lattice.given(w[i]);
  return decide<F>(x);
}

/// The threshold of filter B for points of the lattice: that for differences of 1, times a power of two, which rounds
/// nothing.  Where a value might overflow it is infinite, and nothing beyond.
template <Formula F>
[[gnu::always_inline]] inline double lattice_threshold(const LatticeIntake& lattice) {
  constexpr double terms =
      LargestMagnitude(evaluate<F>([](std::size_t) { return LargestMagnitude::Input{1}; })).magnitude;
  static_assert(terms < 0x1p20, "reach_to leaves so much room");
  constexpr double of_one = filter_constant<F>() * terms, least = of_one * power<degree<F>()>(largest_floor<F>);
  const double threshold = of_one * lattice.reach_to<degree<F>()>();
  return threshold > least ? threshold : least;
}

/// The sign of F in one arithmetic.
template <Formula F, Arithmetic A, Words W, class Recorder, std::size_t... N>
[[gnu::always_inline]] inline Sign sign_in(const LatticeIntake& lattice, double threshold, Recorder& recorder,
                                           const LatticePoint<N>&... p) {
  const auto found = [&](PlanStage stage, auto sign) {
    recorder.decided(stage);
    return static_cast<Sign>(sign);
  };
  if constexpr (A == Arithmetic::plain_double) {
    return found(PlanStage::whole, sign_of_number(static_cast<double>(over<F, WordAsDouble>(words_of<F>(anew(p)...)))));
  } else if constexpr (A == Arithmetic::one_word_factors) {
    return found(PlanStage::whole, over<F, WordAsInteger<one_word_factors<F> + 1>>(words_of<F>(anew(p)...)).sign());
  } else if constexpr (A == Arithmetic::chain && !is_homogeneous<F>) {
    return found(PlanStage::exact, given_sign<F>(lattice, p...));
  } else if constexpr (A == Arithmetic::chain) {
    if (const int s = filter<F>(seen<F, W>(p...)); s != 0) [[likely]]
      return found(PlanStage::filter, s);
    return found(PlanStage::exact, chain_sign<F, W>(lattice, p...));
  } else {
    const auto x = seen<F, W>(p...);
    const double value = value_of<F>(x);
    if (magnitude_of(value) > threshold) [[likely]]  // no branch on the sign, as in the filters
      return found(PlanStage::bound, sign_bit_of(value));
    if constexpr (A == Arithmetic::modulo_word) {
      return found(PlanStage::exact, modulo_word_sign<F>(p...));
    } else if constexpr (A == Arithmetic::two_words) {
      return found(PlanStage::exact, two_word_sign<F, W>(lattice, p...));
    } else {
      // Where a point far off makes the bound useless, this is decide, with the value at hand.
      if (magnitude_of(value) > filter_threshold<F>(x, value)) return found(PlanStage::filter, sign_bit_of(value));
      return found(PlanStage::exact, chain_sign<F, W>(lattice, p...));
    }
  }
}

/// An arithmetic, and the words that it finds.
template <Arithmetic A, Words W>
struct Way {
  static constexpr Arithmetic arithmetic = A;
  static constexpr Words words = W;
};

/// Calls action(Way<A, W>) for the arithmetic of a lattice.
template <Formula F, class Action>
[[gnu::always_inline]] inline decltype(auto) dispatch(const LatticeIntake& lattice, Action&& action) {
  constexpr int words = arith::lattice_word::double_bits;
  const int bits = lattice.lattice().bits;
  if constexpr (is_homogeneous<F>) {
    constexpr int plain = certify::planned::plain_double<F>, one = certify::planned::one_word_factors<F>,
                  modulo = certify::planned::modulo_word<F>, two = certify::planned::two_words<F>;
    if constexpr (plain < words) {
      if (bits <= plain) return action(Way<Arithmetic::plain_double, Words::of_integers>{});
    }
    if constexpr (one > plain && one < words) {
      if (bits <= one) return action(Way<Arithmetic::one_word_factors, Words::of_integers>{});
    }
    if constexpr (modulo > one && modulo > plain && modulo < words) {
      if (bits <= modulo) return action(Way<Arithmetic::modulo_word, Words::of_integers>{});
    }
    if constexpr (two > modulo && two > one && two > plain && two < words) {
      if (bits <= two) return action(Way<Arithmetic::two_words, Words::of_integers>{});
    }
    if (bits > words) {
      if constexpr (two > words) {
        if (bits <= two) return action(Way<Arithmetic::two_words, Words::of_doubles>{});
      }
      return action(Way<arithmetic_for<F>(unbounded), Words::of_doubles>{});
    }
  }
  return action(Way<arithmetic_for<F>(words), Words::of_integers>{});
}

}  // namespace certify::planned

/// A formula with the arithmetic of a scene fixed: Kernel::with hands it out.  Refers to its kernel.
template <Formula F, class Way>
class PlannedPredicate {
 public:
  static constexpr Arithmetic arithmetic = Way::arithmetic;

  explicit PlannedPredicate(const LatticeIntake& lattice)
      : lattice_(&lattice), stamp_(lattice.stamp()), threshold_(threshold_on(lattice)) {}

  /// The sign of F at points taken in, one for each argument.
  template <std::size_t... N>
  [[nodiscard]] PLUMB_CHECKABLE Sign operator()(const LatticePoint<N>&... p) const {
    certify::planned::NoPlanRecorder none;
    return recorded(none, p...);
  }
  /// The same; the recorder is told which stage decided.
  template <class Recorder, std::size_t... N>
  [[nodiscard, gnu::flatten]] PLUMB_CHECKABLE Sign recorded(Recorder& recorder, const LatticePoint<N>&... p) const {
    static_assert((N + ...) == arity<F>, "Kernel: the formula takes another number of coordinates than these points");
    assert_sound_thread();
    if ((p.stamp() & ...) != stamp_) [[unlikely]]
      refuse(p...);
    return certify::planned::sign_in<F, arithmetic, Way::words>(*lattice_, threshold_, recorder, p...);
  }

 private:
  // Either bound tells a sign; what the second leaves fits remainders modulo 2^64.
  static double threshold_on(const LatticeIntake& lattice) {
    using namespace certify::planned;
    if constexpr (arithmetic == Arithmetic::modulo_word) {
      const double bound = lattice_threshold<F>(lattice), most = error<F>(modulo_word<F>).root;
      return bound < most ? bound : most;
    } else if constexpr (arithmetic == Arithmetic::two_words || arithmetic == Arithmetic::bounded_chain) {
      return lattice_threshold<F>(lattice);
    } else {
      return 0;
    }
  }

  template <std::size_t... N>
  [[noreturn, gnu::noinline, gnu::cold]] void refuse(const LatticePoint<N>&... p) const {
    lattice_->refuse_stamp(F::name, std::array{p.stamp()...});
  }

  const LatticeIntake* lattice_;
  std::uint64_t stamp_;
  double threshold_;
};

}  // namespace plumb
