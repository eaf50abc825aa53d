/* What is asked of the surface of a mesh, and of the plane?  A part of plumb.h: components, loops, welding, faces of one
 * plane, sections, repair step by step, covers, clashes; Voronoi's vertices, convex pieces, arrangements of segments.
 *
 *   plumb_loops* loops;
 *   const plumb_loop* each;
 *   size_t count;
 *   if (plumb_mesh_boundary_loops(mesh, &loops) == PLUMB_OK) plumb_loops_of(loops, &each, &count);
 *
 * Laws: those of plumb.h.  What a report or an array of structs points to is there as long as the handle it is of.
 * Source: RTCD 12, by the names of plumb/surface.hpp; docs/c.md.
 * Cost: that of the C++ functions; figures are read, and numbers are copied, once.
 */
#ifndef PLUMB_SURFACES_H
#define PLUMB_SURFACES_H

#include "plumb/plumb.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- topology ---- */

/* Triangles are joined over edges of two triangles, over any edge, or over any vertex. */
typedef enum plumb_joined_over {
  PLUMB_OVER_MANIFOLD_EDGES = 0,
  PLUMB_OVER_EDGES,
  PLUMB_OVER_VERTICES
} plumb_joined_over;
/* The component of each triangle, by a plumb_joined_over, numbered by their first triangles; *count of them. */
plumb_status plumb_mesh_components(const plumb_mesh* mesh, int over, uint32_t* component_of, size_t* count);

/* What kind of surface each component over manifold edges is: it is closed where it has no loops. */
typedef struct plumb_surface_kind { /* does not grow: arrays of them are written */
  uint64_t vertices, edges, faces, loops;
  int64_t euler, genus; /* handles; of what is not orientable crosscaps */
  int32_t is_orientable;
} plumb_surface_kind;
/* *count is how many there are, also where the array is shorter. */
plumb_status plumb_mesh_surface_kinds(const plumb_mesh* mesh, plumb_surface_kind* kinds, size_t capacity,
                                      size_t* count);

/* Loops of vertices: where a surface ends; also the convex pieces of a polygon. */
typedef struct plumb_loops plumb_loops;
typedef struct plumb_loop { /* does not grow; the numbers are there as long as the handle */
  const uint32_t* vertices;
  size_t count;
  int32_t is_closed; /* else a chain, from an edge of more than two triangles to another */
} plumb_loop;
plumb_status plumb_mesh_boundary_loops(const plumb_mesh* mesh, plumb_loops** loops);
plumb_status plumb_loops_of(const plumb_loops* loops, const plumb_loop** each, size_t* count);
void plumb_loops_destroy(plumb_loops* loops);

/* ---- what mends ---- */

typedef enum plumb_weld_rule { PLUMB_CLUSTERS = 0, PLUMB_CHAINS } plumb_weld_rule;
typedef struct plumb_weld_options {
  size_t size;
  double tolerance;
  int32_t rule; /* plumb_weld_rule */
  int32_t keeps_turned; /* not 0: triangles may turn over */
} plumb_weld_options;
typedef struct plumb_merged_vertex { uint32_t vertex, into; double distance; } plumb_merged_vertex; /* does not grow */
/* What was merged, and the triangles that collapsed or were turned over; `refused` are first vertices of groups that
 * fell apart, for triangles would turn over.  All of it is there as long as the weld. */
typedef struct plumb_weld_report {
  size_t size;
  const uint32_t* into; /* of each vertex */
  const plumb_merged_vertex* merged;
  const uint32_t *collapsed, *turned, *refused;
  size_t vertex_count, merged_count, collapsed_count, turned_count, refused_count;
} plumb_weld_report;
typedef struct plumb_weld plumb_weld;
/* Options may be NULL: equal vertices alone. */
plumb_status plumb_mesh_weld(const plumb_mesh* mesh, const plumb_weld_options* options, plumb_mesh** welded,
                             plumb_weld** weld);
plumb_status plumb_weld_of(const plumb_weld* weld, plumb_weld_report* report);
void plumb_weld_destroy(plumb_weld* weld);

