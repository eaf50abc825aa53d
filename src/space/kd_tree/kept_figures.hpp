// The figures that trees keep, one after the other, and their boxes, which are looked at before a tree is built.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "plumb/space/kd_tree/figure_tree.hpp"

// instantiate(Figure) for each of them.
#define PLUMB_FOR_KEPT_FIGURES(instantiate)                                                                \
  instantiate(Aabb2) instantiate(Segment2) instantiate(Triangle2) instantiate(Aabb3) instantiate(Segment3) \
      instantiate(Triangle3)

namespace plumb::space::kd {

/// In space.  Throws NonFinite and InvalidShape, naming the function and the figure.
template <class Figure>
std::vector<Aabb3> checked_boxes_of(std::string_view function, std::span<const Figure> figures, Execution execution);

}  // namespace plumb::space::kd
