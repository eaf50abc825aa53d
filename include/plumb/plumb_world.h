/* Which bodies of a scene meet, what is hit, what is near, and when do those that move meet?  A part of plumb.h: worlds.
 *
 *   plumb_world* world;
 *   plumb_body ball;
 *   plumb_world_events now;
 *   plumb_world_create(NULL, &world);
 *   plumb_world_add(world, &sphere, 1, NULL, NULL, &ball);
 *   now.size = sizeof now;
 *   plumb_world_commit(world, &now);
 *
 * Laws: those of plumb.h and of plumb/world/world.hpp; answers are those of the C++ functions.  A body is named by a number
 * that no other body ever has.  A world changes: one thread at a time has it, but for questions, which any number may ask
 * while none changes it.  What is told by pointers is there until the next commit.
 * Where an array is shorter than what is told, the first are written; *count is how many there are.
 * Source: RTCD 2.4; docs/c.md.
 * Cost: that of the C++ functions.
 */
#ifndef PLUMB_WORLD_H
#define PLUMB_WORLD_H

#include "plumb/plumb.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct plumb_world plumb_world;
typedef uint64_t plumb_body;
typedef struct plumb_world_options {
  size_t size;
  int32_t contacts;     /* beside pairs */
  int32_t one_thread;   /* else all that there are */
} plumb_world_options;
typedef struct plumb_body_options {
  size_t size;
  uint32_t group, mask; /* two are asked about if each one's mask has a bit of the other's group */
  uint64_t user_id;
  double margin;        /* contacts begin this far from the body */
  int32_t is_static;    /* two static ones are not asked about */
} plumb_body_options;

/* Options may be NULL: without contacts, on all threads. */
plumb_status plumb_world_create(const plumb_world_options* options, plumb_world** world);
void plumb_world_destroy(plumb_world* world);
/* One figure, or several as one body, under a pose, or none if it is NULL.  Options may be NULL: group 1, every mask. */
plumb_status plumb_world_add(plumb_world* world, const plumb_figure* figures, size_t count, const plumb_rigid3* pose,
                             const plumb_body_options* options, plumb_body* body);
plumb_status plumb_world_add_mesh(plumb_world* world, const plumb_mesh* mesh, const plumb_rigid3* pose,
                                  const plumb_body_options* options, plumb_body* body);
/* The pose takes the place of that which the body had. */
plumb_status plumb_world_move(plumb_world* world, plumb_body body, const plumb_rigid3* pose);
plumb_status plumb_world_replace(plumb_world* world, plumb_body body, const plumb_figure* figures, size_t count);
plumb_status plumb_world_remove(plumb_world* world, plumb_body body);
plumb_status plumb_world_contains(const plumb_world* world, plumb_body body, int* answer);
plumb_status plumb_world_size(const plumb_world* world, size_t* count);
plumb_status plumb_world_allow_collision(plumb_world* world, plumb_body a, plumb_body b, int allowed);
/* Pairs of which `keeps` returns 0 are left out from the next commit on; NULL: none.  Each is asked about once a
 * commit, in the order of pairs; the filter may ask the world and not change it. */
plumb_status plumb_world_set_filter(plumb_world* world, int (*keeps)(plumb_body a, plumb_body b, void* user),
                                    void* user);

/* ---- what may be asked in place of a body first: no answer depends on it ---- */

/* What misses the proxy of a body, which holds it, misses the body. */
typedef enum plumb_proxy { PLUMB_PROXY_NONE = 0, PLUMB_PROXY_SPHERE, PLUMB_PROXY_BOX, PLUMB_PROXY_HULL } plumb_proxy;
/* A plumb_proxy; a body that has none of the kind, as a flat one has no hull, is PLUMB_INVALID_SHAPE. */
plumb_status plumb_world_set_proxy(plumb_world* world, plumb_body body, int proxy);
plumb_status plumb_world_proxy(const plumb_world* world, plumb_body body, int* proxy);
/* A body that is no single figure, and is in a pair of several questions; `told_apart`: pairs, by the proxies. */
typedef struct plumb_body_plan { /* does not grow */
  plumb_body body;
  uint64_t user_id;
  size_t pairs, told_apart, saved; /* saved: questions, by this proxy alone */
  int32_t proxy;
} plumb_body_plan;
typedef struct plumb_plan_report { size_t size, questions_without, questions_with; } plumb_plan_report;
/* For which bodies does a proxy pay now, and which one?  By user ids; the report may be NULL. */
plumb_status plumb_world_plan(const plumb_world* world, plumb_body_plan* bodies, size_t capacity, size_t* count,
                              plumb_plan_report* report);
