// The expansion of a formula in infinitesimals: its tape, replayed over sparse polynomials.
//
// Coefficients are integers modulo a power of two beyond their largest value, in as many limbs as that takes; up to
// 1024 bits no number is allocated, and no terms while they are few.
#include "certify/expansion.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <vector>

#include "arith/infinitesimal.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb::certify::perturbation {
namespace {

/// An integer modulo 2^(64 N), read as two's complement.
template <std::size_t N>
struct Modular {
  std::array<std::uint64_t, N> limb;

  [[nodiscard]] bool is_zero() const {
    std::uint64_t any = 0;
    for (const std::uint64_t x : limb) any |= x;
    return any == 0;
  }
  [[nodiscard]] Sign sign() const {
    return is_zero() ? Sign::zero : (limb[N - 1] >> 63) != 0 ? Sign::negative : Sign::positive;
  }

  friend Modular operator+(const Modular& a, const Modular& b) {
    Modular r;
    std::uint8_t carry = 0;
    for (std::size_t i = 0; i < N; ++i) r.limb[i] = arith::wide::add(a.limb[i], b.limb[i], carry);
    return r;
  }
  friend Modular operator-(const Modular& a, const Modular& b) {
    Modular r;
    std::uint8_t borrow = 0;
    for (std::size_t i = 0; i < N; ++i) r.limb[i] = arith::wide::subtract(a.limb[i], b.limb[i], borrow);
    return r;
  }
  friend Modular operator*(const Modular& a, const Modular& b) {
    Modular r{};
    for (std::size_t i = 0; i < N; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t k = 0; i + k < N; ++k) {
        const UInt128 t = static_cast<UInt128>(a.limb[i]) * b.limb[k] + r.limb[i + k] + carry;
        r.limb[i + k] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
    }
    return r;
  }
};

/// A product of infinitesimals is a number whose bit fields are the powers, the smallest infinitesimal's at the top:
/// products add the numbers, and the larger product is the lower number.
template <class Number>
struct Term {
  std::uint64_t product;
  Number coefficient;  // not zero
};

/// Terms by size, largest first.
template <class Number>
using Polynomial = std::span<const Term<Number>>;

/// Memory for the terms of one expansion: first from the stack, then from the heap.
template <class Number>
class TermSpace {
 public:
  TermSpace() : next_(few_), end_(few_ + std::size(few_)) {}
  TermSpace(const TermSpace&) = delete;
  TermSpace& operator=(const TermSpace&) = delete;

  /// Room for n terms until kept() says how many of them stay.
  Term<Number>* take(std::size_t n) {
    if (static_cast<std::size_t>(end_ - next_) < n) {
      const std::size_t size = std::max<std::size_t>(n, 4096);
      next_ = more_.emplace_back(new Term<Number>[size]).get();
      end_ = next_ + size;
    }
    return next_;
  }
  Polynomial<Number> kept(Term<Number>* end) { return {std::exchange(next_, end), end}; }

 private:
  Term<Number> few_[sizeof(Number) > 64 ? 96 : 192];  // NOLINT: left uninitialized
  Term<Number>*next_, *end_;
  std::vector<std::unique_ptr<Term<Number>[]>> more_;  // NOLINT
};

template <class Number>
class Expansion {
 public:
  Polynomial<Number> moved(const Number& value, std::uint64_t infinitesimal) {
    Term<Number>*const begin = space_.take(2), *end = begin;
    if (!value.is_zero()) *end++ = {0, value};
    if (infinitesimal != 0) *end++ = {infinitesimal, Number{{1}}};
    return space_.kept(end);
  }

  Polynomial<Number> product(Polynomial<Number> a, Polynomial<Number> b) {
    if (a.size() > b.size()) std::swap(a, b);
    Term<Number>*const begin = space_.take(a.size() * b.size()), *end = begin;
    for (const Term<Number>& l : a) {
      Term<Number>* at = begin;  // the products with l come by size, too
      for (const Term<Number>& r : b) {
        const Term<Number> term{l.product + r.product, l.coefficient * r.coefficient};
        while (at != end && at->product < term.product) ++at;
        if (at != end && at->product == term.product) {
          at->coefficient = at->coefficient + term.coefficient;
        } else {
          std::copy_backward(at, end, end + 1);
          ++end;
          *at = term;
        }
      }
    }
    return space_.kept(std::remove_if(begin, end, [](const Term<Number>& t) { return t.coefficient.is_zero(); }));
  }

  template <bool Subtract>
  Polynomial<Number> sum(Polynomial<Number> a, Polynomial<Number> b) {
    Term<Number>*const begin = space_.take(a.size() + b.size()), *end = begin;
    auto l = a.begin();
    auto r = b.begin();
    while (l != a.end() || r != b.end()) {
      if (r == b.end() || (l != a.end() && l->product < r->product)) {
        *end++ = *l++;
      } else if (l == a.end() || r->product < l->product) {
        *end++ = {r->product, Subtract ? Number{} - r->coefficient : r->coefficient};
        ++r;
      } else {
        const Number c = Subtract ? l->coefficient - r->coefficient : l->coefficient + r->coefficient;
        if (!c.is_zero()) *end++ = {l->product, c};
        ++l, ++r;
      }
    }
    return space_.kept(end);
  }

 private:
  TermSpace<Number> space_;
};

struct PerturbedFormula {
  certify::tape::Program program;
  std::span<const double> coordinates;
  std::span<const std::uint16_t> moved;
  int bits_of_power;  // a field wide enough for any power
  Lattice lattice;

