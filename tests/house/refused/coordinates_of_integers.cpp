// Not every integer is a double: the compiler asks who converts.
// refused: narrowing
#include "plumb/plumb.hpp"

auto ask(int i, int j, int k) {
#ifdef MENDED
  return plumb::Point3{double(i), double(j), double(k)};
#else
  return plumb::Point3{i, j, k};
#endif
}