/* Neighbors in one plane as polygons with holes.  The rings of face f are first_ring[f] to first_ring[f + 1] - 1, the
 * vertices of ring r corners[first_corner[r]] to corners[first_corner[r + 1] - 1], and likewise a face's triangles.
 * `plane` is the triangle in whose plane a face is, `apart` are first triangles of what becomes no polygon. */
typedef struct plumb_coplanar_report {
  size_t size;
  const uint32_t *corners, *first_corner, *first_ring, *triangles, *first_triangle, *plane, *apart;
  size_t face_count, apart_count;
} plumb_coplanar_report;
typedef struct plumb_coplanar plumb_coplanar;
/* Within the tolerance; `drops_collinear`: vertices that all rings run straight through.  `fewer` is the mesh of the
 * polygons' triangles. */
plumb_status plumb_mesh_merge_coplanar(const plumb_mesh* mesh, double tolerance, int drops_collinear,
                                       plumb_mesh** fewer, plumb_coplanar** faces);
plumb_status plumb_coplanar_of(const plumb_coplanar* faces, plumb_coplanar_report* report);
void plumb_coplanar_destroy(plumb_coplanar* faces);

/* ---- sections ---- */

/* Where planes (of three points or a normal) cut a mesh: contours, plane by plane. */
typedef struct plumb_contours plumb_contours;
typedef struct plumb_contour { /* does not grow; the points are there as long as the handle */
  const double* points;
  size_t count, plane, depth; /* depth: how many contours lie around it */
  int64_t parent;             /* the number of the contour around it, or -1 */
  int32_t is_closed, turn;    /* turn: 1 counterclockwise, seen from the normal's side */
} plumb_contour;
/* `are_below`: vertices in a plane count as below it, else as above. */
plumb_status plumb_mesh_sections(const plumb_mesh* mesh, const plumb_figure* planes, size_t count, int are_below,
                                 plumb_contours** contours);
plumb_status plumb_contours_of(const plumb_contours* contours, const plumb_contour** each, size_t* count);
void plumb_contours_destroy(plumb_contours* contours);

/* The two sides of a plane (of three points or a normal) of the solid that a closed mesh bounds, each rounded; they have
 * the same corners where they are cut.  The normal's side is `above`.  The reports may be NULL. */
plumb_status plumb_mesh_split(const plumb_mesh* mesh, const plumb_figure* plane, plumb_mesh** above,
                              plumb_mesh** below, plumb_solid_report* of_above, plumb_solid_report* of_below);
/* The solid around which a closed mesh, which may cross itself, winds as a plumb_winding_rule says; where it merges, all
 * that lies in one plane becomes as few triangles as can be.  The report may be NULL. */
plumb_status plumb_mesh_resolve(const plumb_mesh* mesh, int rule, int merges, plumb_mesh** result,
                                plumb_solid_report* report);

/* ---- trees of solids ---- */

/* A leaf, if `mesh` or `figure` is not NULL: a closed mesh, or a box, tetrahedron or polyhedron that stands as it is.
 * Else a plumb_operation of the last `operands` trees that the steps before have made, one at least, which it takes. */
typedef struct plumb_tree_step { /* does not grow: arrays of them are read */
  const plumb_mesh* mesh;
  const plumb_figure* figure;
  int32_t operation;
  uint32_t operands;
} plumb_tree_step;
/* The solid of a tree whose steps stand in postfix order, its root last: all leaves are cut along one another once, and
 * the result is rounded at the end, however deep the tree is.  `merges`: all that lies in one plane becomes as few
 * triangles as can be.  The report may be NULL. */
plumb_status plumb_evaluate(const plumb_tree_step* steps, size_t count, int merges, plumb_mesh** result,
                            plumb_solid_report* report);

/* ---- exact chains ---- */

/* A surface with exact corners, in ascending order: what operations make of such is such again, so that a chain of them
 * is rounded once, at its end.  A mesh under a pose is not rounded; the pose may be NULL. */
