// What is the perturbed sign?  The definition, taken by its word: every coordinate is moved, the polynomial is expanded
// in all infinitesimals over GMP's rationals, and the terms are sorted.
//
// Law: shares nothing with the library but the formula.
// Cost: microseconds for orient2d, tens of milliseconds for insphere.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "plumb/arith/big.hpp"
#include "plumb/certify/formula.hpp"

namespace plumb::oracle {

/// Terms by the powers of the infinitesimals in them, the power of the smallest first; in the order of a map the
/// largest term comes first, and every term is beyond all multiples of those behind it.
struct Expanded {
  std::map<std::vector<int>, mpq_class> terms;

  void add(const std::vector<int>& powers, const mpq_class& by) {
    mpq_class& c = terms[powers];
    c += by;
    if (c == 0) terms.erase(powers);
  }
  friend Expanded operator+(Expanded a, const Expanded& b) {
    for (const auto& [powers, c] : b.terms) a.add(powers, c);
    return a;
  }
  friend Expanded operator-(Expanded a, const Expanded& b) {
    for (const auto& [powers, c] : b.terms) a.add(powers, -c);
    return a;
  }
  friend Expanded operator*(const Expanded& a, const Expanded& b) {
    Expanded r;
    for (const auto& [left, l] : a.terms) {
      for (const auto& [right, x] : b.terms) {
        std::vector<int> powers(left.size());
        for (std::size_t i = 0; i < powers.size(); ++i) powers[i] = left[i] + right[i];
        r.add(powers, l * x);
      }
    }
    return r;
  }
  [[nodiscard]] Sign sign() const { return terms.empty() ? Sign::zero : sign_of_number(sgn(terms.begin()->second)); }
};

/// How many coordinates have a larger infinitesimal than coordinate i.
template <Formula F, class Indices>
std::array<std::size_t, arity<F>> ranks(const Indices& indices) {
  std::array<std::size_t, arity<F>> rank{};
  std::vector<std::size_t> by_index(indices.size());
  std::iota(by_index.begin(), by_index.end(), std::size_t{0});
  std::ranges::sort(by_index, {}, [&](std::size_t a) { return indices[a]; });
  std::size_t next = 0;
  for (const std::size_t a : by_index) {
    std::size_t first = 0;
    for (std::size_t b = 0; b < a; ++b) first += static_cast<std::size_t>(arguments<F>[b]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(arguments<F>[a]); ++k) rank[first + k] = next++;
  }
  return rank;
}

template <Formula F, class Indices>
Sign expanded_sign(const Coordinates<F>& p, const Indices& indices) {
  const auto rank = ranks<F>(indices);
  return evaluate<F>([&](std::size_t i) {
           Expanded x;
           x.add(std::vector<int>(arity<F>), mpq_class(p[i]));
           std::vector<int> own(arity<F>);
           own[arity<F> - 1 - rank[i]] = 1;
           x.add(own, 1);
           return x;
         })
      .sign();
}

}  // namespace plumb::oracle
