// Top-down: by bins, by sweeps, or at one place.
#include "space/bvh/builders.hpp"
#include "space/bvh/grown_tree.hpp"
#include "space/bvh/item_cutter.hpp"
#include "space/bvh/place_cutter.hpp"
#include "space/bvh/sweep_cutter.hpp"

namespace plumb::space {
namespace {

// Puts items into the slots from one on, and says how large they are.
template <class ItemAt>
Extent put(std::vector<std::uint32_t>& slots, const SlotRange& range, const ItemAt& item_at) {
  Extent box;
  for (std::uint32_t slot = range.begin; slot < range.end; ++slot) {
    const BoxedItem& item = item_at(slot);
    box.take(item.low(), item.high());
    slots[slot] = item.item;
  }
  return box;
}

SlotRange whole(std::size_t items) { return {0, static_cast<std::uint32_t>(items)}; }

}  // namespace

Built build_binned(std::vector<BoxedItem> items, const BvhOptions& options, std::uint32_t depth) {
  CutArrays arrays(std::move(items), options);
  Built built;
  built.items.resize(arrays.items[0].size());
  const auto leaf = [&](const ItemRange& range) {
    return put(
        built.items, range, [&](std::uint32_t slot) -> auto& { return arrays.items[range.array][slot]; });
  };
  ItemRange all = arrays.whole();
  all.depth = depth;
  built.nodes = grow(
      options.execution, all, [&] { return ItemCutter(arrays); }, leaf);
  return built;
}

Built build_by_sweeps(const std::vector<BoxedItem>& items, const BvhOptions& options) {
  SweepLists lists(items, options);
  Built built;
  built.items.resize(items.size());
  const auto leaf = [&](const SlotRange& range) {
    return put(
        built.items, range, [&](std::uint32_t slot) -> auto& { return items[lists.sorted[0][slot]]; });
  };
  built.nodes = grow(
      options.execution, whole(items.size()), [&] { return SweepCutter(lists); }, leaf);
  return built;
}

Built build_at_places(std::vector<BoxedItem> items, const BvhOptions& options) {
  Built built;
  built.items.resize(items.size());
  const auto leaf = [&](const SlotRange& range) {
    return put(
        built.items, range, [&](std::uint32_t slot) -> auto& { return items[slot]; });
  };
  built.nodes = grow(
      options.execution, whole(items.size()), [&] { return PlaceCutter(items, options); }, leaf);
  return built;
}

Built build(std::vector<BoxedItem> items, const BvhOptions& options) {
  switch (options.method) {
    case BvhMethod::binned:
      break;
    case BvhMethod::sweep:
      return build_by_sweeps(items, options);
    case BvhMethod::object_median:
    case BvhMethod::object_mean:
    case BvhMethod::spatial_median:
      return build_at_places(std::move(items), options);
    case BvhMethod::linear:
      return build_linear(items, options);
    case BvhMethod::agglomerative:
      return build_agglomerative(items, options);
    case BvhMethod::nearest_pairs:
      return build_of_nearest_pairs(items, options);
    case BvhMethod::insertion:
      return build_by_insertion(items, options);
  }
  return build_binned(std::move(items), options);
}

}  // namespace plumb::space