typedef struct plumb_exact_mesh plumb_exact_mesh;
plumb_status plumb_exact_mesh_create(const plumb_mesh* mesh, const plumb_rigid3* pose, plumb_exact_mesh** exact);
void plumb_exact_mesh_destroy(plumb_exact_mesh* exact);
plumb_status plumb_exact_mesh_posed(const plumb_exact_mesh* exact, const plumb_rigid3* pose,
                                    plumb_exact_mesh** result);
/* A plumb_operation of closed ones; `merges` as of a tree. */
plumb_status plumb_exact_mesh_combine(int operation, const plumb_exact_mesh* const* meshes, size_t count, int merges,
                                      plumb_exact_mesh** result);
plumb_status plumb_exact_mesh_resolve(const plumb_exact_mesh* exact, int rule, int merges, plumb_exact_mesh** result);
/* The report may be NULL. */
plumb_status plumb_exact_mesh_round(const plumb_exact_mesh* exact, plumb_mesh** result, plumb_solid_report* report);
plumb_status plumb_exact_mesh_size(const plumb_exact_mesh* exact, size_t* vertices, size_t* triangles);
/* Three vertices of each; in `sources`, which may be NULL, which mesh of the last operation it is a piece of, and which
 * triangle of that.  They are there as long as the handle. */
plumb_status plumb_exact_mesh_triangles(const plumb_exact_mesh* exact, const uint32_t** triangles,
                                        const uint32_t** sources, size_t* count);
/* Fractions as text: "-8/3", and of a vertex "0 1/3 2".  *length is that of the whole text, of which an array that is
 * long enough gets all and the ending 0. */
plumb_status plumb_exact_mesh_volume(const plumb_exact_mesh* exact, char* text, size_t capacity, size_t* length);
plumb_status plumb_exact_mesh_vertex(const plumb_exact_mesh* exact, size_t vertex, char* text, size_t capacity,
                                     size_t* length);

/* Where two surfaces meet: polylines, and points where they touch.  plumb/surface/solid/intersection_curves.hpp says in
 * which order. */
typedef struct plumb_curves plumb_curves;
typedef struct plumb_curve {    /* does not grow; all of it is there as long as the handle */
  const double* points;         /* rounded once; of a closed curve the first is not told again */
  const uint32_t* faces;        /* a triangle of a and one of b for each edge, of a point for that */
  size_t count, face_count;
  int32_t is_closed;
} plumb_curve;
plumb_status plumb_intersection_curves(const plumb_mesh* a, const plumb_mesh* b, plumb_curves** curves);
plumb_status plumb_curves_of(const plumb_curves* curves, const plumb_curve** each, size_t* count);
void plumb_curves_destroy(plumb_curves* curves);

/* ---- repair, covers ---- */

/* The steps of plumb/surface/repair/repair.hpp. */
typedef enum plumb_repair_kind {
  PLUMB_WELD = 0, PLUMB_DEGENERATE, PLUMB_SLIVERS, PLUMB_T_JUNCTIONS, PLUMB_ZIP, PLUMB_DUPLICATES, PLUMB_WALLS,
  PLUMB_SMALL_COMPONENTS, PLUMB_ORIENTATION, PLUMB_HOLES, PLUMB_OUTWARD, PLUMB_SPLIT, PLUMB_MERGE_COPLANAR, PLUMB_UNUSED
} plumb_repair_kind;
typedef struct plumb_repair_step {
  size_t size;
  double tolerance;
  uint64_t smallest; /* the triangles that a component needs */
  int32_t kind, rule, keeps_turned, keeps_collinear;
} plumb_repair_step;
typedef struct plumb_repair_change {
  size_t size;
  const char* what; /* "hole filled" */
  double place[3], distance;
  uint64_t how_many;
  int32_t step, is_left; /* is_left: it could not be mended */
} plumb_repair_change;
/* Each change is told to `take`, which returns 0 to be told no more; it, `progress` and `faults` may be NULL. */
plumb_status plumb_mesh_repair_by(const plumb_mesh* mesh, const plumb_repair_step* steps, size_t count,
                                  const plumb_progress* progress, plumb_mesh** repaired, plumb_faults* faults,
                                  int (*take)(const plumb_repair_change* change, void* user), void* user);

