/* Does all memory of handles come from whom the caller sets, does it go back there, and is every place where it may run
 * out an error and no end?  A program in C of 1999. */
#include <math.h>
#include <stdlib.h>

#include "expect.h"

#if UINTPTR_MAX == UINT64_MAX
IS_LARGE(plumb_allocator, 32);
#endif

/* Counts what is out, and gives nothing once `left` are given; threads of the library ask too. */
typedef struct counted { long blocks, bytes, asked, left, wrong; } counted;

static void* allocate(size_t bytes, size_t alignment, void* user) {
  counted* c = user;
  char *raw, *block;
  __atomic_add_fetch(&c->asked, 1, __ATOMIC_SEQ_CST);
  if (__atomic_sub_fetch(&c->left, 1, __ATOMIC_SEQ_CST) < 0) return NULL;
  if (alignment < sizeof(void*) || (alignment & (alignment - 1)) != 0)
    __atomic_add_fetch(&c->wrong, 1, __ATOMIC_SEQ_CST);
  raw = malloc(bytes + alignment + sizeof raw);
  if (raw == NULL) abort();
  block = raw + sizeof raw;
  block += alignment - (uintptr_t)block % alignment;
  ((char**)block)[-1] = raw;
  __atomic_add_fetch(&c->blocks, 1, __ATOMIC_SEQ_CST);
  __atomic_add_fetch(&c->bytes, (long)bytes, __ATOMIC_SEQ_CST);
  return block;
}
static void release(void* block, size_t bytes, size_t alignment, void* user) {
  counted* c = user;
  if ((uintptr_t)block % alignment != 0) __atomic_add_fetch(&c->wrong, 1, __ATOMIC_SEQ_CST);
  __atomic_sub_fetch(&c->blocks, 1, __ATOMIC_SEQ_CST);
  __atomic_sub_fetch(&c->bytes, (long)bytes, __ATOMIC_SEQ_CST);
  memset(block, 0xee, bytes);
  free(((char**)block)[-1]);
}

/* They work as long as the process: some memory is kept. */
static counted first, second;
static plumb_allocator by(counted* c) {
  plumb_allocator a;
  a.size = sizeof a;
  a.allocate = allocate, a.release = release, a.user = c;
  c->left = 1L << 40;
  return a;
}

static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};

#define TRY(call) if ((status = (call)) != PLUMB_OK) goto done

static plumb_status of_figures(void) {
  plumb_status status;
  plumb_kept* kept = NULL;
  plumb_contact_cache* cache = NULL;
  char answer[200];
  size_t length;
  plumb_figure a = figure(PLUMB_AABB, 3), b;
  plumb_manifold manifold;
  plumb_corner told[8];
  plumb_relation relation;
  int found;
  memset(&b, 0, sizeof b);
  b.size = sizeof b;
  manifold.size = sizeof manifold;
  a.as.aabb3.max[0] = a.as.aabb3.max[1] = a.as.aabb3.max[2] = 1;
  TRY(plumb_kept_parse("tetrahedron3 0 0 0.5 1 0 0.5 0 1 0.5 0 0 2", &kept));
  b.kept = kept;
  TRY(plumb_relate(&a, &b, &relation));
  EXPECT(relation == PLUMB_OVERLAPPING);
  TRY(plumb_contact_cache_create(&cache));
  TRY(plumb_contact(&a, &b, NULL, cache, &found, &manifold, told, 8));
  TRY(plumb_ask("distance | ball3 0 0 0 1 | ball3 3 0 0 1", answer, sizeof answer, &length));
  EXPECT(strstr(answer, "0x1p+0") != NULL);
done:
  plumb_contact_cache_destroy(cache);
  plumb_kept_destroy(kept);
  return status;
}

static plumb_status of_meshes(void) {
  plumb_status status;
  plumb_mesh *mesh = NULL, *other = NULL, *both = NULL;
  plumb_bvh* bvh = NULL;
  plumb_pairs* pairs = NULL;
  plumb_weld* weld = NULL;
  plumb_contours* contours = NULL;
  plumb_mesh* welded = NULL;
  plumb_figure plane = figure(PLUMB_PLANE, 3);
  const plumb_mesh* operands[2];
  const double origin[3] = {0.25, 0.25, -1}, up[3] = {0, 0, 1};
  double moved[12], t = 0;
  int64_t triangle = -1;
  plumb_faults faults;
  int i;
  faults.size = sizeof faults;
  plane.as.plane3.normal[2] = 1, plane.as.plane3.offset = 0.25;
  for (i = 0; i < 12; ++i) moved[i] = corners[i] + 0.125;
  TRY(plumb_mesh_create(corners, 4, faces, 4, &mesh));
  TRY(plumb_mesh_create(moved, 4, faces, 4, &other));
  TRY(plumb_mesh_faults(mesh, NULL, &faults));
  EXPECT(faults.is_sound);
  operands[0] = mesh, operands[1] = other;
  TRY(plumb_mesh_combine(PLUMB_UNITE, operands, 2, &both, NULL));
  TRY(plumb_bvh_create(both, &bvh));
  TRY(plumb_bvh_first_hits(bvh, origin, up, 1, &triangle, &t, NULL));
  EXPECT(triangle >= 0 && t == 1);
  TRY(plumb_bvh_intersecting_pairs(bvh, NULL, NULL, &pairs));
  TRY(plumb_mesh_weld(mesh, NULL, &welded, &weld));
  TRY(plumb_mesh_sections(both, &plane, 1, 1, &contours));
done:
  plumb_contours_destroy(contours);
  plumb_weld_destroy(weld);
  plumb_mesh_destroy(welded);
  plumb_pairs_destroy(pairs);
  plumb_bvh_destroy(bvh);
  plumb_mesh_destroy(both);
  plumb_mesh_destroy(other);
  plumb_mesh_destroy(mesh);
  return status;
}

