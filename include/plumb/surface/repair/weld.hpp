// Vertex welding: which vertices are one and the same, exactly or within a tolerance, and what becomes of the triangles?
//
//   const Weld weld = find_weld(mesh, {.tolerance = 1e-6});
//   for (const MergedVertex& m : weld.merged) print(m.vertex, m.into, m.distance);
//   const TriangleMesh mended = welded(mesh, weld);
//
// Equal points (-0 equals +0) are always one.  Within a tolerance above 0 points become one by a named rule:
// - clusters: no group is wider than the tolerance: each two of its points are at most that far apart.  The least point
//   that is in no group opens one; the others within reach join it, the nearest first, if they are near enough to all
//   that have.  Points are ordered by x, then y, then z; of equally near ones the least is first.
// - chains: all that short steps connect, of at most the tolerance each; a group may be as long as it likes.
// Laws: (1) distances are compared with the tolerance exactly, equal ones are within.  (2) A group becomes its least
// point, of equal points that of the smallest number: no new coordinate is made.  (3) Groups depend on the points alone,
// not on the order of vertices or triangles, nor on threads.  (4) A triangle is turned over where the exact dot product
// of its normals before and after is negative.  Where that is refused, the groups of its corners, but for equal points,
// fall apart, all at once, until none is.  (5) What joins no group stays bit for bit.  Points that no triangle names
// are welded as well.
// A tolerance that is NaN or infinite throws NonFinite, a negative one InvalidShape; so do meshes that are none.
// Source: RTCD 12.1.
// Cost: linear, but for equal points, where the tolerance is 0; else a k-d tree and a range search for each point that
// passes over what is in a group, and for clusters a search of the group so far, by boxes, for what is beyond reach.
// Near n log n however dense the points; farther where most pairs are all but as far apart as the tolerance.  Bounded by
// n^2 log n operations, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/certify/batch.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

enum class WeldRule : unsigned char { clusters, chains };
enum class TurnedOver : unsigned char { refused, kept };

struct WeldOptions {
  double tolerance = 0;
  WeldRule rule = WeldRule::clusters;
  TurnedOver turned_over = TurnedOver::refused;
  Execution execution = Execution::parallel;
};

struct MergedVertex {
  std::uint32_t vertex, into;
  double distance;  // the double nearest to how far it moved
  friend bool operator==(const MergedVertex&, const MergedVertex&) = default;
};

struct Weld {
  std::vector<std::uint32_t> into;       // of each vertex, its own number where it stays
  std::vector<MergedVertex> merged;      // those that do not stay, ascending
  std::vector<std::uint32_t> collapsed;  // triangles, two corners of which became one
  std::vector<std::uint32_t> turned;     // triangles that are turned over
  std::vector<std::uint32_t> refused;    // first vertices of groups that fell apart, since triangles would turn over
};

Weld find_weld(const TriangleMesh& mesh, const WeldOptions& options = {});

/// The triangles with their new vertices, without those that collapsed; all vertices stay, used or not.
TriangleMesh welded(const TriangleMesh& mesh, const Weld& weld);

}  // namespace plumb
