// What must hold of any bytes that are read as the points of a predicate.
//
// Laws: a NaN or an infinity is refused, and no filter trusts it; otherwise every way of answering (the chain, each
// stage alone, the other filter, the tape over integers) tells the sign that the formula has over rationals, the chain
// names the first stage that is certain, and the case survives being written as a case line.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <vector>

#include "certify/argument_cases.hpp"
#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Odd first byte: a case of any family, aimed at any degeneracy; even: the doubles as they lie in memory.
inline std::vector<double> coordinates_from(const CatalogEntry& e, Bytes bytes) {
  std::vector<double> p(e.arity());
  if (bytes.empty()) return p;
  const bool family = bytes[0] % 2 == 1;
  bytes = bytes.subspan(1);
  if (family) {
    Entropy entropy = Entropy::from_bytes(bytes);
    const Family which = any_family(entropy);
    if (e.dimension == 2 || e.dimension == 3) {
      fill_points(which, degeneracies[entropy.below(degeneracies.size())], e.dimension, p, entropy);
    } else {
      battery::fill_arguments(e, which, p, entropy);
    }
  } else if (!bytes.empty()) {
    std::memcpy(p.data(), bytes.data(), std::min(bytes.size(), p.size() * sizeof(double)));
  }
  return p;
}

struct Checked {
  const CatalogEntry& e;
  const std::vector<double>& p;

  void require(bool holds, std::string_view what) const {
    if (holds) return;
    std::cerr << "does not hold: " << what << "\n" << to_string(CaseLine{std::string(e.name), p, {}}) << std::endl;
    std::abort();
  }

  void refused() const {
    try {
      e.decide(p);
    } catch (const NonFinite&) {
      require(!e.ask(Stage::filter, p).certain() && !e.ask_other_filter(p).certain(), "no filter trusts a NaN");
      return;
    }
    require(false, "what is no real number is refused");
  }

  void agreed(Sign truth) const {
    const Decision decided = e.decide(p);
    require(decided.sign == truth, "the chain tells the sign");
    bool first = true;
    for (std::size_t i = 0; i < stage_names.size(); ++i) {
      const auto stage = static_cast<Stage>(i);
      const Unsure<Sign> said = e.ask(stage, p);
      if (!said.certain()) continue;
      require(said.value() == truth, to_string(stage));
      require(!first || decided.stage == stage, "the first certain stage decides");
      first = false;
    }
    require(!first, "some stage is certain");
    const Unsure<Sign> other = e.ask_other_filter(p);
    require(!other.certain() || other.value() == truth, "the other filter");
    const CaseLine line{std::string(e.name), p, Unsure{truth}};
    require(parse_case_line(to_string(line)) == line, "a case line comes back");
  }
};

/// Tries one predicate; truth(p) is its sign by rationals.
template <class Truth>
int run(const CatalogEntry& e, Bytes bytes, const Truth& truth) {
  const std::vector<double> p = coordinates_from(e, bytes);
  const Checked checked{e, p};
  if (!std::ranges::all_of(p, [](double x) { return std::isfinite(x); })) {
    checked.refused();
  } else {
    checked.agreed(truth(p));
  }
  return 0;
}

template <Formula F>
int run(Bytes bytes) {
  return run(*find_predicate(F::name), bytes, [](const std::vector<double>& p) {
    return evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).sign();
  });
}

}  // namespace plumb::fuzz
