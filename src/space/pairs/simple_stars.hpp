// At which vertices of a mesh have the triangles around no more in common than the vertices that they share?
//
// Those of which some way shows one side alone, and whose sectors around the vertex, seen along it, follow one another
// once round or less: what two have in common is then seen where their sectors meet, at a shared edge or at the vertex.
// Laws: (1) of two triangles that share one of these vertices relate_in_mesh says disjoint.  (2) Nothing is said of other
// vertices: the way is a guess, which exact signs prove.
// Source: Volino and Magnenat-Thalmann 1994, of a surface that one way shows, here of a star and by exact signs.
// Cost: 3 orient2d a triangle, and where no axis of space shows one side, or a fan is open, 2 orient3d for each of its
// corners; bounded by 256 comparisons for each, for of vertices with more triangles nothing is said.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/pairs/slot_mesh.hpp"

namespace plumb::space {

class SimpleStars {
 public:
  /// Takes a mesh none of whose triangles is in two slots.
  template <class Mesh>
  SimpleStars(const SlotMesh<Mesh>& mesh, std::size_t slots, Execution execution);

  [[nodiscard]] bool has(std::uint32_t vertex) const { return is_simple_[vertex] != 0; }
  /// Do they share one of these vertices?  Then they have no more in common than what they share.
  [[nodiscard]] bool tell_apart(const Bvh::Corners& a, const Bvh::Corners& b) const {
    for (const std::uint32_t v : a) {
      if ((v == b[0] || v == b[1] || v == b[2]) && has(v)) return true;
    }
    return false;
  }

 private:
  std::vector<std::uint8_t> is_simple_;
};

/// Those of a mesh that is asked about itself, computed when the first part of a search has found less than it wanted;
/// none of two meshes, under a pose, or where a triangle is in several slots.
template <class Source>
class StarsOfSearch {
 public:
  StarsOfSearch(const Source& source, bool is_own, Execution execution)
      : source_(source), may_be_asked_(is_own && !is_posed_source<Source>) {
    if (execution == Execution::parallel) compute(execution);
  }
  /// Parts come one after another where they were not computed at once.
  [[nodiscard]] const SimpleStars* before(std::size_t part) {
    if (part > 0 && may_be_asked_) compute(Execution::serial);
    return stars_ ? &*stars_ : nullptr;
  }

 private:
  void compute(Execution execution) {
    if constexpr (!is_posed_source<Source>) {
      if (!std::exchange(may_be_asked_, false) || is_split(source_)) return;
      stars_.emplace(SlotMesh<Source>(source_), source_.slots(), execution);
    }
  }
  const Source& source_;
  bool may_be_asked_;
  std::optional<SimpleStars> stars_;
};

}  // namespace plumb::space
