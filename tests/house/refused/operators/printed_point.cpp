// What is printed are numbers.
// refused: plumb: nothing is printed by <<
#include <iostream>

#include "plumb/plumb.hpp"

auto ask(const plumb::Point2& p) {
#ifdef MENDED
  return (std::cout << p.x << " " << p.y).good();
#else
  return (std::cout << p).good();
#endif
}
