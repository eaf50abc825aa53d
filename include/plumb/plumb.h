/* What does Plumb answer to a program in C, or in a language that calls C?  Signs, figures, meshes and points;
 * what is asked of surfaces and of the plane is in plumb_surfaces.h, exact numbers are in plumb_exact.h, which this
 * includes.
 *
 *   plumb_figure ball = {sizeof ball, PLUMB_BALL, 3}, box = {sizeof box, PLUMB_AABB, 3};
 *   ball.as.sphere3 = (plumb_sphere3){{0, 0, 0}, 1};
 *   box.as.aabb3 = (plumb_aabb3){{1, 0, 0}, {2, 1, 1}};
 *   plumb_relation told;
 *   if (plumb_relate(&ball, &box, &told) != PLUMB_OK) puts(plumb_last_error());
 *
 * Laws:
 * (1) Answers are those of the C++ functions of the same names, bit by bit: decisions are exact for the doubles given,
 *     numbers are the exact ones rounded once.
 * (2) A function that can fail returns a plumb_status; its answer is written through the pointers at the end, and not
 *     at all if it fails.  plumb_last_error() is the text of what failed last in the calling thread.  No exception and
 *     no signal crosses the interface.
 * (3) The first member of a struct that may grow is its size, which the caller sets to sizeof: a program keeps the
 *     meaning it was compiled with.  A size that this library does not know yet is PLUMB_INVALID_ARGUMENT.
 * (4) An opaque handle is made by a function ..._create, ..._read or ..._parse and released by ..._destroy, which takes
 *     NULL.  A handle refers to no memory of the caller.  A handle that was released must not be used again.  Handles
 *     are never changed, so that threads may share them.
 *     Choices come as int, so that one that is none is an error.
 * (5) Numbers of points stand one after another: x, y of the plane, x, y, z of space.  Callers own all arrays.
 * Source: RTCD as a whole, by the names of plumb/query.hpp, plumb/space.hpp and plumb/surface.hpp; docs/c.md.
 * Cost: that of the C++ functions and a copy of each figure: to relate two balls takes 40 ns.
 */
#ifndef PLUMB_H
#define PLUMB_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- errors ---- */

typedef enum plumb_status {
  PLUMB_OK = 0,
  PLUMB_INVALID_ARGUMENT = 1, /* a null pointer, an index out of range, an unknown kind, a size from the future */
  PLUMB_NON_FINITE = 2,       /* a NaN or an infinity; the text says where */
  PLUMB_INVALID_SHAPE = 3,    /* numbers that are no figure; the text says what is wanted */
  PLUMB_UNSUPPORTED = 4,      /* the question has no answer for these kinds; the text names them */
  PLUMB_FILE = 5,             /* a file that is not there, cannot be read or written, or is no mesh */
  PLUMB_CANCELLED = 6,        /* a progress callback returned 0 */
  PLUMB_OUT_OF_MEMORY = 7,
  PLUMB_FAILED = 8            /* any other error of the library */
} plumb_status;

/* The text of the last error of this thread, "" before the first; valid until the thread's next failure. */
const char* plumb_last_error(void);

/* "0.1.0" */
const char* plumb_version(void);

/* Called now and then with the share that is done, 0 to 1, by any of the library's threads; returns 0 to stop. */
typedef struct plumb_progress {
  int (*call)(double done, void* user);
  void* user;
} plumb_progress;

/* ---- memory ---- */

/* Where the library takes its memory from.  `allocate` returns NULL where there is none, which becomes
 * PLUMB_OUT_OF_MEMORY; `release` is told the bytes and the alignment, a power of two, that were asked for.  Any of the
 * library's threads calls them; they do not call the library. */
typedef struct plumb_allocator {
  size_t size;
  void* (*allocate)(size_t bytes, size_t alignment, void* user);
  void (*release)(void* block, size_t bytes, size_t alignment, void* user);
  void* user;
} plumb_allocator;
/* From now on, in all threads; NULL: from malloc.  All that handles and answers hold comes from it, and what is needed
 * in between; numbers of GMP, files and stacks of threads do not: docs/c.md.  A block goes back to whom it came from,
 * and some are kept until the process ends, so that whoever was set once must work as long.
 * PLUMB_UNSUPPORTED where the library was built of shared libraries, whose memory it does not have. */
