// Separation of two hierarchies: the nearest points of the coarsest polytopes, then of one that is finer by a step
// against the other, in turn.
//
// What of the finer polytope lies beyond the plane through the nearest point, at right angles to the way, is within the
// hull of one removed vertex and its neighbors, as query/polytope_hierarchy/descent.hpp says.  Where there is no such
// vertex the pair is still the nearest.  Where there is one, the point is not nearest any more: it is in the hull of
// these few, which all the corners in the plane are among, and from it a way leads nearer; whatever is nearer begins
// beyond the plane, and so within that hull.  So the nearest pair is that of the few and of the other polytope, down
// which they descend by themselves.
#include "arith/exact_number.hpp"
#include "plumb/query/separation/separation.hpp"
#include "query/polytope_hierarchy/nearest_way.hpp"
#include "query/separation/corner_numbers.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb {
namespace query::hierarchy {
namespace {

struct NearestOfBoth {
  DifferenceCorners corners;  // by ranks of a and of b
  bool meets;
};

/// A finer polytope of `h`, which is number `of` of the two, against that of `other` of which `level` is the finest.
/// False where a number takes too many bits.
bool refine(const PolytopeHierarchy& h, std::size_t of, std::size_t finer, const PolytopeHierarchy& other,
            std::size_t level, const std::array<CoreCorners, 2>& both, NearestOfBoth& found) {
  const std::uint32_t at = fewest_removed(h.levels[finer], named(found.corners, of).all());
  const NearestWay toward_other(both[0], both[1], found.corners, of == 0 ? Heading::to_second : Heading::to_first);
  const auto beyond = beyond_plane(h, h.levels[finer], at, toward_other);
  if (!beyond) return true;
  const Candidates candidates = candidates_about(h, finer, *beyond);
  const auto nearer = nearest(other, corners_of(candidates.all()), level);
  if (!nearer) return false;
  found = {nearer->corners, nearer->meets};
  for (std::size_t k = 0; k < found.corners.size; ++k) {
    const auto [few, rank] = nearer->corners.ends[k];
    found.corners.ends[k][of] = candidates.rank[few], found.corners.ends[k][1 - of] = rank;
  }
  return true;
}

std::optional<NearestOfBoth> nearest_of_both(const PolytopeHierarchy& a, const PolytopeHierarchy& b) {
  const std::array both{corners_of(a.points), corners_of(b.points)};
  const auto coarsest = proved_nearest(corners_of(std::span(a.points).first(a.levels.back().size)),
                                       corners_of(std::span(b.points).first(b.levels.back().size)));
  if (!coarsest) return {};
  NearestOfBoth found{coarsest->corners, coarsest->meets};
  std::size_t i = a.levels.size() - 1, j = b.levels.size() - 1;
  while ((i > 0 || j > 0) && !found.meets) {
    if (i > 0 && !refine(a, 0, --i, b, j, both, found)) return {};
    if (j > 0 && !found.meets && !refine(b, 1, --j, a, i, both, found)) return {};
  }
  return found;
}

}  // namespace
}  // namespace query::hierarchy

double distance(const PolytopeHierarchy& a, const PolytopeHierarchy& b) {
  using namespace query::hierarchy;
  const auto found = nearest_of_both(a, b);
  if (!found) return distance(a.polyhedron, b.polyhedron);
  return found->meets ? 0 : query::distance_of(corners_of(a.points), corners_of(b.points), found->corners);
}

Rational squared_distance_exact(const PolytopeHierarchy& a, const PolytopeHierarchy& b) {
  using namespace query::hierarchy;
  const auto found = nearest_of_both(a, b);
  if (!found) return exact_distance(a.polyhedron, b.polyhedron).square;
  if (found->meets) return 0;
  return exact_number(query::square_of(corners_of(a.points), corners_of(b.points), found->corners));
}

bool intersects(const PolytopeHierarchy& a, const PolytopeHierarchy& b) {
  const auto found = query::hierarchy::nearest_of_both(a, b);
  return found ? found->meets : exact_distance(a.polyhedron, b.polyhedron).square.sign() == Sign::zero;
}

}  // namespace plumb
