// On which inputs is speed measured?  The same classes everywhere: every family of degenerate/, aimed at the question
// of the predicate, and the exactly degenerate lattice of 20-bit coordinates.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/degenerate/exact.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::bench {

constexpr std::size_t cases = 8192;  // fits the second-level cache, and is too long for branch predictors to learn

constexpr Degeneracy question_of(std::string_view predicate) {
  if (predicate == "orient2d") return Degeneracy::collinear;
  if (predicate == "orient3d") return Degeneracy::coplanar;
  return predicate == "incircle" ? Degeneracy::cocircular : Degeneracy::cospherical;
}

inline std::vector<std::string> input_classes() {
  std::vector<std::string> names{"lattice20"};
  for (const FamilyInfo& f : families) names.emplace_back(f.name);
  return names;
}

/// `cases` sets of arity coordinates each, one after the other.
inline std::vector<double> inputs(std::string_view predicate, std::size_t arity, int dimension,
                                  const std::string& name) {
  std::vector<double> all(cases * arity);
  for (std::size_t i = 0; i < cases; ++i) {
    Entropy entropy(2026, i);
    const std::span<double> one(&all[i * arity], arity);
    if (name == "lattice20") {
      fill_exact(question_of(predicate), dimension, 20, one, entropy);
    } else {
      fill_points(*family_named(name), question_of(predicate), dimension, one, entropy);
    }
  }
  return all;
}

}  // namespace plumb::bench
