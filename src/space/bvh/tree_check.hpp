// Is this a tree at all?  Looked at before anybody descends what comes from a file.
//
// Its parts serve either layout; each answers in words which law is broken first, with nothing where none is.
// Cost: linear; a word or two a slot, of a compact tree 29 bytes a node as well.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"

namespace plumb::space {

/// Which law of box_tree.hpp or bvh.hpp is broken first, in words; empty where none is.
std::string broken_law(const Bvh& bvh);

/// Of compact_tree.hpp: boxes on the way to a leaf contain together the triangles in it, or that and the other leaves of
/// a triangle that is in several.
std::string broken_law(const CompactBvh& bvh);

/// What is NaN is in nothing.
inline bool holds(const FloatBox3& outer, const FloatBox3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(outer.min[k] <= box.min[k]) || !(box.max[k] <= outer.max[k])) return false;
  }
  return true;
}

/// Do these boxes together hold the triangle?  What is in none of them whole is halved, as those who split triangles do.
bool are_full(const BoxFrame& frame, const Triangle3& triangle, const std::vector<FloatBox3>& boxes);

// More than builders make of one triangle: what is in no such tree is not looked for longer.
inline constexpr std::size_t most_slots_of_one = 256;

/// Of a Bvh or a CompactBvh: vertices are finite, and triangles name them.
template <class Mesh>
std::string broken_mesh(const Mesh& bvh) {
  const std::span<const Point3> vertices = bvh.vertices.view();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point3& p = vertices[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return "vertex " + std::to_string(i) + " is not finite";
    }
  }
  for (std::size_t i = 0; i < bvh.slots(); ++i) {
    const Bvh::Corners c = bvh.corners_of(i);
    const std::uint32_t last = std::max({c[0], c[1], c[2]});
    if (last >= vertices.size()) {
      return "the triangle in slot " + std::to_string(i) + " names vertex " + std::to_string(last) + " of " +
             std::to_string(vertices.size());
    }
  }
  return "";
}

inline constexpr std::uint32_t in_no_slot = 0xffffffff;

/// Of each triangle its last slot, and of each slot the one before it of the same triangle.
struct SlotLists {
  std::vector<std::uint32_t> last, before;
};

/// Numbers go from 0 on without a gap, and slots of one number have the same corners.
template <class Mesh>
std::string broken_numbers(const Mesh& bvh, SlotLists& lists) {
  const std::size_t slots = bvh.slots();
  lists.before.assign(slots, in_no_slot);
  std::uint32_t numbers = 0;
  lists.last.assign(slots, in_no_slot);
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    const std::uint32_t item = bvh.number(slot);
    if (item >= slots) return "triangle " + std::to_string(item) + " has a number beyond the slots";
    numbers = std::max(numbers, item + 1);
    lists.before[slot] = std::exchange(lists.last[item], slot);
    if (lists.before[slot] != in_no_slot && bvh.corners_of(slot) != bvh.corners_of(lists.before[slot]))
      return "triangle " + std::to_string(item) + " has other corners in another slot";
  }
  lists.last.resize(numbers);
  for (std::uint32_t i = 0; i < numbers; ++i) {
    if (lists.last[i] == in_no_slot) return "triangle " + std::to_string(i) + " is in no slot";
  }
  return "";
}

/// Every triangle is in the boxes of its slots, together; box_of(slot), and where(slot) for the words.
template <class Mesh, class BoxOf, class Where>
std::string broken_boxes(const Mesh& bvh, const SlotLists& lists, const BoxOf& box_of, const Where& where) {
  std::vector<FloatBox3> boxes;
  for (const std::uint32_t last : lists.last) {
    boxes.clear();
    for (std::uint32_t s = last; s != in_no_slot; s = lists.before[s]) boxes.push_back(box_of(s));
    if (boxes.size() > most_slots_of_one || !are_full(bvh.tree.frame, bvh.triangle(last), boxes)) {
      return "the triangle in slot " + std::to_string(last) +
             (boxes.size() == 1 ? " is not in " + where(last) : " is not in the boxes of its leaves");
    }
  }
  return "";
}

}  // namespace plumb::space
