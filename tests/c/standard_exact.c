/* Exact chains of solids, and curves where surfaces meet, asked by a program in C of 1999: answers that are counted by
 * hand, and what is refused. */
#include <math.h>

#include "expect.h"

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_curve, 40);
#endif

static plumb_mesh* box_at(double x, double y, double z, double size) {
  static const uint32_t faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  double corners[24];
  plumb_mesh* mesh = NULL;
  int i;
  for (i = 0; i < 8; ++i) {
    corners[3 * i] = x + (i & 1 ? size : 0);
    corners[3 * i + 1] = y + (i & 2 ? size : 0);
    corners[3 * i + 2] = z + (i & 4 ? size : 0);
  }
  EXPECT_STATUS(plumb_mesh_create(corners, 8, faces, 12, &mesh), PLUMB_OK);
  return mesh;
}

static void expect_volume(const plumb_exact_mesh* exact, const char* fraction) {
  char text[32] = "?";
  size_t length = 99;
  EXPECT_STATUS(plumb_exact_mesh_volume(exact, text, sizeof text, &length), PLUMB_OK);
  if (strcmp(text, fraction) != 0) fprintf(stderr, "%s for %s\n", text, fraction);
  EXPECT(strcmp(text, fraction) == 0 && length == strlen(fraction));
}

