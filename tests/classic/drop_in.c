/* A program written for the classic interface, with its own declarations of it: does it get every sign right against
 * integer arithmetic, from one thread and from several at once?  It ends with 0 when it does. */
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>

#define REAL double

extern void exactinit();
extern REAL orient2d(REAL *pa, REAL *pb, REAL *pc);
extern REAL orient3d(REAL *pa, REAL *pb, REAL *pc, REAL *pd);
extern REAL incircle(REAL *pa, REAL *pb, REAL *pc, REAL *pd);
extern REAL insphere(REAL *pa, REAL *pb, REAL *pc, REAL *pd, REAL *pe);

__extension__ typedef __int128 Wide;

static int sign_of_integer(Wide x) { return (x > 0) - (x < 0); }
static int sign_of_real(REAL x) { return (x > 0) - (x < 0); }

static Wide det3(const Wide *a, const Wide *b, const Wide *c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Points around (0.5, 0.5), a unit in the last place apart, against the line through (12, 12) and (24, 24). */
static long wrong_near_a_line(void) {
  const REAL unit = 1.0 / 9007199254740992.0; /* 2^-53 */
  const Wide one = (Wide)1 << 53;
  long wrong = 0;
  for (int i = 0; i < 256; ++i) {
    for (int j = 0; j < 256; ++j) {
      REAL p[2] = {0.5 + i * unit, 0.5 + j * unit}, q[2] = {12, 12}, r[2] = {24, 24};
      const Wide px = one / 2 + i, py = one / 2 + j;
      const Wide det = (px - 24 * one) * (-12 * one) - (py - 24 * one) * (-12 * one);
      wrong += sign_of_real(orient2d(p, q, r)) != sign_of_integer(det);
    }
  }
  return wrong;
}

/* Points of small grids, of which many lie on one line, plane, circle or sphere. */
static long wrong_on_a_grid(uint64_t state, int bits, long *zeros) {
  long wrong = 0;
  for (int n = 0; n < 20000; ++n) {
    REAL x[5][3];
    Wide d3[4][3], d2[3][3], sphere = 0;
    for (int i = 0; i < 5; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        x[i][axis] = (REAL)(int64_t)(state >> (64 - bits));
      }
    }
    for (int i = 0; i < 4; ++i) {
      for (int axis = 0; axis < 3; ++axis) d3[i][axis] = (Wide)(x[i][axis] - x[4][axis]);
    }
    for (int i = 0; i < 3; ++i) { /* seen from x[3]: edges in space, and lifted edges in the plane */
      const Wide u = (Wide)(x[i][0] - x[3][0]), v = (Wide)(x[i][1] - x[3][1]);
      d2[i][0] = u;
      d2[i][1] = v;
      d2[i][2] = u * u + v * v;
    }
    for (int i = 0; i < 4; ++i) {
      const Wide *rest[3];
      int k = 0;
      for (int other = 0; other < 4; ++other) {
        if (other != i) rest[k++] = d3[other];
      }
      const Wide lift = d3[i][0] * d3[i][0] + d3[i][1] * d3[i][1] + d3[i][2] * d3[i][2];
      sphere += (i % 2 == 0 ? -1 : 1) * lift * det3(rest[0], rest[1], rest[2]);
    }
    Wide edges[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) edges[i][axis] = (Wide)(x[i][axis] - x[3][axis]);
    }
    const int in_space = sign_of_integer(det3(edges[0], edges[1], edges[2]));
    const int in_circle = sign_of_integer(det3(d2[0], d2[1], d2[2]));
    wrong += sign_of_real(orient3d(x[0], x[1], x[2], x[3])) != in_space;
    wrong += sign_of_real(incircle(x[0], x[1], x[2], x[3])) != in_circle;
    wrong += sign_of_real(insphere(x[0], x[1], x[2], x[3], x[4])) != sign_of_integer(sphere);
    *zeros += (in_space == 0) + (in_circle == 0) + (sphere == 0);
  }
  return wrong;
}

static void *count_wrong(void *number) {
  long zeros = 0;
  long wrong = wrong_near_a_line();
  for (int bits = 2; bits <= 17; bits += 5) wrong += wrong_on_a_grid(*(uint64_t *)number, bits, &zeros);
  if (zeros < 1000) wrong += 1000000; /* the grids were to be degenerate */
  *(long *)number = wrong;
  return 0;
}

int main(void) {
  uint64_t number[5] = {1, 2, 3, 4, 5};
  pthread_t thread[4];
  exactinit();
  count_wrong(&number[4]);
  for (int i = 0; i < 4; ++i) {
    if (pthread_create(&thread[i], 0, count_wrong, &number[i]) != 0) return 2;
  }
  for (int i = 0; i < 4; ++i) pthread_join(thread[i], 0);
  for (int i = 0; i < 5; ++i) {
    printf("%s %d: %ld wrong\n", i < 4 ? "thread" : "alone", i, (long)number[i]);
    if (number[i] != 0) return 1;
  }
  return 0;
}