plumb_status plumb_set_allocator(const plumb_allocator* allocator);

/* ---- signs ---- */

/* How many predicates there are: each line of plumb/predicates/manifest.hpp. */
size_t plumb_sign_count(void);
/* Their names ("orient2d") and how many numbers each takes; NULL and 0 beyond the last. */
const char* plumb_sign_name(size_t which);
size_t plumb_sign_arity(size_t which);
/* SIZE_MAX where there is none of this name. */
size_t plumb_find_sign(const char* name);

/* The sign, -1, 0 or 1, for numbers that stand argument after argument. */
plumb_status plumb_sign(size_t which, const double* numbers, int* sign);
/* Many cases, on all threads: number k of case i is columns[k][i * strides[k]]; strides may be NULL for all 1, by which
 * orient2d, orient3d, incircle and insphere go in lanes. */
plumb_status plumb_signs(size_t which, const double* const* columns, const ptrdiff_t* strides, size_t count,
                         int8_t* signs);

/* ---- figures ---- */

/* A kind is one of the plane (dimension 2), of space (3) or of both. */
typedef enum plumb_kind {
  PLUMB_POINT = 1,
  PLUMB_LINE,
  PLUMB_RAY,
  PLUMB_SEGMENT,
  PLUMB_PLANE,             /* 3 */
  PLUMB_THREE_POINT_PLANE, /* 3 */
  PLUMB_HALFSPACE,         /* normal . x <= offset */
  PLUMB_TRIANGLE,
  PLUMB_QUADRILATERAL,
  PLUMB_POLYGON,
  PLUMB_HOLED_POLYGON,
  PLUMB_RECTANGLE,   /* 3 */
  PLUMB_TETRAHEDRON, /* 3 */
  PLUMB_BALL,        /* circle2, sphere3: with what is within */
  PLUMB_AABB,
  PLUMB_OBB,
  PLUMB_CAPSULE,
  PLUMB_LOZENGE,  /* 3 */
  PLUMB_CYLINDER, /* 3 */
  PLUMB_CONE,     /* 3 */
  PLUMB_K_DOP,
  PLUMB_HALFSPACES,
  PLUMB_POLYHEDRON,   /* 3, convex */
  PLUMB_SPHERICAL_CAP /* 3 */
} plumb_kind;

/* The numbers of a figure of each kind and dimension. */
typedef struct plumb_point2 { double at[2]; } plumb_point2;
typedef struct plumb_point3 { double at[3]; } plumb_point3;
typedef struct plumb_line2 { double point[2], direction[2]; } plumb_line2;
typedef struct plumb_line3 { double point[3], direction[3]; } plumb_line3;
typedef struct plumb_ray2 { double origin[2], direction[2]; } plumb_ray2;
typedef struct plumb_ray3 { double origin[3], direction[3]; } plumb_ray3;
typedef struct plumb_segment2 { double a[2], b[2]; } plumb_segment2;
typedef struct plumb_segment3 { double a[3], b[3]; } plumb_segment3;
typedef struct plumb_plane3 { double normal[3], offset; } plumb_plane3;
typedef struct plumb_three_point_plane3 { double a[3], b[3], c[3]; } plumb_three_point_plane3;
typedef struct plumb_halfspace2 { double normal[2], offset; } plumb_halfspace2;
typedef struct plumb_halfspace3 { double normal[3], offset; } plumb_halfspace3;
typedef struct plumb_triangle2 { double a[2], b[2], c[2]; } plumb_triangle2;
typedef struct plumb_triangle3 { double a[3], b[3], c[3]; } plumb_triangle3;
typedef struct plumb_quadrilateral2 { double a[2], b[2], c[2], d[2]; } plumb_quadrilateral2;
typedef struct plumb_quadrilateral3 { double a[3], b[3], c[3], d[3]; } plumb_quadrilateral3;
typedef struct plumb_rectangle3 { double center[3], axes[2][3], half[2]; } plumb_rectangle3;
typedef struct plumb_tetrahedron3 { double a[3], b[3], c[3], d[3]; } plumb_tetrahedron3;
typedef struct plumb_circle2 { double center[2], radius; } plumb_circle2;
typedef struct plumb_sphere3 { double center[3], radius; } plumb_sphere3;
typedef struct plumb_aabb2 { double min[2], max[2]; } plumb_aabb2;
typedef struct plumb_aabb3 { double min[3], max[3]; } plumb_aabb3;
typedef struct plumb_obb2 { double center[2], axes[2][2], half[2]; } plumb_obb2;
typedef struct plumb_obb3 { double center[3], axes[3][3], half[3]; } plumb_obb3;
typedef struct plumb_capsule2 { double a[2], b[2], radius; } plumb_capsule2;
typedef struct plumb_capsule3 { double a[3], b[3], radius; } plumb_capsule3;
typedef struct plumb_lozenge3 { double corner[3], edges[2][3], radius; } plumb_lozenge3;
typedef struct plumb_cylinder3 { double a[3], b[3], radius; } plumb_cylinder3;
typedef struct plumb_cone3 { double apex[3], base[3], radius; } plumb_cone3;
typedef struct plumb_spherical_cap3 { plumb_sphere3 sphere; plumb_halfspace3 halfspace; } plumb_spherical_cap3;
/* The outer ring of a holed polygon is the first; a polygon is one ring, and `ring_sizes` is NULL for it. */
typedef struct plumb_rings {
  const double* vertices;
  size_t vertex_count;
  const size_t* ring_sizes;
  size_t ring_count;
} plumb_rings;
/* The numbers are, for each halfspace, its normal, then its offset. */
typedef struct plumb_halfspaces { const double* numbers; size_t count; } plumb_halfspaces;
/* All x with min[i] <= directions[i] . x <= max[i]. */
typedef struct plumb_k_dop { const double *directions, *min, *max; size_t count; } plumb_k_dop;
/* Corners are numbers of vertices, face after face, counterclockwise seen from outside. */
typedef struct plumb_polyhedron {
  const double* vertices;
  size_t vertex_count;
  const uint32_t* corners;
  const uint32_t* face_sizes;
  size_t face_count;
} plumb_polyhedron;

