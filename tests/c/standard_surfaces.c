/* What plumb_surfaces.h has, asked by a program in C of 1999: answers, and what is refused. */
#include "expect.h"

#include <math.h>

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_surface_kind, 56);
IS_LARGE(plumb_loop, 24);
IS_LARGE(plumb_weld_options, 24);
IS_LARGE(plumb_merged_vertex, 16);
IS_LARGE(plumb_weld_report, 88);
IS_LARGE(plumb_coplanar_report, 80);
IS_LARGE(plumb_contour, 48);
IS_LARGE(plumb_repair_step, 40);
IS_LARGE(plumb_repair_change, 64);
IS_LARGE(plumb_arrangement_report, 112);
IS_LARGE(plumb_clash, 112);
IS_LARGE(plumb_clash_pair, 16);
IS_LARGE(plumb_clash_options, 40);
#endif

/* A cube of side 2; its top (z = 2) is its last two triangles. */
static const uint32_t sides[36] = {0, 2, 3, 0, 3, 1, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                   0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 4, 5, 7, 4, 7, 6};
static plumb_mesh* cube_of(size_t triangles) {
  double corners[24];
  plumb_mesh* mesh = NULL;
  int i;
  for (i = 0; i < 8; ++i) {
    corners[3 * i] = 2 * (i & 1);
    corners[3 * i + 1] = i & 2;
    corners[3 * i + 2] = (i & 4) / 2;
  }
  EXPECT_STATUS(plumb_mesh_create(corners, 8, sides, triangles, &mesh), PLUMB_OK);
  return mesh;
}
static plumb_mesh* open_cube(void) { return cube_of(10); }

