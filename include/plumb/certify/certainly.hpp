// The worlds that everyone has, and the question asked of them: certainly(statement, input...).
//
//   struct IsBeyond {                                    // is |p q| longer than |r s|?
//     template <class W>
//     bool operator()(W& w, const Point2& p, const Point2& q, const Point2& r, const Point2& s) const {
//       const auto square = [&](const Point2& a, const Point2& b) {
//         const auto x = w.difference(b.x, a.x), y = w.difference(b.y, a.y);
//         return x * x + y * y;
//       };
//       return w.compare(square(p, q), square(r, s)) == Sign::positive;
//     }
//   };
//   const bool longer = certainly(IsBeyond{}, p, q, r, s);
//
// Doubles whose error is derived when the statement is compiled; pairs of doubles likewise, which on a lattice of few
// bits tell zero as well; integers of as many limbs as they need, on the stack, up to 1,024 bits; then rational
// numbers.  Other worlds are named: certainly<ExactWorlds>(statement, input...).  A statement whose numbers are of a higher power of its scales than 6 says so: `static constexpr int highest
// = 8;`; one whose leaves belong to more than one scale, `static constexpr Scales scales{.count = 2};`.
// Laws: those of certify/world.hpp.
// Source: docs/add_a_decision.md.
// Cost: that of the plain operations, and a magnitude and a sum for each leaf; a few times as much in pairs; no
// allocation but in rationals, which take some microseconds.
#pragma once

#include <array>
#include <bit>
#include <optional>
#include <type_traits>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/arith/track.hpp"
#include "plumb/certify/checked.hpp"
#include "plumb/certify/world.hpp"

/// Doubles, one at a time.
namespace plumb::certify::one_lane {

using Truth = bool;
constexpr double loaded(double x) { return x; }
constexpr double of_all(double x) { return x; }
constexpr double size(double x) { return __builtin_fabs(x); }
constexpr double larger(double a, double b) { return a > b ? a : b; }
constexpr double smaller(double a, double b) { return a < b ? a : b; }
constexpr double turned(double x) { return x; }
constexpr double turned_back(double x) { return x; }
constexpr double total(double x) { return x; }
constexpr double largest(double x) { return x; }
constexpr double x_of(double x) { return x; }
constexpr double plus_product(double sum, double a, double b) { return sum + a * b; }
constexpr double minus_product(double sum, double a, double b) { return sum - a * b; }
constexpr bool above(double a, double b) { return a > b; }
constexpr bool is_zero(double x) { return x == 0; }
constexpr double chosen(bool first, double a, double b) { return first ? a : b; }
constexpr double least(double x) { return x; }
constexpr double lowest_bit(double x) {
  const auto pattern = std::bit_cast<std::uint64_t>(x) & ~(std::uint64_t{1} << 63);
  const double size = std::bit_cast<double>(pattern);
  if (pattern == 0) return __builtin_huge_val();
  return pattern << 12 == 0 ? size : size - std::bit_cast<double>(pattern & (pattern - 1));
}
constexpr double product_error(double a, double b, double) { return two_product(a, b).error; }
constexpr bool any(bool x) { return x; }
constexpr bool all(bool x) { return x; }
constexpr bool both(bool a, bool b) { return a && b; }

#define PLUMB_PAIRS_TEXT
#include "plumb/certify/detail/pairs_text.hpp"
#define PLUMB_FLOATS_TEXT
#include "plumb/certify/detail/floats_text.hpp"

}  // namespace plumb::certify::one_lane

namespace plumb {

inline Rational magnitude(const Rational& x) { return x.sign() == Sign::negative ? -x : x; }
inline Rational negated(const Rational& x) { return -x; }
inline Rational larger(const Rational& a, const Rational& b) { return a < b ? b : a; }
inline Rational smaller(const Rational& a, const Rational& b) { return b < a ? b : a; }
inline Rational twice(const Rational& x) { return x + x; }
inline Rational between(const Rational& a, const Rational& b, double t) { return a + (b - a) * Rational(t); }
inline Rational select(bool first, const Rational& a, const Rational& b) { return first ? a : b; }

/// Exact numbers, one at a time; N is made of a double.
template <class N, WorldKind which>
class ExactNumbers {
 public:
  static constexpr WorldKind kind = which;
  using Number = N;

  template <std::size_t scale = 0>
  [[nodiscard]] N difference(double b, double a) const {
    return N(b) - N(a);
  }
  template <std::size_t scale = 0>
  [[nodiscard]] N number(double a) const {
    return N(a);
  }
  template <std::size_t over>
  [[nodiscard]] N weight(double a) const {
    return N(a);
  }
  [[nodiscard]] N portion(double t) const { return N(portion_of(t)); }
  [[nodiscard]] Sign sign(const N& x) const { return x.sign(); }
  [[nodiscard]] Sign compare(const N& x, const N& y) const { return (x - y).sign(); }
  [[nodiscard]] bool negative(const N& x) const { return x.sign() == Sign::negative; }
  static constexpr bool certain() { return true; }
};

/// Integers of just the width, on the stack: certain where none takes more than 1,024 bits.
class IntegerWorld : public ExactNumbers<StackDyadic, WorldKind::integers> {
 public:
  IntegerWorld() { StackDyadic::clear_range(); }
  static bool certain() { return !StackDyadic::left_range(); }
};

template <class Statement>
inline constexpr int highest_power = [] {
  if constexpr (requires { Statement::highest; }) {
    return Statement::highest;
  } else {
    return 6;
  }
}();

template <class Statement>
inline constexpr Scales scales_of = [] {
  if constexpr (requires { Statement::scales; }) {
    return Statement::scales;
  } else {
    return Scales{};
  }
}();
template <class Statement>
using FloatWorld = certify::one_lane::Floats<double, highest_power<Statement>, scales_of<Statement>>;
template <class Statement>
using PairWorld = certify::one_lane::Floats<double, highest_power<Statement>, scales_of<Statement>, NoBoundListener,
                                            Precision::pairs>;
using RationalWorld = ExactNumbers<Rational, WorldKind::rationals>;

/// Worlds in the order in which they are asked; the last one is certain of everything.
template <class... World>
struct Worlds {
  template <class Recorder, class Statement, class... Input>
  static auto answer(Recorder&& recorder, const Statement& statement, const Input&... input) {
    return certify::one_lane::ask_worlds<World...>(recorder, statement, input...);
  }
};
using ExactWorlds = Worlds<IntegerWorld, RationalWorld>;
/// After doubles, which the caller has asked.
template <class Statement>
using CloserWorlds = Worlds<PairWorld<Statement>, IntegerWorld, RationalWorld>;

/// Those that derive the errors of this statement.
struct DerivedWorlds {
  template <class Recorder, class Statement, class... Input>
  static auto answer(Recorder&& recorder, const Statement& statement, const Input&... input) {
    using List = Worlds<FloatWorld<Statement>, PairWorld<Statement>, IntegerWorld, RationalWorld>;
    return List::answer(recorder, statement, input...);
  }
};

/// The answer; the recorder is told which world gave it.
template <class List = DerivedWorlds, class Recorder, class Statement, class... Input>
auto certainly_recorded(Recorder&& recorder, const Statement& statement, const Input&... input) {
  assert_sound_thread();
  return List::answer(recorder, statement, input...);
}
template <class List = DerivedWorlds, class Statement, class... Input>
auto certainly(const Statement& statement, const Input&... input) {
  return certainly_recorded<List>(NoWorldRecorder{}, statement, input...);
}

}  // namespace plumb
