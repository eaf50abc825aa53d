/* Exact numbers, what figures have in common, certificates and bounds, asked by a program in C of 1999: answers that are
 * counted by hand, and what is refused. */
#include <math.h>

#include "expect.h"

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_common_size, 48);
IS_LARGE(plumb_support, 24);
IS_LARGE(plumb_bounds_options, 32);
IS_LARGE(plumb_bounds, 56);
#endif

static char text[4096];
static size_t length;

/* The text is this one, and so is its length; then it is gone. */
static void expect_text(const char* wanted) {
  if (strcmp(text, wanted) != 0) fprintf(stderr, "%s for %s\n", text, wanted);
  EXPECT(strcmp(text, wanted) == 0 && length == strlen(wanted));
  text[0] = '?', text[1] = 0, length = 99;
}

static plumb_figure ball_at(double x, double radius) {
  plumb_figure f = figure(PLUMB_BALL, 3);
  f.as.sphere3.center[0] = x;
  f.as.sphere3.radius = radius;
  return f;
}

static plumb_figure box_at(double min, double max) {
  plumb_figure f = figure(PLUMB_AABB, 3);
  int i;
  for (i = 0; i < 3; ++i) f.as.aabb3.min[i] = min, f.as.aabb3.max[i] = max;
  return f;
}

static plumb_figure point_at(double x, double y, double z) {
  plumb_figure f = figure(PLUMB_POINT, 3);
  f.as.point3.at[0] = x, f.as.point3.at[1] = y, f.as.point3.at[2] = z;
  return f;
}

static plumb_figure plane_of(double x, double y, double z, double offset) {
  plumb_figure f = figure(PLUMB_PLANE, 3);
  f.as.plane3.normal[0] = x, f.as.plane3.normal[1] = y, f.as.plane3.normal[2] = z, f.as.plane3.offset = offset;
  return f;
}

