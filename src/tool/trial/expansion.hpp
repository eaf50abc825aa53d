// What do expansions of doubles cost, and where do they fail?  A value as a sum of doubles that do not overlap,
// smallest first.
//
// Exact while no product of components overflows or underflows; components that are zero are left out, so values of few
// bits far apart stay short.  Memory comes from an arena that the evaluation resets.
// Source: Shewchuk 1997 (sums by merging, products by scaling with each component).
// Cost: a few operations a component for sums; products cost the product of the lengths.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb::tool::trial {

class Expansion {
 public:
  static void reset() { used() = 0; }

  Expansion() = default;
  explicit Expansion(double x) : at_(take(1)) { push(x); }
  /// a - b, exactly.
  static Expansion difference(double a, double b) {
    const Rounded d = two_sum(a, -b);
    Expansion r;
    r.at_ = take(2);
    r.push(d.error);
    r.push(d.value);
    return r;
  }

  [[nodiscard]] Sign sign() const { return size_ == 0 ? Sign::zero : sign_of_number(at_[size_ - 1]); }

  [[nodiscard]] double estimate() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += at_[i];
    return sum;
  }

  friend Expansion operator+(const Expansion& a, const Expansion& b) { return merged(a, b, 1); }
  friend Expansion operator-(const Expansion& a, const Expansion& b) { return merged(a, b, -1); }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    if (a.size_ < b.size_) return b * a;
    Expansion sum;
    for (std::size_t i = 0; i < b.size_; ++i) sum = i == 0 ? scaled(a, b.at_[i]) : sum + scaled(a, b.at_[i]);
    return sum;
  }

 private:
  static constexpr std::size_t capacity = 1
                                          << 20;  // more than insphere takes at its worst; branching code may ask more
  static std::size_t& used() {
    thread_local std::size_t n = 0;
    return n;
  }
  static double* take(std::size_t n) {
    if (n > capacity - used()) throw std::length_error("an expansion grew beyond its arena");
    thread_local const std::unique_ptr<double[]> arena(new double[capacity]);
    double* const p = arena.get() + used();
    used() += n;
    return p;
  }
  void push(double x) {
    at_[size_] = x;
    size_ += x != 0;
  }

  static Expansion merged(const Expansion& a, const Expansion& b, double sign) {
    if (a.size_ == 0 && b.size_ == 0) return {};
    Expansion r;
    r.at_ = take(a.size_ + b.size_);
    std::size_t i = 0, j = 0;
    const auto next = [&] {
      if (j == b.size_ || (i < a.size_ && __builtin_fabs(a.at_[i]) < __builtin_fabs(b.at_[j]))) return a.at_[i++];
      return sign * b.at_[j++];
    };
    double sum = next();
    while (i < a.size_ || j < b.size_) {
      const Rounded s = two_sum(sum, next());
      r.push(s.error);
      sum = s.value;
    }
    r.push(sum);
    return r;
  }

  static Expansion scaled(const Expansion& a, double x) {
    Expansion r;
    r.at_ = take(2 * a.size_);
    const Rounded first = two_product(a.at_[0], x);
    r.push(first.error);
    double sum = first.value;
    for (std::size_t i = 1; i < a.size_; ++i) {
      const Rounded product = two_product(a.at_[i], x), low = two_sum(sum, product.error);
      r.push(low.error);
      const Rounded high = two_sum(product.value, low.value);
      r.push(high.error);
      sum = high.value;
    }
    r.push(sum);
    return r;
  }

  double* at_ = nullptr;
  std::size_t size_ = 0;
};

template <Formula F>
Sign expansion_sign(const Coordinates<F>& p) {
  Expansion::reset();
  return evaluate<F>([&](std::size_t i) { return Expansion(p[i]); }).sign();
}

}  // namespace plumb::tool::trial
