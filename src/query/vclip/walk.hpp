// V-Clip: from pair to pair of features, until they are nearest or a point is common.
//
// Laws: a step is a function of the pair alone.  What it decides is exact; of several features that it may go on to, it
// takes by a guess in doubles the one that seems nearest.
// Source: Mirtich 1998; RTCD 9.2.1.
// Cost: a step takes the planes of two features, at some 10 ns a sign.
#pragma once

#include "query/vclip/checked_signs.hpp"
#include "query/vclip/voronoi_planes.hpp"

namespace plumb::query::vclipping {

enum class Outcome : unsigned char {
  moved,
  nearest,
  holds_vertex,  // the vertex of the pair is in the other solid
  crosses,       // the edge of the pair has a point in the face of the other
};

class Walk {
 public:
  Walk(const Solid& a, const Solid& b, const MeshFeaturePair& start, CheckedSigns& sign)
      : solids_{&a, &b}, at_{start.a, start.b}, sign_(sign) {}

  [[nodiscard]] MeshFeaturePair pair() const { return {at_[0], at_[1]}; }
  Outcome step();
  /// Of an edge that crosses: the plane by which it comes in above the face, nothing where it begins there.
  [[nodiscard]] const std::optional<VoronoiPlane>& entry() const { return entry_; }

 private:
  Outcome move(std::size_t which, const MeshFeature& to) {
    at_[which] = to;
    return Outcome::moved;
  }
  Outcome from_vertices();
  Outcome from_edges();
  Outcome from_vertex_and_edge(std::size_t vertex);
  Outcome from_vertex_and_face(std::size_t vertex);
  Outcome from_edge_and_face(std::size_t edge);
  Outcome out_of_local_minimum(std::size_t vertex);
  /// The vertex that the other one is at.
  [[nodiscard]] bool is_below(std::size_t which, std::uint32_t face) const;
  [[nodiscard]] double guessed_square_to(std::size_t face_of, std::uint32_t face, std::uint32_t edge) const;

  template <class T>
  [[nodiscard]] Vec<T> place(std::size_t which) const {
    return solids_[which]->place<T>(at_[which].corner);
  }

  std::array<const Solid*, 2> solids_;
  std::array<MeshFeature, 2> at_;
  CheckedSigns& sign_;
  std::optional<VoronoiPlane> entry_;
};

}  // namespace plumb::query::vclipping
