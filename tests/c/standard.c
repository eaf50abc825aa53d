/* The header in C of 1999, and a program that uses it: figures, errors, a mesh, points. */
#include "expect.h"

#include <math.h>

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_figure, 248);
IS_LARGE(plumb_closest, 80);
IS_LARGE(plumb_hit, 72);
IS_LARGE(plumb_meeting, 32);
IS_LARGE(plumb_penetration, 88);
IS_LARGE(plumb_contact_options, 24);
IS_LARGE(plumb_manifold, 56);
IS_LARGE(plumb_corner, 72);
IS_LARGE(plumb_faults, 112);
IS_LARGE(plumb_solid_report, 24);
#endif

static plumb_figure ball(double x, double y, double z, double radius) {
  plumb_figure f = figure(PLUMB_BALL, 3);
  const plumb_sphere3 s = {{0, 0, 0}, 0};
  f.as.sphere3 = s;
  f.as.sphere3.center[0] = x;
  f.as.sphere3.center[1] = y;
  f.as.sphere3.center[2] = z;
  f.as.sphere3.radius = radius;
  return f;
}

static plumb_figure box(double lower, double upper) {
  plumb_figure f = figure(PLUMB_AABB, 3);
  int k;
  for (k = 0; k < 3; ++k) {
    f.as.aabb3.min[k] = lower;
    f.as.aabb3.max[k] = upper;
  }
  return f;
}

