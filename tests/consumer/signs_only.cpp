// A user's program that wants signs only: it links plumb::predicates and nothing else.
#include <cstdio>
#include <plumb/predicates.hpp>

int main() {
  // Degenerate, so that the library's exact stages are asked, GMP's among them.
  const plumb::Point2 a{1e-300, 1e-300}, b{1e300, 1e300}, c{3, 3};
  std::puts(plumb::orient2d(a, b, c) == plumb::Sign::zero ? "as expected" : "not as expected");
}
