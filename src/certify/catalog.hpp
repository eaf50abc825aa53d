// Which predicates are there, and what is known of each?  The manifest at run time.
//
// Tests, fuzz targets and the program reach every predicate of the manifest through this table, by name or in turn.
// Law: entry i is formula i of PLUMB_PREDICATES (predicates/manifest.hpp).
// Cost: one indirect call more than the direct one.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "plumb/certify/decision.hpp"
#include "plumb/certify/detail/tape.hpp"
#include "plumb/certify/plan.hpp"

namespace plumb {

struct CatalogEntry {
  std::string_view name;
  std::span<const int> arguments;             // how many coordinates each argument has
  std::string_view axes;                      // how the coordinates of an argument are called
  int points, dimension;                      // when all are points of one dimension, otherwise 0
  bool homogeneous;                           // all terms have one degree
  int degree;                                 // of the terms, or of the highest ones
  double filter_constant;                     // in units of one, about `roundings` times 2^-53
  bool filter_is_magnitude;                   // filter A, otherwise filter B
  std::array<bool, stage_names.size()> asks;  // which stages the chain has for it
  PlannedBits planned_bits;
  certify::tape::Program program;
  /// Bits that the exact value takes when the coordinates are integers of this many bits.
  int (*value_bits)(int coordinate_bits);
  /// Sign and stage; throws NonFinite.  As many coordinates as arity(), argument after argument.
  Decision (*decide)(std::span<const double> coordinates);
  /// What one stage alone answers, nothing where the chain does not have it; finite coordinates.
  Unsure<Sign> (*ask)(Stage stage, std::span<const double> coordinates);
  /// What the filter that the chain does not use for this predicate answers, where it could.
  Unsure<Sign> (*ask_other_filter)(std::span<const double> coordinates);

  [[nodiscard]] std::size_t arity() const { return program.arity; }
};

std::span<const CatalogEntry> catalog();

/// The first four: PLUMB_CLASSICS.
std::span<const CatalogEntry> classics();

/// nullptr when there is no predicate of that name.
const CatalogEntry* find_predicate(std::string_view name);

}  // namespace plumb