static void ask_figures(void) {
  plumb_figure a = ball(0, 0, 0, 1), b = ball(2, 0, 0, 1), c = box(-1, 1), other = figure(PLUMB_BALL, 2);
  plumb_figure ray = figure(PLUMB_RAY, 3);
  plumb_relation relation;
  plumb_closest closest = {sizeof closest};
  plumb_hit hit = {sizeof hit};
  plumb_meeting meeting = {sizeof meeting};
  plumb_penetration penetration = {sizeof penetration};
  plumb_manifold manifold = {sizeof manifold};
  plumb_corner corners[8];
  plumb_contact_cache* cache = NULL;
  plumb_kept* kept = NULL;
  const double by[3] = {1, 0, 0}, direction[3] = {0, 0, 1};
  double point[3], distance = 7;
  char line[256];
  size_t length = 0;
  int answer = 7, found = 7;

  EXPECT_STATUS(plumb_relate(&a, &b, &relation), PLUMB_OK);
  EXPECT(relation == PLUMB_TOUCHING);
  b.as.sphere3.center[0] = nextafter(2, 3);
  EXPECT_STATUS(plumb_relate(&a, &b, &relation), PLUMB_OK);
  EXPECT(relation == PLUMB_DISJOINT);
  b.as.sphere3.center[0] = 5;
  EXPECT_STATUS(plumb_distance(&a, &b, &distance), PLUMB_OK);
  EXPECT(distance == 3);
  EXPECT_STATUS(plumb_closest_points(&a, &b, &closest), PLUMB_OK);
  EXPECT(closest.distance == 3 && closest.on_a[0] == 1 && closest.on_b[0] == 4 && closest.size == sizeof closest);
  EXPECT_STATUS(plumb_intersects(&a, &c, &answer), PLUMB_OK);
  EXPECT(answer == 1);
  EXPECT_STATUS(plumb_contains(&c, &a, &answer), PLUMB_OK);
  EXPECT(answer == 1);
  EXPECT_STATUS(plumb_first_contact(&a, by, &b, NULL, &found, &meeting), PLUMB_OK);
  EXPECT(found == 0);
  b.as.sphere3.center[0] = 2.5;
  EXPECT_STATUS(plumb_first_contact(&a, by, &b, NULL, &found, &meeting), PLUMB_OK);
  EXPECT(found == 1 && meeting.time == 0.5);
  ray.as.ray3.origin[0] = -5;
  ray.as.ray3.direction[0] = 2;
  EXPECT_STATUS(plumb_first_hit(&ray, &a, &found, &hit), PLUMB_OK);
  EXPECT(found == 1 && hit.t == 2 && hit.point[0] == -1 && hit.normal[0] == -1);
  EXPECT_STATUS(plumb_hits(&ray, &b, &answer), PLUMB_OK);
  EXPECT(answer == 1);

  /* A cube that rests on another has the four corners of its face. */
  b = box(-1, 1);
  b.pose_kind = PLUMB_RIGID;
  b.pose.rigid3.w = 1;
  b.pose.rigid3.translation[2] = 2;
  EXPECT_STATUS(plumb_contact_cache_create(&cache), PLUMB_OK);
  EXPECT_STATUS(plumb_contact(&c, &b, NULL, cache, &found, &manifold, corners, 8), PLUMB_OK);
  EXPECT(found == 1 && manifold.relation == PLUMB_TOUCHING && manifold.corner_count == 4 && manifold.normal[2] == 1);
  plumb_contact_cache_destroy(cache);
  b.pose.rigid3.translation[2] = 1.5;
  EXPECT_STATUS(plumb_penetrate(&c, &b, &found, &penetration), PLUMB_OK);
  EXPECT(found == 1 && penetration.depth == 0.5);
  EXPECT_STATUS(plumb_support_point(&a, direction, point), PLUMB_OK);
  EXPECT(point[2] == 1);

  EXPECT_STATUS(plumb_figure_line(&b, NULL, 0, &length), PLUMB_OK);
  EXPECT(length > 0 && length < sizeof line);
  EXPECT_STATUS(plumb_figure_line(&b, line, sizeof line, &length), PLUMB_OK);
  char told[40];
  EXPECT_STATUS(plumb_ask("relate | ball3 0 0 0 1 | ball3 2 0 0 1", told, sizeof told, &length), PLUMB_OK);
  EXPECT(length == strlen("touching") && strcmp(told, "touching") == 0);
  EXPECT_STATUS(plumb_ask("distance | ball3 0 0 0 1 | cone3 0 0 0 1 0 0 1", NULL, 0, &length), PLUMB_OK);
  EXPECT(length > strlen("refused: "));
  EXPECT_STATUS(plumb_ask("touch | ball3 0 0 0 1", told, sizeof told, &length), PLUMB_FAILED);
  EXPECT_STATUS(plumb_ask("# nothing", told, sizeof told, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_ask(NULL, told, sizeof told, &length), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_kept_parse(line, &kept), PLUMB_OK);
  a = figure(0, 0);
  a.kept = kept;
  EXPECT_STATUS(plumb_penetrate(&c, &a, &found, &penetration), PLUMB_OK);
  EXPECT(found == 1 && penetration.depth == 0.5);

  /* What cannot be asked is an error by name, and writes nothing. */
  relation = PLUMB_OVERLAPPING;
  EXPECT_STATUS(plumb_relate(&other, &c, &relation), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_relate(NULL, &c, &relation), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "plumb_relate: a is NULL") != NULL);
  a = ball(NAN, 0, 0, 1);
  EXPECT_STATUS(plumb_relate(&a, &c, &relation), PLUMB_NON_FINITE);
  a = ball(0, 0, 0, -1);
  EXPECT_STATUS(plumb_relate(&a, &c, &relation), PLUMB_INVALID_SHAPE);
  a = figure(99, 3);
  EXPECT_STATUS(plumb_relate(&a, &c, &relation), PLUMB_INVALID_ARGUMENT);
  a = ball(0, 0, 0, 1);
  a.size += 8;
  EXPECT_STATUS(plumb_relate(&a, &c, &relation), PLUMB_INVALID_ARGUMENT);
  closest.size = 1000;
  EXPECT_STATUS(plumb_closest_points(&c, &c, &closest), PLUMB_INVALID_ARGUMENT);
  EXPECT(relation == PLUMB_OVERLAPPING);
  plumb_kept_destroy(kept);
}

static int stop(double done, void* user) {
  (void)done;
  ++*(int*)user;
  return 0;
}

static int take(uint32_t index, void* user) {
  *(unsigned*)user = 10 * *(unsigned*)user + index;
  return 1;
}

