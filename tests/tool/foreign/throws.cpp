// A function of C's that lets an exception of C++'s out.
#include <stdexcept>

extern "C" double throwing_orient3d(const double* a, const double* b, const double* c, const double* d) {
  if (a[2] == b[2] && b[2] == c[2] && c[2] == d[2]) throw std::domain_error("four points of one height");
  return a[2] - b[2];
}

// In Latin-1.
extern "C" double latin_orient3d(const double*, const double*, const double*, const double*) {
  throw std::domain_error("nicht m\xf6glich");
}