/* The few hulls that cover a solid, none of which reaches farther beyond its share than the length that is told;
 * `concavity` is the length that is allowed, `most_parts` 0 for no limit.  As plumb_mesh_convex_parts tells parts. */
plumb_status plumb_mesh_covering_parts(const plumb_mesh* mesh, double concavity, uint32_t most_parts,
                                       int (*take)(const plumb_mesh* hull, double concavity, void* user), void* user);

/* ---- assemblies ---- */

/* Which parts are in each other's way: the words of plumb/world/clash.hpp, in its order. */
typedef enum plumb_clash_kind {
  PLUMB_CLASH_APART = 0, PLUMB_CLASH_WITHIN_CLEARANCE, PLUMB_CLASH_TOUCHING, PLUMB_CLASH_OVERLAPPING,
  PLUMB_CLASH_PIERCING, PLUMB_CLASH_ENCLOSED, PLUMB_CLASH_DUPLICATE
} plumb_clash_kind;
typedef struct plumb_clash { /* does not grow; NaN for a number that there is not */
  uint32_t a, b;             /* parts, a before b */
  int32_t kind, inner;       /* inner: 0 where a lies in b, 1 where b lies in a, else -1 */
  double place[3], distance, volume, depth_lower, depth_upper, direction[3]; /* a leaves along the direction */
  const uint32_t* meeting; /* triangles of a and of b in turn, there as long as the handle */
  size_t meeting_count;    /* pairs */
} plumb_clash;
typedef struct plumb_clash_pair { uint32_t a, b; double clearance; } plumb_clash_pair; /* does not grow */
typedef struct plumb_clash_options {
  size_t size;
  double clearance; /* of pairs that are at most so far apart; below zero: those that meet alone */
  int32_t measures; /* not 0: volume and depth, too */
  const plumb_clash_pair* pairs; /* NULL: all; else these, by their own clearances */
  size_t pair_count;
} plumb_clash_options;
typedef struct plumb_clashes plumb_clashes;
/* All pairs that are not apart, ascending, of parts where their vertices stand.  Options may be NULL: those that meet,
 * measured; so may progress. */
plumb_status plumb_find_clashes(const plumb_mesh* const* parts, size_t count, const plumb_clash_options* options,
                                const plumb_progress* progress, plumb_clashes** clashes);
plumb_status plumb_clashes_of(const plumb_clashes* clashes, const plumb_clash** each, size_t* count);
void plumb_clashes_destroy(plumb_clashes* clashes);

/* ---- of the plane ---- */

/* The triangle over each edge, from corner k to the next, UINT32_MAX for none; of Delaunay triangles alone. */
plumb_status plumb_triangles_neighbors(const plumb_triangles* triangles, const uint32_t** neighbors, size_t* count);
/* The vertices of the Voronoi diagram, two numbers for each Delaunay triangle, rounded once; none of segments. */
plumb_status plumb_voronoi_vertices(const plumb_triangles* triangles, double* vertices);
/* Convex polygons without new vertices; `fewest`: as few as can be, of a simple polygon, in n^3. */
plumb_status plumb_convex_pieces(const plumb_figure* polygon, int rule, int fewest, plumb_loops** pieces);

/* How segments (four numbers each) divide the plane: plumb/surface/planar/arrange_segments.hpp.  All of it is there as
 * long as the arrangement. */
typedef struct plumb_arrangement_report {
  size_t size;
  const double* vertices; /* two numbers each, rounded once */
  const uint32_t *ends, *edges, *sides, *triangles, *face_of;
  const int32_t *weights, *windings; /* windings: one a face; NULL where faces have none */
  size_t vertex_count, segment_count, edge_count, triangle_count, face_count;
} plumb_arrangement_report;
typedef struct plumb_arrangement plumb_arrangement;
plumb_status plumb_arrange_segments(const double* segments, size_t count, plumb_arrangement** arrangement);
plumb_status plumb_arrangement_of(const plumb_arrangement* arrangement, plumb_arrangement_report* report);
void plumb_arrangement_destroy(plumb_arrangement* arrangement);

#ifdef __cplusplus
}
#endif

#endif
