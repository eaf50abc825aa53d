/* A user's program in C: it includes the header of the classic interface and links plumb::classic. */
#include <plumb/classic.h>
#include <stdio.h>

int main(void) {
  /* 0.5 and its neighbors against a line that no plain floating point keeps them off. */
  const double below[2] = {0.5, 0.49999999999999994}, on[2] = {0.5, 0.5}, a[2] = {12, 12}, b[2] = {24, 24};
  const int as_expected = orient2d(a, b, below) < 0 && orient2d(a, b, on) == 0 && orient2d(b, a, below) > 0;
  exactinit();
  puts(as_expected ? "as expected" : "not as expected");
  return !as_expected;
}
