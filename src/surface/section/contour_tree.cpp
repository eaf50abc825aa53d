#include "surface/section/contour_tree.hpp"

#include <array>

namespace plumb::surface {

Aabb2 nearest_box(std::span<const std::uint32_t> corners, const CutCorners& at) {
  const auto box_of = [&](std::uint32_t c) {
    const Point2 p{at.nearest(c, 0), at.nearest(c, 1)};
    return Aabb2{p, p};
  };
  Aabb2 box = box_of(corners[0]);
  for (const std::uint32_t c : corners.subspan(1)) box = merge(box, box_of(c));
  return box;
}

ContourTree::ContourTree(std::span<const std::uint32_t> loop, const CutCorners& corners) : loop_(loop) {
  runs_.reserve(2 * loop.size() - 1);
  build(0, static_cast<std::uint32_t>(loop.size() - 1), corners);
}

Aabb2 ContourTree::build(std::uint32_t first, std::uint32_t last, const CutCorners& corners) {
  const std::size_t at = runs_.size();
  runs_.push_back({{}, first, last, 0});
  Aabb2 box;
  if (first == last) {
    box = nearest_box(std::array{corner_before(first), loop_[last]}, corners);
  } else {
    const std::uint32_t middle = first + (last - first) / 2;
    box = build(first, middle, corners);
    box = merge(box, build(middle + 1, last, corners));
  }
  runs_[at].box = box;
  runs_[at].next = static_cast<std::uint32_t>(runs_.size());
  return box;
}

}  // namespace plumb::surface
