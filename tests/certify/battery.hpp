// Which cases must every predicate get right, and do all its stages?  The shared part of the tests of certify/.
//
// Laws: case number i of a predicate and family is the same on every machine; a failure is shrunk and told as one case
// line that `plumb sign` replays.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "certify/argument_cases.hpp"
#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "certify/sanitized.hpp"
#include "oracle/oracle.hpp"
#include "plumb/degenerate.hpp"

namespace plumb::battery {

/// Cases for each predicate and family.
#if defined(PLUMB_LONG_TESTS)
inline constexpr std::uint64_t cases = 10'000'000;
#else
inline const std::uint64_t cases = sanitized ? 2'000 : 100'000;
#endif
/// Every how many cases the rationals judge (elsewhere the last stage does, which they have judged), and CGAL is asked;
/// odd, so that the special zero sets, every fourth case, get their turn.
#if defined(PLUMB_LONG_TESTS)
inline constexpr std::uint64_t rationals_every = 21, cgal_every = 201;
#else
inline constexpr std::uint64_t rationals_every = 1, cgal_every = 9;
#endif

/// All stages, in the order in which the chain asks them.
inline constexpr auto stages = [] {
  std::array<Stage, stage_names.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Stage>(i);
  return all;
}();

/// Is it one of the four, whose zeros are what the families are degenerate in?
inline bool is_classic(const CatalogEntry& e) {
  return std::ranges::any_of(classics(), [&](const CatalogEntry& c) { return c.name == e.name; });
}

/// What makes a classic predicate zero, all but the last being special cases: points of a line lie in a plane, points
/// of a plane or circle make the determinant of any sphere vanish.
inline std::span<const Degeneracy> zero_sets(const CatalogEntry& e) {
  static constexpr std::array flat2{Degeneracy::collinear};
  static constexpr std::array round2{Degeneracy::collinear, Degeneracy::cocircular};
  static constexpr std::array flat3{Degeneracy::collinear, Degeneracy::cocircular, Degeneracy::coplanar};
  static constexpr std::array round3{Degeneracy::collinear, Degeneracy::coplanar, Degeneracy::cocircular,
                                     Degeneracy::cospherical};
  // A polynomial of the least degree that the dimension allows vanishes on flats.
  const bool flat = e.degree <= e.dimension;
  if (e.dimension == 2) return flat ? std::span<const Degeneracy>(flat2) : round2;
  return flat ? std::span<const Degeneracy>(flat3) : round3;
}

/// A number for the cases of this predicate alone.
inline std::uint64_t start_of(const CatalogEntry& e) {
  std::uint64_t start = 0;
  for (const char c : e.name) start = start * 31 + static_cast<unsigned char>(c);
  return start;
}

/// Case number `index`; of a classic predicate every fourth is of a special zero set.
inline std::vector<double> coordinates_of(const CatalogEntry& e, Family family, std::uint64_t index) {
  if (!is_classic(e)) {
    Entropy entropy(start_of(e), index);
    std::vector<double> p(e.arity());
    fill_arguments(e, family, p, entropy);
    return p;
  }
  const auto sets = zero_sets(e);
  const Degeneracy degeneracy = index % 4 == 3 ? sets[index / 4 % sets.size()] : sets.back();
  Entropy entropy(static_cast<std::uint64_t>(e.degree * 100 + e.dimension * 10 + e.points), index);
  std::vector<double> p(e.arity());
  fill_points(family, degeneracy, e.dimension, p, entropy);
  return p;
}

inline std::string case_line(const CatalogEntry& e, std::span<const double> p) {
  return to_string(CaseLine{std::string(e.name), {p.begin(), p.end()}, Unsure{oracle::rational_sign(e.name, p)}});
}

/// Empty when every way of answering agrees with the oracle at p; otherwise who does not.
struct Judges {
  bool rationals = true, cgal = true;
};

inline std::string disagreement(const CatalogEntry& e, std::span<const double> p, Judges ask = {}) {
  const Sign truth = ask.rationals ? oracle::rational_sign(e.name, p) : e.ask(Stage::big_integer, p).value();
  const auto objection = [&](std::string_view who, Sign said) {
    return std::string(who) + " says " + to_char(said) +
           (ask.rationals ? ", rationals say " : ", the last stage says ") + to_char(truth);
  };
  const Decision decided = e.decide(p);
  if (decided.sign != truth) return objection("decide", decided.sign);
  bool first = true;
  for (const Stage stage : stages) {
    const Unsure<Sign> said = e.ask(stage, p);
    if (!said.certain()) continue;
    if (said.value() != truth) return objection(to_string(stage), said.value());
    if (first && stage != decided.stage) {
      return std::string(to_string(stage)) + " was certain, but " + std::string(to_string(decided.stage)) + " decided";
    }
    first = false;
  }
  if (first) return "no stage was certain";
  if (const auto said = e.ask_other_filter(p); said.certain() && said.value() != truth) {
    return objection("the other filter", said.value());
  }
  if (ask.cgal) {
    if (const auto said = oracle::cgal_sign(e.name, p); said && *said != truth) return objection("CGAL", *said);
  }
  return {};
}

/// A failure as people should read it: shrunk, with the line that replays it.
inline std::string report(const CatalogEntry& e, std::span<const double> p) {
  const auto fails = [&](std::span<const double> q) { return !disagreement(e, q).empty(); };
  const std::vector<double> least = shrink_coordinates({p.begin(), p.end()}, std::max(e.dimension, 1), fails, 5'000);
  return disagreement(e, least) + "\n  " + case_line(e, least) + "\nshrunk from\n  " + case_line(e, p);
}

}  // namespace plumb::battery
