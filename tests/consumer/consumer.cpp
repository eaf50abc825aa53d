// A user's program: a sign, a mesh and hard inputs.  It says "as expected" and ends with 0 when all is well.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <plumb/degenerate.hpp>
#include <plumb/predicates.hpp>
#include <plumb/surface.hpp>
#include <string>
#include <system_error>
#include <vector>

// -Wconversion and -Wshadow would complain here: plumb's own warnings are not to reach its users.
static int rounded_down(double real) {
  int whole = real;
  {
    int real = whole;
    return real;
  }
}

static bool signs() {
  // 0.1, 0.2, 0.3 are no multiples of each other as doubles: the points are not on one line.
  return plumb::orient2d({0, 0}, {1, 1}, {2, 2}) == plumb::Sign::zero &&
         plumb::orient2d({0, 0}, {1, 0}, {0, 1}) == plumb::Sign::positive &&
         plumb::orient2d({0.1, 0.1}, {0.2, 0.3}, {0.3, 0.5}) != plumb::Sign::zero;
}

static bool many_signs() {
  const std::vector<plumb::Point2> a(1000, {0, 0}), b(1000, {0.1, 0.1}), c(1000, {0.3, 0.3});
  std::vector<plumb::Sign> signs(1000, plumb::Sign::negative);
  plumb::orient2d(a, b, c, signs, plumb::Execution::parallel);
  return signs == std::vector<plumb::Sign>(1000, plumb::Sign::zero);
}

static bool mesh(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "square.obj";
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  const plumb::TriangleMesh square = plumb::read_mesh(path);
  return square.vertices.size() == 4 && square.triangles.size() == 2;
}

static bool hard_inputs() {
  int degenerate = 0;
  for (std::uint64_t number = 0; number < 100; ++number) {
    plumb::Entropy entropy(1, number);
    const std::vector<plumb::Point2> p =
        plumb::points2(plumb::Family::degenerate_short, plumb::Degeneracy::collinear, 3, entropy);
    degenerate += plumb::orient2d(p[0], p[1], p[2]) == plumb::Sign::zero;
  }
  return degenerate == 100;
}

int main(int, char** argv) {
  const std::filesystem::path folder = std::filesystem::absolute(argv[0]).parent_path();
  if (rounded_down(1.5) != 1 || !signs() || !many_signs() || !mesh(folder) || !hard_inputs()) {
    std::puts("not as expected");
    return 1;
  }
  std::puts("as expected");
}
