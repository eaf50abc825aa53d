// Along which direction is the least translation that parts two bodies?
//
// Laws: those of plumb/query/penetration/penetration.hpp; nothing of bodies that are disjoint.
// Source: query/penetration/search.hpp; of cores that are apart, query/separation/proved_corners.hpp.
// Cost: that of both.
#pragma once

#include "query/penetration/basis.hpp"
#include "query/penetration/proved_surface.hpp"
#include "query/penetration/search.hpp"
#include "query/penetration/way.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query::parting {

struct Parting {
  Way way;
  bool cores_are_apart, is_unique;
  bool cores_touch = false;                            // as they stand, known for certain; else it may be so
  std::optional<std::array<LevelCorners, 2>> level{};  // of each body what lies in the plane, where it is known
};

/// `radii`: both together, where a body has one.
std::optional<Parting> parted(const Difference& d, const std::optional<mpq_class>& radii);

/// Do the cores meet, and which corners of their difference are nearest to the origin?
struct CoreDistance {
  DifferenceCorners nearest;
  bool meet = false;
};
CoreDistance core_distance(const Difference& d);

/// From there on: of cores that are apart the way back from the nearest point.
Parting parted_from(const Difference& d, const CoreDistance& core);

/// The sign of that distance less the radii, of cores that are apart.
Sign compare_with_radii(const Difference& d, const DifferenceCorners& nearest, const mpq_class& radii);

/// Of cores that meet; a flat difference has its origin on the boundary, and no facets.
template <class Aim>
NearestPlanes nearest_planes(const Difference& d, const CoreDistance& core, const Aim& aim) {
  const bool around = core.nearest.size == 4;
  const Basis basis = around ? Basis() : affine_basis(d, {core.nearest.ends.data(), core.nearest.size});
  if (!around && basis.size() < 4) return {Origin::on_boundary, {}, {}, basis};
  const std::array<Ends, 4>& start = around ? core.nearest.ends : basis.all();
  if constexpr (std::is_same_v<Aim, EveryWay>) {
    if (auto proved = proved_planes(d, start)) return *proved;
  }
  return Search(d, aim).run(start, around);
}

/// The first of several facets, by the direction in which the body leaves.
struct FirstWay {
  std::size_t index;
  bool is_unique;
};
FirstWay first_way(const Difference& d, std::span<const std::array<Ends, 3>> facets);
Parting first_of(const Difference& d, const NearestPlanes& planes);

}  // namespace plumb::query::parting
