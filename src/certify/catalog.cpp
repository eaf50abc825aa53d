#include "plumb/certify/catalog.hpp"

#include <algorithm>

#include "plumb/certify/decide.hpp"

namespace plumb {
namespace {

template <Formula F>
Coordinates<F> copy(std::span<const double> coordinates) {
  Coordinates<F> p{};
  std::ranges::copy(coordinates.first(p.size()), p.begin());
  return p;
}

Unsure<Sign> of_filter(int s) { return s == 0 ? Unsure<Sign>{} : Unsure{static_cast<Sign>(s)}; }

template <Formula F>
Unsure<Sign> ask(Stage stage, std::span<const double> coordinates) {
  const Coordinates<F> p = copy<F>(coordinates);
  switch (stage) {
    case Stage::filter:
      return of_filter(filter<F>(p));
    case Stage::structural_zero:
      return structural_zero_sign<F>(p);
    case Stage::integer:
      return integer_sign<F>(p, largest_pattern(p));
    case Stage::interval:
      return interval_sign<F>(p);
    case Stage::wide_integer:
      return wide_integer_sign<F>(p);
    case Stage::big_integer:
      return Unsure{big_integer_sign(program<F>(), p)};
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
  const Coordinates<F> p = copy<F>(coordinates);
  return of_filter(filter_is_magnitude<F> ? largest_filter<F>(p) : magnitude_filter<F>(p));
}

template <Formula F>
CatalogEntry entry() {
  return {F::name,      F::points,     F::dimension,         degree<F>(), filter_constant<F>(),
          program<F>(), value_bits<F>, decide_with_stage<F>, ask<F>,      ask_other_filter<F>};
}

}  // namespace

std::span<const CatalogEntry> catalog() {
#define PLUMB_ENTRY(formula) entry<predicates::formula>(),
  static const std::array entries{PLUMB_PREDICATES(PLUMB_ENTRY)};
#undef PLUMB_ENTRY
  return entries;
}

const CatalogEntry* find_predicate(std::string_view name) {
  const auto found = std::ranges::find(catalog(), name, &CatalogEntry::name);
  return found == catalog().end() ? nullptr : &*found;
}

}  // namespace plumb