/* A box, its image under a turn that no doubles hold, and a chain of both. */
static void chain(void) {
  plumb_mesh *cube = NULL, *made = NULL;
  plumb_figure box = figure(PLUMB_AABB, 3);
  plumb_tree_step leaf;
  plumb_exact_mesh *a = NULL, *b = NULL, *c = NULL, *both[2], *sum = NULL, *less = NULL, *again = NULL;
  const plumb_rigid3 turn = {2, 0, 0, 1, {0, 0, 0}}; /* (3 + 4 i) / 5 about z */
  const plumb_rigid3 back = {2, 0, 0, -1, {0, 0, 0}};
  const uint32_t *triangles = NULL, *sources = NULL;
  plumb_solid_report report;
  char text[64] = "?";
  size_t vertices = 0, faces = 0, length = 0, i;
  report.size = sizeof report;
  for (i = 0; i < 3; ++i) box.as.aabb3.max[i] = 3;
  memset(&leaf, 0, sizeof leaf);
  leaf.figure = &box;
  EXPECT_STATUS(plumb_evaluate(&leaf, 1, 0, &cube, NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_exact_mesh_create(cube, NULL, &a), PLUMB_OK);
  EXPECT_STATUS(plumb_exact_mesh_create(cube, &turn, &b), PLUMB_OK);
  expect_volume(a, "27");
  expect_volume(b, "27");
  EXPECT_STATUS(plumb_exact_mesh_size(b, &vertices, &faces), PLUMB_OK);
  EXPECT(vertices == 8 && faces == 12);
  EXPECT_STATUS(plumb_exact_mesh_vertex(b, 0, text, sizeof text, &length), PLUMB_OK);
  EXPECT(strcmp(text, "-12/5 9/5 0") == 0 && length == 11); /* of (0, 3, 0) */
  EXPECT_STATUS(plumb_exact_mesh_posed(b, &back, &c), PLUMB_OK);
  EXPECT_STATUS(plumb_exact_mesh_vertex(c, 7, text, sizeof text, &length), PLUMB_OK);
  EXPECT(strcmp(text, "3 3 3") == 0); /* nothing was rounded on the way */
  both[0] = a, both[1] = b;
  EXPECT_STATUS(plumb_exact_mesh_combine(PLUMB_UNITE, (const plumb_exact_mesh* const*)both, 2, 0, &sum), PLUMB_OK);
  both[0] = sum;
  EXPECT_STATUS(plumb_exact_mesh_combine(PLUMB_SUBTRACT, (const plumb_exact_mesh* const*)both, 2, 1, &less), PLUMB_OK);
  /* In common is a kite of corners 0, (9/5, 12/5), (1, 3), (0, 3), of area 3; all is 3 high. */
  expect_volume(less, "18");
  EXPECT_STATUS(plumb_exact_mesh_triangles(less, &triangles, &sources, &faces), PLUMB_OK);
  for (i = 0; i < faces; ++i) EXPECT(triangles[3 * i] < triangles[3 * i + 1] && sources[2 * i] < 2);
  EXPECT_STATUS(plumb_exact_mesh_resolve(less, PLUMB_POSITIVE, 0, &again), PLUMB_OK);
  expect_volume(again, "18");
  EXPECT_STATUS(plumb_exact_mesh_round(less, &made, &report), PLUMB_OK);
  EXPECT(report.is_sound && report.moved < 1e-15);
  plumb_mesh_destroy(made);
  plumb_exact_mesh_destroy(sum);
  sum = NULL;
  made = NULL;
  /* Refused: no array, no operation, an open mesh, a vertex that is none, a turn that is none. */
  EXPECT_STATUS(plumb_exact_mesh_combine(9, (const plumb_exact_mesh* const*)both, 0, 0, &sum), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_exact_mesh_combine(0, NULL, 1, 0, &sum), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_exact_mesh_resolve(a, 9, 0, &sum), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_exact_mesh_vertex(a, 8, text, sizeof text, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_exact_mesh_volume(a, text, 2, &length), PLUMB_OK); /* too short for 27 and its end */
  EXPECT(length == 2 && strcmp(text, "3 3 3") == 0);
  EXPECT_STATUS(plumb_exact_mesh_volume(NULL, text, 2, &length), PLUMB_INVALID_ARGUMENT);
  {
    plumb_rigid3 none = turn;
    none.w = none.z = 0;
    EXPECT_STATUS(plumb_exact_mesh_create(cube, &none, &sum), PLUMB_INVALID_SHAPE);
    none.w = NAN;
    EXPECT_STATUS(plumb_exact_mesh_posed(a, &none, &sum), PLUMB_NON_FINITE);
  }
  EXPECT_STATUS(plumb_exact_mesh_create(NULL, NULL, &sum), PLUMB_INVALID_ARGUMENT);
  EXPECT(sum == NULL);
  EXPECT_STATUS(plumb_exact_mesh_combine(PLUMB_UNITE, NULL, 0, 0, &sum), PLUMB_OK);
  expect_volume(sum, "0");
  plumb_exact_mesh_destroy(a);
  plumb_exact_mesh_destroy(b);
  plumb_exact_mesh_destroy(c);
  plumb_exact_mesh_destroy(sum);
  plumb_exact_mesh_destroy(less);
  plumb_exact_mesh_destroy(again);
  plumb_exact_mesh_destroy(NULL);
  plumb_mesh_destroy(cube);
}

static void curves(void) {
  plumb_mesh *a = box_at(0, 0, 0, 2), *b = box_at(1, 1, 1, 2), *at = box_at(2, 2, 2, 1);
  plumb_curves* found = NULL;
  const plumb_curve* each = NULL;
  size_t count = 9, i;
  EXPECT_STATUS(plumb_intersection_curves(a, b, &found), PLUMB_OK);
  EXPECT_STATUS(plumb_curves_of(found, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].is_closed && each[0].face_count == each[0].count);
  EXPECT(each[0].points[0] == 1 && each[0].points[1] == 1 && each[0].points[2] == 2);
  for (i = 0; i < each[0].count; ++i) {
    const double* p = each[0].points + 3 * i; /* of the hexagon around the common cube */
    EXPECT((p[0] == 1 || p[1] == 1 || p[2] == 1) && (p[0] == 2 || p[1] == 2 || p[2] == 2));
    EXPECT(each[0].faces[2 * i] < 12 && each[0].faces[2 * i + 1] < 12);
  }
  plumb_curves_destroy(found);
  EXPECT_STATUS(plumb_intersection_curves(a, at, &found), PLUMB_OK); /* a corner of each */
  EXPECT_STATUS(plumb_curves_of(found, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].count == 1 && !each[0].is_closed && each[0].points[0] == 2);
  plumb_curves_destroy(found);
  found = NULL;
  EXPECT_STATUS(plumb_intersection_curves(a, NULL, &found), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_curves_of(NULL, &each, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT(found == NULL);
  plumb_curves_destroy(NULL);
  plumb_mesh_destroy(a);
  plumb_mesh_destroy(b);
  plumb_mesh_destroy(at);
}

int main(void) {
  chain();
  curves();
  if (failures == 0) puts("all is as expected");
  return failures != 0;
}
