#include "space/broad_phase/index_costs.hpp"

namespace plumb::space {
namespace {

using M = BroadPhaseMethod;

// Nanoseconds of the processor, as fitted to some 1,400 runs on one core of the machine of docs/measurements.md that
// others kept busy, by g++ 12 at -O3: 100 to 100,000 boxes in the plane and in space, all over it, in 50 clusters, of
// sizes from 1 to 1,000, along a line, and long ones; of those kept, 1, 10 and 100 of 100 boxes move.  As a rule a
// prediction is within a half of what was measured, for one in ten it is off by a factor from 2 to 4; of MovingBoxes
// (whose first row was set by hand) by up to 7, where boxes are few.  kd_tree's row is fitted to 58 runs of its own, of
// 100 to 50,000 such boxes: half of its predictions are within a half, nine of ten within a factor of 2.6, all of 3.4.
// That of octree is fitted to 903 runs of it and of grids of levels, in seconds of the processor: half of its predictions
// are within a half or so, nine of ten within a factor of 2.5.  The structures of space/textbook have none.
// Columns as in CountedThing: once, doublings, thousands of boxes, copies, mates, pairs, windows, swept copies, swept
// windows, moved, swept windows of what is moved.
constexpr MethodCosts costs[] = {
    // clang-format off
    {M::swept_columns, false, {93, 0, 0, 0, 0, 2.7, 0, 0, 0.54, 0, 0}},
    {M::sort_and_sweep, false, {49, 0, 0, 0, 0, 1.8, 0.61, 0, 0, 0, 0}},
    {M::brute_force, false, {0, 0, 2300, 0, 0, 0, 0, 0, 0, 0, 0}},
    {M::static_grid, false, {0, 9.1, 0, 14, 3, 5.8, 0, 0, 0, 0, 0}},
    {M::octree, false, {277, 4.8, 0, 0, 0, 99, 0, 0, 0, 0, 0}},
    {M::octree_of_leaves, false, {0, 29, 0, 0, 5.2, 0, 0, 0, 0, 0, 0}},
    {M::box_tree, false, {0, 36, 0, 0, 0, 51, 0, 0, 0, 0, 0}},
    {M::lists_along_one, false, {0, 6.5, 0, 0, 0, 110, 100, 0, 0, 0, 0}},
    {M::lists_along_two, false, {0, 0, 16000, 0, 0, 33, 120, 0, 0, 0, 0}},
    {M::lists_along_three, false, {0, 0, 15000, 0, 0, 0, 170, 0, 0, 0, 0}},
    {M::kd_tree, false, {0, 94, 0, 580, 7, 53, 0, 0, 0, 0, 0}},
    {M::swept_columns, true, {0, 0, 0, 0, 0, 0, 0, 0, 0, 800, 10}},
    {M::swept_columns, true, {0, 0, 0, 0, 0, 5.7, 0, 87, 1.2, 0, 0}},
    {M::sort_and_sweep, true, {24, 1.5, 0, 0, 0, 0.32, 0.62, 0, 0, 0, 0}},
    // clang-format on
};

}  // namespace

std::span<const MethodCosts> method_costs() { return costs; }

double predicted_cost(const MethodCosts& of, const Counts& counts) {
  double sum = 0;
  for (std::size_t i = 0; i < counted_things; ++i) sum += of.nanoseconds[i] * counts[i];
  return sum;
}

}  // namespace plumb::space
