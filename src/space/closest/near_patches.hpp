// What lies in a leaf, or in a node of few triangles, as doubles: its vertices, and how far it reaches along its own normal
// and along any other way.
//
// Laws: (1) no way is longer than 1, so that two patches are as far apart as they are along it, or farther.  (2) What a
// patch says of a way is off by no more than reach() for each vertex: the bound of the same sums at the largest numbers.
// Source: RTCD 4.3.4, 4.6.1.
// Cost: some 100 ns a patch, once; then five operations a vertex.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

#include "space/bvh/posed_box.hpp"
#include "space/closest/near_sources.hpp"

namespace plumb::space {

/// The same way, a little shorter than 1; none where doubles do not tell it.
inline Vector3 shorter_than_one(const Vector3& v) {
  constexpr double shorter = 1 - 0x1p-40;  // a guess; that it serves is proved
  const double by = shorter / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const Approximate x(v.x * by), y(v.y * by), z(v.z * by);
  return surely_above(x * x + y * y + z * z) <= 1 ? Vector3{x.value, y.value, z.value} : Vector3{0, 0, 0};
}

struct Stretch {
  double low, high;
};

struct NearPatch {
  std::uint32_t from = 0, to = 0;  // vertices
  std::uint32_t first = 0;         // of a leaf's triangles
  std::uint32_t slot = 0, slots = 0;
  Point3 middle{0, 0, 0};   // a guess
  Vector3 normal{0, 0, 0};  // likewise
  Stretch along_normal{0, 0};
  Stretch along_way{0, 0};  // that was asked for last
  std::uint32_t way = 0;
  bool is_beyond = false;  // the wall that was asked for last
  std::uint32_t wall = 0;
};

template <class Source>
class NearPatches {
 public:
  explicit NearPatches(Source& source)
      : source_(source), nodes_(source.bvh().tree.nodes.view()), of_node_(nodes_.size()) {}

  /// Answers for a leaf, or a node with few triangles below it, else none.
  NearPatch* operator[](std::uint32_t node) {
    std::uint32_t& patch = of_node_[node];
    if (patch == unknown) patch = make(node);
    return patch == none ? nullptr : &patches_[patch];
  }
  /// The box around the triangle in its slot of this number.
  [[nodiscard]] const Aabb3& box(const NearPatch& patch, std::uint32_t i) const {
    return triangles_[patch.first + i].box;
  }
  /// The triangle in its slot of this number, as doubles.
  [[nodiscard]] Triangle3 triangle(const NearPatch& patch, std::uint32_t i) const {
    const auto place = [&](std::uint32_t k) { return Point3{x_[k], y_[k], z_[k]}; };
    const auto& [a, b, c] = triangles_[patch.first + i].corners;
    return {place(a), place(b), place(c)};
  }
  [[nodiscard]] Stretch along(const NearPatch& patch, std::uint32_t i, const Vector3& way) const {
    const std::array<std::uint32_t, 3>& c = triangles_[patch.first + i].corners;
    const double u = at(c[0], way), v = at(c[1], way), w = at(c[2], way);
    return {std::min(u, std::min(v, w)), std::max(u, std::max(v, w))};
  }
  [[nodiscard]] Stretch along(const NearPatch& patch, const Vector3& way) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::array<double, at_once> low, high;
    low.fill(far), high.fill(-far);
    for (std::uint32_t i = patch.from; i < patch.to; i += at_once) {
      for (std::uint32_t k = 0; k < at_once; ++k) {
        const double is = at(i + k, way);
        low[k] = is < low[k] ? is : low[k];
        high[k] = is > high[k] ? is : high[k];
      }
    }
    return {std::min(std::min(low[0], low[1]), std::min(low[2], low[3])),
            std::max(std::max(high[0], high[1]), std::max(high[2], high[3]))};
  }
  /// The same of a way that has a number, which is kept.
  const Stretch& along(NearPatch& patch, const Vector3& way, std::uint32_t number) const {
    if (patch.way != number) patch.along_way = along(patch, way), patch.way = number;
    return patch.along_way;
  }