/* A figure stands as it is, under a matrix, under a turn by a quaternion that need not be of length one and is exact,
 * or under a chain of such turns, the last nearest to the figure. */
typedef enum plumb_pose_kind { PLUMB_AS_IT_IS = 0, PLUMB_MATRIX, PLUMB_RIGID, PLUMB_CHAIN } plumb_pose_kind;
typedef struct plumb_matrix2 { double columns[2][2], translation[2]; } plumb_matrix2;
typedef struct plumb_matrix3 { double columns[3][3], translation[3]; } plumb_matrix3;
typedef struct plumb_rigid2 { double w, z, translation[2]; } plumb_rigid2;
typedef struct plumb_rigid3 { double w, x, y, z, translation[3]; } plumb_rigid3;
typedef struct plumb_chain2 { const plumb_rigid2* links; size_t count; } plumb_chain2;
typedef struct plumb_chain3 { const plumb_rigid3* links; size_t count; } plumb_chain3;

/* A figure that the library keeps, so that lists and poses are read and checked once. */
typedef struct plumb_kept plumb_kept;

/* `kept` instead of the rest, if it is not NULL. */
typedef struct plumb_figure {
  size_t size;
  int32_t kind, dimension; /* plumb_kind; 2 or 3 */
  union {
    plumb_point2 point2; plumb_point3 point3; plumb_line2 line2; plumb_line3 line3;
    plumb_ray2 ray2; plumb_ray3 ray3; plumb_segment2 segment2; plumb_segment3 segment3;
    plumb_plane3 plane3; plumb_three_point_plane3 three_point_plane3;
    plumb_halfspace2 halfspace2; plumb_halfspace3 halfspace3;
    plumb_triangle2 triangle2; plumb_triangle3 triangle3;
    plumb_quadrilateral2 quadrilateral2; plumb_quadrilateral3 quadrilateral3;
    plumb_rectangle3 rectangle3; plumb_tetrahedron3 tetrahedron3;
    plumb_circle2 circle2; plumb_sphere3 sphere3; plumb_aabb2 aabb2; plumb_aabb3 aabb3;
    plumb_obb2 obb2; plumb_obb3 obb3; plumb_capsule2 capsule2; plumb_capsule3 capsule3;
    plumb_lozenge3 lozenge3; plumb_cylinder3 cylinder3; plumb_cone3 cone3; plumb_spherical_cap3 spherical_cap3;
    plumb_rings rings; plumb_halfspaces halfspaces; plumb_k_dop k_dop; plumb_polyhedron polyhedron;
  } as;
  int32_t pose_kind; /* plumb_pose_kind */
  union {
    plumb_matrix2 matrix2; plumb_matrix3 matrix3; plumb_rigid2 rigid2; plumb_rigid3 rigid3;
    plumb_chain2 chain2; plumb_chain3 chain3;
  } pose;
  const plumb_kept* kept;
} plumb_figure;

