// Any bytes as points with indices, of any of the classic four predicates, perturbed.
//
// Laws: never zero; the exact sign where that is not zero; the sign of the expansion, by the library's integers and by
// its number type over rationals; swapping two points flips it; only the order of the indices matters.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "arith/infinitesimal.hpp"
#include "certify/case_line.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::fuzz {
namespace {

template <Formula F>
struct Question {
  static constexpr auto axes = static_cast<std::size_t>(F::dimension);
  Coordinates<F> p{};
  Indices<F> indices{};

  void require(bool holds, std::string_view what) const {
    if (holds) return;
    std::cerr << "does not hold: " << what << "\n"
              << to_string(CaseLine{std::string(F::name), {p.begin(), p.end()}, {}}) << " # indices";
    for (const std::uint64_t i : indices) std::cerr << " " << i;
    std::cerr << std::endl;
    std::abort();
  }

  [[nodiscard]] Sign sign() const { return decide<F>(perturbed, p, indices); }

  void swap(std::size_t i, std::size_t k) {
    std::swap_ranges(&p[axes * i], &p[axes * i] + axes, &p[axes * k]);
    std::swap(indices[i], indices[k]);
  }

  /// Coordinates by the size of their infinitesimals.
  [[nodiscard]] std::array<std::uint16_t, arity<F>> order() const {
    std::array<std::uint16_t, arity<F>> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint16_t>(i);
    std::ranges::stable_sort(all, {}, [this](std::uint16_t i) { return indices[i / axes]; });
    return all;
  }

  void check() const {
    const Sign s = sign(), exact = decide<F>(p);
    require(s != Sign::zero, "never zero");
    require(exact == Sign::zero || s == exact, "the exact sign is kept");
    const auto by_size = order();
    require(certify::perturbation::expanded_sign(certify::tape::program<F>(), true, p, by_size) == s,
            "the expansion agrees");
    if constexpr (F::points < 5) {
      using Number = Infinitesimal<BigRational>;
      const Number value = evaluate<F>([&](std::size_t i) {
        const auto rank = static_cast<std::size_t>(std::ranges::find(by_size, i) - by_size.begin());
        return Number::moved(big_rational(p[i]), big_rational(1), rank);
      });
      require(value.sign() == s, "the number type agrees");
    }
    for (std::size_t i = 1; i < indices.size(); ++i) {
      Question other = *this;
      other.swap(i - 1, i);
      require(other.sign() == -s, "a swap flips the sign");
    }
    Question ranked = *this;
    for (std::size_t j = 0; j < by_size.size(); ++j) ranked.indices[by_size[j] / axes] = j / axes;
    require(ranked.sign() == s, "only the order of the indices matters");
  }
};

template <Formula F>
void ask(Entropy& e) {
  Question<F> q;
  for (std::size_t i = 0; i < q.indices.size(); ++i) q.indices[i] = e.below(256) << 8 | i;
  switch (e.below(3)) {
    case 0:  // a small grid
      for (double& x : q.p) x = static_cast<double>(e.within(3));
      break;
    case 1:
      fill_points(any_family(e), degeneracies[e.below(degeneracies.size())], F::dimension, q.p, e);
      break;
    default: {  // coordinates of a few values of any kind
      std::array<double, 4> values{};
      for (double& x : values) x = extreme_coordinate(e);
      for (double& x : q.p) x = values[e.below(values.size())];
    }
  }
  q.check();
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy e = Entropy::from_bytes({data, size});
  switch (e.below(4)) {
    case 0:
      fuzz::ask<predicates::Orient2d>(e);
      break;
    case 1:
      fuzz::ask<predicates::Orient3d>(e);
      break;
    case 2:
      fuzz::ask<predicates::InCircle>(e);
      break;
    default:
      fuzz::ask<predicates::InSphere>(e);
  }
  return 0;
}