 private:
  struct PatchTriangle {
    Aabb3 box;
    std::array<std::uint32_t, 3> corners;
  };
  static constexpr std::uint32_t at_once = 4;
  /// A guess of the nodes, beside leaves, whose vertices are worth their time: each second or third level of them.
  static bool pays(std::uint32_t slots) { return (slots >= 20 && slots <= 48) || (slots >= 110 && slots <= 256); }
  static constexpr std::uint32_t unknown = 0, none = 1;

  [[nodiscard]] double at(std::uint32_t i, const Vector3& way) const {
    return way.x * x_[i] + way.y * y_[i] + way.z * z_[i];
  }

  std::uint32_t make(std::uint32_t node) {
    std::uint32_t first = node, last = node;
    while (!nodes_[first].is_leaf()) ++first;
    while (!nodes_[last].is_leaf()) last += nodes_[last].link;
    NearPatch patch;
    patch.slot = nodes_[first].link, patch.slots = nodes_[last].link + nodes_[last].count - patch.slot;
    const bool is_leaf = nodes_[node].is_leaf();
    if (!is_leaf && !pays(patch.slots)) return none;
    const std::span<const Bvh::Corners> all = source_.bvh().triangles.view().subspan(patch.slot, patch.slots);
    patch.from = static_cast<std::uint32_t>(x_.size()), patch.first = static_cast<std::uint32_t>(triangles_.size());
    around_.clear();
    forget_places(3 * patch.slots);
    for (const auto& [i, k, l] : all) {
      const std::array places{place_of(i), place_of(k), place_of(l)};
      const Aabb3 &a = around_[places[0]], &b = around_[places[1]], &c = around_[places[2]];
      if (is_leaf) {
        triangles_.push_back(
            {merged(merged(a, b), c), {patch.from + places[0], patch.from + places[1], patch.from + places[2]}});
      }
      const Point3 &p = a.min, &q = b.min, &r = c.min;
      const Vector3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
      patch.normal = {patch.normal.x + (u.y * v.z - u.z * v.y), patch.normal.y + (u.z * v.x - u.x * v.z),
                      patch.normal.z + (u.x * v.y - u.y * v.x)};
    }
    Aabb3 whole = around_[0];
    for (const Aabb3& box : around_) whole = merged(whole, box);
    while (x_.size() % at_once != 0) add(Aabb3(around_.back()));
    patch.to = static_cast<std::uint32_t>(x_.size());
    patch.middle = {whole.min.x / 2 + whole.max.x / 2, whole.min.y / 2 + whole.max.y / 2,
                    whole.min.z / 2 + whole.max.z / 2};
    patch.normal = shorter_than_one(patch.normal);
    patch.along_normal = along(patch, patch.normal);
    patches_.push_back(patch);
    return static_cast<std::uint32_t>(patches_.size()) - 1;
  }
  /// Among the vertices of the patch that is made, each of which is added once.
  std::uint32_t place_of(std::uint32_t vertex) {
    std::size_t i = vertex * 0x9e3779b1u >> 16;
    for (i &= known_.size() - 1; known_[i].patch == patches_.size(); i = (i + 1) & (known_.size() - 1)) {
      if (known_[i].vertex == vertex) return known_[i].place;
    }
    known_[i] = {patches_.size(), vertex, static_cast<std::uint32_t>(around_.size())};
    add(source_.around_vertex(vertex));
    return known_[i].place;
  }
  void forget_places(std::size_t most) {
    if (known_.size() < 2 * most) known_.assign(std::bit_ceil(2 * most), {});
  }
  void add(const Aabb3& box) {
    around_.push_back(box);
    x_.push_back(box.min.x), y_.push_back(box.min.y), z_.push_back(box.min.z);
  }

  Source& source_;
  std::span<const BoxNode> nodes_;
  std::vector<std::uint32_t> of_node_;
  std::deque<NearPatch> patches_ = std::deque<NearPatch>(2);  // of which none is unknown or none
  std::vector<PatchTriangle> triangles_;
  std::vector<double> x_, y_, z_;
  struct Known {
    std::size_t patch = 0;
    std::uint32_t vertex = 0, place = 0;
  };
  std::vector<Known> known_;  // by their hashes: where a vertex of the patch that is made is
  std::vector<Aabb3> around_;
};

/// No less than what a double along a way is off, of coordinates of at most this magnitude.
inline double reach_along_ways(double largest) {
  return raised(posed_part(1, 1, 1, 0, largest, largest, largest).reach());
}

}  // namespace plumb::space