static plumb_status of_points(void) {
  plumb_status status;
  plumb_points* tree = NULL;
  plumb_triangles* triangles = NULL;
  double points[2 * 40], nearest = -1;
  int64_t index = -1;
  int i;
  for (i = 0; i < 40; ++i) points[2 * i] = i % 7, points[2 * i + 1] = (3 * i) % 11;
  TRY(plumb_points_create(points, 40, 2, &tree));
  TRY(plumb_points_nearest(tree, points + 6, 1, 1, &index, &nearest));
  EXPECT(index == 3 && nearest == 0);
  TRY(plumb_delaunay(points, 40, NULL, 0, &triangles));
done:
  plumb_triangles_destroy(triangles);
  plumb_points_destroy(tree);
  return status;
}

static plumb_status of_worlds(void) {
  plumb_status status;
  plumb_world* world = NULL;
  plumb_world_options options;
  plumb_figure box = figure(PLUMB_AABB, 3);
  plumb_rigid3 at = {1, 0, 0, 0, {0, 0, 0.5}};
  plumb_body a, b;
  const plumb_world_contact* contacts;
  size_t count = 0;
  options.size = sizeof options;
  options.contacts = options.one_thread = 1;
  box.as.aabb3.max[0] = box.as.aabb3.max[1] = box.as.aabb3.max[2] = 1;
  TRY(plumb_world_create(&options, &world));
  TRY(plumb_world_add(world, &box, 1, NULL, NULL, &a));
  TRY(plumb_world_add(world, &box, 1, &at, NULL, &b));
  TRY(plumb_world_commit(world, NULL));
  TRY(plumb_world_contacts(world, &contacts, &count));
  EXPECT(count == 1);
done:
  plumb_world_destroy(world);
  return status;
}

typedef plumb_status (*work)(void);
static const work works[] = {of_figures, of_meshes, of_points, of_worlds};
static const char* const names[] = {"figures", "meshes", "points", "worlds"};

static void all_goes_back(size_t which) {
  long blocks, bytes;
  EXPECT_STATUS(works[which](), PLUMB_OK); /* what is kept for the next time is there after this */
  blocks = first.blocks, bytes = first.bytes;
  first.asked = 0;
  EXPECT_STATUS(works[which](), PLUMB_OK);
  EXPECT(first.asked > 3);
  EXPECT(first.blocks == blocks);
  EXPECT(first.bytes == bytes);
  if (failures != 0) fprintf(stderr, "of %s: %ld blocks instead of %ld\n", names[which], first.blocks, blocks);
}

static void each_may_be_the_last(size_t which) {
  plumb_status status = PLUMB_OUT_OF_MEMORY;
  long given = 0, blocks = first.blocks, failed = 0;
  for (; status == PLUMB_OUT_OF_MEMORY; ++given) {
    first.left = given;
    status = works[which]();
    first.left = 1L << 40;
    if (status != PLUMB_OUT_OF_MEMORY) break;
    ++failed;
    if (first.blocks != blocks) {
      fprintf(stderr, "of %s, after %ld: %ld blocks instead of %ld\n", names[which], given, first.blocks, blocks);
      ++failures;
      return;
    }
  }
  EXPECT(status == PLUMB_OK);
  EXPECT(failed > 3);
}

int main(void) {
  plumb_allocator a = by(&first), wrong = a;
  plumb_mesh *mesh = NULL, *later = NULL;
  const double* vertices = NULL;
  size_t which, count = 0;
  long of_mesh;
  if (plumb_set_allocator(&a) == PLUMB_UNSUPPORTED) {
    puts("skipped: this library's memory is not its own");
    return 77;
  }
  for (which = 0; which < sizeof works / sizeof *works; ++which) {
    all_goes_back(which);
    each_may_be_the_last(which);
  }

  /* A block goes back to whom it came from, whoever is set meanwhile. */
  of_mesh = first.blocks;
  EXPECT_STATUS(plumb_mesh_create(corners, 4, faces, 4, &mesh), PLUMB_OK);
  EXPECT(first.blocks > of_mesh + 2); /* the handle, vertices, triangles */
  a = by(&second);
  EXPECT_STATUS(plumb_set_allocator(&a), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_create(corners, 4, faces, 4, &later), PLUMB_OK);
  plumb_mesh_destroy(mesh);
  EXPECT(first.blocks == of_mesh);
  EXPECT(second.blocks > 2 && second.bytes >= (long)(sizeof corners + sizeof faces));
  EXPECT_STATUS(plumb_set_allocator(NULL), PLUMB_OK);
  EXPECT_STATUS(plumb_mesh_vertices(later, &vertices, &count), PLUMB_OK);
  EXPECT(count == 4 && vertices[3] == 1);
  plumb_mesh_destroy(later);
  EXPECT(second.blocks == 0 && second.bytes == 0);
  second.asked = 0;
  EXPECT_STATUS(of_figures(), PLUMB_OK);
  EXPECT(second.asked == 0);
  EXPECT(first.wrong == 0 && second.wrong == 0);

  wrong.size = 8;
  EXPECT_STATUS(plumb_set_allocator(&wrong), PLUMB_INVALID_ARGUMENT);
  wrong = a, wrong.allocate = NULL;
  EXPECT_STATUS(plumb_set_allocator(&wrong), PLUMB_INVALID_ARGUMENT);
  wrong = a, wrong.release = NULL;
  EXPECT_STATUS(plumb_set_allocator(&wrong), PLUMB_INVALID_ARGUMENT);
  EXPECT(strstr(plumb_last_error(), "release") != NULL);
  return failures == 0 ? 0 : 1;
}
