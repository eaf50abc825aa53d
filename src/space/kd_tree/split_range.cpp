#include "plumb/space/kd_tree/split_range.hpp"

#include <algorithm>

#include "query/body/figure_input.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/figure_box.hpp"
#include "space/kd_tree/figures_meet.hpp"
#include "space/kd_tree/kept_figures.hpp"
#include "space/kd_tree/leaves_meeting.hpp"

namespace plumb {
namespace space::kd {

/// The leaves of each figure, ascending.
class LeavesOf {
 public:
  template <class Figure>
  explicit LeavesOf(const SplitTree<Figure>& tree) : first_(tree.figures.size() + 1, 0), leaves_(tree.items.size()) {
    for (const std::uint32_t i : tree.items) ++first_[i + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t leaf = 0; leaf < tree.leaves(); ++leaf) {
      for (const std::uint32_t i : tree.items_in(leaf)) leaves_[next[i]++] = static_cast<std::uint32_t>(leaf);
    }
  }

  /// Is it the first of those that have both?
  [[nodiscard]] bool is_first_of_both(std::uint32_t i, std::uint32_t k, std::size_t leaf) const {
    std::uint32_t a = first_[i], b = first_[k];
    while (leaves_[a] != leaves_[b]) leaves_[a] < leaves_[b] ? ++a : ++b;
    return leaves_[a] == leaf;
  }

 private:
  std::vector<std::uint32_t> first_, leaves_;
};

namespace {

template <class Figure>
void add_pairs_of_leaf(const SplitTree<Figure>& tree, const LeavesOf& leaves, std::size_t leaf, bool touching,
                       std::vector<BoxPair>& pairs) {
  const auto items = tree.items_in(leaf);
  std::vector<Aabb3> boxes;
  for (const std::uint32_t i : items) boxes.push_back(box_in_space(tree.figures[i]));
  for (std::size_t m = 0; m < items.size(); ++m) {
    for (std::size_t n = m + 1; n < items.size(); ++n) {
      if (!boxes_meet(boxes[m], boxes[n]) || !leaves.is_first_of_both(items[m], items[n], leaf)) continue;
      const Figure &a = tree.figures[items[m]], &b = tree.figures[items[n]];
      if (figures_meet(a, b, touching)) pairs.push_back({items[m], items[n]});
    }
  }
}

}  // namespace
}  // namespace space::kd

template <KeptFigure Figure>
std::vector<std::uint32_t> in_box(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Box& box,
                                  const InBoxOptions& options, std::vector<std::uint32_t> rows) {
  using namespace space::kd;
  query::require_figure("in_box", "box", box);
  rows.clear();
  if (is_empty(box)) return rows;
  const Aabb3 asked = space::box_in_space(box);
  for_leaves_meeting(tree, box, [&](std::uint32_t leaf) {
    for (const std::uint32_t i : tree.items_in(leaf)) {
      if (space::boxes_meet(asked, space::box_in_space(tree.figures[i]))) rows.push_back(i);
    }
  });
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  std::erase_if(rows, [&](std::uint32_t i) { return !figures_meet(tree.figures[i], box, options.touching); });
  return rows;
}

template <KeptFigure Figure>
std::vector<BoxPair> overlapping_pairs(const SplitTree<Figure>& tree, const BoxPairOptions& options,
                                       std::vector<BoxPair> rows) {
  using namespace space::kd;
  constexpr std::size_t block = 64;
  const LeavesOf leaves(tree);
  std::vector<std::vector<BoxPair>> parts(space::blocks_of(tree.leaves(), block));
  space::for_blocks(options.execution, tree.leaves(), block, [&](std::size_t b, std::size_t from, std::size_t to) {
    for (std::size_t leaf = from; leaf < to; ++leaf) add_pairs_of_leaf(tree, leaves, leaf, options.touching, parts[b]);
  });
  rows.clear();
  for (const auto& part : parts) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

#define PLUMB_INSTANTIATE(F)                                                                                     \
  template std::vector<std::uint32_t> in_box(const SplitTree<F>&, const SplitTree<F>::Box&, const InBoxOptions&, \
                                             std::vector<std::uint32_t>);                                        \
  template std::vector<BoxPair> overlapping_pairs(const SplitTree<F>&, const BoxPairOptions&, std::vector<BoxPair>);
PLUMB_FOR_KEPT_FIGURES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
