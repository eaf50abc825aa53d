/* What is the answer before it is rounded, which points have two figures in common, and what proves an answer?  A part of
 * plumb.h: exact numbers, intersections, certificates, bounds for bodies of the caller's.
 *
 *   char square[64];
 *   size_t length;
 *   plumb_squared_distance(&a, &b, square, sizeof square, &length);       "1/3"
 *
 * Laws: those of plumb.h; answers are those of the C++ functions.  An exact number is text: an integer or a fraction in
 * lowest terms, "-5", "1/3"; several are parted by one space.  *length is that of the text without the ending 0; all of
 * it is written if it is below the capacity, else nothing, so that capacity 0 with a text of NULL asks how long it is.
 * Source: RTCD 5.3, 5.4, 9.1, 9.5.3; docs/c.md.
 * Cost: that of the C++ functions and of the text: some microseconds, of certificates tens of them.
 */
#ifndef PLUMB_EXACT_H
#define PLUMB_EXACT_H

#include "plumb/plumb.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- exact numbers ---- */

/* The sign of |ab| - |cd|, decided exactly. */
plumb_status plumb_compare_distance(const plumb_figure* a, const plumb_figure* b, const plumb_figure* c,
                                    const plumb_figure* d, int* sign);
/* The square of the distance of two figures neither of which is round. */
plumb_status plumb_squared_distance(const plumb_figure* a, const plumb_figure* b, char* text, size_t capacity,
                                    size_t* length);
/* Two numbers, s and r: the distance is the root of s less r, and 0 where that is below 0. */
plumb_status plumb_exact_distance(const plumb_figure* a, const plumb_figure* b, char* text, size_t capacity,
                                  size_t* length);
/* Three numbers, t, s and 1 or -1: the ray's parameter is t plus or minus the root of s. */
plumb_status plumb_first_hit_parameter(const plumb_figure* ray, const plumb_figure* figure, int* found, char* text,
                                       size_t capacity, size_t* length);
/* One number, the time; or, where it is irrational, two bounds and the coefficients, ascending, of a polynomial of which
 * it is the only root between them.  The motions are those of plumb_first_contact. */
plumb_status plumb_first_contact_time(const plumb_figure* a, const double* by_a, const plumb_figure* b,
                                      const double* by_b, int* found, char* text, size_t capacity, size_t* length);
/* Eight numbers: the direction, the translation that parts the cores, its square, the radii together.  The depth is the
 * root of the square plus the radii, or, where *apart is not 0, the radii less the root. */
plumb_status plumb_exact_penetration(const plumb_figure* a, const plumb_figure* b, int* found, int* apart, char* text,
                                     size_t capacity, size_t* length);
/* Along which of these directions (3 numbers each) is a parted from b soonest?  The translation (3 numbers) may be NULL;
 * the text is the multiple of the direction, as plumb_first_contact_time writes a time. */
plumb_status plumb_penetration_along(const plumb_figure* a, const plumb_figure* b, const double* directions,
                                     size_t count, int* found, size_t* which, double* depth, double* translation,
                                     char* text, size_t capacity, size_t* length);
/* The greatest product of the direction and a point of the figure, rounded upward. */
plumb_status plumb_support_value(const plumb_figure* figure, const double* direction, double* value);

/* ---- what two figures have in common ---- */

typedef struct plumb_common plumb_common;
typedef enum plumb_common_kind {
  PLUMB_COMMON_NOTHING = 0,
  PLUMB_COMMON_POINT,
  PLUMB_COMMON_SEGMENT,
  PLUMB_COMMON_RAY,  /* its origin and a further point, or one point and a direction */
  PLUMB_COMMON_LINE, /* two points, or one and a direction */
  PLUMB_COMMON_POLYGON,
  PLUMB_COMMON_SOLID,
  PLUMB_COMMON_PLANE, /* one point and two directions */
  PLUMB_COMMON_SPACE
} plumb_common_kind;
typedef struct plumb_common_size {
  size_t size;
  int32_t kind;                                     /* plumb_common_kind */
  int32_t dimension;                                /* of what is in common, -1 for nothing */
  int32_t coordinates;                              /* 2 or 3 a vertex */
  size_t vertex_count, direction_count, face_count; /* faces: of a bounded solid */
} plumb_common_size;