/* Each body gets the proxy of its plan. */
plumb_status plumb_world_adopt(plumb_world* world, const plumb_body_plan* bodies, size_t count);

/* A terrain of two triangles a cell: the corner of column i and row j is heights[j * columns + i] above the origin, i
 * and j times the spacing along x and y.  Cell j * (columns - 1) + i has the triangles 2 * cell and 2 * cell + 1.
 * `spacing` (two numbers) and `origin` (three) may be NULL: 1 and 0. */
plumb_status plumb_heightfield_mesh(const double* heights, size_t columns, size_t rows, const double* spacing,
                                    const double* origin, plumb_mesh** mesh);

/* ---- what meets ---- */

typedef struct plumb_world_pair { /* does not grow, like all that is seen in arrays */
  uint64_t id_a, id_b;
  plumb_body a, b;
  int32_t relation; /* plumb_relation; of a pair that has ended, what it was */
} plumb_world_pair;
typedef struct plumb_world_events {
  size_t size;
  const plumb_world_pair *begun, *kept, *ended;
  size_t begun_count, kept_count, ended_count;
} plumb_world_events;
typedef struct plumb_part { uint32_t part, triangle; } plumb_part;
typedef struct plumb_world_contact {
  uint64_t id_a, id_b;
  plumb_body a, b;
  plumb_part part_a, part_b;
  int32_t relation; /* plumb_relation */
  double normal[3], distance;
  const plumb_corner* corners;
  size_t corner_count;
} plumb_world_contact;
/* A corner by its name, as that of a contact has it. */
typedef struct plumb_world_corner {
  uint64_t id_a, id_b;
  plumb_body a, b;
  plumb_part part_a, part_b;
  plumb_feature feature_a, feature_b;
} plumb_world_corner;
typedef struct plumb_corner_events {
  size_t size;
  const plumb_world_corner *begun, *ended;
  size_t begun_count, ended_count;
} plumb_corner_events;

/* What has begun, is kept and has ended since the last commit; events may be NULL. */
plumb_status plumb_world_commit(plumb_world* world, plumb_world_events* events);
plumb_status plumb_world_pairs(const plumb_world* world, const plumb_world_pair** pairs, size_t* count);
/* Of a world that was created with contacts. */
plumb_status plumb_world_contacts(const plumb_world* world, const plumb_world_contact** contacts, size_t* count);
/* The corners that have begun and ended since the commit before the last; all others of contacts were there before. */
plumb_status plumb_world_corner_events(const plumb_world* world, plumb_corner_events* events);
/* What must hold and does not, a sentence a line; so many bodies are held against all others.  *length is that of the
 * whole text, of which an array that is long enough gets all and the ending 0; 0 where all holds. */
plumb_status plumb_world_check(const plumb_world* world, size_t samples, char* text, size_t capacity, size_t* length);

/* ---- questions about the bodies as they stand, whose group has a bit of the mask ---- */

typedef struct plumb_world_hit {
  uint64_t user_id;
  plumb_body body;
  plumb_part part;
  double t, point[3], normal[3];
} plumb_world_hit;
typedef struct plumb_world_near {
  uint64_t user_id;
  plumb_body body;
  plumb_part part;
  double distance;
} plumb_world_near;
typedef struct plumb_world_near_pair {
  uint64_t id_a, id_b;
  plumb_body a, b;
  plumb_part part_a, part_b;
  double distance;
} plumb_world_near_pair;

