// What is a certificate with one thing changed?  Every number nudged, every index changed, what it claims, the order.
//
// Law: each mutant differs from the certificate.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plumb/query/certificate/certificate.hpp"

namespace plumb::certificate_laws {

template <class Proof>
struct Mutant {
  std::string name;
  Proof proof;
};

/// A little more, a little less, turned round, nothing, and twice as much.
inline std::vector<Rational> nudged(const Rational& x) {
  const Rational little(std::ldexp(1.0, -70));
  std::vector<Rational> all{x + little, x - little, -x, Rational(0), x * Rational(2)};
  std::erase(all, x);
  return all;
}

template <class Proof>
class MutantsOf {
 public:
  explicit MutantsOf(const Proof& proof) : proof_(proof) {
    directions();
    pairs();
    if constexpr (requires { proof.claim; }) {
      for (int claim = -2; claim <= 3; ++claim) {
        if (claim != static_cast<int>(proof.claim))
          add("claim " + std::to_string(claim), [&](Proof& p) { p.claim = static_cast<Claim>(claim); });
      }
    } else {
      for (const Rational& x : nudged(proof.exact.square)) add("square", [&](Proof& p) { p.exact.square = x; });
      for (const Rational& x : nudged(proof.exact.inset)) add("inset", [&](Proof& p) { p.exact.inset = x; });
      for (const double x :
           {std::nextafter(proof.distance, HUGE_VAL), std::nextafter(proof.distance, -HUGE_VAL), -proof.distance,
            std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        add("distance " + std::to_string(x), [&](Proof& p) { p.distance = x; });
    }
  }

  [[nodiscard]] const std::vector<Mutant<Proof>>& all() const { return all_; }

 private:
  template <class Change>
  void add(std::string name, Change change) {
    Mutant<Proof> m{std::move(name), proof_};
    change(m.proof);
    all_.push_back(std::move(m));
  }

  void directions() {
    if (!proof_.direction) {
      add("a direction", [](Proof& p) { p.direction = ExactVector3{1, 0, 0}; });
      return;
    }
    const ExactVector3 n = *proof_.direction;
    add("no direction", [](Proof& p) { p.direction.reset(); });
    add("direction zero", [](Proof& p) { p.direction = ExactVector3{0, 0, 0}; });
    add("direction turned", [&](Proof& p) { p.direction = ExactVector3{-n.x, -n.y, -n.z}; });
    const Rational third(1, 3);
    add("direction shorter", [&](Proof& p) { p.direction = ExactVector3{n.x * third, n.y * third, n.z * third}; });
    for (const Rational& x : nudged(n.x)) add("direction.x", [&](Proof& p) { p.direction->x = x; });
    for (const Rational& y : nudged(n.y)) add("direction.y", [&](Proof& p) { p.direction->y = y; });
    for (const Rational& z : nudged(n.z)) add("direction.z", [&](Proof& p) { p.direction->z = z; });
  }

  void pairs() {
    const std::size_t n = proof_.pairs.size();
    add("one pair more", [](Proof& p) { p.pairs.push_back({0, 0, Rational(1)}); });
    add("one of no weight", [](Proof& p) { p.pairs.push_back({0, 0, Rational(0)}); });
    for (std::size_t i = 0; i < n; ++i) {
      const std::string name = "pair " + std::to_string(i);
      const WeightedPair pair = proof_.pairs[i];
      for (const Rational& w : nudged(pair.weight)) add(name + ": weight", [&](Proof& p) { p.pairs[i].weight = w; });
      for (const std::uint32_t k : {pair.of_a + 1, pair.of_a - 1})
        add(name + ": of_a", [&](Proof& p) { p.pairs[i].of_a = k; });
      for (const std::uint32_t k : {pair.of_b + 1, pair.of_b - 1})
        add(name + ": of_b", [&](Proof& p) { p.pairs[i].of_b = k; });
      if (pair.of_a != pair.of_b)
        add(name + ": turned", [&](Proof& p) { std::swap(p.pairs[i].of_a, p.pairs[i].of_b); });
      add(name + ": left out", [&](Proof& p) { p.pairs.erase(p.pairs.begin() + static_cast<std::ptrdiff_t>(i)); });
      add(name + ": in halves", [&](Proof& p) {
        p.pairs[i].weight = pair.weight / Rational(2);
        p.pairs.push_back(p.pairs[i]);
      });
      for (std::size_t j = i + 1; j < n; ++j) {
        add(name + ": in another order", [&](Proof& p) { std::swap(p.pairs[i], p.pairs[j]); });
        if (pair.weight != proof_.pairs[j].weight)
          add(name + ": weights swapped", [&](Proof& p) { std::swap(p.pairs[i].weight, p.pairs[j].weight); });
        if (pair.of_a != proof_.pairs[j].of_a)
          add(name + ": of_a swapped", [&](Proof& p) { std::swap(p.pairs[i].of_a, p.pairs[j].of_a); });
      }
    }
  }

  Proof proof_;
  std::vector<Mutant<Proof>> all_;
};

}  // namespace plumb::certificate_laws
