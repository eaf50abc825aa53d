// Triangles on stations of a path become triangles on its corners: stations that an edge passes are taken out.
//
// Laws: a station that is no corner lies on the edge between the stations before and after it, with its triangles on
// one side; those become as many less one, of the same place.
// Source: Toussaint and Avis 1982: a chain that is seen from an edge is cut by one scan.
// Cost: the triangles about each.
#pragma once

#include <vector>

#include "surface/planar/ring_stations.hpp"

namespace plumb::surface {

class PassedStations {
 public:
  PassedStations(const GivenPoints& points, const std::vector<Station>& stations,
                 std::vector<StationTriangle>& triangles);

  /// False where triangles about a station are no fan.
  bool take_out();

 private:
  void note(std::uint32_t triangle);
  bool take_out(std::uint32_t passed);
  std::vector<std::uint32_t> chain_about(std::uint32_t passed);
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  const GivenPoints& points_;
  const std::vector<Station>& stations_;
  std::vector<StationTriangle>& triangles_;
  std::vector<std::vector<std::uint32_t>> about_;  // of stations that are no corners; some are dead
  std::vector<bool> dead_;
};

}  // namespace plumb::surface