/* Two flat figures of one space, the pairs of docs/intersection.md. */
plumb_status plumb_intersection(const plumb_figure* a, const plumb_figure* b, plumb_common** common);
void plumb_common_destroy(plumb_common* common);
plumb_status plumb_common_of(const plumb_common* common, plumb_common_size* size);
/* Each vertex rounded once, `coordinates` numbers each; of more than `capacity` vertices the first. */
plumb_status plumb_common_vertices(const plumb_common* common, double* vertices, size_t capacity, size_t* count);
/* Two or three numbers. */
plumb_status plumb_common_vertex(const plumb_common* common, size_t vertex, char* text, size_t capacity,
                                 size_t* length);
/* Three numbers, a way in which the common points go on forever. */
plumb_status plumb_common_direction(const plumb_common* common, size_t direction, char* text, size_t capacity,
                                    size_t* length);
/* The vertices of a face, counterclockwise seen from outside, as long as the handle is there. */
plumb_status plumb_common_face(const plumb_common* common, size_t face, const uint32_t** corners, size_t* count);
/* Four numbers: the plane that a face lies in, its normal outward and its offset. */
plumb_status plumb_common_plane(const plumb_common* common, size_t face, char* text, size_t capacity, size_t* length);
/* Of a solid; *rounded may be NULL. */
plumb_status plumb_common_volume(const plumb_common* common, double* rounded, char* text, size_t capacity,
                                 size_t* length);

/* ---- proofs ---- */

typedef enum plumb_claim { PLUMB_CLAIM_RELATION = 0, PLUMB_CLAIM_INTERSECTION, PLUMB_CLAIM_DISTANCE } plumb_claim;
/* A certificate of the answer about two convex bodies of space, as one line of JSON that has both: docs/convex.md. */
plumb_status plumb_prove(int claim, const plumb_figure* a, const plumb_figure* b, char* text, size_t capacity,
                         size_t* length);
/* Does a certificate prove what it claims?  The flaw is the empty text where it does. */
plumb_status plumb_verify(const char* certificate, int* proven, char* flaw, size_t capacity, size_t* length);

/* ---- bodies of the caller's ---- */

/* A convex body of which no more is known than a point that is farthest along each direction, which `farthest` writes;
 * it calls no function of the library that has this body. */
typedef struct plumb_support {
  size_t size;
  void (*farthest)(const double* direction, double* point, void* user);
  void* user;
} plumb_support;
typedef struct plumb_bounds_options {
  size_t size;
  double rounding;     /* no point told is farther than this from the true one */
  double within;       /* how near the bounds have to come; 0: as near as they do */
  uint32_t most_steps; /* of plumb_penetration_bounds; 0: 128 */
} plumb_bounds_options;
typedef enum plumb_bounds_told {
  PLUMB_BOUNDS_DISJOINT = 0,
  PLUMB_BOUNDS_MEETING,
  PLUMB_BOUNDS_UNDECIDED
} plumb_bounds_told;
typedef struct plumb_bounds {
  size_t size;
  double lower, upper, direction[3];
  int32_t told; /* plumb_bounds_told */
  uint32_t steps;
} plumb_bounds;
/* Between which numbers is the distance?  Options may be NULL. */
plumb_status plumb_gjk_bounds(const plumb_support* a, const plumb_support* b, const plumb_bounds_options* options,
                              plumb_bounds* bounds);
/* And the depth?  Moved by `upper` along the direction, a is parted from b. */
plumb_status plumb_penetration_bounds(const plumb_support* a, const plumb_support* b,
                                      const plumb_bounds_options* options, plumb_bounds* bounds);

#ifdef __cplusplus
}
#endif

#endif
