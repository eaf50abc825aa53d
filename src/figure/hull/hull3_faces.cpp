#include "figure/hull/hull3_faces.hpp"

#include <numeric>

namespace plumb::figure::hull3 {

void FaceList::fan(std::span<const std::uint32_t> polygon) {
  const auto smallest = static_cast<std::size_t>(std::ranges::min_element(polygon) - polygon.begin());
  const auto at = [&](std::size_t i) { return polygon[(smallest + i) % polygon.size()]; };
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) triangle(at(0), at(i), at(i + 1));
}

void FaceList::move_to(Hull3& hull) {
  struct Key {
    std::uint64_t corners;
    std::uint32_t face;
  };
  const std::size_t count = first_.size() - 1;
  std::vector<Key> keys(count);
  std::uint32_t most = 0;
  for (std::size_t f = 0; f < count; ++f) {
    const auto from = corners_.begin() + first_[f], to = corners_.begin() + first_[f + 1];
    std::rotate(from, std::min_element(from, to), to);
    keys[f] = {std::uint64_t{*from} << 32 | *(from + 1), static_cast<std::uint32_t>(f)};
    most = std::max(most, *from);
  }
  // A directed edge belongs to one face, so no two keys are equal.
  const auto less = [](const Key& a, const Key& b) { return a.corners < b.corners; };
  if (most / 8 < count) {  // many faces: those of each first corner are brought together, then sorted
    std::vector<std::uint32_t> begin(std::size_t{most} + 2, 0);
    for (const Key& k : keys) ++begin[(k.corners >> 32) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Key> together(count);
    std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
    for (const Key& k : keys) together[at[k.corners >> 32]++] = k;
    for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
      std::sort(together.begin() + begin[i], together.begin() + begin[i + 1], less);
    }
    keys = std::move(together);
  } else {
    std::ranges::sort(keys, less);
  }
  hull.corners.reserve(corners_.size());
  hull.first.reserve(first_.size());
  for (const Key& k : keys) {
    hull.corners.insert(hull.corners.end(), corners_.begin() + first_[k.face], corners_.begin() + first_[k.face + 1]);
    hull.first.push_back(static_cast<std::uint32_t>(hull.corners.size()));
  }
  corners_.clear();
  first_.assign(1, 0);
}

Outlines::Outlines(const Surface& surface)
    : surface_(surface), inner_(3 * surface.faces().size(), 0), degree_(surface.nodes().size(), 0) {
  for (Id f = 0; f < surface.faces().size(); ++f) {
    if (!surface.faces()[f].alive()) continue;
    for (Id h = 3 * f; h < 3 * f + 3; ++h) {
      const Id twin = surface.twin(h);
      if (h < twin) {
        const Id opposite = surface.end_of(next_in_face(twin));
        inner_[h] = inner_[twin] = surface.side(f, surface.point(opposite)) == 0 ? 1 : 0;
        any_inner_ = any_inner_ || inner_[h] != 0;
      }
      if (inner_[h] == 0) ++degree_[surface.start_of(h)];
    }
  }
}

Hull3 faces_of(const Surface& surface, std::size_t input_size, const HullOptions& options) {
  const Outlines outlines(surface);
  FaceList faces;
  IndexSet vertices(input_size);
  std::vector<std::uint32_t> polygon;
  outlines.each([&](std::span<const Id> loop) {
    polygon.clear();
    for (const Id h : loop) {
      const Id node = surface.start_of(h);
      if (outlines.degree(node) < 3) continue;
      polygon.push_back(surface.nodes()[node].index);
      vertices.insert(polygon.back());
    }
    options.triangulate ? faces.fan(polygon) : faces.polygon(polygon);
  });
  Hull3 hull;
  hull.dimension = 3;
  hull.vertices = vertices.ascending();
  faces.move_to(hull);
  return hull;
}

}  // namespace plumb::figure::hull3
