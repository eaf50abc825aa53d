// Not every integer is a double: the compiler asks who converts.
// refused: narrow
#include "plumb/plumb.hpp"

auto ask(int i) {
#ifdef MENDED
  return plumb::Point3{double(i), 0, 0};
#else
  return plumb::Point3{i, 0, 0};
#endif
}