plumb_status plumb_kept_create(const plumb_figure* figure, plumb_kept** kept);
/* Reads a line such as `ball3 0 0 0 1`, with its pose: plumb/query/body/any_figure.hpp. */
plumb_status plumb_kept_parse(const char* line, plumb_kept** kept);
void plumb_kept_destroy(plumb_kept* kept);
/* The line of a figure, numbers in hexadecimal; *length without the ending 0, of which all is written if it is below
 * the capacity.  `line` may be NULL to ask how long it is. */
plumb_status plumb_figure_line(const plumb_figure* figure, char* line, size_t capacity, size_t* length);
/* The answer to a question in a line, such as `relate | ball3 0 0 0 1 | ball3 2 0 0 1`, in words and hexadecimal
 * numbers (plumb/query/variant/question_line.hpp); told as plumb_figure_line tells.  What refuses the figures is an answer. */
plumb_status plumb_ask(const char* question, char* answer, size_t capacity, size_t* length);

/* ---- two figures ---- */

typedef enum plumb_relation { PLUMB_DISJOINT = -1, PLUMB_TOUCHING = 0, PLUMB_OVERLAPPING = 1 } plumb_relation;
typedef enum plumb_location { PLUMB_OUTSIDE = -1, PLUMB_BOUNDARY = 0, PLUMB_INSIDE = 1 } plumb_location;
typedef enum plumb_feature_kind { PLUMB_VERTEX = 0, PLUMB_EDGE, PLUMB_FACE, PLUMB_INTERIOR } plumb_feature_kind;
typedef struct plumb_feature { int32_t kind; uint32_t index; } plumb_feature;

typedef struct plumb_closest {
  size_t size;
  double on_a[3], on_b[3], distance;
  plumb_feature feature_a, feature_b;
} plumb_closest;
typedef struct plumb_hit {
  size_t size;
  double t, point[3], normal[3];
  plumb_feature feature;
} plumb_hit;
typedef struct plumb_meeting {
  size_t size;
  double time;
  plumb_feature feature_a, feature_b;
} plumb_meeting;
typedef struct plumb_penetration {
  size_t size;
  double depth, direction[3], translation[3];
  plumb_feature feature_a, feature_b;
  int32_t is_unique;
} plumb_penetration;

plumb_status plumb_relate(const plumb_figure* a, const plumb_figure* b, plumb_relation* relation);
plumb_status plumb_intersects(const plumb_figure* a, const plumb_figure* b, int* answer);
plumb_status plumb_contains(const plumb_figure* outer, const plumb_figure* inner, int* answer);
plumb_status plumb_distance(const plumb_figure* a, const plumb_figure* b, double* distance);
plumb_status plumb_closest_points(const plumb_figure* a, const plumb_figure* b, plumb_closest* closest);
/* The first is a line, a ray or a segment; *found is 0 where nothing is hit, and then nothing else is written. */
plumb_status plumb_hits(const plumb_figure* ray, const plumb_figure* figure, int* answer);
plumb_status plumb_first_hit(const plumb_figure* ray, const plumb_figure* figure, int* found, plumb_hit* hit);
/* When do they meet first, while a moves by `by_a` and b by `by_b` in time 0 to 1?  NULL: it stands still. */
plumb_status plumb_first_contact(const plumb_figure* a, const double* by_a, const plumb_figure* b, const double* by_b,
                                 int* found, plumb_meeting* meeting);
/* How far, and along what, must a move so that two convex bodies of space meet no longer? */
plumb_status plumb_penetrate(const plumb_figure* a, const plumb_figure* b, int* found, plumb_penetration* penetration);
/* relate, intersects and distance of a[i] and b[i], on all threads; the first pair that fails is told. */
plumb_status plumb_relate_each(const plumb_figure* a, const plumb_figure* b, size_t count, int8_t* relations);
plumb_status plumb_intersects_each(const plumb_figure* a, const plumb_figure* b, size_t count, int8_t* answers);
plumb_status plumb_distance_each(const plumb_figure* a, const plumb_figure* b, size_t count, double* distances);

