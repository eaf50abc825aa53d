/* Functions as people write them, each with a fault that `plumb fuzz` is to find. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int an_object = 7; /* no function at all */

static double det3(const double *a, const double *b, const double *c, const double *d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  const double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  const double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  return ax * (by * cz - bz * cy) + bx * (cy * az - cz * ay) + cx * (ay * bz - az * by);
}

/* As the textbook has it: right but for rounding. */
double naive_orient3d(const double *a, const double *b, const double *c, const double *d) { return det3(a, b, c, d); }

/* Right, but it talks. */
double talking_orient3d(const double *a, const double *b, const double *c, const double *d) {
  printf("my orient3d was asked\n");
  fprintf(stderr, "and complains\n");
  fflush(stdout);
  return det3(a, b, c, d);
}

/* Dies where two points are equal. */
double crashing_orient3d(const double *a, const double *b, const double *c, const double *d) {
  if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]) abort();
  return det3(a, b, c, d);
}

/* Never ends where the volume is zero. */
double hanging_orient3d(const double *a, const double *b, const double *c, const double *d) {
  volatile double det = det3(a, b, c, d);
  while (det == 0) {
  }
  return det;
}

/* Leaves the program where the volume is zero. */
double leaving_orient3d(const double *a, const double *b, const double *c, const double *d) {
  const double det = det3(a, b, c, d);
  if (det == 0) exit(3);
  return det;
}

/* Reads a fifth point that nobody gave it. */
double greedy_orient3d(const double *a, const double *b, const double *c, const double *d) {
  return det3(a, b, c, d) + 0 * d[3];
}

/* Triangles without their edges: rays leak where two meet. */
static void minus(const double *p, const double *q, double *out) {
  for (int k = 0; k < 3; ++k) out[k] = p[k] - q[k];
}
static double triple(const double *p, const double *q, const double *r) {
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
}
int leaking_ray_mesh(const double *ray, const double *vertices, size_t n, const size_t *triangles, size_t m,
                     double *t) {
  int hit = 0;
  (void)n;
  for (size_t i = 0; i < m; ++i) {
    const double *a = vertices + 3 * triangles[3 * i], *d = ray + 3;
    double e[3], f[3], s[3];
    minus(vertices + 3 * triangles[3 * i + 1], a, e);
    minus(vertices + 3 * triangles[3 * i + 2], a, f);
    minus(ray, a, s);
    const double det = triple(d, f, e), u = triple(d, f, s) / det, v = triple(d, s, e) / det, at = triple(s, e, f) / det;
    if (!(u > 0 && v > 0 && u + v < 1 && at >= 0) || (hit && at >= *t)) continue;
    hit = 1;
    *t = at;
  }
  return hit;
}

/* Looks at one vertex more than there are. */
int greedy_ray_mesh(const double *ray, const double *vertices, size_t n, const size_t *triangles, size_t m, double *t) {
  volatile double beyond = vertices[3 * n];
  (void)beyond;
  return leaking_ray_mesh(ray, vertices, n, triangles, m, t);
}

/* Closes files that it has not opened. */
double closing_orient3d(const double *a, const double *b, const double *c, const double *d) {
  for (int file = 3; file < 64; ++file) close(file);
  return det3(a, b, c, d);
}

/* Comes back twice, the first time. */
double forking_orient3d(const double *a, const double *b, const double *c, const double *d) {
  static int forked = 0;
  if (!forked++) fork();
  return det3(a, b, c, d);
}

/* Takes its time. */
double slow_orient3d(const double *a, const double *b, const double *c, const double *d) {
  usleep(20000);
  return det3(a, b, c, d);
}

/* Separating axes with an epsilon: triangles that are nearly apart meet, and those of zero area meet everything. */
static void cross(const double *u, const double *v, double *out) {
  out[0] = u[1] * v[2] - u[2] * v[1], out[1] = u[2] * v[0] - u[0] * v[2], out[2] = u[0] * v[1] - u[1] * v[0];
}

static int apart_along(const double *axis, const double *s, const double *t) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (int i = 0; i < 6; ++i) {
    const double *p = i < 3 ? s + 3 * i : t + 3 * (i - 3);
    const double at = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    low[i / 3] = fmin(low[i / 3], at), high[i / 3] = fmax(high[i / 3], at);
  }
  return low[0] > high[1] + 1e-9 || low[1] > high[0] + 1e-9;
}

int epsilon_triangles(const double *s, const double *t) {
  double edges[6][3], normals[2][3], axis[3];
  for (int i = 0; i < 6; ++i) {
    const double *of = i < 3 ? s : t, *p = of + 3 * (i % 3), *q = of + 3 * ((i + 1) % 3);
    for (int k = 0; k < 3; ++k) edges[i][k] = q[k] - p[k];
  }
  cross(edges[0], edges[1], normals[0]);
  cross(edges[3], edges[4], normals[1]);
  for (int i = 0; i < 2; ++i) {
    if (apart_along(normals[i], s, t)) return 0;
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 3; j < 6; ++j) {
      cross(edges[i], edges[j], axis);
      if (apart_along(axis, s, t)) return 0;
    }
  }
  return 1;
}

/* Of a tetrahedron right, of anything else without an answer that could be. */
size_t hull_of_four(const double *points, size_t n, size_t *triangles, size_t capacity) {
  static const size_t faces[12] = {0, 1, 2, 0, 3, 1, 1, 3, 2, 2, 3, 0};
  if (n != 4 || capacity < 4) return 0;
  const double det = det3(points, points + 3, points + 6, points + 9);
  if (det == 0) return 0;
  for (int i = 0; i < 12; ++i) triangles[i] = faces[det > 0 ? i : 11 - i];
  return 4;
}

/* As if all points were on the x axis, the first of each the nearest. */
double distance_on_axis(const double *a, size_t n, const double *b, size_t m) {
  (void)n, (void)m;
  return fabs(a[0] - b[0]);
}

/* Inside where a ray to the right crosses an odd number of edges: on an edge it is now in, now out. */
int crossing_polygon(const double *p, const double *vertices, size_t n) {
  int inside = 0;
  for (size_t i = 0, j = n - 1; i < n; j = i++) {
    const double *a = vertices + 2 * i, *b = vertices + 2 * j;
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]) inside = !inside;
  }
  return inside;
}

/* Which of two sites is nearer: in floats, and exactly for floats between 0.001 and 1000. */
double nearer(const double *p, const double *a, const double *b) {
  return hypotf((float)(p[0] - a[0]), (float)(p[1] - a[1])) - hypotf((float)(p[0] - b[0]), (float)(p[1] - b[1]));
}
double nearer_exactly(const double *p, const double *a, const double *b) {
  __float128 sum = 0;
  for (int k = 0; k < 2; ++k) {
    const __float128 to_a = (__float128)p[k] - a[k], to_b = (__float128)p[k] - b[k];
    sum += to_a * to_a - to_b * to_b;
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}
double no_judge(const double *p, const double *a, const double *b) {
  if (p[0] == a[0] && p[1] == a[1]) abort();
  return nearer(p, a, b);
}

/* A hit wherever one is asked for, at 1; and who leaves open where. */
int always_hit(const double *ray, const double *triangle, double *t) {
  (void)ray, (void)triangle;
  *t = 1;
  return 1;
}
int hit_without_parameter(const double *ray, const double *triangle, double *t) {
  (void)ray, (void)triangle, (void)t;
  return 1;
}

/* As the textbook has it: right but for rounding. */
double naive_incircle(const double *a, const double *b, const double *c, const double *d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1];
  const double cx = c[0] - d[0], cy = c[1] - d[1];
  return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}
