// Takes a sign of each classic, sure and degenerate, for plain_flags_test.cpp, which counts what runs between signals.
// Compiled several times, with the flags of people who think of none.
#include <csignal>

#include "plumb/predicates.hpp"

// Not const, and of other files too: the compiler cannot know them.
plumb::Point2 plane[4]{{0.1, 0.1}, {0.7, 0.3}, {0.4, 0.9}, {0.3, 0.4}}, on_lattice[4]{{1, 1}, {3, 3}, {8, 8}, {9, 9}};
plumb::Point3 space[5]{{0.1, 0.1, 0.2}, {0.7, 0.3, 0.1}, {0.4, 0.9, 0.3}, {0.3, 0.4, 0.8}, {0.4, 0.4, 0.3}},
    in_plane[5]{{1, 1, 0}, {3, 3, 0}, {8, 8, 0}, {9, 9, 0}, {5, 5, 0}};
volatile int sign;

template <class Ask>
static void counted(Ask ask) {
  ask();  // whatever the loader does at a first call
  static_cast<void>(std::raise(SIGUSR1));
  ask();
  static_cast<void>(std::raise(SIGUSR1));
}

static void ask_all(const plumb::Point2* p, const plumb::Point3* q) {
  counted([p] { sign = static_cast<int>(plumb::orient2d(p[0], p[1], p[2])); });
  counted([q] { sign = static_cast<int>(plumb::orient3d(q[0], q[1], q[2], q[3])); });
  counted([p] { sign = static_cast<int>(plumb::incircle(p[0], p[1], p[2], p[3])); });
  counted([q] { sign = static_cast<int>(plumb::insphere(q[0], q[1], q[2], q[3], q[4])); });
}

int main() {
  counted([] {});
  ask_all(plane, space);
  ask_all(on_lattice, in_plane);
}
