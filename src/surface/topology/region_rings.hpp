// Along which rings does a part of a mesh end, and through which vertices do all rings run straight?
//
// Laws: (1) rings are made of the half-edges of a part whose twins are not of it; each is passed once.  A ring runs as
// the triangles do, and keeps to one fan at a vertex.  (2) A vertex is straight where all rings that pass it run between
// the same two neighbors and straight through it: to drop it divides no edge of one part that another has whole.
// Source: RTCD 12.2.2, 12.4.
// Cost: linear.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "plumb/surface/topology/adjacency.hpp"

namespace plumb::surface {

class RegionRings {
 public:
  /// The spans outlive this; region[t] is the part of triangle t, which may be told later.
  RegionRings(std::span<const TriangleMesh::Triangle> triangles, std::span<const std::uint32_t> twin,
              std::span<const std::uint32_t> region)
      : triangles_(triangles), twin_(twin), region_(region), passed_(3 * triangles.size()) {}

  /// Of the part that these triangles are.
  std::vector<std::vector<std::uint32_t>> of(std::span<const std::uint32_t> part) {
    std::vector<std::vector<std::uint32_t>> rings;
    for (const std::uint32_t t : part) {
      for (std::uint32_t start = 3 * t; start < 3 * t + 3; ++start) {
        if (passed_[start] || is_inner(start)) continue;
        std::vector<std::uint32_t> ring;
        std::uint32_t h = start;
        do {
          passed_[h] = true;
          ring.push_back(triangles_[h / 3][h % 3]);
          for (h = next_half_edge(h); is_inner(h);) h = next_half_edge(twin_[h]);
        } while (h != start);
        rings.push_back(std::move(ring));
      }
    }
    return rings;
  }

 private:
  [[nodiscard]] bool is_inner(std::uint32_t h) const {
    return twin_[h] != no_half_edge && region_[twin_[h] / 3] == region_[h / 3];
  }

  std::span<const TriangleMesh::Triangle> triangles_;
  std::span<const std::uint32_t> twin_, region_;
  std::vector<bool> passed_;
};

/// Who is beside each vertex on the rings that pass it?
class RingNeighbors {
 public:
  explicit RingNeighbors(std::size_t vertices) : beside_(vertices, {none_yet, none_yet}), branches_(vertices) {}

  void add(std::span<const std::uint32_t> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      auto& [one, other] = beside_[ring[i]];
      for (const std::uint32_t v : {ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]}) {
        if (one == none_yet || one == v) {
          one = v;
        } else if (other == none_yet || other == v) {
          other = v;
        } else {
          branches_[ring[i]] = true;
        }
      }
    }
  }

  [[nodiscard]] bool is_passed(std::uint32_t v) const { return beside_[v][0] != none_yet; }
  /// Where between(a, v, b) says whether v is on the segment from a to b, and none of its ends.
  template <class Between>
  [[nodiscard]] bool is_straight(std::uint32_t v, const Between& between) const {
    const auto& [one, other] = beside_[v];
    return !branches_[v] && other != none_yet && between(one, v, other);
  }

 private:
  static constexpr std::uint32_t none_yet = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::array<std::uint32_t, 2>> beside_;
  std::vector<bool> branches_;
};

}  // namespace plumb::surface
