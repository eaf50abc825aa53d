// How often is each method wrong on this mesh, and how long does it take?
//
// Laws: counts and worst cases depend on the mesh alone, not on threads or time.  Times are medians over blocks of
// decisions, all methods on the same block one after the other.
// Source: RTCD 11.2; cost: a few hundred nanoseconds a decision, microseconds with verification.
#pragma once

#include <array>
#include <string>

#include "plumb/arith/lattice.hpp"
#include "plumb/surface/read_mesh.hpp"
#include "plumb/surface/topology.hpp"
#include "progress.hpp"
#include "tally.hpp"

namespace plumb::tool {

struct MeshCheck {
  std::string name;
  LoadReport load;
  bool from_file = false;
  MeshStatistics statistics;
  Lattice lattice;
  EdgeAnswers edges;
  std::array<Comparison, kinds.size()> kind;

  /// The kinds that put their question to this predicate.
  [[nodiscard]] Comparison of_predicate(std::string_view predicate) const;
  [[nodiscard]] Comparison total() const;
};

/// Fills in what the mesh itself says: statistics, lattice, comparisons.  Verification takes every exact sign again in
/// rational arithmetic, or `verified_of_kind` evenly spread ones where a kind has more.
struct CheckSettings {
  bool verify = false;
  std::uint64_t verified_of_kind = 100'000;
};

/// The decisions that check_mesh will take, for a progress bar; each is one step of it.
void check_mesh(const TriangleMesh& mesh, const CheckSettings& settings, MeshCheck& check);

}  // namespace plumb::tool
