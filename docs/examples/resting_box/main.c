/* A box sinks onto a table, frame by frame: when does it touch, and at which corners does it stand then?
 *
 * The pose is a turn by a quaternion that need not be of length one, and a place; both are exact.  The ids of the corners
 * are the same from frame to frame, as long as it rests on the same face. */
#include <plumb/plumb.h>
#include <stdio.h>
#include <stdlib.h>

static void must(plumb_status status) {
  if (status == PLUMB_OK) return;
  fprintf(stderr, "%s\n", plumb_last_error());
  exit(1);
}

int main(void) {
  plumb_figure table = {sizeof table, PLUMB_AABB, 3, {{{0}}}, PLUMB_AS_IT_IS, {{{{0}}}}, NULL};
  plumb_figure box = table;
  const plumb_aabb3 top = {{-4, -4, -1}, {4, 4, 0}}, cube = {{-1, -1, -1}, {1, 1, 1}};
  const double down[3] = {0, 0, -4};
  plumb_contact_cache* cache = NULL;
  plumb_meeting meeting;
  int found = 0, frame;

  table.as.aabb3 = top;
  box.as.aabb3 = cube;
  box.pose_kind = PLUMB_RIGID;
  box.pose.rigid3.w = 2; /* a turn about z by twice the angle whose tangent is 1/2 */
  box.pose.rigid3.z = 1;
  box.pose.rigid3.translation[2] = 3;

  meeting.size = sizeof meeting;
  must(plumb_first_contact(&box, down, &table, NULL, &found, &meeting));
  printf("it falls: contact at time %g\n", found ? meeting.time : -1.0);

  must(plumb_contact_cache_create(&cache));
  for (frame = 0; frame < 4; ++frame) {
    plumb_manifold manifold;
    plumb_corner corners[8];
    size_t i;
    manifold.size = sizeof manifold;
    box.pose.rigid3.translation[2] = 1.125 - 0.0625 * frame;
    must(plumb_contact(&box, &table, NULL, cache, &found, &manifold, corners, 8));
    if (!found) {
      printf("frame %d: apart\n", frame);
      continue;
    }
    printf("frame %d: %s, distance %g, corners", frame, manifold.relation == PLUMB_TOUCHING ? "rests" : "too deep",
           manifold.distance);
    for (i = 0; i < manifold.corner_count && i < 8; ++i) printf(" %u", corners[i].feature_a.index);
    printf("\n");
  }
  plumb_contact_cache_destroy(cache);
  return 0;
}
