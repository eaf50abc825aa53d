// How often is each method wrong on this mesh, and how long does it take?
//
// Laws: counts and worst cases depend on the mesh and the settings alone, not on threads or time.  The inexact methods
// are asked first, of a sample where the mesh is big (decision_sample.hpp); then the exact ones, of every decision.
// Times are medians over blocks of decisions, the methods on the same block one after the other.
// Source: RTCD 11.2.
// Cost: some 2 us a decision of the sample, 0.2 us of the others, microseconds with verification.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "plumb/arith/lattice.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/topology/topology.hpp"
#include "tool/check/surface.hpp"
#include "tool/check/tally.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {

struct MeshCheck {
  std::string name;
  LoadReport load;
  bool from_file = false;
  std::uint64_t bent_faces = 0;  // of the file, before triangulation
  MeshStatistics statistics;
  SurfaceFaults surface;
  Lattice lattice;
  EdgeAnswers edges;
  std::array<Comparison, kinds.size()> kind;

  /// The kinds that put their question to this predicate.
  [[nodiscard]] Comparison of_predicate(std::string_view predicate) const;
  [[nodiscard]] Comparison total() const;

  /// Of each kind the inexact methods were asked at most so many decisions; of all where this is 0.
  std::uint64_t sampled_of_kind = 0;
  [[nodiscard]] bool is_sampled() const { return sampled_of_kind != 0; }
};

struct CheckSettings {
  bool verify = false;                       // take exact signs again in rational arithmetic, of each kind
  std::uint64_t verified_of_kind = 100'000;  // at most so many, evenly spread
  bool all = false;                          // ask the inexact methods of every decision, not of a sample
  std::uint64_t sampled_of_kind = 100'000;
  std::optional<double> nearer_than;  // vertices nearer than this are close
  bool decisions = true;              // else of the surface alone

  [[nodiscard]] std::uint64_t asked_of_kind() const {
    return all ? std::numeric_limits<std::uint64_t>::max() : sampled_of_kind;
  }
};

/// What is known, in the order of becoming known: the mesh's statistics, surface, lattice and edges; what the inexact
/// methods say; what the exact ones do.
enum class CheckStep : std::uint8_t { mesh, inexact, exact };
using CheckWatcher = std::function<void(CheckStep)>;

/// Fills in what the mesh itself says; the watcher is called after each step, no progress bar being shown.
void check_mesh(const TriangleMesh& mesh, const CheckSettings& settings, MeshCheck& check,
                const CheckWatcher& watcher = {});

}  // namespace plumb::tool
