// How does code that branches run in the integers that the inputs' lattice needs?  In 64 bits, in 128, or not at all.
//
// A first run, which is not measured, follows the code over each question with numbers that know how many bits the
// lattice lets them grow to; the run that is measured takes the same ways in plain integers, which that proves wide
// enough.
// Laws: (1) no integer overflows; what more than 128 bits may be needed for is not asked; (2) the answers are those of
// the code in numbers that do not round: for code that adds and multiplies alone, and is right in such numbers.
// Source: RTCD 11.5.
// Cost: what is measured.
#pragma once

#include <bit>
#include <cstdint>
#include <stdexcept>

#include "lab/trial/float_methods.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb::lab::trial {

/// A coordinate as a multiple of the lattice's unit; for a lattice of fewer than 127 bits.
inline Int128 on_lattice(double x, const Lattice& lattice) {
  const OddForm f = odd_form(x);
  return f.mantissa == 0
             ? 0
             : static_cast<Int128>(f.mantissa) * (static_cast<Int128>(1) << (f.exponent - lattice.exponent));
}

/// An integer, and the bits that numbers so made of the lattice's may take; throws std::overflow_error beyond 127.
class GrowingInteger {
 public:
  GrowingInteger(Int128 x = 0)  // NOLINT: an integer is one
      : GrowingInteger(x, static_cast<int>(std::bit_width(static_cast<UInt128>(x < 0 ? -x : x)))) {}
  static GrowingInteger input(Int128 x, int bits) { return {x, bits}; }
  static int& most() {
    thread_local int bits = 0;
    return bits;
  }

  friend GrowingInteger operator+(const GrowingInteger& a, const GrowingInteger& b) {
    const int bits = grown(std::max(a.bits_, b.bits_) + 1);
    return {a.value_ + b.value_, bits};
  }
  friend GrowingInteger operator-(const GrowingInteger& a, const GrowingInteger& b) { return a + -b; }
  friend GrowingInteger operator-(const GrowingInteger& a) { return {-a.value_, a.bits_}; }
  friend GrowingInteger operator*(const GrowingInteger& a, const GrowingInteger& b) {
    const int bits = grown(a.bits_ + b.bits_);
    return {a.value_ * b.value_, bits};
  }
  friend auto operator<=>(const GrowingInteger& a, const GrowingInteger& b) { return a.value_ <=> b.value_; }
  friend bool operator==(const GrowingInteger& a, const GrowingInteger& b) { return a.value_ == b.value_; }

 private:
  GrowingInteger(Int128 x, int bits) : value_(x), bits_(bits) {}
  static int grown(int bits) {
    if (bits > 127) throw std::overflow_error("an integer grew beyond 128 bits");
    most() = std::max(most(), bits);
    return bits;
  }
  Int128 value_;
  int bits_;
};

/// The bits that the algorithm may need for one of the questions; more than 127 where those do not suffice.
template <std::size_t N, class Algorithm>
int bits_needed(const std::vector<std::array<Int128, N>>& questions, int lattice_bits, const Algorithm& algorithm) {
  GrowingInteger::most() = lattice_bits;
  try {
    for (const auto& q : questions) {
      std::array<GrowingInteger, N> grown;
      std::ranges::transform(q, grown.begin(), [=](Int128 x) { return GrowingInteger::input(x, lattice_bits); });
      algorithm(grown, GrowingInteger());
    }
  } catch (const std::overflow_error&) {
    return 128;
  }
  return GrowingInteger::most();
}

template <class Int, std::size_t N, class Algorithm>
std::unique_ptr<Round> in_integers(const std::vector<std::array<Int128, N>>& questions, Algorithm) {
  std::vector<std::array<Int, N>> all(questions.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    std::ranges::transform(questions[i], all[i].begin(), [](Int128 x) { return static_cast<Int>(x); });
  return one_by_one(std::move(all), [](const std::array<Int, N>& q) { return Algorithm{}(q, Int(0)); });
}

template <std::size_t N, class Algorithm>
Method lattice_method(Algorithm algorithm) {
  return {"plan", "ours, the common code in the integers of 64 or 128 bits that the lattice of all inputs needs",
          [algorithm](std::span<const double> questions, const Scene& scene) -> std::unique_ptr<Round> {
            if (scene.lattice.bits > 126) return nullptr;
            std::vector<std::array<Int128, N>> all(questions.size() / N);
            for (std::size_t i = 0; i < questions.size(); ++i)
              all[i / N][i % N] = on_lattice(questions[i], scene.lattice);
            const int bits = bits_needed(all, scene.lattice.bits, algorithm);
            if (bits > 127) return nullptr;
            return bits > 63 ? in_integers<Int128>(all, algorithm) : in_integers<std::int64_t>(all, algorithm);
          }};
}

}  // namespace plumb::lab::trial