/* The contact manifold of convex bodies of space: plumb/query/contact/contact.hpp. */
typedef struct plumb_contact_options {
  size_t size;
  double margin;  /* bodies no farther apart than this have a contact */
  size_t at_most; /* corners; 0: all */
} plumb_contact_options;
typedef struct plumb_manifold {
  size_t size;
  int32_t relation;            /* plumb_relation */
  double normal[3], distance;  /* from a to b; below zero where they must move to be parted */
  size_t corner_count;         /* how many there are, also where the array is shorter */
} plumb_manifold;
typedef struct plumb_corner { /* does not grow: arrays of them are written */
  double on_a[3], on_b[3], distance;
  plumb_feature feature_a, feature_b; /* its id, which persists */
} plumb_corner;
typedef struct plumb_contact_cache plumb_contact_cache;
plumb_status plumb_contact_cache_create(plumb_contact_cache** cache);
void plumb_contact_cache_destroy(plumb_contact_cache* cache);
/* Options and cache may be NULL; a cache is used by one thread at a time and changes no answer. */
plumb_status plumb_contact(const plumb_figure* a, const plumb_figure* b, const plumb_contact_options* options,
                           plumb_contact_cache* cache, int* found, plumb_manifold* manifold, plumb_corner* corners,
                           size_t capacity);

/* ---- one figure ---- */

plumb_status plumb_locate(const plumb_figure* figure, const double* point, plumb_location* location);
/* The z of figures of the plane is 0. */
plumb_status plumb_fit_aabb(const plumb_figure* figure, plumb_aabb3* box);
plumb_status plumb_support_point(const plumb_figure* figure, const double* direction, double* point);

/* ---- meshes ---- */

typedef struct plumb_mesh plumb_mesh;
typedef struct plumb_bvh plumb_bvh;
typedef struct plumb_pairs plumb_pairs;
typedef struct plumb_faults {
  size_t size;
  int32_t is_sound, closed, oriented; /* is_sound: none of the others is there */
  uint64_t touching_pairs, overlapping_pairs, degenerate_triangles, repeated_vertices, shells, inside_out_shells,
      open_edges, non_manifold_edges, non_manifold_vertices, vertices_on_edges, duplicate_triangles;
} plumb_faults;

/* Triangles are three numbers of vertices each, counterclockwise seen from outside. */
plumb_status plumb_mesh_create(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                               size_t triangle_count, plumb_mesh** mesh);
plumb_status plumb_mesh_read(const char* path, plumb_mesh** mesh);
/* The extension tells the format (.stl, .obj, .off, .ply).  A file is replaced only if `replace` is not 0. */
plumb_status plumb_mesh_write(const plumb_mesh* mesh, const char* path, int replace);
void plumb_mesh_destroy(plumb_mesh* mesh);
/* The mesh's own arrays, as long as the mesh is there. */
plumb_status plumb_mesh_vertices(const plumb_mesh* mesh, const double** vertices, size_t* count);
plumb_status plumb_mesh_triangles(const plumb_mesh* mesh, const uint32_t** triangles, size_t* count);
plumb_status plumb_mesh_faults(const plumb_mesh* mesh, const plumb_progress* progress, plumb_faults* faults);
/* Follows the plan that makes a printable solid; what cannot be mended stays: ask for the faults. */
plumb_status plumb_mesh_repair(const plumb_mesh* mesh, plumb_mesh** repaired);

typedef enum plumb_operation {
  PLUMB_UNITE = 0,
  PLUMB_INTERSECT,
  PLUMB_SUBTRACT, /* from the first all others */
  PLUMB_SYMMETRIC_DIFFERENCE,
  PLUMB_MERGE_PIECES = 256 /* added to one of these: all that lies in one plane becomes as few triangles as can be */
} plumb_operation;
typedef struct plumb_solid_report {
  size_t size;
  int32_t is_sound; /* closed, wound outward, free of crossings: decided of the doubles that are told */
  double moved;     /* no point is farther than this from the exact result */
} plumb_solid_report;
/* The solids that closed meshes bound, combined exactly and rounded, by a plumb_operation: docs/solids.md.  The report
 * may be NULL. */
