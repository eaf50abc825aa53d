// What does the catalog say of a formula?  Everything that is derived from it, as one entry.
//
// A part of the catalog is one list of the manifest, compiled by itself together with the exact stages of its formulas:
// the parts can be built side by side.
// Cost: compile time, for each formula its filter and its small integers.
#pragma once

#include <algorithm>
#include <array>

#include "certify/catalog.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/certify/plan.hpp"

namespace plumb {

template <Formula F>
requires in_library<F> Decision decide_exactly(const Coordinates<F>& p) { return decide_by_stages<F>(p); }

}  // namespace plumb

namespace plumb::certify::catalog_part {

template <Formula F>
Coordinates<F> copy(std::span<const double> coordinates) {
  Coordinates<F> p{};
  std::ranges::copy(coordinates.first(p.size()), p.begin());
  return p;
}

inline Unsure<Sign> of_filter(int s) { return s == 0 ? Unsure<Sign>{} : Unsure{static_cast<Sign>(s)}; }

template <Formula F>
constexpr bool asks(Stage stage) {
  switch (stage) {
    case Stage::integer:
      return is_homogeneous<F>;
    case Stage::wide_integer:
      return is_homogeneous<F> && has_wide_stages<F>;
    case Stage::long_double:
    case Stage::interval:
      return has_wide_stages<F>;
    default:
      return true;
  }
}

template <Formula F>
Unsure<Sign> ask(Stage stage, std::span<const double> coordinates) {
  Coordinates<F> p = copy<F>(coordinates);
  if constexpr (has_wide_stages<F>) {
    if (stage != Stage::filter && certify::Levels<F>(p).are_low()) {  // raised after a look for structural zeros
      if (stage == Stage::integer && structural_zero_sign<F>(p).certain()) return {};
      p = certify::raised<F>(p);
    }
  }
  switch (stage) {
    case Stage::filter:
      return of_filter(filter<F>(p));
    case Stage::structural_zero:
      if constexpr (has_wide_stages<F>) {
        if (const auto s = repeated_argument_sign<F>(p, certify::Levels<F>(p)); s.certain()) return s;
      }
      return structural_zero_sign<F>(p);
    case Stage::integer:
      if constexpr (asks<F>(Stage::integer)) return integer_sign<F>(p);
      break;
    case Stage::long_double:
      if constexpr (asks<F>(Stage::long_double)) return long_double_sign<F>(p);
      break;
    case Stage::wide_integer:
      if constexpr (asks<F>(Stage::wide_integer)) return wide_integer_sign<F>(p);
      break;
    case Stage::interval:
      if constexpr (asks<F>(Stage::interval)) return interval_sign<F>(p);
      break;
    case Stage::big_integer:
      return Unsure{big_integer_sign(certify::tape::program<F>(), p)};
  }
  return {};
}

template <Formula F>
Decision decide_with_stage(std::span<const double> coordinates) {
  struct Last {
    Stage stage{};
    void decided(Stage s) { stage = s; }
  } last;
  const Sign s = decide<F>(copy<F>(coordinates), last);
  return {s, last.stage};
}

template <Formula F>
Unsure<Sign> ask_other_filter(std::span<const double> coordinates) {
  if constexpr (!filter_is_magnitude<F>) {
    return of_filter(magnitude_filter<F>(copy<F>(coordinates)));
  } else if constexpr (TakesPoints<F> && is_homogeneous<F>) {
    return of_filter(largest_filter<F>(copy<F>(coordinates)));
  } else {
    return {};
  }
}

template <Formula F>
constexpr PlannedBits planned_bits() {
  if constexpr (is_homogeneous<F>)
    return {certify::planned::plain_double<F>, certify::planned::one_word_factors<F>, certify::planned::modulo_word<F>,
            certify::planned::two_words<F>, certify::planned::bounded<F> ? certify::planned::unbounded : -1};
  return {-1, -1, -1, -1, -1};
}

template <Formula F>
CatalogEntry entry() {
  CatalogEntry e{};
  e.name = F::name;
  e.arguments = arguments<F>;
  e.axes = axes<F>;
  if constexpr (TakesPoints<F>) {
    e.points = F::points;
    e.dimension = F::dimension;
  }
  e.homogeneous = is_homogeneous<F>;
  e.degree = term_degrees<F>().highest;
  e.filter_constant = filter_constant<F>();
  e.filter_is_magnitude = filter_is_magnitude<F>;
  for (std::size_t i = 0; i < e.asks.size(); ++i) e.asks[i] = asks<F>(static_cast<Stage>(i));
  e.planned_bits = planned_bits<F>();
  e.program = certify::tape::program<F>();
  e.value_bits = value_bits<F>;
  e.decide = decide_with_stage<F>;
  e.ask = ask<F>;
  e.ask_other_filter = ask_other_filter<F>;
  return e;
}

}  // namespace plumb::certify::catalog_part

#define PLUMB_CATALOG_STAGES(formula) \
  template Decision decide_exactly<predicates::formula>(const Coordinates<predicates::formula>&);
#define PLUMB_CATALOG_ENTRY(formula) entry<predicates::formula>(),

/// Compiles the exact stages of a list of the manifest, and defines certify::catalog_part::name() as its entries.
#define PLUMB_CATALOG_PART(name, list)                            \
  namespace plumb {                                               \
  list(PLUMB_CATALOG_STAGES) namespace certify::catalog_part {    \
    std::span<const CatalogEntry> name() {                        \
      static const std::array entries{list(PLUMB_CATALOG_ENTRY)}; \
      return entries;                                             \
    }                                                             \
  }                                                               \
  }
