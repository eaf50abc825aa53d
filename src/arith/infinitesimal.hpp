// What is a formula's value when coordinates are moved by infinitesimals?  Polynomials in infinitesimals, as numbers
// that a formula can run over.
//
// There are infinitesimals e0, e1, e2, ..., all positive.  Each is smaller than every positive number made from those
// before it: e1 is below e0, e0^2, e0^3 and so on.
// Laws: exact, over an exact ring.  Of two products of infinitesimals that one is the smaller which has the higher
// power of the last infinitesimal in which they differ, whatever numbers they are multiplied by.  So the sign is that
// of the coefficient of the largest product that is left; zero only when nothing is left. A Ring has + - *, sign(), and
// zero as its default.
// Source: Edelsbrunner and Muecke, "Simulation of simplicity", 1990.
// Cost: a tree node and a vector for each term, so for oracles and last resorts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "plumb/arith/sign.hpp"

namespace plumb {

/// e0^power[0] e1^power[1] ...; the last power is not 0.
struct InfinitesimalProduct {
  std::vector<std::uint32_t> power;

  friend InfinitesimalProduct operator*(const InfinitesimalProduct& a, const InfinitesimalProduct& b) {
    const bool longer = a.power.size() > b.power.size();
    InfinitesimalProduct r = longer ? a : b;
    const std::vector<std::uint32_t>& other = (longer ? b : a).power;
    for (std::size_t i = 0; i < other.size(); ++i) r.power[i] += other[i];
    return r;
  }

  /// Orders the larger product first.
  struct LargerFirst {
    bool operator()(const InfinitesimalProduct& a, const InfinitesimalProduct& b) const {
      if (a.power.size() != b.power.size()) return a.power.size() < b.power.size();
      return std::lexicographical_compare(a.power.rbegin(), a.power.rend(), b.power.rbegin(), b.power.rend());
    }
  };
};

template <class Ring>
class Infinitesimal {
 public:
  using Terms = std::map<InfinitesimalProduct, Ring, InfinitesimalProduct::LargerFirst>;

  Infinitesimal() = default;
  explicit Infinitesimal(const Ring& value) { add({}, value); }

  /// value + one * e(number).
  static Infinitesimal moved(const Ring& value, const Ring& one, std::size_t number) {
    Infinitesimal r(value);
    InfinitesimalProduct e{std::vector<std::uint32_t>(number + 1)};
    e.power[number] = 1;
    r.add(e, one);
    return r;
  }

  [[nodiscard]] Sign sign() const { return terms_.empty() ? Sign::zero : terms_.begin()->second.sign(); }
  /// The terms that are not zero, largest first.
  [[nodiscard]] const Terms& terms() const { return terms_; }

  friend Infinitesimal operator+(const Infinitesimal& a, const Infinitesimal& b) {
    Infinitesimal r = a;
    for (const auto& [product, coefficient] : b.terms_) r.add(product, coefficient);
    return r;
  }
  friend Infinitesimal operator-(const Infinitesimal& a, const Infinitesimal& b) {
    Infinitesimal r = a;
    for (const auto& [product, coefficient] : b.terms_) r.add(product, Ring{} - coefficient);
    return r;
  }
  friend Infinitesimal operator*(const Infinitesimal& a, const Infinitesimal& b) {
    Infinitesimal r;
    for (const auto& [left, l] : a.terms_)
      for (const auto& [right, x] : b.terms_) r.add(left * right, l * x);
    return r;
  }

 private:
  void add(const InfinitesimalProduct& product, const Ring& coefficient) {
    const auto [at, is_new] = terms_.try_emplace(product, coefficient);
    if (!is_new) at->second = at->second + coefficient;
    if (at->second.sign() == Sign::zero) terms_.erase(at);
  }

  Terms terms_;
};

}  // namespace plumb