static void ask_indexes(void) {
  static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  static const uint32_t beyond[3] = {0, 1, 4};
  static const double origin[3] = {0.25, 0.25, -1}, up[3] = {0, 0, 1}, inside[3] = {0.125, 0.125, 0.125};
  static const double boxes[12] = {0, 0, 0, 1, 1, 1, 1, 0, 0, 2, 1, 1};
  plumb_mesh *mesh = NULL, *mended = NULL;
  plumb_bvh* bvh = NULL;
  plumb_points* points = NULL;
  plumb_pairs* pairs = NULL;
  plumb_faults faults = {sizeof faults};
  plumb_progress progress;
  const uint32_t* numbers = NULL;
  const double* there = NULL;
  int64_t triangle = 7, nearest[6];
  double t = 0, hit[3], distances[6];
  int8_t where = 7;
  size_t count = 7;
  unsigned taken = 0;
  int calls = 0;

  EXPECT_STATUS(plumb_mesh_create(corners, 4, beyond, 1, &mesh), PLUMB_INVALID_ARGUMENT);
  EXPECT(mesh == NULL);
  EXPECT_STATUS(plumb_mesh_create(corners, 4, faces, 4, &mesh), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_vertices(mesh, &there, &count), PLUMB_OK);
  EXPECT(count == 4 && there[3] == 1);
  EXPECT_STATUS(plumb_mesh_faults(mesh, NULL, &faults), PLUMB_OK);
  EXPECT(faults.is_sound && faults.closed && faults.shells == 1);
  progress.call = stop;
  progress.user = &calls;
  EXPECT_STATUS(plumb_mesh_faults(mesh, &progress, &faults), PLUMB_CANCELLED);
  EXPECT(calls > 0);
  EXPECT_STATUS(plumb_mesh_repair(mesh, &mended), PLUMB_OK);
  EXPECT_STATUS(plumb_bvh_create(mesh, &bvh), PLUMB_OK);
  plumb_mesh_destroy(mesh); /* a tree refers to no mesh */
  plumb_mesh_destroy(mended);
  EXPECT_STATUS(plumb_bvh_first_hits(bvh, origin, up, 1, &triangle, &t, hit), PLUMB_OK);
  EXPECT(triangle == 0 && t == 1 && hit[2] == 0);
  EXPECT_STATUS(plumb_bvh_locate(bvh, inside, 1, &where), PLUMB_OK);
  EXPECT(where == PLUMB_INSIDE);
  EXPECT_STATUS(plumb_bvh_closest(bvh, origin, 1, &triangle, &t, NULL), PLUMB_OK);
  EXPECT(triangle == 0 && t == 1);
  EXPECT_STATUS(plumb_bvh_distance(bvh, bvh, &t), PLUMB_OK);
  EXPECT(t == 0);
  EXPECT_STATUS(plumb_bvh_intersecting_pairs(bvh, NULL, NULL, &pairs), PLUMB_OK);
  EXPECT_STATUS(plumb_pairs_of(pairs, &numbers, NULL, &count), PLUMB_OK);
  EXPECT(count == 0);
  plumb_pairs_destroy(pairs);
  EXPECT_STATUS(plumb_overlapping_pairs(boxes, 2, 3, &pairs), PLUMB_OK);
  EXPECT_STATUS(plumb_pairs_of(pairs, &numbers, NULL, &count), PLUMB_OK);
  EXPECT(count == 1 && numbers[0] == 0 && numbers[1] == 1);
  plumb_pairs_destroy(pairs);
  EXPECT_STATUS(plumb_overlapping_pairs(boxes, 2, 4, &pairs), PLUMB_INVALID_ARGUMENT);

  EXPECT_STATUS(plumb_points_create(corners, 4, 3, &points), PLUMB_OK);
  EXPECT_STATUS(plumb_points_nearest(points, inside, 1, 6, nearest, distances), PLUMB_OK);
  EXPECT(nearest[0] == 0 && nearest[1] == 1 && nearest[3] == 3 && nearest[4] == -1 && distances[5] > 1e300);
  EXPECT_STATUS(plumb_points_within(points, corners, 1, take, &taken), PLUMB_OK);
  EXPECT(taken == 123); /* 0, 1, 2, 3: at exactly 1 as well */
  plumb_points_destroy(points);
  plumb_bvh_destroy(bvh);
  plumb_bvh_destroy(NULL);
  EXPECT_STATUS(plumb_mesh_read("no/such/file.stl", &mesh), PLUMB_FILE);
  EXPECT(strstr(plumb_last_error(), "no/such/file.stl") != NULL);
}

