// Mesh repair: what makes this mesh the surface of a solid, and what was changed?
//
//   const Repaired done = repair(mesh);                            // the default plan: a printable solid
//   const Repaired less = repair(mesh, {{{RepairKind::weld, 1e-6}, {RepairKind::holes}}});
//   for (const RepairChange& c : done.changes) print(text_of(c.kind), c.place, c.count);
//   done.faults.closed, done.faults.open_edges ...                 // judged by find_faults, as any mesh is
//
// Steps are data, run in the order in which they are given:
// - weld: vertices within the tolerance of each other become one (weld.hpp); triangles that collapse are left out.
// - degenerate: triangles that name a vertex twice, or whose corners are exactly on one line, are left out; the
//   neighbor at the longest edge is divided at the corner on it, so that no gap is left.
// - slivers: the same of triangles with a corner within the tolerance of the opposite edge, and between its ends.
// - t_junctions: triangles are divided where a vertex is exactly on their edge, until none is; then those at an edge,
//   open or not, that a vertex is near to (defects.hpp), within the tolerance, as long as fewer are left by it.
// - zip: open edges alone: their ends are welded within the tolerance, and those that run by an end of another within
//   the tolerance are divided there, as long as edges are closed by it.
// - duplicates: of triangles on the same three points at most one is left: of equal ones the first, of opposite ones that
//   which its neighbors agree with, or none (a wall without thickness).
// - walls: open shells inside of a solid are left out (shells.hpp), but those that all but enclose a space: the area
//   that their triangles leave over, as vectors in sum, is less than half of their own.  They are cavities with holes.
// - small_components: those of fewer triangles than `size`, joined over edges, are left out.
// - orientation: over edges of two triangles, each component is wound alike; the fewer triangles are turned.
// - holes: boundary loops are filled, without new vertices.  Loops of one plane, one around others, are filled between
//   them; a loop in a plane by exact triangulation; others by the filling of exactly the least area, for loops of at most
//   256 corners, and are left where another filling, which is not the same surface, has exactly that area.  A filling
//   that would meet the surface or another filling beyond its loop, decided exactly, is refused; then, and for longer
//   loops, the smallest corners are cut off (a guess in doubles).
// - outward: closed shells that are inside out are turned, by exact volumes and nesting.
// - split: a vertex of several fans becomes one vertex a fan; at an edge of four triangles and more those that bound
//   the same solid stay together; shells that come of it are turned outward.
// - merge_coplanar: neighbors in one plane, exactly or within the tolerance (merge_coplanar.hpp), are triangulated anew
//   where that gives fewer triangles; vertices that all faces run straight through are dropped, unless they are kept.
// - unused: vertices that no triangle names are left out.
// Laws: (1) no vertex gets a new coordinate; vertices and triangles that no step names stay, bit for bit, in their order.
// (2) Everything is decided exactly, tolerances are compared exactly; what is a guess is which corners of a loop are cut
// off first.  (3)
// The same mesh with vertices and triangles in another order becomes the same mesh in another order, where equal points
// are one vertex: weld comes first, or a step may tell them apart; threads change nothing.  (4) What cannot be mended
// stays, and is in the list of changes (is_left), but for what a later step mended, took away or tells again.  (5)
// Crossing surfaces are not parted.
// A mesh that is none, a step that there is not and a negative tolerance throw InvalidShape; what is NaN or infinite
// NonFinite.
// Source: RTCD 12.1, 12.3, 12.5.1; Barequet and Sharir 1995 (least area).
// Cost: a tree and the pairs of triangles that meet, some 1 us a triangle for each step that asks about nesting or
// fillings, and for the judgement; n^3 intervals for a loop of n <= 256 corners that is in no plane, and n^4 exact areas
// where large pieces of it are in one plane each, so that most fillings are equally large.  Bounded by n^4 operations,
// on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/space/bvh/progress.hpp"
#include "plumb/surface/repair/merge_coplanar.hpp"
#include "plumb/surface/repair/weld.hpp"
#include "plumb/surface/topology/faults.hpp"

namespace plumb {

enum class RepairKind : unsigned char {
  weld,
  degenerate,
  slivers,
  t_junctions,
  zip,
  duplicates,
  walls,
  small_components,
  orientation,
  holes,
  outward,
  split,
  merge_coplanar,
  unused
};
inline constexpr std::size_t repair_kinds = 14;

/// "weld", "t-junctions", ...
std::string_view name_of(RepairKind kind);

struct RepairStep {
  RepairKind kind;
  double tolerance = 0;                                      // of weld, slivers, t_junctions, zip and merge_coplanar
  std::uint64_t size = 0;                                    // of small_components
  WeldRule rule = WeldRule::clusters;                        // of weld and zip
  TurnedOver turned_over = TurnedOver::refused;              // of weld and zip
  CollinearVertices collinear = CollinearVertices::dropped;  // of merge_coplanar
};

/// weld, degenerate, t_junctions, duplicates, walls, orientation, holes, walls again (of solids that had holes), outward,
/// split, unused.  Where there is a tolerance, zip and t_junctions within it come before duplicates.
std::vector<RepairStep> printable_solid(double tolerance = 0);

enum class ChangeKind : unsigned char {
  merged_vertex,       // came to another; `distance` is how far
  collapsed_triangle,  // two of its corners were merged
  flat_triangle,       // left out: degenerate or a sliver
  divided_edge,        // at the place; `count` triangles were divided there
  duplicate_triangle,
  opposite_triangle,
  removed_wall,  // of `count` triangles, as those below
  removed_component,
  turned_triangles,  // to agree with others
  filled_hole,       // by `count` triangles
  turned_shell,
  split_vertex,     // into `count` more
  merged_coplanar,  // `count` triangles in one plane became fewer
  unused_vertex,
  // What is left as it was:
  turning_group,   // vertices that were not merged, for a triangle would turn over
  kept_flat,       // a degenerate triangle or sliver whose neighbor cannot be divided
  kept_junction,   // a vertex by an edge that cannot be divided there
  one_sided,       // a component of `count` triangles that no turning makes agree: a Moebius strip
  kept_hole,       // of `count` edges: its filling would meet the surface
  tied_hole,       // of `count` edges: two fillings have exactly the least area
  one_sided_hole,  // of a component that is one-sided
  open_chain,      // open edges that end at edges of more than two triangles
  kept_edge,       // of more than two triangles
  kept_coplanar,   // triangles in one plane that cover one another there, or touch with a vertex
};
inline constexpr std::size_t change_kinds = 24;

/// "vertex merged", ...
std::string_view text_of(ChangeKind kind);
constexpr bool is_left(ChangeKind kind) { return kind >= ChangeKind::turning_group; }

struct RepairChange {
  ChangeKind kind;
  RepairKind step;
  Point3 place;  // a vertex of what was changed
  std::uint64_t count = 1;
  double distance = 0;
  friend bool operator==(const RepairChange&, const RepairChange&) = default;
};

struct RepairOptions {
  Execution execution = Execution::parallel;
  Progress progress = {};
  bool judge = true;  // else `faults` says nothing
};

struct Repaired {
  TriangleMesh mesh;
  std::vector<RepairChange> changes;  // step by step
  SurfaceFaults faults;               // of the mesh as it is now
};

Repaired repair(TriangleMesh mesh, std::span<const RepairStep> steps, const RepairOptions& options = {});
Repaired repair(TriangleMesh mesh, std::initializer_list<RepairStep> steps, const RepairOptions& options = {});
Repaired repair(TriangleMesh mesh, const RepairOptions& options = {});

}  // namespace plumb