plumb_status plumb_world_overlaps(const plumb_world* world, const plumb_figure* figure, uint32_t mask,
                                  plumb_body* bodies, size_t capacity, size_t* count);
/* Of a line, a ray or a segment; *found is 0 where nothing is hit, and then nothing else is written. */
plumb_status plumb_world_first_hit(const plumb_world* world, const plumb_figure* ray, uint32_t mask, int* found,
                                   plumb_world_hit* hit);
plumb_status plumb_world_any_hit(const plumb_world* world, const plumb_figure* ray, uint32_t mask, int* answer);
/* Each body that is hit, in the order of the ray. */
plumb_status plumb_world_hits(const plumb_world* world, const plumb_figure* ray, uint32_t mask, plumb_world_hit* hits,
                              size_t capacity, size_t* count);
/* The nearest, at most k; and all within a distance, in the same order. */
plumb_status plumb_world_nearest(const plumb_world* world, const plumb_figure* figure, size_t k, uint32_t mask,
                                 plumb_world_near* near_bodies, size_t* count);
plumb_status plumb_world_within(const plumb_world* world, const plumb_figure* figure, double distance, uint32_t mask,
                                plumb_world_near* near_bodies, size_t capacity, size_t* count);
/* The pairs of bodies that are nearest to one another and no farther than `within`, at most k. */
plumb_status plumb_world_nearest_pairs(const plumb_world* world, size_t k, double within, plumb_world_near_pair* pairs,
                                       size_t* count);

/* ---- motion during time 0 to 1; the bodies stay where they are ---- */

typedef struct plumb_world_cast {
  uint64_t user_id;
  plumb_body body;
  plumb_part part;
  double time;
  plumb_feature feature_a, feature_b; /* a: of what moves */
} plumb_world_cast;
typedef struct plumb_body_motion { plumb_body body; double by[3]; } plumb_body_motion;
typedef struct plumb_world_impact {
  uint64_t id_a, id_b;
  plumb_body a, b;
  plumb_part part_a, part_b;
  double time;
  plumb_feature feature_a, feature_b;
  size_t rank; /* those of one rank are at exactly one time */
} plumb_world_impact;
/* From the pose that the body has; both quaternion and translation by (1 - t) and t. */
typedef struct plumb_body_turn { plumb_body body; plumb_rigid3 to; } plumb_body_turn;
typedef struct plumb_world_span {
  uint64_t id_a, id_b;
  plumb_body a, b;
  double from, to; /* before it they do not meet */
  int32_t is_certain; /* that they meet in it */
} plumb_world_span;
typedef struct plumb_cast_span {
  uint64_t user_id;
  plumb_body body;
  double from, to;
  int32_t is_certain;
} plumb_cast_span;

/* What does a figure that moves by three numbers come to first? */
plumb_status plumb_world_first_contact(const plumb_world* world, const plumb_figure* figure, const double* by,
                                       uint32_t mask, int* found, plumb_world_cast* cast);
/* Each body that it comes to, by exact times. */
plumb_status plumb_world_contacts_along(const plumb_world* world, const plumb_figure* figure, const double* by,
                                        uint32_t mask, plumb_world_cast* casts, size_t capacity, size_t* count);
plumb_status plumb_world_first_contacts(const plumb_world* world, const plumb_body_motion* motions,
                                        size_t motion_count, plumb_world_impact* impacts, size_t capacity,
                                        size_t* count);
/* No span is longer than the resolution; 0 is for 2^-12. */
plumb_status plumb_world_first_contact_spans(const plumb_world* world, const plumb_body_turn* turns, size_t turn_count,
                                             double resolution, plumb_world_span* spans, size_t capacity,
                                             size_t* count);
/* The figure goes from its rigid pose, or none, to another: each body that it may come to, by where spans begin. */
plumb_status plumb_world_contact_spans_along(const plumb_world* world, const plumb_figure* figure,
                                             const plumb_rigid3* to, uint32_t mask, double resolution,
                                             plumb_cast_span* spans, size_t capacity, size_t* count);

#ifdef __cplusplus
}
#endif

#endif
