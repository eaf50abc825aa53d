// Where does a closed path leave and reach the vertices of its triangulation?  Its stations, and what they cut off.
//
// Laws: those of cut_ring.hpp.  Triangles are named by stations.
// Cost: linear in the degrees of the vertices.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "surface/planar/triangulator.hpp"

namespace plumb::surface {

using StationTriangle = std::array<std::uint32_t, 3>;

struct Station {
  Vertex vertex;
  std::uint32_t corner;  // of the path, or none where an edge passes
  HalfEdge in, out;      // none where an edge has no length
  std::uint32_t previous, next;
};

class RingStations {
 public:
  /// The path goes counterclockwise, or is walked backward.
  RingStations(const Triangulator<GivenPoints>& made, std::uint32_t corners, bool backward);

  /// Folds with the outside about them and edges without length are cut off, pinches divided.  False where that does
  /// not make rings of faces.
  bool divide(std::span<const std::int32_t> windings, std::int32_t inside);

  [[nodiscard]] const std::vector<Station>& stations() const { return stations_; }
  /// Those without area.
  [[nodiscard]] const std::vector<StationTriangle>& flat() const { return flat_; }
  /// The station to which the corner of a triangle belongs from which a half-edge leaves.
  [[nodiscard]] std::uint32_t station_at(HalfEdge e) const { return sector_[e]; }

 private:
  void add_edge(std::uint32_t from, std::uint32_t to);
  HalfEdge toward(Vertex a, Vertex b) const;
  void link(std::uint32_t k, std::uint32_t n);
  void cut_folds(std::span<const std::int32_t> windings, std::int32_t inside);
  bool collect_sectors(std::span<const std::int32_t> windings, std::int32_t inside);
  void divide_pinches();

  const Triangulator<GivenPoints>& made_;
  const Triangles& triangles_;
  std::vector<HalfEdge> leaving_;
  std::vector<std::uint32_t> degree_;
  std::vector<Station> stations_;
  std::vector<bool> gone_;
  std::vector<StationTriangle> flat_;
  std::vector<std::uint32_t> sector_;   // of half-edges
  std::vector<std::uint32_t> closing_;  // of a station: the one whose incoming edge ends its sector
};

}  // namespace plumb::surface
