/* A program in C, written for the classic interface: the convex hull of points that all but lie on lines.
 *
 * With orient2dfast, which is plain floating point, the hull has corners that are none or lacks some. */
#include <plumb/classic.h>
#include <stdio.h>
#include <stdlib.h>

typedef double Point[2];
typedef double Orientation(const double*, const double*, const double*);

static int by_x(const void* a, const void* b) {
  const double *p = a, *q = b;
  if (p[0] != q[0]) return p[0] < q[0] ? -1 : 1;
  return (p[1] > q[1]) - (p[1] < q[1]);
}

/* Andrew's monotone chain: strict corners, counterclockwise; returns how many. */
static int hull(const Point* points, int n, Orientation* orientation, int* corners) {
  int many = 0;
  for (int i = 0; i < n; ++i) {
    while (many >= 2 && orientation(points[corners[many - 2]], points[corners[many - 1]], points[i]) <= 0) --many;
    corners[many++] = i;
  }
  const int lower = many;
  for (int i = n - 2; i >= 0; --i) {
    while (many > lower && orientation(points[corners[many - 2]], points[corners[many - 1]], points[i]) <= 0) --many;
    corners[many++] = i;
  }
  return many - 1;
}

/* How many points lie outside of the hull, by exact signs. */
static int outside(const Point* points, int n, const int* corners, int many) {
  int count = 0;
  for (int i = 0; i < n; ++i) {
    int out = 0;
    for (int k = 0; k < many; ++k) out |= orient2d(points[corners[k]], points[corners[(k + 1) % many]], points[i]) < 0;
    count += out;
  }
  return count;
}

int main(void) {
  enum { n = 400 };
  static Point points[n];
  static int corners[2 * n];
  for (int i = 0; i < n; ++i) { /* a thin band along y = x / 3, as decimals make it */
    points[i][0] = 0.1 * (i / 2);
    points[i][1] = 0.1 * (i / 2) / 3 + (i % 2) * 0x1p-52;
  }
  qsort(points, n, sizeof(Point), by_x);
  const int exact = hull((const Point*)points, n, orient2d, corners);
  printf("orient2d: %d corners, %d points outside\n", exact, outside((const Point*)points, n, corners, exact));
  const int fast = hull((const Point*)points, n, orient2dfast, corners);
  printf("orient2dfast: %d corners, %d points outside\n", fast, outside((const Point*)points, n, corners, fast));
  return 0;
}
