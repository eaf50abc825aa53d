// Are convex parts convex, and together as large as the solid?  Polycubes, with a few corners moved, so that faces fold
// or cross: those that bound no solid are refused.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>

#include "figure/basic/solids.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/surface/parts/convex_parts.hpp"

namespace plumb::fuzz {
namespace {

[[noreturn]] void fail(const char* text) {
  std::cerr << text << std::endl;
  std::abort();
}

struct Solid {
  TriangleMesh mesh;
  bool moved;
};

Solid solid_from(Entropy& entropy) {
  std::set<solids::Cell> cells;
  const auto coordinate = [&] { return static_cast<int>(entropy.below(3)); };
  for (std::uint64_t n = 1 + entropy.below(12); n > 0; --n) {
    const int x = coordinate(), y = coordinate();
    cells.insert({x, y, coordinate()});
  }
  TriangleMesh mesh = solids::voxels(cells);
  const std::uint64_t moved = entropy.below(4);
  for (std::uint64_t n = moved; n > 0; --n) {
    Point3& p = mesh.vertices[entropy.below(mesh.vertices.size())];
    p.x += static_cast<double>(entropy.within(3)) / 16;
    p.z += static_cast<double>(entropy.within(3)) * 0x1p-50;
  }
  return {mesh, moved != 0};
}

Rational volume_of(const TriangleMesh& mesh) {
  Rational six = 0;
  for (const auto& [i, k, l] : mesh.triangles) {
    const Point3 &a = mesh.vertices[i], &b = mesh.vertices[k], &c = mesh.vertices[l];
    six = six + Rational(a.x) * (Rational(b.y) * c.z - Rational(b.z) * c.y) +
          Rational(a.y) * (Rational(b.z) * c.x - Rational(b.x) * c.z) +
          Rational(a.z) * (Rational(b.x) * c.y - Rational(b.y) * c.x);
  }
  return six / 6;
}

void expect_parts(const Solid& solid) {
  const TriangleMesh& mesh = solid.mesh;
  ConvexParts found;
  try {
    found = convex_parts(mesh);
  } catch (const InvalidShape& refusal) {
    if (!solid.moved) fail(refusal.what());
    return;
  }
  Rational sum = 0;
  for (const ConvexPart& part : found.parts) {
    sum = sum + exact_volume(part.solid);
    for (std::size_t f = 0; f < part.solid.faces(); ++f) {
      const auto ids = part.solid.corners_of(f);
      for (const ExactPoint3& p : part.solid.vertices) {
        const auto& v = part.solid.vertices;
        if (orient3d(v[ids[0]], v[ids[1]], v[ids[2]], p) == Sign::negative) fail("a corner is above a face");
      }
    }
  }
  if (sum != volume_of(mesh)) fail("the parts are not as large as the solid");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::Entropy entropy = plumb::Entropy::from_bytes({data, size});
  plumb::fuzz::expect_parts(plumb::fuzz::solid_from(entropy));
  return 0;
}
