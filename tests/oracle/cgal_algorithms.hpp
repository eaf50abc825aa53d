// Do CGAL's algorithms give the same on our signs as on Epick's?  What they make, as plain numbers that can be
// compared.
//
// Laws: both kernels get the same points in the same order; what comes back tells combinatorics only, in the order in
// which the algorithm made it (where CGAL keeps to one), so that equal results mean equal decisions all the way.  CGAL
// perturbs symbolically where points are degenerate, so the exact zeros count as much as the signs.
// Source: CGAL 5.5's manual.
// Cost: microseconds a point.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace plumb::oracle {

enum class KernelChoice { epick, ours };
enum class Algorithm { delaunay_2, delaunay_3, convex_hull_3 };

/// Of a triangulation the vertices, cell after cell; of a hull the points that lie in the plane of each facet, facet
/// after facet with its size ahead, or its vertices when it is flat.  A point is named by its place in the input, from
/// 1 (the first place of equal ones); 0 is the vertex at infinity.  Takes x y x y ... or x y z x y z ...
std::vector<std::uint32_t> made_by(Algorithm algorithm, KernelChoice kernel, std::span<const double> coordinates);

/// What each predicate that the kernel has from us answers about five points in space (x y z ...), and about their
/// first two coordinates: a name and -1, 0 or 1 each.  Those of coplanar points are asked only where they are.
struct Answer {
  std::string predicate;
  int sign;
  friend bool operator==(const Answer&, const Answer&) = default;
};
std::vector<Answer> answers_of(KernelChoice kernel, std::span<const double> five_points);

/// The same by CGAL's rational kernel.
std::vector<Answer> exact_answers(std::span<const double> five_points);

}  // namespace plumb::oracle
