#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"

#include "plumb/arith/error.hpp"
#include "space/pairs/checked_boxes.hpp"
#include "space/sort_and_sweep/swept_set.hpp"

namespace plumb {
namespace {

template <class Box>
space::SetBounds checked_bounds(const char* function, std::span<const Box> boxes) {
  space::SetBounds bounds;
  if (!space::find_bounds(boxes, bounds)) space::check_boxes(function, "boxes", boxes);
  return bounds;
}

template <class Box>
std::vector<BoxPair> swept_pairs(std::span<const Box> boxes, const SortAndSweepOptions& options,
                                 std::vector<BoxPair> pairs) {
  pairs.clear();
  if (space::is_planar<Box> && options.axis == SweepAxis::z) {
    throw InvalidShape("sort_and_sweep_pairs: options.axis is z, which boxes in the plane do not have");
  }
  const space::SetBounds bounds = checked_bounds("sort_and_sweep_pairs", boxes);
  const space::BoxSet<Box> set{boxes, {}, options.touching};
  const std::size_t axis = options.axis == SweepAxis::greatest_variance ? space::widest_axis(set, bounds)
                                                                        : static_cast<std::size_t>(options.axis);
  space::find_by_sweep(options.execution, set, bounds, axis,
                       {&pairs, [](void* to, std::span<const BoxPair> block, double) {
                          auto& kept = *static_cast<std::vector<BoxPair>*>(to);
                          kept.insert(kept.end(), block.begin(), block.end());
                        }});
  return pairs;
}

template <class Box>
SweepAxis axis_of(std::span<const Box> boxes) {
  const space::SetBounds bounds = checked_bounds("axis_of_greatest_variance", boxes);
  return static_cast<SweepAxis>(space::widest_axis(space::BoxSet<Box>{boxes}, bounds));
}

}  // namespace

#define PLUMB_SORT_AND_SWEEP(Box)                                                                           \
  std::vector<BoxPair> sort_and_sweep_pairs(std::span<const Box> boxes, const SortAndSweepOptions& options, \
                                            std::vector<BoxPair> rows) {                                    \
    return swept_pairs(boxes, options, std::move(rows));                                                    \
  }                                                                                                         \
  SweepAxis axis_of_greatest_variance(std::span<const Box> boxes) { return axis_of(boxes); }
PLUMB_SORT_AND_SWEEP(Aabb2)
PLUMB_SORT_AND_SWEEP(Aabb3)
PLUMB_SORT_AND_SWEEP(FloatBox2)
PLUMB_SORT_AND_SWEEP(FloatBox3)
#undef PLUMB_SORT_AND_SWEEP

}  // namespace plumb
