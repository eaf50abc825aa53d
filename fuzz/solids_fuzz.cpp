// Do operations on solids keep their laws, and is what is called sound when rounded so?  Tetrahedra on few points in
// special position, many of them flat, inside out, or face to face.
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/round.hpp"
#include "plumb/surface/solid/split.hpp"
#include "triangle_heap.hpp"

namespace plumb::fuzz {
namespace {

/// Every tetrahedron is closed, so what they make up is.
TriangleMesh solid_from(Entropy& entropy, const std::vector<Point3>& points) {
  TriangleMesh mesh{points, {}};
  const auto vertex = [&] { return static_cast<std::uint32_t>(entropy.below(points.size())); };
  for (std::uint64_t n = 1 + entropy.below(4); n > 0; --n) {
    const std::uint32_t a = vertex(), b = vertex(), c = vertex(), d = vertex();
    for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}})
      mesh.triangles.push_back(t);
  }
  return mesh;
}

bool are_same(const ExactMesh& a, const ExactMesh& b) {
  return std::ranges::equal(a.vertices, b.vertices) && a.triangles == b.triangles;
}

void ask_rounded(const ExactMesh& exact) {
  const RoundedMesh rounded = round(exact);
  if (!rounded.sound) {
    if (rounded.meeting.empty()) fail("a mesh is not sound, and nothing meets");
    return;
  }
  const ExactMesh again = resolve(rounded.mesh);
  if (again.triangles != rounded.mesh.triangles) fail("what is called sound is cut by itself");
  if (!round(again).sound) fail("what is called sound is not when it is told again");
}

void ask_operations(const TriangleMesh& a, const TriangleMesh& b) {
  const ExactMesh of_a = resolve(a), of_b = resolve(b), both = unite(a, b), common = intersect(a, b),
                  first = subtract(a, b), either = symmetric_difference(a, b);
  const Rational in_both = exact_volume(both), in_common = exact_volume(common), in_first = exact_volume(first);
  if (exact_volume(of_a) + exact_volume(of_b) != in_both + in_common)
    fail("a union and an intersection are not the two");
  if (exact_volume(of_a) != in_common + in_first) fail("an intersection and a difference are not the first");
  if (exact_volume(either) + in_common != in_both) fail("a symmetric difference and an intersection are not the union");
  if (!are_same(unite(b, turned_round(a)), both)) fail("the order of what is given changes a union");
  for (const ExactMesh* mesh : {&both, &common, &first, &either}) ask_rounded(*mesh);
}

void ask_split(const TriangleMesh& a, const ThreePointPlane3& plane) {
  if (collinear(ExactPoint3(plane.a), ExactPoint3(plane.b), ExactPoint3(plane.c))) return;
  const ExactMesh whole = resolve(a);
  const SplitSolid halves = split(whole, plane);
  if (exact_volume(halves.above) + exact_volume(halves.below) != exact_volume(whole)) fail("halves are not the whole");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  std::vector<Point3> points;
  const std::size_t count = 4 + entropy.below(6);
  if (entropy.below(4) == 0) {
    points = points3(any_family(entropy), degeneracies[entropy.below(degeneracies.size())], count, entropy);
  } else {
    const auto coordinate = [&] { return static_cast<double>(entropy.within(2)); };
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate(), y = coordinate();
      points.push_back({x, y, coordinate()});
    }
  }
  const TriangleMesh a = fuzz::solid_from(entropy, points), b = fuzz::solid_from(entropy, points);
  fuzz::ask_operations(a, b);
  const auto any = [&] { return points[entropy.below(points.size())]; };
  const Point3 p = any(), q = any();
  fuzz::ask_split(a, {p, q, any()});
  return 0;
}
