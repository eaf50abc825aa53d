// The decisions of checked_test.cpp in a file that does not ask for the look at the thread.
#undef PLUMB_CHECKED

#include <array>

#include "plumb/certify/bounded_points.hpp"
#include "plumb/predicates.hpp"

namespace plumb {

int decide_unchecked() {
  using predicates::Orient2d;
  const Point2 a{0, 0}, b{1, 0}, c{0, 1};
  const BoundedPoints<Point2> scene(std::array{a, b, c});
  int decided = 0;
  decided += orient2d(a, b, c) == Sign::positive;
  decided += sign_of(Orient2d{}, a, b, c) == Sign::positive;
  decided += decide<Orient2d>({0, 0, 1, 0, 0, 1}) == Sign::positive;
  decided += LineSide(a, b)(c) == Sign::positive;
  decided += scene.predicate<Orient2d>()(0, 1, 2) == Sign::positive;
  return decided;
}

}  // namespace plumb
