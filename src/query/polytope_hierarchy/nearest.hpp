// Distance of a hierarchy: where does its polytope come nearest to a point, a segment or another small body?
//
// The nearest point of the coarsest polytope, then of each finer one: what of that is beyond the plane through the one
// before, at right angles to the way, is within the hull of one removed vertex and its neighbors, eight at most, and
// nothing else of it can be nearer.
// Laws: exact; nothing where a number takes more than a thousand bits.
// Source: Dobkin and Kirkpatrick 1990; RTCD 9.3.1.
// Cost: a step of query/polytope_hierarchy/descent.hpp a polytope, and a search among nine points where it finds one.
#pragma once

#include "query/polytope_hierarchy/descent.hpp"
#include "query/separation/nearest_corners.hpp"

namespace plumb::query::hierarchy {

struct NearestOfHierarchy {
  DifferenceCorners corners;  // of the body, and of the polytope by its ranks
  bool meets;
  // The finest polytope that changed the answer; of another than the coarsest the vertex about which it did.
  std::size_t level;
  std::optional<std::uint32_t> about;
};

/// Where the body meets a polytope of the hierarchy, finer ones are not asked; nor are those finer than `finest`.
std::optional<NearestOfHierarchy> nearest(const PolytopeHierarchy& h, const CoreCorners& body, std::size_t finest = 0);

/// A vertex that was removed of the polytope `level`, and its neighbors there: all that can be nearer than the coarser
/// one.
struct Candidates {
  std::array<std::uint32_t, PolytopeHierarchy::most_neighbors + 1> rank;
  std::array<Point3, PolytopeHierarchy::most_neighbors + 1> points;
  std::size_t size = 0;
  [[nodiscard]] std::span<const Point3> all() const { return {points.data(), size}; }
};
Candidates candidates_about(const PolytopeHierarchy& h, std::size_t level, std::uint32_t removed);

/// Of vertices in a plane the one that has the fewest removed neighbors to be asked.
std::uint32_t fewest_removed(const HierarchyLevel& finer, std::span<const std::uint32_t> ranks);

/// Of the hull of these points, which live longer.
CoreCorners corners_of(std::span<const Point3> points);

}  // namespace plumb::query::hierarchy
