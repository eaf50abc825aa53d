/* How do the programs in C say what they expect, and how many failed? */
#ifndef PLUMB_TESTS_C_EXPECT_H
#define PLUMB_TESTS_C_EXPECT_H

#include <plumb/plumb.h>

#include <stdio.h>
#include <string.h>

/* Programs that are compiled stay valid as long as no struct is laid out anew; one that grows brings a case of its old
 * size to guarded.hpp, and its new size to IS_LARGE. */
#define IS_LARGE(type, bytes) typedef char type##_is_as_large_as_it_was[sizeof(type) == (bytes) ? 1 : -1]

static int failures = 0;

static void expect(int is_so, const char* what) {
  if (is_so) return;
  fprintf(stderr, "failed: %s (last error: %s)\n", what, plumb_last_error());
  ++failures;
}
#define EXPECT(condition) expect((condition), #condition)
#define EXPECT_STATUS(call, status) expect((call) == (status), #call " is " #status)

static plumb_figure figure(int kind, int dimension) {
  plumb_figure f;
  memset(&f, 0, sizeof f);
  f.size = sizeof f;
  f.kind = kind;
  f.dimension = dimension;
  return f;
}

#endif
