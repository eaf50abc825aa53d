/* What plumb_world.h has, asked by a program in C of 1999: answers, and what is refused. */
#include <math.h>

#include "expect.h"

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_world_options, 16);
IS_LARGE(plumb_body_options, 40);
IS_LARGE(plumb_world_pair, 40);
IS_LARGE(plumb_world_events, 56);
IS_LARGE(plumb_world_contact, 104);
IS_LARGE(plumb_world_corner, 64);
IS_LARGE(plumb_corner_events, 40);
IS_LARGE(plumb_world_hit, 80);
IS_LARGE(plumb_world_near, 32);
IS_LARGE(plumb_world_near_pair, 56);
IS_LARGE(plumb_world_cast, 48);
IS_LARGE(plumb_world_impact, 80);
IS_LARGE(plumb_world_span, 56);
IS_LARGE(plumb_cast_span, 40);
IS_LARGE(plumb_body_plan, 48);
IS_LARGE(plumb_plan_report, 24);
#endif

static const plumb_rigid3 nowhere = {1, 0, 0, 0, {0, 0, 0}};

static plumb_figure ball_at(double x, double y, double z) {
  plumb_figure f = figure(PLUMB_BALL, 3);
  const plumb_sphere3 ball = {{0, 0, 0}, 1};
  f.as.sphere3 = ball;
  f.as.sphere3.center[0] = x, f.as.sphere3.center[1] = y, f.as.sphere3.center[2] = z;
  return f;
}
static plumb_figure box_of(double low, double high) {
  plumb_figure f = figure(PLUMB_AABB, 3);
  int i;
  for (i = 0; i < 3; ++i) f.as.aabb3.min[i] = low, f.as.aabb3.max[i] = high;
  return f;
}
static plumb_body_options named(uint64_t user_id) {
  plumb_body_options o;
  memset(&o, 0, sizeof o);
  o.size = sizeof o;
  o.group = 1;
  o.mask = 0xffffffff;
  o.user_id = user_id;
  return o;
}

