// Which figures of a k-d tree meet a box, and which two of them meet?
//
// Laws: (1) in_box tells the figures that have a point in the closed box, as of intersects, or without touching overlap
// it, as of relate, ascending. (2) overlapping_pairs tells each two figures that meet once, a < b, or without touching
// those whose relation is overlapping, in the order of the first leaves that they have in common: there alone they are
// asked.  It depends on the tree alone, not on the number of threads.
// An inverted box meets nothing.  A coordinate that is NaN or infinite throws NonFinite, by name.
// Source: RTCD 7.3.7.
// Cost: the leaves that the box meets, and a sort of what is in them; comparisons of boxes in each leaf, and a test for
// each pair whose boxes meet.  Bounded by n^2 tests a leaf for pairs, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/kd_tree/split_tree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

template <KeptFigure Figure>
std::vector<std::uint32_t> in_box(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Box& box,
                                  const InBoxOptions& options = {}, std::vector<std::uint32_t> rows = {});

template <KeptFigure Figure>
std::vector<BoxPair> overlapping_pairs(const SplitTree<Figure>& tree, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});

}  // namespace plumb
