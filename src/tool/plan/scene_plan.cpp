#include "tool/plan/scene_plan.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "certify/catalog.hpp"
#include "tool/plan/times.hpp"

namespace plumb::tool {
namespace {

Lattice lattice_of_mesh(const TriangleMesh& mesh) {
  static_assert(sizeof(Point3) == 3 * sizeof(double));
  return lattice_of({&mesh.vertices.front().x, 3 * mesh.vertices.size()});
}

/// Of the coordinates of both.
Lattice joined(const Lattice& a, const Lattice& b) {
  if (a.bits == 0) return b;
  if (b.bits == 0) return a;
  const int low = std::min(a.exponent, b.exponent), end = std::max(a.exponent + a.bits, b.exponent + b.bits);
  return {low, end - low};
}

std::array<Arithmetic, classic_count> arithmetic_at(int bits) {
  std::array<Arithmetic, classic_count> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = arithmetic_of(classics()[k].planned_bits, bits);
  return all;
}

/// The numbers of bits, fewer than the scene has, below which a classic needs less, from many to few.
std::vector<int> cheaper_bits(int bits) {
  std::set<int, std::greater<>> steps;
  for (const CatalogEntry& e : classics()) {
    for (const int most : e.planned_bits) {
      if (most >= 0 && most < bits && arithmetic_of(e.planned_bits, most) != arithmetic_of(e.planned_bits, most + 1))
        steps.insert(most);
    }
  }
  return {steps.begin(), steps.end()};
}

ScenePlanRow row_at(const SceneDecisions& decisions, const Lattice& lattice, int exponent) {
  ScenePlanRow row{lattice.bits, exponent, {}, arithmetic_at(lattice.bits), {}};
  for (std::size_t k = 0; k < row.times.size(); ++k) row.times[k] = decisions.measure(k, lattice, exponent);
  return row;
}

BoundPlan bound_plan(const NamedMesh& m, const ScenePlanOptions& options) {
  const auto& points = m.mesh.vertices;
  MeshBounds rated{m.name, points.size(),
                   rate_bounds(points, {.placements = options.placements, .measure_times = true}), options.refined_ns};
  BoundCosts costs{.refined_ns = options.refined_ns};
  for (std::size_t k = 0; k < costs.test_ns.size(); ++k) costs.test_ns[k] = rated.ratings.kinds[k].test_ns;
  const BoundKind kind = choose_bound(points, costs, {.placements = options.placements}).kind;
  return {std::move(rated), static_cast<std::size_t>(kind)};
}

template <class Number>
auto greatest(const std::vector<SnapDamage>& damage, Number number) {
  double most = 0;
  for (const SnapDamage& d : damage) most = std::max(most, d.*number);
  return most;
}
template <class List>
std::uint64_t counted(const std::vector<SnapDamage>& damage, List list) {
  std::uint64_t all = 0;
  for (const SnapDamage& d : damage) all += (d.*list).size();
  return all;
}

}  // namespace

double ScenePlanRow::greatest_move() const { return greatest(damage, &SnapDamage::greatest_move); }
double ScenePlanRow::greatest_distance() const { return greatest(damage, &SnapDamage::greatest_distance); }
std::uint64_t ScenePlanRow::merged() const { return counted(damage, &SnapDamage::merged); }
std::uint64_t ScenePlanRow::collapsed() const { return counted(damage, &SnapDamage::collapsed); }
std::uint64_t ScenePlanRow::turned_over() const { return counted(damage, &SnapDamage::turned_over); }

Arithmetic arithmetic_of(const PlannedBits& planned_bits, int bits) {
  const auto found = std::ranges::find_if(planned_bits, [bits](int most) { return bits <= most; });
  return static_cast<Arithmetic>(found - planned_bits.begin());
}

std::string_view short_name(Arithmetic a) {
  constexpr std::array<std::string_view, arithmetic_count> names{"double",    "integers", "modulo",
                                                                 "two words", "bounded",  "chain"};
  return names[static_cast<std::size_t>(a)];
}

std::uint64_t steps_of(std::span<const NamedMesh> meshes) {
  return 3 * meshes.size() + 1 + cheaper_bits(std::numeric_limits<int>::max()).size();
}

ScenePlan plan_scene(std::span<const NamedMesh> meshes, const ScenePlanOptions& options,
                     const std::function<void()>& step) {
  ScenePlan scene;
  Lattice lattice;
  std::vector<std::span<const Point3>> vertices;
  for (const NamedMesh& m : meshes) {
    scene.names.push_back(m.name);
    scene.vertices.push_back(m.mesh.vertices.size());
    scene.triangles.push_back(m.mesh.triangles.size());
    scene.lattices.push_back(lattice_of_mesh(m.mesh));
    lattice = joined(lattice, scene.lattices.back());
    vertices.emplace_back(m.mesh.vertices);
  }
  const SceneDecisions decisions(meshes);
  scene.rows.push_back(row_at(decisions, lattice, lattice.exponent));
  step();
  for (const int bits : cheaper_bits(lattice.bits)) {
    if (const auto exponent = exponent_for_bits(vertices, lattice, bits)) {
      Lattice coarse;
      std::vector<SnapDamage> damage;
      for (const NamedMesh& m : meshes) {
        damage.push_back(*snap_damage(m.mesh, *exponent));
        coarse = joined(coarse, damage.back().lattice);
      }
      scene.rows.push_back(row_at(decisions, coarse, *exponent));
      scene.rows.back().damage = std::move(damage);
    }
    step();
  }
  for (const NamedMesh& m : meshes) {
    scene.bounds.push_back(bound_plan(m, options));
    step();
    scene.trees.push_back(plan_trees(m.mesh));
    step();
    scene.volumes.push_back(plan_volumes(m.mesh));
    step();
  }
  return scene;
}

}  // namespace plumb::tool
