// Which predicates are there, and what is known of each?  The manifest at run time.
//
// Tests, fuzz targets and the program reach every predicate of the manifest through this table, by name or in turn.
// Law: entry i is line i of predicates/manifest.hpp.  Cost: one indirect call more than the direct one.
#pragma once

#include <span>
#include <string_view>

#include "plumb/arith/tape.hpp"
#include "plumb/certify/decision.hpp"

namespace plumb {

struct CatalogEntry {
  std::string_view name;
  int points, dimension;
  int degree;
  double filter_constant;  // in units of one, about `roundings` times 2^-53
  Program program;
  /// Bits that the exact value takes when the coordinates are integers of this many bits.
  int (*value_bits)(int coordinate_bits);
  /// Sign and stage; throws NonFinite.  As many coordinates as points * dimension, point after point.
  Decision (*decide)(std::span<const double> coordinates);
  /// What one stage alone answers; finite coordinates.
  Unsure<Sign> (*ask)(Stage stage, std::span<const double> coordinates);
  /// What the filter that the chain does not use for this predicate answers.
  Unsure<Sign> (*ask_other_filter)(std::span<const double> coordinates);

  [[nodiscard]] std::size_t arity() const { return static_cast<std::size_t>(points * dimension); }
};

std::span<const CatalogEntry> catalog();

/// nullptr when there is no predicate of that name.
const CatalogEntry* find_predicate(std::string_view name);

}  // namespace plumb
