#include "plumb/space/sort_and_sweep/sweep_array.hpp"

#include "space/pairs/checked_boxes.hpp"
#include "space/sort_and_sweep/swept_set.hpp"

namespace plumb {

struct SweepArray::State {
  bool touching = true, from_scratch = true;
  std::size_t axis = 3, steps = 0;
  std::vector<std::uint32_t> order;
  std::vector<space::OrdinalBox> sorted;
  space::SweptBoxes swept;
  std::vector<BoxPair> pairs;

  /// Ascending by start, then by number; false, and in no order, where that takes too many steps.
  bool insertion_sort() {
    constexpr std::size_t most_steps = 16;  // of each box
    const auto comes_after = [](const space::OrdinalBox& a, const space::OrdinalBox& b) {
      return a.low[0] > b.low[0] || (a.low[0] == b.low[0] && a.number > b.number);
    };
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      const space::OrdinalBox box = sorted[i];
      std::size_t at = i;
      for (; at > 0 && comes_after(sorted[at - 1], box); --at) sorted[at] = sorted[at - 1];
      sorted[at] = box;
      steps += i - at;
      if (steps > most_steps * sorted.size()) return false;
    }
    return true;
  }
};

SweepArray::SweepArray(const SweepArrayOptions& options) : state_(std::make_unique<State>()) {
  state_->touching = options.touching;
}
SweepArray::SweepArray(SweepArray&&) noexcept = default;
SweepArray& SweepArray::operator=(SweepArray&&) noexcept = default;
SweepArray::~SweepArray() = default;

SweepAxis SweepArray::axis() const { return static_cast<SweepAxis>(state_->axis); }
std::size_t SweepArray::steps() const { return state_->steps; }
bool SweepArray::from_scratch() const { return state_->from_scratch; }

const std::vector<BoxPair>& SweepArray::overlapping_pairs(std::span<const Aabb3> boxes) {
  State& s = *state_;
  space::SetBounds bounds;
  if (!space::find_bounds(boxes, bounds)) space::check_boxes("SweepArray::pairs", "boxes", boxes);
  s.pairs.clear();
  s.steps = 0;
  const std::size_t n = boxes.size();
  if (n == 0) {
    s.order.clear();
    return s.pairs;
  }
  const space::BoxSet<Aabb3> set{boxes, {}, s.touching};
  const std::size_t axis = space::widest_axis(set, bounds);
  const space::OrdinalMap map(bounds, {axis, (axis + 1) % 3, (axis + 2) % 3},
                              {space::swept_bits(n), space::ordinal_bits, space::ordinal_bits});
  s.from_scratch = s.order.size() != n || axis != s.axis;
  s.axis = axis;
  if (!s.from_scratch) {
    s.sorted.resize(n);
    for (std::size_t i = 0; i < n; ++i) s.sorted[i] = map(boxes[s.order[i]], s.order[i], 0);
    s.from_scratch = !s.insertion_sort();
  }
  if (s.from_scratch) {
    const auto sorted = space::sorted_ordinals(Execution::serial, set, map);
    s.sorted.assign(sorted.get(), sorted.get() + n);
  }
  s.order.resize(n);
  for (std::size_t i = 0; i < n; ++i) s.order[i] = static_cast<std::uint32_t>(s.sorted[i].number);
  s.swept.assign(s.sorted);
  space::PairBlock block(&s.pairs, [](void* to, std::span<const BoxPair> pairs) {
    auto& kept = *static_cast<std::vector<BoxPair>*>(to);
    kept.insert(kept.end(), pairs.begin(), pairs.end());
  });
  space::sweep(s.swept, 0, n - 1, {&set, &space::decide_of_set<Aabb3>}, block);
  block.flush();
  return s.pairs;
}

}  // namespace plumb