plumb_status plumb_mesh_combine(int operation, const plumb_mesh* const* meshes, size_t count, plumb_mesh** result,
                                plumb_solid_report* report);

/* Each convex part of a solid, its corners rounded once, its faces in triangles, is told to `take`, which returns 0 to
 * stop; the part is there as long as the call. */
plumb_status plumb_mesh_convex_parts(const plumb_mesh* mesh, int (*take)(const plumb_mesh* part, void* user),
                                     void* user);

plumb_status plumb_bvh_create(const plumb_mesh* mesh, plumb_bvh** bvh);
void plumb_bvh_destroy(plumb_bvh* bvh);
/* The triangle that each ray hits first, of equal hits the lowest, or -1; t and points (3 numbers each) may be NULL. */
plumb_status plumb_bvh_first_hits(const plumb_bvh* bvh, const double* origins, const double* directions, size_t count,
                                  int64_t* triangles, double* t, double* points);
/* Tells where each point is to the solid that a closed mesh bounds: plumb_location. */
plumb_status plumb_bvh_locate(const plumb_bvh* bvh, const double* points, size_t count, int8_t* locations);
/* Distances and nearest points (3 numbers each) may be NULL. */
plumb_status plumb_bvh_closest(const plumb_bvh* bvh, const double* points, size_t count, int64_t* triangles,
                               double* distances, double* nearest);
/* Infinite where one is empty. */
plumb_status plumb_bvh_distance(const plumb_bvh* a, const plumb_bvh* b, double* distance);
/* The triangles of a that meet triangles of b, or, where b is NULL, of a beyond the vertices that neighbors share. */
plumb_status plumb_bvh_intersecting_pairs(const plumb_bvh* a, const plumb_bvh* b, const plumb_progress* progress,
                                          plumb_pairs** pairs);
/* The boxes (min, max of `dimension` numbers each) that have a point in common. */
plumb_status plumb_overlapping_pairs(const double* boxes, size_t count, int dimension, plumb_pairs** pairs);
/* Two numbers each, ascending; relations (plumb_relation) are NULL of boxes.  All pointers may be NULL. */
plumb_status plumb_pairs_of(const plumb_pairs* pairs, const uint32_t** numbers, const int8_t** relations,
                            size_t* count);
void plumb_pairs_destroy(plumb_pairs* pairs);

/* ---- points and polygons ---- */

/* Triangles of polygons and points: three indices each. */
typedef struct plumb_triangles plumb_triangles;
typedef enum plumb_winding_rule { PLUMB_ODD = 0, PLUMB_NONZERO, PLUMB_POSITIVE } plumb_winding_rule;
/* Cuts a polygon, with holes or without, of the plane or of space, by a plumb_winding_rule: indices are of vertices as
 * `rings` has them. */
plumb_status plumb_triangulate(const plumb_figure* polygon, int rule, plumb_triangles** triangles);
/* Joins points of the plane, so that no circle of a triangle holds another; segments are pairs of indices, or NULL. */
plumb_status plumb_delaunay(const double* points, size_t count, const uint32_t* segments, size_t segment_count,
                            plumb_triangles** triangles);
plumb_status plumb_triangles_of(const plumb_triangles* triangles, const uint32_t** indices, size_t* count);
void plumb_triangles_destroy(plumb_triangles* triangles);

typedef struct plumb_points plumb_points; /* a k-d tree */
plumb_status plumb_points_create(const double* points, size_t count, int dimension, plumb_points** tree);
void plumb_points_destroy(plumb_points* tree);
/* The k nearest of each query, nearest first, of equally near ones the lower number; -1 and infinity beyond the last.
 * Arrays have k entries a query; distances may be NULL. */
plumb_status plumb_points_nearest(const plumb_points* tree, const double* queries, size_t count, size_t k,
                                  int64_t* indices, double* distances);
/* Those within the radius, ascending, are told to `take`, which returns 0 to stop. */
plumb_status plumb_points_within(const plumb_points* tree, const double* query, double radius,
                                 int (*take)(uint32_t index, void* user), void* user);

#ifdef __cplusplus
}
#endif

#include "plumb/plumb_exact.h"
#include "plumb/plumb_surfaces.h"
#include "plumb/plumb_world.h"

#endif