static void distances(void) {
  plumb_figure line = figure(PLUMB_LINE, 3), origin = point_at(0, 0, 0), ball = ball_at(5, 1), other = ball_at(0, 1);
  plumb_figure future = origin;
  int sign = 7;
  double value = 7;
  const double slope[3] = {1, 1, 1};
  line.as.line3.point[0] = 1;
  line.as.line3.direction[0] = line.as.line3.direction[1] = line.as.line3.direction[2] = 1;
  EXPECT_STATUS(plumb_squared_distance(&origin, &line, text, sizeof text, &length), PLUMB_OK);
  expect_text("2/3"); /* 1 - 1/3 */
  EXPECT_STATUS(plumb_squared_distance(&origin, &line, text, 3, &length), PLUMB_OK);
  EXPECT(length == 3 && text[0] == '?'); /* no room for its end */
  EXPECT_STATUS(plumb_squared_distance(&origin, &line, NULL, 0, &length), PLUMB_OK);
  EXPECT(length == 3);
  EXPECT_STATUS(plumb_squared_distance(&origin, &line, NULL, 1, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_squared_distance(&origin, &line, text, 1, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_squared_distance(&origin, &ball, text, 1, &length), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_exact_distance(&ball, &other, text, sizeof text, &length), PLUMB_OK);
  expect_text("25 2");
  EXPECT_STATUS(plumb_compare_distance(&ball, &other, &origin, &ball, &sign), PLUMB_OK);
  EXPECT(sign == -1); /* 3 against 4 */
  EXPECT_STATUS(plumb_compare_distance(&origin, &ball, &ball, &other, &sign), PLUMB_OK);
  EXPECT(sign == 1);
  EXPECT_STATUS(plumb_compare_distance(&origin, &ball, &ball, &origin, &sign), PLUMB_OK);
  EXPECT(sign == 0);
  EXPECT_STATUS(plumb_support_value(&ball, slope, &value), PLUMB_OK);
  EXPECT(value == nextafter(5 + sqrt(3.0), 9) || value == 5 + sqrt(3.0));
  future.size += 8;
  value = 7, sign = 7;
  EXPECT_STATUS(plumb_compare_distance(&origin, &future, &ball, &other, &sign), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_compare_distance(&origin, &ball, &ball, NULL, &sign), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_compare_distance(&origin, &ball, &ball, &other, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_support_value(&ball, NULL, &value), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_exact_distance(NULL, &other, text, 9, &length), PLUMB_INVALID_ARGUMENT);
  origin.as.point3.at[1] = NAN;
  EXPECT_STATUS(plumb_exact_distance(&origin, &other, text, 9, &length), PLUMB_NON_FINITE);
  EXPECT(value == 7 && sign == 7);
}

static void times(void) {
  plumb_figure ray = figure(PLUMB_RAY, 3), ball = ball_at(3, 1), box = box_at(0, 3), far = ball_at(10, 1);
  const double by[3] = {-21, 0, 0}, aside[3] = {-20, 0, 0}, away[3] = {1, 0, 0};
  int found = 7, apart = 7;
  ray.as.ray3.direction[0] = 2;
  EXPECT_STATUS(plumb_first_hit_parameter(&ray, &ball, &found, text, sizeof text, &length), PLUMB_OK);
  EXPECT(found == 1);
  expect_text("3/2 1/4 -1"); /* the parameter is 1 */
  ray.as.ray3.direction[0] = -2;
  EXPECT_STATUS(plumb_first_hit_parameter(&ray, &ball, &found, text, sizeof text, &length), PLUMB_OK);
  EXPECT(found == 0 && text[0] == '?');
  EXPECT_STATUS(plumb_first_hit_parameter(&ball, &ray, &found, text, sizeof text, &length), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_first_hit_parameter(&ray, &ball, NULL, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  far.as.sphere3.center[1] = far.as.sphere3.center[2] = 1;
  EXPECT_STATUS(plumb_first_contact_time(&far, by, &box, NULL, &found, text, sizeof text, &length), PLUMB_OK);
  expect_text("2/7");              /* 6 of 21 */
  far.as.sphere3.center[1] = -0.5; /* the edge is met at 3 + sqrt(3) / 2 */
  EXPECT_STATUS(plumb_first_contact_time(&far, aside, &box, NULL, &found, text, sizeof text, &length), PLUMB_OK);
  {
    /* Two bounds, then (7 - 20 t)^2 = 3/4 times a number. */
    double c0 = 0, c1 = 0, c2 = 0;
    const char* bounds_end = strchr(strchr(text, ' ') + 1, ' ');
    EXPECT(found == 1 && bounds_end != NULL && length == strlen(text));
    EXPECT(sscanf(bounds_end, " %lf %lf %lf", &c0, &c1, &c2) == 3);
    EXPECT(c0 != 0);
    EXPECT(c1 * 193 == c0 * -1120 && c2 * 193 == c0 * 1600);
  }
  found = 7, text[0] = '?', text[1] = 0;
  EXPECT_STATUS(plumb_first_contact_time(&far, away, &box, NULL, &found, text, sizeof text, &length), PLUMB_OK);
  EXPECT(found == 0 && text[0] == '?');
  EXPECT_STATUS(plumb_first_contact_time(&far, by, NULL, NULL, &found, text, sizeof text, &length),
                PLUMB_INVALID_ARGUMENT);
  far = box_at(2, 9);
  EXPECT_STATUS(plumb_exact_penetration(&far, &box, &found, &apart, text, sizeof text, &length), PLUMB_OK);
  EXPECT(found == 1 && apart == 0);
  EXPECT(strstr(text, " 1 0") != NULL && length == strlen(text)); /* its square is 1, and there are no radii */
  far = box_at(4, 9);
  EXPECT_STATUS(plumb_exact_penetration(&far, &box, &found, &apart, text, sizeof text, &length), PLUMB_OK);
  EXPECT(found == 0);
  EXPECT_STATUS(plumb_exact_penetration(&far, &box, &found, NULL, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
}

/* Boxes that share a unit cube's depth along every axis, and balls. */
static void along(void) {
  plumb_figure a = box_at(0, 3), b = box_at(2, 5), far = box_at(4, 5), ball = ball_at(0, 1), other = ball_at(1, 1);
  const double ways[6] = {0, 2, 0, -4, 0, 0};
  double depth = 0, by[3] = {9, 9, 9};
  size_t which = 9;
  int found = 7;
  EXPECT_STATUS(plumb_penetration_along(&a, &b, ways, 2, &found, &which, &depth, by, text, sizeof text, &length),
                PLUMB_OK);
  EXPECT(found == 1 && which == 1 && depth == 1 && by[0] == -1 && by[1] == 0 && by[2] == 0);
  expect_text("1/4");
  EXPECT_STATUS(
      plumb_penetration_along(&ball, &other, ways, 1, &found, &which, &depth, NULL, text, sizeof text, &length),
      PLUMB_OK);
  EXPECT(found == 1 && which == 0 && depth == sqrt(3.0) && strchr(text, ' ') != NULL); /* 1 + y^2 = 4 */
  which = 9;
  EXPECT_STATUS(plumb_penetration_along(&a, &far, ways, 2, &found, &which, &depth, by, text, sizeof text, &length),
                PLUMB_OK);
  EXPECT(found == 0 && which == 9);
  EXPECT_STATUS(plumb_penetration_along(&a, &b, ways, 0, &found, &which, &depth, by, text, sizeof text, &length),
                PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_penetration_along(&a, &b, NULL, 2, &found, &which, &depth, by, text, sizeof text, &length),
                PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_penetration_along(&a, &b, ways, 2, &found, NULL, &depth, by, text, sizeof text, &length),
                PLUMB_INVALID_ARGUMENT);
}

static void in_common(void) {
  plumb_figure a = box_at(0, 3), b = box_at(1, 5), flat = plane_of(1, 0, 0, 3), other = plane_of(0, 3, 0, 1);
  plumb_figure first = figure(PLUMB_SEGMENT, 2), second = figure(PLUMB_SEGMENT, 2), ball = ball_at(0, 1);
  plumb_common* common = NULL;
  plumb_common_size is;
  const uint32_t* corners = NULL;
  double vertices[24] = {0}, volume = 0;
  size_t count = 0, i;
  is.size = sizeof is;
  EXPECT_STATUS(plumb_intersection(&a, &b, &common), PLUMB_OK);
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_OK);
  EXPECT(is.kind == PLUMB_COMMON_SOLID && is.dimension == 3 && is.coordinates == 3);
  EXPECT(is.vertex_count == 8 && is.direction_count == 0 && is.face_count == 6);
  EXPECT_STATUS(plumb_common_vertices(common, vertices, 8, &count), PLUMB_OK);
  EXPECT(count == 8 && vertices[0] == 1 && vertices[23] == 3);
  vertices[3] = 7;
  EXPECT_STATUS(plumb_common_vertices(common, vertices, 1, &count), PLUMB_OK);
  EXPECT(count == 8 && vertices[3] == 7);
  EXPECT_STATUS(plumb_common_volume(common, &volume, text, sizeof text, &length), PLUMB_OK);
  expect_text("8");
  EXPECT(volume == 8);
  for (i = 0; i < 6; ++i) {
    EXPECT_STATUS(plumb_common_face(common, i, &corners, &count), PLUMB_OK);
    EXPECT(count == 4 && corners[0] < 8);
    EXPECT_STATUS(plumb_common_plane(common, i, text, sizeof text, &length), PLUMB_OK);
    EXPECT(length == strlen(text) && strlen(text) >= 7);
  }
  EXPECT_STATUS(plumb_common_face(common, 6, &corners, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_plane(common, 6, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_vertex(common, 8, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_direction(common, 0, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_vertices(common, NULL, 1, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_of(common, NULL), PLUMB_INVALID_ARGUMENT);
  is.size = 400;
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_INVALID_ARGUMENT);
  is.size = sizeof is;
  plumb_common_destroy(common);

  EXPECT_STATUS(plumb_intersection(&flat, &other, &common), PLUMB_OK);
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_OK);
  EXPECT(is.kind == PLUMB_COMMON_LINE && is.dimension == 1 && is.vertex_count == 1 && is.direction_count == 1);
  EXPECT_STATUS(plumb_common_direction(common, 0, text, sizeof text, &length), PLUMB_OK);
  EXPECT(strcmp(text, "0 0 1") == 0 || strcmp(text, "0 0 -1") == 0 || strcmp(text, "0 0 3") == 0);
  EXPECT_STATUS(plumb_common_vertex(common, 0, text, sizeof text, &length), PLUMB_OK);
  EXPECT(strncmp(text, "3 1/3 ", 6) == 0);
  EXPECT_STATUS(plumb_common_volume(common, NULL, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_face(common, 0, &corners, &count), PLUMB_INVALID_ARGUMENT);
  plumb_common_destroy(common);
  EXPECT_STATUS(plumb_intersection(&flat, &flat, &common), PLUMB_OK);
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_OK);
  EXPECT(is.kind == PLUMB_COMMON_PLANE && is.dimension == 2 && is.direction_count == 2);
  plumb_common_destroy(common);

  first.as.segment2.b[0] = first.as.segment2.b[1] = 1; /* the diagonal against (0, 1) to (2, 0) */
  second.as.segment2.a[1] = 1, second.as.segment2.b[0] = 2;
  EXPECT_STATUS(plumb_intersection(&first, &second, &common), PLUMB_OK);
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_OK);
  EXPECT(is.kind == PLUMB_COMMON_POINT && is.dimension == 0 && is.coordinates == 2 && is.vertex_count == 1);
  EXPECT_STATUS(plumb_common_vertex(common, 0, text, sizeof text, &length), PLUMB_OK);
  expect_text("2/3 2/3");
  EXPECT_STATUS(plumb_common_vertices(common, vertices, 1, &count), PLUMB_OK);
  EXPECT(vertices[0] == 2.0 / 3 && vertices[1] == 2.0 / 3);
  plumb_common_destroy(common);
  second.as.segment2.a[1] = second.as.segment2.b[1] = 9;
  EXPECT_STATUS(plumb_intersection(&first, &second, &common), PLUMB_OK);
  EXPECT_STATUS(plumb_common_of(common, &is), PLUMB_OK);
  EXPECT(is.kind == PLUMB_COMMON_NOTHING && is.dimension == -1 && is.vertex_count == 0);
  plumb_common_destroy(common);
  common = NULL;
  EXPECT_STATUS(plumb_intersection(&a, &ball, &common), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_intersection(&a, NULL, &common), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_intersection(&a, &b, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_common_of(NULL, &is), PLUMB_INVALID_ARGUMENT);
  EXPECT(common == NULL);
  plumb_common_destroy(NULL);
}

static void proofs(void) {
  plumb_figure a = box_at(0, 1), b = box_at(2, 3), inside = box_at(0.25, 3);
  int proven = 7, claim;
  char flaw[256] = "?", *place;
  size_t flaw_length = 99;
  for (claim = PLUMB_CLAIM_RELATION; claim <= PLUMB_CLAIM_DISTANCE; ++claim) {
    const plumb_figure* with[2];
    int i;
    with[0] = &b, with[1] = &inside;
    for (i = 0; i < 2; ++i) {
      EXPECT_STATUS(plumb_prove(claim, &a, with[i], text, sizeof text, &length), PLUMB_OK);
      EXPECT(length == strlen(text));
      EXPECT_STATUS(plumb_verify(text, &proven, flaw, sizeof flaw, &flaw_length), PLUMB_OK);
      EXPECT(proven == 1 && flaw_length == 0 && flaw[0] == 0);
    }
  }
  EXPECT_STATUS(plumb_prove(PLUMB_CLAIM_RELATION, &a, &b, text, sizeof text, &length), PLUMB_OK);
  place = strstr(text, "disjoint");
  EXPECT(place != NULL);
  if (place != NULL) memcpy(place, "touching", 8);
  EXPECT_STATUS(plumb_verify(text, &proven, flaw, sizeof flaw, &flaw_length), PLUMB_OK);
  EXPECT(proven == 0 && flaw_length > 0 && flaw_length == strlen(flaw));
  EXPECT_STATUS(plumb_verify("{", &proven, flaw, sizeof flaw, &flaw_length), PLUMB_FAILED);
  EXPECT_STATUS(plumb_verify(NULL, &proven, flaw, sizeof flaw, &flaw_length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_verify(text, &proven, NULL, 2, &flaw_length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_prove(3, &a, &b, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_prove(-1, &a, &b, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_prove(0, &a, NULL, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
}

/* A box from `user` to that plus 2 along each axis. */
static void corner(const double* direction, double* point, void* user) {
  int i;
  for (i = 0; i < 3; ++i) point[i] = *(const double*)user + (direction[i] > 0 ? 2 : 0);
}
/* Tells another point each time, on the side that is not asked for. */
static void liar(const double* direction, double* point, void* user) {
  int i;
  for (i = 0; i < 3; ++i) point[i] = (direction[i] > 0 ? -1 : 1) * ++*(double*)user;
}
static void of_nothing(const double* direction, double* point, void* user) {
  point[0] = direction[0] + *(double*)user, point[1] = point[2] = NAN;
}

static void bounds(void) {
  double at = 0, at_three = 3, at_one = 1;
  plumb_support a = {sizeof a, corner, NULL}, b = {sizeof b, corner, NULL};
  plumb_bounds_options options = {sizeof options, 0, 0, 0};
  plumb_bounds told;
  a.user = &at, b.user = &at_three;
  told.size = sizeof told;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, NULL, &told), PLUMB_OK);
  EXPECT(told.told == PLUMB_BOUNDS_DISJOINT && told.steps > 0);
  EXPECT(told.lower <= sqrt(3.0) && told.upper >= sqrt(3.0) && told.upper - told.lower < 1e-12);
  b.user = &at_one;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, &options, &told), PLUMB_OK);
  EXPECT(told.told == PLUMB_BOUNDS_MEETING && told.lower == 0);
  EXPECT_STATUS(plumb_penetration_bounds(&a, &b, &options, &told), PLUMB_OK);
  EXPECT(told.told == PLUMB_BOUNDS_MEETING && told.lower <= 1 && told.upper >= 1 && told.upper - told.lower < 1e-12);
  options.most_steps = 1;
  EXPECT_STATUS(plumb_penetration_bounds(&a, &b, &options, &told), PLUMB_OK);
  EXPECT(told.upper >= 1);
  options.rounding = -1;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, &options, &told), PLUMB_INVALID_SHAPE);
  options.rounding = 0, options.size = 999;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, &options, &told), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_penetration_bounds(&a, &b, &options, &told), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_gjk_bounds(&a, NULL, NULL, &told), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  b.farthest = NULL;
  EXPECT_STATUS(plumb_penetration_bounds(&a, &b, NULL, &told), PLUMB_INVALID_ARGUMENT);
  b.farthest = of_nothing;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, NULL, &told), PLUMB_NON_FINITE);
  b.farthest = liar;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, NULL, &told), PLUMB_INVALID_SHAPE);
  b.size = 3;
  EXPECT_STATUS(plumb_gjk_bounds(&a, &b, NULL, &told), PLUMB_INVALID_ARGUMENT);
}

int main(void) {
  distances();
  times();
  along();
  in_common();
  proofs();
  bounds();
  if (failures == 0) puts("all is as expected");
  return failures != 0;
}