static void ask_pairs(void) {
  plumb_world_options with;
  plumb_world* world = NULL;
  plumb_body a = 0, b = 0, c = 0;
  plumb_body_options id = named(7);
  plumb_figure box = box_of(0, 1), ball = ball_at(2, 0.5, 0.5), parts[2];
  plumb_rigid3 up = nowhere;
  plumb_world_events now;
  const plumb_world_pair* pairs = NULL;
  const plumb_world_contact* contacts = NULL;
  plumb_corner_events corners;
  size_t count = 9;
  int answer = 7;
  char text[8] = "?";
  memset(&with, 0, sizeof with);
  with.size = sizeof with;
  with.contacts = 1;
  now.size = sizeof now;
  EXPECT_STATUS(plumb_world_create(&with, &world), PLUMB_OK);
  EXPECT_STATUS(plumb_world_add(world, &box, 1, NULL, &id, &a), PLUMB_OK);
  id.user_id = 8;
  EXPECT_STATUS(plumb_world_add(world, &ball, 1, NULL, &id, &b), PLUMB_OK);
  parts[0] = box_of(50, 51), parts[1] = box_of(60, 61);
  id.user_id = 9;
  EXPECT_STATUS(plumb_world_add(world, parts, 2, &nowhere, &id, &c), PLUMB_OK);
  EXPECT_STATUS(plumb_world_size(world, &count), PLUMB_OK);
  EXPECT(count == 3);
  EXPECT_STATUS(plumb_world_commit(world, &now), PLUMB_OK);
  EXPECT(now.begun_count == 1 && now.kept_count == 0 && now.ended_count == 0);
  EXPECT(now.begun[0].id_a == 7 && now.begun[0].b == b && now.begun[0].relation == PLUMB_TOUCHING);
  EXPECT_STATUS(plumb_world_pairs(world, &pairs, &count), PLUMB_OK);
  EXPECT(count == 1 && pairs[0].a == a);
  EXPECT_STATUS(plumb_world_contacts(world, &contacts, &count), PLUMB_OK);
  EXPECT(count == 1 && contacts[0].corner_count == 1 && contacts[0].distance == 0);
  EXPECT(contacts[0].corners[0].on_a[0] == 1 && contacts[0].corners[0].on_b[1] == 0.5);
  corners.size = sizeof corners;
  EXPECT_STATUS(plumb_world_corner_events(world, &corners), PLUMB_OK);
  EXPECT(corners.begun_count == 1 && corners.ended_count == 0 && corners.begun[0].id_a == 7 && corners.begun[0].b == b);
  EXPECT(corners.begun[0].feature_a.kind == contacts[0].corners[0].feature_a.kind);
  EXPECT_STATUS(plumb_world_check(world, 100, text, sizeof text, &count), PLUMB_OK);
  EXPECT(count == 0 && text[0] == '\0');
  up.translation[0] = ldexp(1, -40);
  EXPECT_STATUS(plumb_world_move(world, b, &up), PLUMB_OK);
  EXPECT_STATUS(plumb_world_commit(world, &now), PLUMB_OK);
  EXPECT(now.begun_count == 0 && now.ended_count == 1 && now.ended[0].id_b == 8);
  EXPECT_STATUS(plumb_world_corner_events(world, &corners), PLUMB_OK);
  EXPECT(corners.begun_count == 0 && corners.ended_count == 1 && corners.ended[0].id_b == 8);
  ball = ball_at(0, 0, 0);
  EXPECT_STATUS(plumb_world_replace(world, b, &ball, 1), PLUMB_OK);
  EXPECT_STATUS(plumb_world_allow_collision(world, b, a, 1), PLUMB_OK);
  EXPECT_STATUS(plumb_world_commit(world, NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_world_pairs(world, &pairs, &count), PLUMB_OK);
  EXPECT(count == 0);
  EXPECT_STATUS(plumb_world_remove(world, b), PLUMB_OK);
  EXPECT_STATUS(plumb_world_contains(world, b, &answer), PLUMB_OK);
  EXPECT(answer == 0);
  EXPECT_STATUS(plumb_world_remove(world, b), PLUMB_FAILED);
  EXPECT(strstr(plumb_last_error(), "plumb_world_remove: CollisionWorld::remove: no body has slot 1") != NULL);
  plumb_world_destroy(world);
}

/* Bodies of even numbers are left out; `user` counts how often that is asked. */
static int is_odd(plumb_body a, plumb_body b, void* user) {
  ++*(int*)user;
  return a % 2 == 1 || b % 2 == 1;
}

static void ask_filter(void) {
  plumb_world* world = NULL;
  plumb_body body[3] = {0, 0, 0};
  plumb_figure ball = ball_at(0, 0, 0);
  plumb_world_events now;
  int i, asked = 0, odd = 0;
  now.size = sizeof now;
  EXPECT_STATUS(plumb_world_create(NULL, &world), PLUMB_OK);
  for (i = 0; i < 3; ++i) EXPECT_STATUS(plumb_world_add(world, &ball, 1, NULL, NULL, body + i), PLUMB_OK);
  for (i = 0; i < 3; ++i) odd += (int)(body[i] % 2);
  EXPECT(odd == 1);
  EXPECT_STATUS(plumb_world_set_filter(world, is_odd, &asked), PLUMB_OK);
  EXPECT_STATUS(plumb_world_commit(world, &now), PLUMB_OK);
  EXPECT(asked == 3 && now.begun_count == 2);
  EXPECT_STATUS(plumb_world_set_filter(world, NULL, NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_world_commit(world, &now), PLUMB_OK);
  EXPECT(asked == 3 && now.begun_count == 1 && now.kept_count == 2);
  EXPECT_STATUS(plumb_world_set_filter(NULL, is_odd, &asked), PLUMB_INVALID_ARGUMENT);
  plumb_world_destroy(world);
}

static void ask_questions(void) {
  plumb_world* world = NULL;
  plumb_mesh* mesh = NULL;
  const double corners[9] = {5, -1, -1, 5, 1, -1, 5, 0, 2};
  const uint32_t triangle[3] = {0, 1, 2};
  const double way[3] = {10, 0, 0};
  plumb_body ball = 0, rock = 0, found[3];
  plumb_body_options id = named(1);
  plumb_figure unit = ball_at(0, 0, 0), ray = figure(PLUMB_RAY, 3), point = figure(PLUMB_POINT, 3);
  plumb_world_hit hits[2];
  plumb_world_near near_bodies[3];
  plumb_world_near_pair pair;
  plumb_world_cast cast, casts[2];
  plumb_cast_span turned[2];
  plumb_world_impact impact;
  plumb_world_span span;
  plumb_body_motion motion;
  plumb_body_turn turn;
  size_t count = 9;
  int is_hit = 9;
  EXPECT_STATUS(plumb_world_create(NULL, &world), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_create(corners, 3, triangle, 1, &mesh), PLUMB_OK);
  EXPECT_STATUS(plumb_world_add(world, &unit, 1, NULL, &id, &ball), PLUMB_OK);
  id.user_id = 2, id.group = 2;
  EXPECT_STATUS(plumb_world_add_mesh(world, mesh, NULL, &id, &rock), PLUMB_OK);
  plumb_mesh_destroy(mesh);
  ray.as.ray3.origin[0] = -4, ray.as.ray3.direction[0] = 1;
  EXPECT_STATUS(plumb_world_first_hit(world, &ray, 0xffffffff, &is_hit, hits), PLUMB_OK);
  EXPECT(is_hit == 1 && hits[0].body == ball && hits[0].t == 3 && hits[0].point[0] == -1);
  EXPECT_STATUS(plumb_world_first_hit(world, &ray, 4, &is_hit, hits), PLUMB_OK);
  EXPECT(is_hit == 0);
  EXPECT_STATUS(plumb_world_hits(world, &ray, 0xffffffff, hits, 1, &count), PLUMB_OK);
  EXPECT(count == 2 && hits[0].user_id == 1);
  EXPECT_STATUS(plumb_world_any_hit(world, &ray, 2, &is_hit), PLUMB_OK);
  EXPECT(is_hit == 1);
  EXPECT_STATUS(plumb_world_any_hit(world, &ray, 4, &is_hit), PLUMB_OK);
  EXPECT(is_hit == 0);
  EXPECT_STATUS(plumb_world_first_hit(world, &unit, 1, &is_hit, hits), PLUMB_INVALID_ARGUMENT);
  point.as.point3.at[0] = 2;
  EXPECT_STATUS(plumb_world_nearest(world, &point, 3, 0xffffffff, near_bodies, &count), PLUMB_OK);
  EXPECT(count == 2 && near_bodies[0].body == ball && near_bodies[1].distance == 3);
  EXPECT_STATUS(plumb_world_within(world, &point, 1, 0xffffffff, near_bodies, 3, &count), PLUMB_OK);
  EXPECT(count == 1);
  EXPECT_STATUS(plumb_world_within(world, &point, NAN, 0xffffffff, near_bodies, 3, &count), PLUMB_NON_FINITE);
  EXPECT_STATUS(plumb_world_overlaps(world, &unit, 0xffffffff, found, 3, &count), PLUMB_OK);
  EXPECT(count == 1 && found[0] == ball);
  EXPECT_STATUS(plumb_world_nearest_pairs(world, 1, INFINITY, &pair, &count), PLUMB_OK);
  EXPECT(count == 1 && pair.a == ball && pair.b == rock && pair.distance == 4);
  EXPECT_STATUS(plumb_world_first_contact(world, &unit, way, 2, &is_hit, &cast), PLUMB_OK);
  EXPECT(is_hit == 1 && cast.body == rock && cast.time < 0.5 && cast.time > 0.3999);
  EXPECT_STATUS(plumb_world_contacts_along(world, &unit, way, 3, casts, 2, &count), PLUMB_OK);
  EXPECT(count == 2 && casts[0].body == ball && casts[0].time == 0 && casts[1].time == cast.time);
  turn.to = nowhere;
  turn.to.translation[0] = 10;
  EXPECT_STATUS(plumb_world_contact_spans_along(world, &unit, &turn.to, 2, ldexp(1, -6), turned, 2, &count), PLUMB_OK);
  EXPECT(count == 1 && turned[0].body == rock && turned[0].user_id == 2);
  EXPECT(turned[0].from <= cast.time && cast.time <= turned[0].to && turned[0].to - turned[0].from <= ldexp(1, -6));
  EXPECT_STATUS(plumb_world_contact_spans_along(world, &unit, &turn.to, 3, 0, turned, 1, &count), PLUMB_OK);
  EXPECT(count == 2 && turned[0].body == ball && turned[0].from == 0);
  EXPECT_STATUS(plumb_world_contact_spans_along(world, &unit, NULL, 3, 0, turned, 1, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_world_contact_spans_along(world, &unit, &turn.to, 3, -1, turned, 1, &count), PLUMB_FAILED);
  motion.body = ball;
  memcpy(motion.by, way, sizeof way);
  EXPECT_STATUS(plumb_world_first_contacts(world, &motion, 1, &impact, 1, &count), PLUMB_OK);
  EXPECT(count == 1 && impact.rank == 0 && impact.time == cast.time);
  turn.body = ball;
  turn.to = nowhere;
  turn.to.translation[0] = 10;
  EXPECT_STATUS(plumb_world_first_contact_spans(world, &turn, 1, 0, &span, 1, &count), PLUMB_OK);
  EXPECT(count == 1 && span.from <= cast.time && cast.time <= span.to && span.to - span.from <= ldexp(1, -12));
  turn.to.w = 0;
  EXPECT_STATUS(plumb_world_first_contact_spans(world, &turn, 1, 0, &span, 1, &count), PLUMB_INVALID_SHAPE);
  EXPECT(strstr(plumb_last_error(), "body 1") != NULL);
  plumb_world_destroy(world);
}

/* Two terrains, one a half below the other, which none of their triangles says, but hulls do. */
static void plan_proxies(void) {
  plumb_world* world = NULL;
  plumb_mesh* land = NULL;
  double heights[85], numbers[5] = {1, 1, 0, 0, 0};
  const double* vertices = NULL;
  plumb_body low = 0, high = 0, ball = 0;
  plumb_body_options id = named(1);
  plumb_rigid3 below = nowhere;
  plumb_figure unit = ball_at(3, 2, 9);
  plumb_body_plan plans[3];
  plumb_plan_report report;
  const plumb_world_pair* pairs = NULL;
  size_t count = 9, i;
  int proxy = 9;
  for (i = 0; i < 85; ++i) heights[i] = (double)(i % 17) + 0.25 * (double)(i % 2);
  EXPECT_STATUS(plumb_heightfield_mesh(heights, 17, 5, numbers, numbers + 2, &land), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_vertices(land, &vertices, &count), PLUMB_OK);
  EXPECT(count == 85 && vertices[3 * 18] == 1 && vertices[3 * 18 + 1] == 1 && vertices[3 * 18 + 2] == heights[18]);
  EXPECT_STATUS(plumb_world_create(NULL, &world), PLUMB_OK);
  EXPECT_STATUS(plumb_world_add_mesh(world, land, NULL, &id, &high), PLUMB_OK);
  id.user_id = 2;
  below.translation[0] = 0.5, below.translation[2] = -1;
  EXPECT_STATUS(plumb_world_add_mesh(world, land, &below, &id, &low), PLUMB_OK);
  id.user_id = 3;
  EXPECT_STATUS(plumb_world_add(world, &unit, 1, NULL, &id, &ball), PLUMB_OK);
  report.size = sizeof report;
  EXPECT_STATUS(plumb_world_plan(world, plans, 3, &count, &report), PLUMB_OK);
  EXPECT(count == 2 && plans[0].body == high && plans[1].user_id == 2 && plans[0].saved > 0);
  EXPECT(plans[0].proxy != PLUMB_PROXY_NONE && report.questions_with < report.questions_without);
  EXPECT_STATUS(plumb_world_proxy(world, high, &proxy), PLUMB_OK);
  EXPECT(proxy == PLUMB_PROXY_NONE);
  EXPECT_STATUS(plumb_world_adopt(world, plans, count), PLUMB_OK);
  EXPECT_STATUS(plumb_world_proxy(world, high, &proxy), PLUMB_OK);
  EXPECT(proxy == plans[0].proxy);
  EXPECT_STATUS(plumb_world_plan(world, NULL, 0, &count, NULL), PLUMB_OK);
  EXPECT(count == 2);
  EXPECT_STATUS(plumb_world_commit(world, NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_world_pairs(world, &pairs, &count), PLUMB_OK);
  EXPECT(count == 0);
  EXPECT_STATUS(plumb_world_set_proxy(world, high, 4), PLUMB_INVALID_ARGUMENT);
  plans[0].proxy = -1;
  EXPECT_STATUS(plumb_world_adopt(world, plans, 1), PLUMB_INVALID_ARGUMENT);
  plans[0].proxy = PLUMB_PROXY_SPHERE, plans[0].body = 77;
  EXPECT_STATUS(plumb_world_adopt(world, plans, 1), PLUMB_FAILED);
  plumb_world_destroy(world);
  plumb_mesh_destroy(land);
  land = NULL;
  EXPECT_STATUS(plumb_heightfield_mesh(heights, 1, 5, NULL, NULL, &land), PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_heightfield_mesh(heights, (size_t)1 << 40, (size_t)1 << 40, NULL, NULL, &land),
                PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_heightfield_mesh(NULL, 2, 2, NULL, NULL, &land), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_heightfield_mesh(NULL, 0, 0, NULL, NULL, &land), PLUMB_INVALID_SHAPE);
  heights[2] = NAN;
  EXPECT_STATUS(plumb_heightfield_mesh(heights, 2, 2, NULL, NULL, &land), PLUMB_NON_FINITE);
  EXPECT(land == NULL);
}

static void refuse(void) {
  plumb_world* world = NULL;
  plumb_body body = 0;
  plumb_body_options id = named(41);
  plumb_figure ball = ball_at(0, 0, 0), flat = figure(PLUMB_BALL, 2);
  const plumb_world_contact* contacts = NULL;
  plumb_corner_events corners;
  size_t count = 9;
  EXPECT_STATUS(plumb_world_create(NULL, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_world_create(NULL, &world), PLUMB_OK);
  ball.as.sphere3.center[0] = NAN;
  EXPECT_STATUS(plumb_world_add(world, &ball, 1, NULL, &id, &body), PLUMB_NON_FINITE);
  EXPECT(strstr(plumb_last_error(), "body 41") != NULL);
  EXPECT_STATUS(plumb_world_add(world, &flat, 1, NULL, &id, &body), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_world_add(world, &flat, 0, NULL, &id, &body), PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_world_add(NULL, &flat, 1, NULL, &id, &body), PLUMB_INVALID_ARGUMENT);
  id.size = 3;
  ball = ball_at(0, 0, 0);
  EXPECT_STATUS(plumb_world_add(world, &ball, 1, NULL, &id, &body), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_world_contacts(world, &contacts, &count), PLUMB_UNSUPPORTED);
  corners.size = sizeof corners;
  EXPECT_STATUS(plumb_world_corner_events(world, &corners), PLUMB_UNSUPPORTED);
  corners.size = 8;
  EXPECT_STATUS(plumb_world_corner_events(world, &corners), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_world_size(world, &count), PLUMB_OK);
  EXPECT(count == 0 && body == 0);
  plumb_world_destroy(world);
  plumb_world_destroy(NULL);
}

int main(void) {
  ask_pairs();
  ask_filter();
  ask_questions();
  plan_proxies();
  refuse();
  if (failures == 0) puts("all is as expected");
  return failures != 0;
}