  [[nodiscard]] bool fits() const { return moved.size() * static_cast<std::size_t>(bits_of_power) <= 64; }
  [[nodiscard]] std::uint64_t infinitesimal(std::size_t j) const {
    return std::uint64_t{1} << (j * static_cast<std::size_t>(bits_of_power));
  }
};

template <std::size_t N>
LargestTerm by_integers(const PerturbedFormula& q) {
  using Number = Modular<N>;
  const std::size_t arity = q.coordinates.size(), count = arity + q.program.instructions.size();
  std::array<Polynomial<Number>, 128> few;
  std::vector<Polynomial<Number>> many(count > few.size() ? count : 0);
  Polynomial<Number>* const value = many.empty() ? few.data() : many.data();

  Expansion<Number> expansion;
  const auto integer = [&](std::size_t i) -> Number {
    const OddForm form = odd_form(q.coordinates[i]);
    return {shifted<64 * N - 1>(form.mantissa, form.mantissa == 0 ? 0 : form.exponent - q.lattice.exponent).limb};
  };
  for (std::size_t i = 0; i < arity; ++i) value[i] = expansion.moved(integer(i), 0);
  std::uint64_t simple = 0;
  for (std::size_t j = 0; j < q.moved.size(); ++j) {
    value[q.moved[j]] = expansion.moved(integer(q.moved[j]), q.infinitesimal(j));
    simple += q.infinitesimal(j);
  }
  Polynomial<Number>* next = value + arity;
  for (const certify::tape::Instruction& step : q.program.instructions) {
    const Polynomial<Number> l = value[step.left], r = value[step.right];
    *next++ = step.operation == '*'   ? expansion.product(l, r)
              : step.operation == '-' ? expansion.template sum<true>(l, r)
                                      : expansion.template sum<false>(l, r);
  }
  const Polynomial<Number> result = next[-1];
  if (result.empty()) return {};
  const auto& [product, coefficient] = result.front();
  return {coefficient.sign(), static_cast<int>(product / q.infinitesimal(q.moved.size() - 1)), product == simple};
}

/// Any coordinates, formulas and numbers of infinitesimals.
LargestTerm by_dyadics(const PerturbedFormula& q) {
  using Number = Infinitesimal<BigDyadic>;
  std::vector<Number> value;
  for (const double x : q.coordinates) value.emplace_back(BigDyadic(x));
  for (std::size_t j = 0; j < q.moved.size(); ++j) {
    value[q.moved[j]] = Number::moved(BigDyadic(q.coordinates[q.moved[j]]), BigDyadic(1), j);
  }
  for (const certify::tape::Instruction& step : q.program.instructions) {
    const Number &l = value[step.left], &r = value[step.right];
    value.push_back(step.operation == '*' ? l * r : step.operation == '-' ? l - r : l + r);
  }
  const Number& result = value.back();
  if (result.terms().empty()) return {};
  const std::vector<std::uint32_t>& power = result.terms().begin()->first.power;
  const bool all = power.size() == q.moved.size();
  return {result.sign(), all ? static_cast<int>(power.back()) : 0,
          all && std::ranges::count(power, 1u) == std::ssize(power)};
}

/// The highest number that replaying the program by `make` comes to.
template <class Make>
int highest(certify::tape::Program program, int coordinate, Make make) {
  std::vector<int> value(program.arity, coordinate);
  value.reserve(program.arity + program.instructions.size());
  for (const certify::tape::Instruction& step : program.instructions)
    value.push_back(make(step, value[step.left], value[step.right]));
  return *std::ranges::max_element(value);
}

/// The highest degree that a step reaches, which no power in it exceeds.
int highest_degree(certify::tape::Program program) {
  return highest(program, 1, [](const certify::tape::Instruction& step, int l, int r) {
    return step.operation == '*' ? l + r : std::max(l, r);
  });
}

/// With moved coordinates below 2^bits, no coefficient reaches 2^this.
int coefficient_bits(certify::tape::Program program, int bits) {
  return highest(program, bits, [](const certify::tape::Instruction& step, int l, int r) {
    return step.operation == '*' ? l + r : std::max(l, r) + 1;
  });
}

}  // namespace

LargestTerm largest_term(certify::tape::Program program, bool homogeneous, std::span<const double> coordinates,
                         std::span<const std::uint16_t> moved) {
  PerturbedFormula q{program, coordinates, moved, 0, lattice_of(coordinates)};
  q.bits_of_power = static_cast<int>(std::bit_width(static_cast<unsigned>(highest_degree(program))));
  if (!homogeneous || !q.fits()) return by_dyadics(q);
  const int bits = coefficient_bits(program, q.lattice.bits + 1);
  if (bits < 128) return by_integers<2>(q);
  if (bits < 384) return by_integers<6>(q);
  return bits < 1024 ? by_integers<16>(q) : by_dyadics(q);
}

// One infinitesimal more at a time, and with it the larger ones, first few of them: what is left out is smaller.  A
// term that holds the new one once is larger than any with a power of it, though larger ones were left out of those.
// How many of the larger ones are taken doubles until it is all of them, and then the loop ends.
Sign expanded_sign(certify::tape::Program program, bool homogeneous, std::span<const double> coordinates,
                   std::span<const std::uint16_t> order, std::size_t known_zero) {
  std::vector<std::uint16_t> moved;
  for (std::size_t last = known_zero; last < order.size(); ++last) {
    for (std::size_t larger = 0, next = 1;; larger = std::min(next, last), next *= 2) {
      moved.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(larger));
      moved.push_back(order[last]);
      const LargestTerm t = largest_term(program, homogeneous, coordinates, moved);
      if (t.sign != Sign::zero && (t.last_power == 1 || larger == last)) return t.sign;
      if (larger == last) break;
    }
  }
  return Sign::zero;
}

}  // namespace plumb::certify::perturbation