static void ask_topology(void) {
  plumb_mesh* mesh = open_cube();
  plumb_loops* loops = NULL;
  const plumb_loop* each = NULL;
  plumb_surface_kind kinds[2];
  uint32_t of[10];
  size_t count = 7;
  int i;

  memset(of, 7, sizeof of);
  EXPECT_STATUS(plumb_mesh_components(mesh, PLUMB_OVER_VERTICES, of, &count), PLUMB_OK);
  EXPECT(count == 1);
  for (i = 0; i < 10; ++i) EXPECT(of[i] == 0);
  EXPECT_STATUS(plumb_mesh_surface_kinds(mesh, kinds, 2, &count), PLUMB_OK);
  EXPECT(count == 1 && kinds[0].loops == 1 && kinds[0].euler == 1 && kinds[0].genus == 0 && kinds[0].is_orientable);
  count = 7;
  EXPECT_STATUS(plumb_mesh_surface_kinds(mesh, NULL, 0, &count), PLUMB_OK);
  EXPECT(count == 1);
  EXPECT_STATUS(plumb_mesh_boundary_loops(mesh, &loops), PLUMB_OK);
  EXPECT_STATUS(plumb_loops_of(loops, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].count == 4 && each[0].is_closed && each[0].vertices[0] >= 4);
  plumb_loops_destroy(loops);
  plumb_loops_destroy(NULL);

  loops = NULL;
  count = 7;
  EXPECT_STATUS(plumb_mesh_components(mesh, 3, of, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "over 3 is none of 0 to 2") != NULL);
  EXPECT_STATUS(plumb_mesh_components(mesh, -1, of, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_components(mesh, PLUMB_OVER_EDGES, NULL, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_components(NULL, PLUMB_OVER_EDGES, of, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_surface_kinds(mesh, NULL, 1, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_boundary_loops(NULL, &loops), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_boundary_loops(mesh, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_loops_of(NULL, &each, &count), PLUMB_INVALID_ARGUMENT);
  EXPECT(count == 7 && loops == NULL);
  plumb_mesh_destroy(mesh);
}

/* Two triangles that share an edge but for 0.125 at one end of it, in the plane z = 0. */
static void ask_welding(void) {
  static const double corners[18] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 0.125, 0, 4, 4, 0, 0, 4, 0};
  static const uint32_t triangles[6] = {0, 1, 2, 3, 4, 5};
  plumb_mesh *mesh = NULL, *made = NULL, *fewer = NULL;
  plumb_weld* weld = NULL;
  plumb_coplanar* faces = NULL;
  plumb_weld_options options = {sizeof options, 0.125, PLUMB_CHAINS, 0};
  plumb_weld_report report = {sizeof report};
  plumb_coplanar_report merged = {sizeof merged};
  size_t count = 0;
  const uint32_t* of = NULL;

  EXPECT_STATUS(plumb_mesh_create(corners, 6, triangles, 2, &mesh), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_weld(mesh, NULL, &made, &weld), PLUMB_OK);
  EXPECT_STATUS(plumb_weld_of(weld, &report), PLUMB_OK);
  EXPECT(report.vertex_count == 6 && report.merged_count == 1 && report.merged[0].vertex == 5 &&
         report.merged[0].into == 2 && report.merged[0].distance == 0 && report.into[3] == 3);
  plumb_mesh_destroy(made);
  plumb_weld_destroy(weld);
  EXPECT_STATUS(plumb_mesh_weld(mesh, &options, &made, &weld), PLUMB_OK);
  EXPECT_STATUS(plumb_weld_of(weld, &report), PLUMB_OK);
  EXPECT(report.merged_count == 2 && report.into[3] == 1 && report.merged[0].distance == 0.125 &&
         report.collapsed_count == 0 && report.turned_count == 0 && report.refused_count == 0);
  plumb_weld_destroy(weld);
  plumb_weld_destroy(NULL);
  EXPECT_STATUS(plumb_mesh_merge_coplanar(made, 0, 0, &fewer, &faces), PLUMB_OK);
  EXPECT_STATUS(plumb_coplanar_of(faces, &merged), PLUMB_OK);
  EXPECT(merged.face_count == 1 && merged.apart_count == 0 && merged.first_ring[1] == 1 &&
         merged.first_corner[1] == 4 && merged.first_triangle[1] == 2 && merged.triangles[1] == 1 &&
         merged.plane[0] == 0 && merged.corners[0] < 6);
  EXPECT_STATUS(plumb_mesh_triangles(fewer, &of, &count), PLUMB_OK);
  EXPECT(count == 2);
  plumb_coplanar_destroy(faces);
  plumb_coplanar_destroy(NULL);
  plumb_mesh_destroy(fewer);
  plumb_mesh_destroy(made);

  made = NULL;
  weld = NULL;
  faces = NULL;
  options.rule = 2;
  EXPECT_STATUS(plumb_mesh_weld(mesh, &options, &made, &weld), PLUMB_INVALID_ARGUMENT);
  options.rule = PLUMB_CLUSTERS;
  options.tolerance = -1;
  EXPECT_STATUS(plumb_mesh_weld(mesh, &options, &made, &weld), PLUMB_INVALID_SHAPE);
  options.tolerance = NAN;
  EXPECT_STATUS(plumb_mesh_weld(mesh, &options, &made, &weld), PLUMB_NON_FINITE);
  options.tolerance = 0;
  options.size += 8;
  EXPECT_STATUS(plumb_mesh_weld(mesh, &options, &made, &weld), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_weld(mesh, NULL, NULL, &weld), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_weld(NULL, NULL, &made, &weld), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_weld_of(NULL, &report), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_merge_coplanar(mesh, INFINITY, 0, &made, &faces), PLUMB_NON_FINITE);
  EXPECT_STATUS(plumb_mesh_merge_coplanar(mesh, -1, 0, &made, &faces), PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_coplanar_of(NULL, &merged), PLUMB_INVALID_ARGUMENT);
  EXPECT(made == NULL && weld == NULL && faces == NULL);
  EXPECT_STATUS(plumb_mesh_weld(mesh, NULL, &made, NULL), PLUMB_OK); /* the report need not be asked for */
  plumb_mesh_destroy(made);
  EXPECT_STATUS(plumb_mesh_weld(mesh, NULL, &made, &weld), PLUMB_OK);
  report.size = 1000;
  EXPECT_STATUS(plumb_weld_of(weld, &report), PLUMB_INVALID_ARGUMENT);
  plumb_weld_destroy(weld);
  plumb_mesh_destroy(made);
  plumb_mesh_destroy(mesh);
}

static void ask_sections(void) {
  plumb_mesh* mesh = open_cube();
  plumb_contours* contours = NULL;
  const plumb_contour* each = NULL;
  plumb_figure planes[2];
  size_t count = 7;

  planes[0] = figure(PLUMB_PLANE, 3);
  planes[0].as.plane3.normal[2] = 1;
  planes[0].as.plane3.offset = 9; /* beyond it */
  planes[1] = figure(PLUMB_THREE_POINT_PLANE, 3);
  planes[1].as.three_point_plane3.a[2] = planes[1].as.three_point_plane3.b[2] = 0.5;
  planes[1].as.three_point_plane3.c[2] = 0.5;
  planes[1].as.three_point_plane3.b[0] = planes[1].as.three_point_plane3.c[1] = 1;
  EXPECT_STATUS(plumb_mesh_sections(mesh, planes, 2, 0, &contours), PLUMB_OK);
  EXPECT_STATUS(plumb_contours_of(contours, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].plane == 1 && each[0].is_closed && each[0].turn == 1 && each[0].parent == -1 &&
         each[0].depth == 0 && each[0].count == 8 && each[0].points[2] == 0.5);
  plumb_contours_destroy(contours);
  plumb_contours_destroy(NULL);

  contours = NULL;
  planes[0].as.plane3.offset = NAN;
  EXPECT_STATUS(plumb_mesh_sections(mesh, planes, 2, 0, &contours), PLUMB_NON_FINITE);
  planes[0] = figure(PLUMB_PLANE, 3); /* without a normal */
  EXPECT_STATUS(plumb_mesh_sections(mesh, planes, 2, 0, &contours), PLUMB_INVALID_SHAPE);
  planes[0] = figure(PLUMB_BALL, 3);
  EXPECT_STATUS(plumb_mesh_sections(mesh, planes, 2, 0, &contours), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_mesh_sections(mesh, NULL, 2, 0, &contours), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_sections(NULL, planes, 0, 0, &contours), PLUMB_INVALID_ARGUMENT);
  EXPECT(contours == NULL);
  EXPECT_STATUS(plumb_mesh_sections(mesh, NULL, 0, 0, &contours), PLUMB_OK); /* no plane, no contour */
  EXPECT_STATUS(plumb_contours_of(contours, &each, &count), PLUMB_OK);
  EXPECT(count == 0);
  plumb_contours_destroy(contours);
  plumb_mesh_destroy(mesh);
}

static void ask_halves(void) {
  plumb_mesh* cube = cube_of(12);
  plumb_mesh *above = NULL, *below = NULL, *whole = NULL;
  plumb_solid_report reports[2];
  plumb_figure plane = figure(PLUMB_PLANE, 3);
  const double* corners = NULL;
  const uint32_t* triangles = NULL;
  size_t count = 0, i;

  for (i = 0; i < 2; ++i) reports[i].size = sizeof reports[i];
  plane.as.plane3.normal[2] = 1;
  plane.as.plane3.offset = 0.25;
  EXPECT_STATUS(plumb_mesh_split(cube, &plane, &above, &below, &reports[0], &reports[1]), PLUMB_OK);
  EXPECT(reports[0].is_sound && reports[1].is_sound && reports[0].moved == 0 && reports[1].moved == 0);
  EXPECT_STATUS(plumb_mesh_vertices(below, &corners, &count), PLUMB_OK);
  EXPECT(count >= 8);
  for (i = 0; i < count; ++i) EXPECT(corners[3 * i + 2] == 0 || corners[3 * i + 2] == 0.25);
  plumb_mesh_destroy(below);
  EXPECT_STATUS(plumb_mesh_resolve(above, PLUMB_POSITIVE, 1, &whole, &reports[0]), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_triangles(whole, &triangles, &count), PLUMB_OK);
  EXPECT(reports[0].is_sound && triangles != NULL && count == 12);
  plumb_mesh_destroy(whole);
  plumb_mesh_destroy(above);

  above = below = whole = NULL;
  EXPECT_STATUS(plumb_mesh_split(cube, &plane, &above, NULL, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_split(cube, NULL, &above, &below, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  plane.as.plane3.normal[2] = 0;
  EXPECT_STATUS(plumb_mesh_split(cube, &plane, &above, &below, NULL, NULL), PLUMB_INVALID_SHAPE);
  plane = figure(PLUMB_BALL, 3);
  EXPECT_STATUS(plumb_mesh_split(cube, &plane, &above, &below, NULL, NULL), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_mesh_resolve(cube, 9, 0, &whole, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT(above == NULL && below == NULL && whole == NULL);
  plumb_mesh_destroy(cube);
  cube = open_cube();
  EXPECT_STATUS(plumb_mesh_resolve(cube, PLUMB_ODD, 0, &whole, NULL), PLUMB_INVALID_SHAPE);
  plumb_mesh_destroy(cube);
}

struct told {
  int changes, stop_after, left;
  char last[32];
};

static int hear(const plumb_repair_change* change, void* user) {
  struct told* told = user;
  EXPECT(change->size == sizeof *change && strlen(change->what) < sizeof told->last);
  strcpy(told->last, change->what);
  told->left += change->is_left;
  return ++told->changes != told->stop_after;
}

static int no_progress(double done, void* user) {
  (void)done;
  ++*(int*)user;
  return 0;
}

static int cover(const plumb_mesh* hull, double concavity, void* user) {
  const double* there = NULL;
  size_t count = 0;
  EXPECT_STATUS(plumb_mesh_vertices(hull, &there, &count), PLUMB_OK);
  EXPECT(count == 8 && concavity == 0);
  ++*(int*)user;
  return 1;
}

static void ask_repair(void) {
  plumb_mesh *mesh = open_cube(), *mended = NULL;
  plumb_repair_step steps[2] = {{sizeof steps[0], 0, 0, PLUMB_WELD, PLUMB_CLUSTERS, 0, 0},
                                {sizeof steps[0], 0, 0, PLUMB_HOLES, 0, 0, 0}};
  plumb_faults faults = {sizeof faults};
  plumb_progress progress;
  struct told told = {0, 0, 0, ""};
  int calls = 0, covers = 0;

  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 1, NULL, &mended, &faults, hear, &told), PLUMB_OK);
  EXPECT(told.changes == 0 && !faults.closed && faults.open_edges == 4);
  plumb_mesh_destroy(mended);
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 2, NULL, &mended, &faults, hear, &told), PLUMB_OK);
  EXPECT(told.changes == 1 && strcmp(told.last, "hole filled") == 0 && told.left == 0 && faults.is_sound);
  EXPECT_STATUS(plumb_mesh_covering_parts(mended, 0, 0, cover, &covers), PLUMB_OK);
  EXPECT(covers == 1);
  EXPECT_STATUS(plumb_mesh_covering_parts(mended, 0, 0, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_covering_parts(mended, -1, 0, cover, &covers), PLUMB_INVALID_SHAPE);
  EXPECT_STATUS(plumb_mesh_covering_parts(mended, NAN, 0, cover, &covers), PLUMB_NON_FINITE);
  EXPECT_STATUS(plumb_mesh_covering_parts(mesh, 0, 0, cover, &covers), PLUMB_INVALID_SHAPE); /* open */
  plumb_mesh_destroy(mended);
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, NULL, 0, NULL, &mended, NULL, NULL, NULL), PLUMB_OK);
  plumb_mesh_destroy(mended);

  mended = NULL;
  steps[1].kind = PLUMB_UNUSED + 1;
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 2, NULL, &mended, NULL, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "kind") != NULL);
  steps[1].kind = PLUMB_ZIP;
  steps[1].tolerance = -1;
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 2, NULL, &mended, NULL, NULL, NULL), PLUMB_INVALID_SHAPE);
  steps[1].tolerance = NAN;
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 2, NULL, &mended, NULL, NULL, NULL), PLUMB_NON_FINITE);
  steps[1].size = sizeof steps[0] + 8;
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 2, NULL, &mended, NULL, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, NULL, 2, NULL, &mended, NULL, NULL, NULL), PLUMB_INVALID_ARGUMENT);
  progress.call = no_progress;
  progress.user = &calls;
  EXPECT_STATUS(plumb_mesh_repair_by(mesh, steps, 1, &progress, &mended, &faults, NULL, NULL), PLUMB_CANCELLED);
  EXPECT(mended == NULL && calls > 0);
  plumb_mesh_destroy(mesh);
}

