// What does a scene need, and no more?  Its arithmetic, what coarser lattices would save, its bounding volumes, its trees
// of boxes, and what each of them costs here and now.
//
// Laws: (1) all but the times depends on the meshes and the options alone; (2) `decide` and the plan are asked the same
// decisions, those that mesh software takes on these meshes (tool/mesh/decisions.hpp), and their answers are compared; (3) a
// coarser lattice is listed where some classic predicate gets a cheaper arithmetic on it, and nowhere else; (4) nothing
// is recommended that took longer, as measured here, than doing without it.
// Source: RTCD 4.1, 11.4, 11.5.1, 13.1 (measure first).
// Cost: some seconds for a large mesh.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/certify/plan.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "tool/bounds/command.hpp"
#include "tool/mesh/snap.hpp"
#include "tool/plan/tree_plan.hpp"
#include "tool/plan/volume_plan.hpp"

namespace plumb::tool {

inline constexpr std::size_t classic_count = 4;

/// In nanoseconds a decision, each the median over blocks of the least of some runs; 0 where nothing was asked.
struct DecisionTimes {
  std::uint64_t decisions = 0, contradictions = 0;  // between decide and the plan: none, or something is broken
  double plain = 0, decide = 0, batch = 0, plan = 0;

  /// Is the plan what to take, one decision at a time?  Not where it took longer than decide here.
  [[nodiscard]] bool plan_pays() const { return plan <= decide; }
  /// "plan" or "decide"; "-" where nothing was asked.
  [[nodiscard]] std::string_view taken() const { return decisions == 0 ? "-" : plan_pays() ? "plan" : "decide"; }
};

struct NamedMesh {
  std::string name;
  TriangleMesh mesh;
};

/// A lattice of the scene, as given or coarser.
struct ScenePlanRow {
  int bits;  // aimed at, and the plan's; of the scene as given its own
  int exponent;
  std::vector<SnapDamage> damage;  // of each mesh; of nothing for the scene as given
  std::array<Arithmetic, classic_count> arithmetic;
  std::array<DecisionTimes, classic_count> times;

  [[nodiscard]] double greatest_move() const;
  [[nodiscard]] double greatest_distance() const;
  [[nodiscard]] std::uint64_t merged() const;
  [[nodiscard]] std::uint64_t collapsed() const;
  [[nodiscard]] std::uint64_t turned_over() const;
};

/// The volume that choose_bound takes for one mesh, with the times measured here; without one every query is refined.
struct BoundPlan {
  MeshBounds rated;
  std::size_t chosen;  // of bound_kinds
  [[nodiscard]] double with_ns() const { return rated.expected_ns(chosen); }
  [[nodiscard]] double without_ns() const { return rated.refined_ns; }
  /// The kind to take; "none" where a query is expected to take no less with it than without.
  [[nodiscard]] std::string_view taken() const {
    return with_ns() < without_ns() ? name_of(bound_kinds[chosen]) : std::string_view("none");
  }
};

struct ScenePlan {
  std::vector<std::string> names;
  std::vector<std::uint64_t> vertices, triangles;
  std::vector<Lattice> lattices;    // of each mesh alone
  std::vector<ScenePlanRow> rows;   // first the scene as given, then from fine to coarse
  std::vector<BoundPlan> bounds;    // of each mesh
  std::vector<TreePlan> trees;      // of each mesh
  std::vector<VolumePlan> volumes;  // of each mesh's tree

  [[nodiscard]] Lattice lattice() const { return {rows.front().exponent, rows.front().bits}; }
};

struct ScenePlanOptions {
  std::uint32_t placements = 200;
  double refined_ns = 1'000;  // what is asked where bounds overlap
};

/// Meshes of at least one vertex each, at least one of them.  `step` is called steps_of(meshes) times, as work goes on.
ScenePlan plan_scene(std::span<const NamedMesh> meshes, const ScenePlanOptions& options,
                     const std::function<void()>& step);

/// At most.
std::uint64_t steps_of(std::span<const NamedMesh> meshes);

/// The arithmetic that a predicate of the catalog needs for coordinates of so many bits: arithmetic_for at run time.
Arithmetic arithmetic_of(const PlannedBits& planned_bits, int bits);

/// "double", "integers", "modulo", "two words", "bounded", "chain": a table's word for an arithmetic.
std::string_view short_name(Arithmetic a);

}  // namespace plumb::tool
