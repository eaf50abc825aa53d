#include "tool/pairs/sweep_structure.hpp"

#include <utility>

#include "space/broad_phase/swept_columns.hpp"
#include "tool/pairs/method_names.hpp"

namespace plumb::tool {
namespace {

/// The least number on an axis that is not in an earlier strip, for each strip but the first.
std::vector<double> walls_on(const space::OrdinalMap& map, std::size_t k, std::uint32_t strips, double least,
                             double greatest) {
  std::vector<double> walls;
  const double enough = (greatest / 2 - least / 2) * 1e-4;
  for (std::uint32_t s = 1; s < strips; ++s) {
    double low = walls.empty() ? least : walls.back(), high = greatest;
    for (double middle = low / 2 + high / 2; low < middle && middle < high && high / 2 - low / 2 > enough;
         middle = low / 2 + high / 2) {
      (space::strip_of(map.ordinal(k, middle), strips) < s ? low : high) = middle;
    }
    walls.push_back(high);
  }
  return walls;
}

template <class Box>
SweepStructure columns_of(const space::BoxSet<Box>& set, const space::SetBounds& bounds) {
  auto [map, plan] = space::place_sweep(set, bounds);
  std::vector<space::OrdinalBox> ordinals;
  for (std::size_t i = 0; i < set.size(); ++i) ordinals.push_back(map(set[i], i, 0));
  space::Columns columns;
  while (!space::divide_into_columns(Execution::parallel, ordinals, plan.columns, 4 * set.size() + 4096, columns)) {
    for (auto& strips : plan.columns) strips = (strips + 1) / 2;
  }
  SweepStructure structure{plan.order[0], {}, columns.size(), columns.begin.back()};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t axis = plan.order[k + 1];
    if (axis < space::axes_of<Box>)
      structure.walls[axis] = walls_on(map, k + 1, plan.columns[k], bounds.min[axis], bounds.max[axis]);
  }
  return structure;
}

template <class Box>
std::optional<SweepStructure> structure_of(const space::BoxSet<Box>& set, BroadPhaseMethod method) {
  space::SetBounds bounds, of_b;
  space::find_bounds(set.a, bounds);
  space::find_bounds(set.b, of_b);
  for (std::size_t k = 0; k < space::axes_of<Box> && !set.b.empty(); ++k) {
    bounds.min[k] = std::min(bounds.min[k], of_b.min[k]);
    bounds.max[k] = std::max(bounds.max[k], of_b.max[k]);
  }
  if (set.size() >= 2 && method == BroadPhaseMethod::swept_columns) return columns_of(set, bounds);
  if (set.size() >= 2 && method == BroadPhaseMethod::sort_and_sweep)
    return SweepStructure{space::widest_axis(set, bounds), {}, 1, set.size()};
  return {};
}

}  // namespace

BroadPhaseMethod method_taken(const PairsReport& r) {
  const std::size_t boxes = r.sets.front().size() + (r.of_one() ? 0 : r.sets.back().size());
  return space::method_taken(broad_phase_method(r.method), boxes);
}

std::optional<SweepStructure> sweep_structure(const PairsReport& r) {
  const BroadPhaseMethod method = method_taken(r);
  const BoxInput &a = r.sets.front(), &b = r.sets.back();
  using Planar = std::span<const Aabb2>;
  using Spatial = std::span<const Aabb3>;
  if (r.is_planar())
    return structure_of<Aabb2>({Planar(a.plane), r.of_one() ? Planar() : Planar(b.plane), r.touching}, method);
  return structure_of<Aabb3>({Spatial(a.space), r.of_one() ? Spatial() : Spatial(b.space), r.touching}, method);
}

}  // namespace plumb::tool
