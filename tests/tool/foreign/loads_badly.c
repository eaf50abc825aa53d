/* A library that does not survive being loaded (LOAD_CRASHES), or never has been (LOAD_HANGS). */
#include <stdlib.h>
#include <unistd.h>

__attribute__((constructor)) static void begin(void) {
#ifdef LOAD_CRASHES
  abort();
#else
  for (;;) pause();
#endif
}

double my_orient3d(const double *a, const double *b, const double *c, const double *d) {
  return a[0] + b[0] + c[0] + d[0];
}
