// Shells, connected components: of which closed surfaces does a mesh consist, which lies in which, and is each wound as
// it should be?
//
//   for (const Shell& s : find_shells(mesh).shells)
//     if (s.inside_out()) turn(s);                        // an outer shell wound inward, a cavity wound outward
//
// A shell is a connected component of the triangles over manifold edges: those of exactly two triangles, as vertices are
// numbered.  That is what mesh libraries call components, parts or, at edges of more triangles, manifold patches; in
// solids it is the shell of a boundary representation.  At an edge of more triangles, and at a vertex alone, shells
// end: two cubes that share an edge are two shells, and a box whose wall divides it in two is three.
// Laws: (1) every triangle is in one shell, but for those that name a vertex twice, which are in none; shells ascend by
// their first triangles.  (2) A shell is closed where each edge is in an even number of its triangles, oriented where
// they run along each edge as often one way as the other, but for one where their number is odd.  (3) The volume, of a
// shell that is closed and oriented, is exact and rounded once, positive where triangles turn counterclockwise seen
// from outside; volume_sign is that of the exact volume, also where this rounds to zero.  (4) Shells meet where they
// have a point in common.  They cross where triangles of theirs that are not coplanar overlap, or where one is seen on
// both sides of a closed one: at its vertices, and in the middle of its triangles that meet another shell.  (5) A shell
// lies in a closed one that it does not cross where it is seen inside of it, and nowhere outside; the parent
// is the innermost of these, depth is how many there are.  Whether a point is inside is decided by parity
// (plumb/query/ray/parity.hpp), whichever way shells are wound.  (6) A shell is inside out where its depth is even and
// its volume negative, or its depth odd and its volume positive.  (7) A shell that is not closed is a wall where its
// depth is odd, or where on both of its sides is a cell that its neighbors at edges of more than two triangles enclose;
// the latter of surfaces that do not cross, and have no two triangles on one another at such an edge.  (8) All of it is
// exact, and depends on the mesh alone, not on threads.
// Shells that pass through one another by edges and vertices only, between what law 4 looks at, are told to meet.
// A triangle that names no vertex throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.4.3, 12.3; Zhou et al. 2016 for cells at edges of many triangles.
// Cost: that of a tree and of its pairs of triangles that meet (plumb/space/pairs/mesh_pairs.hpp); n log n for edges;
// 0.3 us a triangle for volumes; a descent for each shell where there are several, for each vertex of those that touch
// or cross another, and for each of their triangles that does.  Memory: a word for each pair of shells that cross.
// Bounded by n^2 tests of pairs, and n for each shell, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/arith/sign.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb {

struct Shell {
  std::uint32_t first_triangle = 0;
  std::uint32_t triangles = 0;
  bool closed = false, oriented = false;
  bool meets = false, crosses = false;  // another shell
  bool wall = false;                    // not closed, inside of a solid
  std::optional<double> volume{};       // signed
  Sign volume_sign = Sign::zero;
  std::optional<std::uint32_t> parent{};  // the innermost closed shell around it
  std::uint32_t depth = 0;                // how many closed shells are around it

  [[nodiscard]] bool inside_out() const { return volume_sign == (depth % 2 == 0 ? Sign::negative : Sign::positive); }
  friend bool operator==(const Shell&, const Shell&) = default;
};

inline constexpr std::uint32_t no_shell = std::numeric_limits<std::uint32_t>::max();

using ShellPair = std::pair<std::uint32_t, std::uint32_t>;

struct Shells {
  std::vector<Shell> shells;
  std::vector<std::uint32_t> shell_of;  // of each triangle
  std::vector<ShellPair> crossing;      // pairs that cross, one of them closed: ascending
  PairCount met;                        // pairs of triangles, as count_intersecting_pairs has them
};

struct ShellOptions {
  Execution execution = Execution::parallel;
  Progress progress = {};  // of the pairs of triangles, which take the longest
};

/// The edges and the tree are those of the mesh.
Shells find_shells(const TriangleMesh& mesh, const MeshEdges& edges, const Bvh& bvh, const ShellOptions& options = {});
Shells find_shells(const TriangleMesh& mesh, const ShellOptions& options = {});

}  // namespace plumb
