#include "surface/planar/triangles.hpp"
#include "surface/solid/outside_winding.hpp"

namespace plumb::surface {
namespace {

class WindingSpread {
 public:
  WindingSpread(const FacePool& pool, const FacetList& list, const SideSets& sets)
      : pool_(pool), list_(list), sets_(sets), windings_(std::size_t{sets.count} * pool.meshes), known_(sets.count) {
    std::vector<std::uint32_t> count(sets.count + 1);
    for (const std::uint32_t set : sets.of) ++count[set + 1];
    for (std::size_t s = 1; s < count.size(); ++s) count[s] += count[s - 1];
    first_ = count;
    sides_.resize(sets.of.size());
    for (std::uint32_t side = 0; side < sets.of.size(); ++side) sides_[count[sets.of[side]]++] = side;
  }

  [[nodiscard]] bool is_known(std::uint32_t set) const { return known_[set] != 0; }

  void spread(std::uint32_t set, std::span<const std::int32_t> windings) {
    std::ranges::copy(windings, row(set));
    known_[set] = 1;
    std::vector<std::uint32_t> pending{set};
    while (!pending.empty()) {
      const std::uint32_t from = pending.back();
      pending.pop_back();
      for (std::uint32_t i = first_[from]; i < first_[from + 1]; ++i) {
        const std::uint32_t beyond = sets_.of[sides_[i] ^ 1U];
        if (is_known(beyond)) continue;
        std::copy(row(from), row(from) + pool_.meshes, row(beyond));
        step(sides_[i], row(beyond));
        known_[beyond] = 1;
        pending.push_back(beyond);
      }
    }
  }

  std::vector<std::int32_t> take() { return std::move(windings_); }

 private:
  [[nodiscard]] std::int32_t* row(std::uint32_t set) { return windings_.data() + std::size_t{set} * pool_.meshes; }

  // Through the facet, from the side on.
  void step(std::uint32_t side, std::int32_t* windings) const {
    const bool downward = side % 2 == 0;
    for (const CoveringFace& by : list_.covers_of(side / 2))
      for (const FacetSource& use : pool_.uses_of(by.face))
        if (!pool_.is_sheet(use.face.mesh))
          windings[use.face.mesh] += ((by.opposite != use.opposite) == downward) ? -1 : 1;
  }

  const FacePool& pool_;
  const FacetList& list_;
  const SideSets& sets_;
  std::vector<std::int32_t> windings_;
  std::vector<std::uint8_t> known_;
  std::vector<std::uint32_t> first_, sides_;  // of each set
};

}  // namespace

std::vector<std::int32_t> windings_of_sets(const FacePool& pool, const Bvh& bvh, const FacetList& list,
                                           const PointTable& table, const SideSets& sets) {
  if (pool.meshes == pool.sheets) return std::vector<std::int32_t>(std::size_t{sets.count} * pool.meshes);
  const OutsideWinding outside(pool, bvh, list, table);
  WindingSpread known(pool, list, sets);
  for (std::uint32_t f = 0; f < list.facets.size(); ++f) {
    if (known.is_known(sets.of[above(f)])) continue;
    const WindingBeside found = outside.beside(f);
    known.spread(sets.of[found.is_above ? above(f) : below(f)], found.windings);
  }
  return known.take();
}

}  // namespace plumb::surface