static void ask_plane(void) {
  static const double points[8] = {0, 0, 2, 0, 0, 2, 2, 2};
  static const double stair[12] = {0, 0, 2, 0, 2, 1, 1, 1, 1, 2, 0, 2};
  static const double cross[8] = {0, 0, 2, 2, 0, 2, 2, 0};
  static const double square[16] = {0, 0, 1, 0, 1, 0, 1, 1, 1, 1, 0, 1, 0, 1, 0, 0};
  static const double bad[4] = {0, 0, NAN, 0};
  static const uint32_t edge[2] = {0, 1};
  plumb_triangles* triangles = NULL;
  plumb_loops* pieces = NULL;
  plumb_arrangement* arrangement = NULL;
  plumb_arrangement_report report = {sizeof report};
  plumb_figure polygon = figure(PLUMB_POLYGON, 2);
  const plumb_loop* each = NULL;
  const uint32_t* neighbors = NULL;
  double centers[4] = {7, 7, 7, 7};
  size_t count = 7;
  int fewest;

  EXPECT_STATUS(plumb_delaunay(points, 4, NULL, 0, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_triangles_neighbors(triangles, &neighbors, &count), PLUMB_OK);
  EXPECT(count == 2 && (neighbors[0] == UINT32_MAX) + (neighbors[1] == UINT32_MAX) + (neighbors[2] == UINT32_MAX) == 2);
  EXPECT_STATUS(plumb_voronoi_vertices(triangles, centers), PLUMB_OK);
  EXPECT(centers[0] == 1 && centers[1] == 1 && centers[2] == 1 && centers[3] == 1);
  EXPECT_STATUS(plumb_voronoi_vertices(triangles, NULL), PLUMB_INVALID_ARGUMENT);
  plumb_triangles_destroy(triangles);
  EXPECT_STATUS(plumb_delaunay(points, 4, edge, 1, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_voronoi_vertices(triangles, centers), PLUMB_UNSUPPORTED);
  plumb_triangles_destroy(triangles);
  EXPECT_STATUS(plumb_delaunay(points, 2, NULL, 0, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_voronoi_vertices(triangles, NULL), PLUMB_OK); /* no triangle, no vertex */
  plumb_triangles_destroy(triangles);

  polygon.as.rings.vertices = stair;
  polygon.as.rings.vertex_count = 6;
  EXPECT_STATUS(plumb_triangulate(&polygon, PLUMB_ODD, &triangles), PLUMB_OK);
  EXPECT_STATUS(plumb_triangles_neighbors(triangles, &neighbors, &count), PLUMB_UNSUPPORTED);
  plumb_triangles_destroy(triangles);
  for (fewest = 0; fewest < 2; ++fewest) {
    EXPECT_STATUS(plumb_convex_pieces(&polygon, PLUMB_ODD, fewest, &pieces), PLUMB_OK);
    EXPECT_STATUS(plumb_loops_of(pieces, &each, &count), PLUMB_OK);
    EXPECT(count >= 2 && (count == 2 || !fewest) && each[0].count >= 3 && each[0].is_closed && each[1].vertices[0] < 6);
    plumb_loops_destroy(pieces);
  }
  pieces = NULL;
  EXPECT_STATUS(plumb_convex_pieces(&polygon, 3, 0, &pieces), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_convex_pieces(NULL, PLUMB_ODD, 0, &pieces), PLUMB_INVALID_ARGUMENT);
  polygon.as.rings.vertex_count = 2;
  EXPECT_STATUS(plumb_convex_pieces(&polygon, PLUMB_ODD, 0, &pieces), PLUMB_INVALID_SHAPE);
  polygon = figure(PLUMB_BALL, 2);
  EXPECT_STATUS(plumb_convex_pieces(&polygon, PLUMB_ODD, 0, &pieces), PLUMB_UNSUPPORTED);
  EXPECT(pieces == NULL);

  EXPECT_STATUS(plumb_arrange_segments(cross, 2, &arrangement), PLUMB_OK);
  EXPECT_STATUS(plumb_arrangement_of(arrangement, &report), PLUMB_OK);
  EXPECT(report.vertex_count == 5 && report.segment_count == 2 && report.edge_count == 4 && report.face_count == 1 &&
         report.windings == NULL && report.vertices[4] == 1 && report.vertices[5] == 1 && report.ends[1] == 4);
  plumb_arrangement_destroy(arrangement);
  EXPECT_STATUS(plumb_arrange_segments(square, 4, &arrangement), PLUMB_OK);
  EXPECT_STATUS(plumb_arrangement_of(arrangement, &report), PLUMB_OK);
  EXPECT(report.face_count == 2 && report.triangle_count == 2 && report.windings[0] == 0 && report.windings[1] == 1 &&
         report.face_of[0] == 1 && report.weights[0] != 0 && report.sides[0] < 2);
  report.size = 1000;
  EXPECT_STATUS(plumb_arrangement_of(arrangement, &report), PLUMB_INVALID_ARGUMENT);
  plumb_arrangement_destroy(arrangement);
  plumb_arrangement_destroy(NULL);
  arrangement = NULL;
  EXPECT_STATUS(plumb_arrange_segments(bad, 1, &arrangement), PLUMB_NON_FINITE);
  EXPECT_STATUS(plumb_arrange_segments(NULL, 1, &arrangement), PLUMB_INVALID_ARGUMENT);
  EXPECT(arrangement == NULL);
  EXPECT_STATUS(plumb_arrange_segments(NULL, 0, &arrangement), PLUMB_OK);
  plumb_arrangement_destroy(arrangement);
}

static plumb_mesh* closed_box(double x, double size) {
  static const uint32_t faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                     2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  double corners[24];
  plumb_mesh* mesh = NULL;
  int i;
  for (i = 0; i < 8; ++i) {
    corners[3 * i] = x + (i & 1 ? size : 0);
    corners[3 * i + 1] = i & 2 ? size : 0;
    corners[3 * i + 2] = i & 4 ? size : 0;
  }
  EXPECT_STATUS(plumb_mesh_create(corners, 8, faces, 12, &mesh), PLUMB_OK);
  return mesh;
}

static void ask_clashes(void) {
  plumb_mesh* owned[3];
  const plumb_mesh* parts[3];
  const plumb_mesh* missing[1] = {NULL};
  plumb_clashes* clashes = NULL;
  const plumb_clash* each = NULL;
  plumb_clash_options options = {sizeof options, 0.5, 0, NULL, 0};
  plumb_clash_pair pair = {0, 2, 3.0};
  size_t count = 0;
  int i;
  for (i = 0; i < 3; ++i) parts[i] = owned[i] = closed_box(i == 0 ? 0 : i == 1 ? 1 : 4.5, i == 1 ? 3 : 2);
  EXPECT_STATUS(plumb_find_clashes(parts, 3, NULL, NULL, &clashes), PLUMB_OK);
  EXPECT_STATUS(plumb_clashes_of(clashes, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].a == 0 && each[0].b == 1 && each[0].kind == PLUMB_CLASH_OVERLAPPING);
  EXPECT(each[0].volume == 4 && each[0].depth_lower == 1 && each[0].depth_upper == 1 && each[0].direction[0] == -1);
  EXPECT(each[0].inner == -1 && isnan(each[0].distance) && each[0].meeting_count > 0 && each[0].meeting[0] < 12);
  plumb_clashes_destroy(clashes);
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_OK);
  EXPECT_STATUS(plumb_clashes_of(clashes, &each, &count), PLUMB_OK);
  EXPECT(count == 2 && isnan(each[0].volume) && isnan(each[0].depth_upper) && isnan(each[0].direction[2]));
  EXPECT(each[1].b == 2 && each[1].kind == PLUMB_CLASH_WITHIN_CLEARANCE && each[1].distance == 0.5);
  plumb_clashes_destroy(clashes);
  options.pairs = &pair;
  options.pair_count = 1;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_OK);
  EXPECT_STATUS(plumb_clashes_of(clashes, &each, &count), PLUMB_OK);
  EXPECT(count == 1 && each[0].a == 0 && each[0].b == 2 && each[0].distance == 2.5);
  plumb_clashes_destroy(clashes);
  plumb_clashes_destroy(NULL);
  clashes = NULL;
  pair.b = 3;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  pair.b = 0;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  options.pairs = NULL;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  options.pair_count = 0;
  options.clearance = NAN;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_NON_FINITE);
  options.size = 1;
  EXPECT_STATUS(plumb_find_clashes(parts, 3, &options, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_find_clashes(missing, 1, NULL, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_find_clashes(NULL, 1, NULL, NULL, &clashes), PLUMB_INVALID_ARGUMENT);
  EXPECT(clashes == NULL);
  EXPECT_STATUS(plumb_find_clashes(NULL, 0, NULL, NULL, &clashes), PLUMB_OK);
  plumb_clashes_destroy(clashes);
  for (i = 0; i < 3; ++i) plumb_mesh_destroy(owned[i]);
}

/* Figures and a mesh are the leaves; what steps are refused is named. */
static void ask_tree(void) {
  plumb_figure low = figure(PLUMB_AABB, 3), high = low, ball = figure(PLUMB_BALL, 3);
  plumb_tree_step steps[5];
  plumb_solid_report report;
  plumb_mesh *bore = NULL, *made = NULL;
  const double* vertices = NULL;
  size_t count = 0, i;
  for (i = 0; i < 3; ++i) low.as.aabb3.max[i] = 2, high.as.aabb3.min[i] = 1, high.as.aabb3.max[i] = 3;
  memset(steps, 0, sizeof steps);
  steps[0].figure = &low, steps[1].figure = &high;
  steps[2].operation = PLUMB_INTERSECT, steps[2].operands = 2;
  report.size = sizeof report;
  EXPECT_STATUS(plumb_evaluate(steps, 3, 0, &bore, &report), PLUMB_OK); /* the box from 1 to 2 */
  EXPECT(report.is_sound && report.moved == 0);
  EXPECT_STATUS(plumb_mesh_vertices(bore, &vertices, &count), PLUMB_OK);
  EXPECT(count == 8);
  for (i = 0; i < 3 * count; ++i) EXPECT(vertices[i] == 1 || vertices[i] == 2);
  steps[2].operation = PLUMB_UNITE;
  steps[3].mesh = bore;
  steps[4].operation = PLUMB_SUBTRACT, steps[4].operands = 2;
  EXPECT_STATUS(plumb_evaluate(steps, 5, 1, &made, NULL), PLUMB_OK); /* two boxes that touch no more but at edges */
  EXPECT_STATUS(plumb_mesh_vertices(made, &vertices, &count), PLUMB_OK);
  for (i = 0; i < count; ++i) EXPECT(vertices[3 * i] >= 0 && vertices[3 * i] <= 3);
  plumb_mesh_destroy(made);
  made = NULL;
  steps[2].operation = PLUMB_SUBTRACT, steps[2].operands = 1; /* one operand stays as it is, so that two trees are left */
  EXPECT_STATUS(plumb_evaluate(steps, 3, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "2 trees") != NULL);
  steps[2].operands = 3;
  EXPECT_STATUS(plumb_evaluate(steps, 3, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "steps[2] takes 3") != NULL);
  steps[2].operands = 0;
  EXPECT_STATUS(plumb_evaluate(steps, 3, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  steps[2].operands = 2, steps[2].operation = 9;
  EXPECT_STATUS(plumb_evaluate(steps, 3, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  steps[1].mesh = bore;
  EXPECT_STATUS(plumb_evaluate(steps, 2, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  ball.as.sphere3.radius = 1;
  steps[0].figure = &ball;
  EXPECT_STATUS(plumb_evaluate(steps, 1, 0, &made, NULL), PLUMB_UNSUPPORTED);
  EXPECT_STATUS(plumb_evaluate(steps, 0, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT_STATUS(plumb_evaluate(NULL, 1, 0, &made, NULL), PLUMB_INVALID_ARGUMENT);
  EXPECT(made == NULL);
  plumb_mesh_destroy(bore);
}

int main(void) {
  ask_topology();
  ask_tree();
  ask_welding();
  ask_sections();
  ask_halves();
  ask_repair();
  ask_plane();
  ask_clashes();
  if (failures != 0) fprintf(stderr, "%d failed\n", failures);
  return failures == 0 ? 0 : 1;
}
