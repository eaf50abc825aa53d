#include "space/bvh/slot_check.hpp"

#include <optional>

#include "space/bvh/slot_boxes.hpp"
#include "space/bvh/triangle_part.hpp"

namespace plumb::space {
namespace {

constexpr std::size_t most_halved = 2 * most_slots_of_one;

}  // namespace

bool are_full(const BoxFrame& frame, const Triangle3& triangle, const std::vector<FloatBox3>& boxes) {
  std::vector<Aabb3> later{box_around(triangle.a, triangle.b, triangle.c)};
  std::size_t halved = 0;
  while (!later.empty()) {
    const Aabb3 part = later.back();
    later.pop_back();
    const FloatBox3 box = frame.around(part);
    if (std::ranges::any_of(boxes, [&](const FloatBox3& b) { return holds(b, box); })) continue;
    if (boxes.size() == 1 || ++halved > most_halved) return false;
    const std::optional<Halves> parts = halves(triangle, part);
    if (!parts) return false;
    for (const std::optional<Aabb3>& p : *parts) {
      if (p) later.push_back(*p);
    }
  }
  return true;
}

}  // namespace plumb::space