/* Two cubes that share half of each. */
static void ask_solids(void) {
  double corners[24];
  static const uint32_t faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  plumb_mesh *solids[2] = {NULL, NULL}, *both = NULL;
  plumb_solid_report report = {sizeof report};
  plumb_faults faults = {sizeof faults};
  plumb_bvh* bvh = NULL;
  static const double middle[3] = {2.5, 1, 1};
  const double* there = NULL;
  size_t count = 0;
  int8_t where = 7;
  int i, k;

  for (k = 0; k < 2; ++k) {
    for (i = 0; i < 8; ++i) {
      corners[3 * i] = 2 * (i & 1) + k;
      corners[3 * i + 1] = i & 2;
      corners[3 * i + 2] = (i & 4) / 2;
    }
    EXPECT_STATUS(plumb_mesh_create(corners, 8, faces, 12, &solids[k]), PLUMB_OK);
  }
  EXPECT_STATUS(plumb_mesh_combine(PLUMB_UNITE, (const plumb_mesh* const*)solids, 2, &both, &report), PLUMB_OK);
  EXPECT(report.is_sound && report.moved == 0);
  EXPECT_STATUS(plumb_mesh_faults(both, NULL, &faults), PLUMB_OK);
  EXPECT(faults.closed && faults.shells == 1);
  EXPECT_STATUS(plumb_bvh_create(both, &bvh), PLUMB_OK);
  EXPECT_STATUS(plumb_bvh_locate(bvh, middle, 1, &where), PLUMB_OK);
  EXPECT(where == PLUMB_INSIDE);
  plumb_bvh_destroy(bvh);
  plumb_mesh_destroy(both);
  EXPECT_STATUS(plumb_mesh_combine(PLUMB_UNITE + PLUMB_MERGE_PIECES, (const plumb_mesh* const*)solids, 2, &both, NULL),
                PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_vertices(both, &there, &count), PLUMB_OK);
  EXPECT(count == 8); /* one is moved along x: a longer box */
  plumb_mesh_destroy(both);
  EXPECT_STATUS(plumb_mesh_combine(PLUMB_INTERSECT, (const plumb_mesh* const*)solids, 2, &both, NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_vertices(both, &there, &count), PLUMB_OK);
  EXPECT(count >= 8);
  plumb_mesh_destroy(both);
  both = NULL;
  EXPECT_STATUS(plumb_mesh_combine(9, (const plumb_mesh* const*)solids, 2, &both, NULL),
                PLUMB_INVALID_ARGUMENT);
  plumb_mesh_destroy(solids[1]);
  EXPECT_STATUS(plumb_mesh_create(corners, 8, faces, 11, &solids[1]), PLUMB_OK); /* open */
  EXPECT_STATUS(plumb_mesh_combine(PLUMB_UNITE, (const plumb_mesh* const*)solids, 2, &both, NULL), PLUMB_INVALID_SHAPE);
  EXPECT(both == NULL);
  plumb_mesh_destroy(solids[0]);
  plumb_mesh_destroy(solids[1]);
}

static int count_parts(const plumb_mesh* part, void* user) {
  const double* there = NULL;
  size_t count = 0;
  EXPECT_STATUS(plumb_mesh_vertices(part, &there, &count), PLUMB_OK);
  EXPECT(count == 8);
  ++*(int*)user;
  return 1;
}

/* A square with a square hole, a cross of five points, a cube. */
static void ask_polygons(void) {
  static const double rings[16] = {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 1, 2, 2, 2, 2, 1};
  static const double points[10] = {0, 0, 2, 0, 0, 2, 2, 2, 1, 1};
  static const size_t sizes[2] = {4, 4};
  static const uint32_t faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  static const uint32_t crossing[4] = {0, 3, 1, 2};
  plumb_figure polygon = figure(PLUMB_HOLED_POLYGON, 2);
  plumb_triangles* triangles = NULL;
  plumb_mesh* cube = NULL;
  const uint32_t* indices = NULL;
  double corners[24];
  size_t count = 0;
  int i, parts = 0;

  polygon.as.rings.vertices = rings;
  polygon.as.rings.vertex_count = 8;
  polygon.as.rings.ring_sizes = sizes;
  polygon.as.rings.ring_count = 2;
  EXPECT_STATUS(plumb_triangulate(&polygon, PLUMB_ODD, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_triangles_of(triangles, &indices, &count), PLUMB_OK);
  EXPECT(count == 8 && indices[0] < 8);
  plumb_triangles_destroy(triangles);
  EXPECT_STATUS(plumb_delaunay(points, 5, NULL, 0, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_triangles_of(triangles, &indices, &count), PLUMB_OK);
  EXPECT(count == 4);
  plumb_triangles_destroy(triangles);
  EXPECT_STATUS(plumb_delaunay(points, 4, crossing, 2, &triangles), PLUMB_FAILED);
  EXPECT(strstr(plumb_last_error(), "cross") != NULL);
  polygon.as.rings.vertex_count = 7;
  EXPECT_STATUS(plumb_triangulate(&polygon, PLUMB_ODD, &triangles), PLUMB_INVALID_ARGUMENT);
  polygon = ball(0, 0, 0, 1);
  EXPECT_STATUS(plumb_triangulate(&polygon, PLUMB_ODD, &triangles), PLUMB_UNSUPPORTED);

  for (i = 0; i < 8; ++i) {
    corners[3 * i] = i & 1;
    corners[3 * i + 1] = (i & 2) / 2;
    corners[3 * i + 2] = (i & 4) / 4;
  }
  EXPECT_STATUS(plumb_mesh_create(corners, 8, faces, 12, &cube), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_convex_parts(cube, count_parts, &parts), PLUMB_OK);
  EXPECT(parts == 1);
  plumb_mesh_destroy(cube);
}

static void ask_signs(void) {
  const size_t which = plumb_find_sign("orient2d");
  const double turn[6] = {0, 0, 1, 0, 0, 1};
  const double x[3] = {1, 2, 3}, zero = 0, one = 1;
  const double* columns[6];
  const ptrdiff_t strides[6] = {0, 0, 0, 0, 1, 0};
  int8_t signs[3] = {7, 7, 7};
  int sign = 7;

  EXPECT(plumb_sign_count() > 40 && plumb_sign_arity(which) == 6 && strcmp(plumb_sign_name(which), "orient2d") == 0);
  EXPECT(plumb_find_sign("no such") == SIZE_MAX && plumb_sign_name(SIZE_MAX) == NULL);
  EXPECT_STATUS(plumb_sign(which, turn, &sign), PLUMB_OK);
  EXPECT(sign == 1);
  EXPECT_STATUS(plumb_sign(SIZE_MAX, turn, &sign), PLUMB_INVALID_ARGUMENT);
  /* (0, 0), (2, 1), (x, 1) */
  columns[0] = columns[1] = &zero;
  columns[2] = x + 1;
  columns[3] = columns[5] = &one;
  columns[4] = x;
  EXPECT_STATUS(plumb_signs(which, columns, strides, 3, signs), PLUMB_OK);
  EXPECT(signs[0] == 1 && signs[1] == 0 && signs[2] == -1);
}

int main(void) {
  ask_figures();
  ask_indexes();
  ask_solids();
  ask_polygons();
  ask_signs();
  EXPECT(strcmp(plumb_version(), "") != 0);
  if (failures == 0) puts("all as it should be");
  return failures != 0;
}
