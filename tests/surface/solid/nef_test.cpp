// Are small solids united, intersected and subtracted as CGAL's Nef polyhedra are?
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "certify/sanitized.hpp"
#include "oracle/nef_solids.hpp"
#include "surface/solid/solid_laws.hpp"

namespace plumb {
namespace {

using oracle::NefSolid, oracle::QuotientPoint, oracle::SolidOperation;
using solids::box;

QuotientPoint quotients(const RationalPoint3& p) { return {p.x.text(), p.y.text(), p.z.text()}; }

std::optional<NefSolid> nef_of(const ExactMesh& mesh) {
  std::vector<QuotientPoint> vertices;
  for (const ExactPoint3& p : mesh.vertices) vertices.push_back(quotients(rational_point(p)));
  return NefSolid::of(vertices, mesh.triangles);
}

/// Wound outward.
TriangleMesh tetrahedron(const std::array<Point3, 4>& p) {
  TriangleMesh mesh{{p.begin(), p.end()}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}}};
  if (solid_laws::volume_of(mesh).sign() == Sign::negative) std::swap(mesh.vertices[0], mesh.vertices[1]);
  return mesh;
}

/// A box or a tetrahedron of a small lattice, sometimes an ulp aside.
TriangleMesh small_solid(std::mt19937_64& random) {
  const auto step = [&](int least, int most) {
    return static_cast<double>(std::uniform_int_distribution(least, most)(random));
  };
  const auto anywhere = [&] { return Point3{step(0, 4), step(0, 4), step(0, 4)}; };
  TriangleMesh mesh;
  if (random() % 2 == 0) {
    const Point3 p = anywhere();
    mesh = box(p, {p.x + step(1, 3), p.y + step(1, 3), p.z + step(1, 3)});
  } else {
    std::array<Point3, 4> p{anywhere(), anywhere(), anywhere(), anywhere()};
    while (orient3d(p[0], p[1], p[2], p[3]) == Sign::zero) p[random() % 4] = anywhere();
    mesh = tetrahedron(p);
  }
  if (random() % 4 == 0) {
    Point3& p = mesh.vertices[random() % mesh.vertices.size()];
    if (mesh.vertices.size() == 4) p.x = std::nextafter(p.x, 9);
  }
  return mesh;
}

/// Corners, middles of edges and of triangles, and what lies beside these.
std::vector<RationalPoint3> places_of(const ExactMesh& mesh) {
  std::vector<RationalPoint3> at, places;
  for (const ExactPoint3& p : mesh.vertices) at.push_back(rational_point(p));
  places = at;
  const Rational half(1, 2), third(1, 3);
  for (const auto& [a, b, c] : mesh.triangles) {
    const RationalPoint3 &p = at[a], &q = at[b], &r = at[c];
    if (a < b) places.push_back({(p.x + q.x) * half, (p.y + q.y) * half, (p.z + q.z) * half});
    const RationalPoint3 middle{(p.x + q.x + r.x) * third, (p.y + q.y + r.y) * third, (p.z + q.z + r.z) * third};
    places.push_back(middle);
    places.push_back({middle.x + Rational(1, 1024), middle.y + Rational(1, 512), middle.z + Rational(1, 2048)});
  }
  return places;
}

TEST(Boolean, IsThatOfNefPolyhedra) {
  std::size_t compared = 0, located = 0;
  std::array<std::size_t, 3> of_place{};
  for (std::uint64_t seed = 0; seed < battery::fitting(60U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const TriangleMesh a = small_solid(random), b = small_solid(random);
    const auto nef_a = nef_of(solid_laws::exact_mesh_of(a)), nef_b = nef_of(solid_laws::exact_mesh_of(b));
    ASSERT_TRUE(nef_a && nef_b);
    const std::array<std::pair<SolidOperation, ExactMesh>, 4> made{
        {{SolidOperation::unite, unite(a, b)},
         {SolidOperation::intersect, intersect(a, b)},
         {SolidOperation::subtract, subtract(a, b)},
         {SolidOperation::symmetric_difference, symmetric_difference(a, b)}}};
    for (const auto& [operation, ours] : made) {
      SCOPED_TRACE("operation " + std::to_string(static_cast<int>(operation)));
      const NefSolid theirs = nef_a->by(operation, *nef_b);
      if (const auto same = nef_of(ours); same && !ours.triangles.empty()) {
        EXPECT_TRUE(theirs.is_same(*same));
        ++compared;
      }
      std::vector<RationalPoint3> places = places_of(ours);
      for (const TriangleMesh* m : {&a, &b}) {
        for (const Point3& p : m->vertices) places.push_back({Rational(p.x), Rational(p.y), Rational(p.z)});
      }
      for (const RationalPoint3& p : places) {
        const auto winding = solid_laws::winding_by_definition(ours, p);
        const Sign place = !winding ? Sign::zero : *winding > 0 ? Sign::positive : Sign::negative;
        EXPECT_EQ(theirs.place(quotients(p)), place) << p.x.text() << " " << p.y.text() << " " << p.z.text();
        ++located, ++of_place[static_cast<std::size_t>(static_cast<int>(place) + 1)];
      }
    }
  }
  EXPECT_GT(compared, battery::fitting(100U));
  for (const std::size_t n : of_place) EXPECT_GT(n, located / 20);
}

}  // namespace
}  // namespace plumb
