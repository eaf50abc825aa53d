#include "surface/section/boxes_around.hpp"

#include <algorithm>
#include <numeric>

#include "plumb/figure/aabb/relation.hpp"

namespace plumb::surface {
namespace {

/// The boxes that the sweep has reached, by the heights that they span.
class Reached {
 public:
  explicit Reached(std::span<const Aabb2> boxes) : boxes_(boxes) {
    for (const Aabb2& b : boxes) heights_.push_back(b.min.y);
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
    spanning_.resize(2 * heights_.size());
  }

  void add(std::uint32_t box) {
    const auto from = std::lower_bound(heights_.begin(), heights_.end(), boxes_[box].min.y);
    const auto to = std::upper_bound(heights_.begin(), heights_.end(), boxes_[box].max.y);
    for (std::size_t l = leaf(from), r = leaf(to); l < r; l /= 2, r /= 2) {
      if (l % 2 == 1) spanning_[l++].push_back(box);
      if (r % 2 == 1) spanning_[--r].push_back(box);
    }
  }

  /// Those in which the box lies, itself among them.
  void find_around(const Aabb2& box, std::vector<std::uint32_t>& found) {
    for (std::size_t node = leaf(std::lower_bound(heights_.begin(), heights_.end(), box.min.y)); node > 0; node /= 2) {
      std::vector<std::uint32_t>& here = spanning_[node];
      std::erase_if(here, [&](std::uint32_t b) { return boxes_[b].max.x < box.min.x; });  // the sweep has passed them
      for (const std::uint32_t b : here) {
        if (contains(boxes_[b], box)) found.push_back(b);
      }
    }
  }

 private:
  [[nodiscard]] std::size_t leaf(std::vector<double>::const_iterator height) const {
    return heights_.size() + static_cast<std::size_t>(height - heights_.begin());
  }

  std::span<const Aabb2> boxes_;
  std::vector<double> heights_;                       // where boxes begin
  std::vector<std::vector<std::uint32_t>> spanning_;  // nodes: the children of i are 2 i and 2 i + 1
};

}  // namespace

std::vector<std::vector<std::uint32_t>> boxes_around(std::span<const Aabb2> boxes) {
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].min.x != boxes[b].min.x ? boxes[a].min.x < boxes[b].min.x : a < b;
  });
  std::vector<std::vector<std::uint32_t>> around(boxes.size());
  Reached reached(boxes);
  auto next = order.begin();
  for (const std::uint32_t box : order) {
    for (; next != order.end() && boxes[*next].min.x <= boxes[box].min.x; ++next) reached.add(*next);
    std::vector<std::uint32_t>& found = around[box];
    reached.find_around(boxes[box], found);
    std::erase(found, box);
    std::sort(found.begin(), found.end());
  }
  return around;
}

}  // namespace plumb::surface
