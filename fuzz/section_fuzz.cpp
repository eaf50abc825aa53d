// Is a section the same however its plane is given, and does it wind as the mesh does?  Heaps of tetrahedra, closed but
// crossing, touching and flat.
#include <cstdint>
#include <iostream>
#include <span>

#include "plumb/degenerate/points.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/section/section.hpp"
#include "surface/section/flat_contours.hpp"

namespace plumb::fuzz {
namespace {

TriangleMesh heap_from(Entropy& entropy) {
  TriangleMesh mesh;
  if (entropy.coin()) {
    const Family family = any_family(entropy);
    mesh.vertices = points3(family, degeneracies[entropy.below(degeneracies.size())], 4 + entropy.below(16), entropy);
  } else {
    const auto coordinate = [&] { return static_cast<double>(entropy.within(3)); };
    for (std::uint64_t n = 4 + entropy.below(24); n > 0; --n) {
      const double x = coordinate(), y = coordinate();
      mesh.vertices.push_back({x, y, coordinate()});
    }
  }
  for (std::uint32_t v = 0; v + 3 < mesh.vertices.size(); v += 4) {
    for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      mesh.triangles.push_back({t[0] + v, t[1] + v, t[2] + v});
  }
  return mesh;
}

[[noreturn]] void fail(const char* text, double height) {
  std::cerr << text << " at z = " << height << std::endl;
  std::abort();
}

bool same(const Section& a, const Section& b) {
  if (a.contours.size() != b.contours.size() || a.coplanar_triangles != b.coplanar_triangles) return false;
  for (std::size_t i = 0; i < a.contours.size(); ++i) {
    const Contour &p = a.contours[i], &q = b.contours[i];
    if (p.corners != q.corners || p.turn != q.turn || p.parent != q.parent || p.depth != q.depth) return false;
  }
  return true;
}

std::size_t segments(const Section& cut) {
  std::size_t many = 0;
  for (const Contour& c : cut.contours) many += c.corners.size();
  return many;
}

void ask(const TriangleMesh& mesh, double height, Entropy& entropy) {
  const Plane3 plane{{0, 0, 1}, height};
  const Section cut = section(mesh, plane);
  const ThreePointPlane3 by_points{{0, 0, height}, {1, 0, height}, {0, 1, height}};
  if (!same(cut, section(mesh, by_points))) fail("three points give another section", height);
  if (2 * height - 2 * height == 0 && height / 2 * 2 == height &&
      !same(cut, section(mesh, Plane3{{0, 0, 0.5}, height / 2})))
    fail("half the normal gives another section", height);
  const Section below = section(mesh, plane, OnPlane::below), turned = section(mesh, Plane3{{0, 0, -1}, -height});
  if (segments(below) != segments(turned) || below.canceled_segments != turned.canceled_segments ||
      below.touching_corners != turned.touching_corners)
    fail("from below it is another section", height);
  for (const Contour& c : cut.contours) {
    if (!c.closed) fail("a closed mesh leaves a chain", height);
    if (c.parent && cut.contours[*c.parent].depth >= c.depth) fail("a contour lies in one no less deep", height);
  }
  const auto contours = oracle::flat_contours(mesh, cut, {0, 1, false});
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (oracle::doubled_area(contours[i]).sign() != cut.contours[i].turn) fail("a contour turns otherwise", height);
  }
  if (cut.corners_on_vertices != 0 || !cut.coplanar_triangles.empty()) return;
  for (const Point3& v : mesh.vertices) {
    if (v.z == height) return;  // the infinitesimal step matters
  }
  for (int i = 0; i < 4; ++i) {
    const Point3 &a = mesh.vertices[entropy.below(mesh.vertices.size())],
                 &b = mesh.vertices[entropy.below(mesh.vertices.size())];
    const Point3 p{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, height};
    const auto turns = oracle::winding(contours, {p.x, p.y});
    const auto in_space = winding_number(mesh, p);
    if (!in_space) continue;  // also of walls that cancel
    if (!turns || *turns != *in_space) fail("the contours wind otherwise than the mesh", height);
  }
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const TriangleMesh mesh = fuzz::heap_from(entropy);
  const double at_vertex = mesh.vertices[entropy.below(mesh.vertices.size())].z;
  const double other = mesh.vertices[entropy.below(mesh.vertices.size())].z;
  for (const double height : {at_vertex, at_vertex / 2 + other / 2, 0.25}) fuzz::ask(mesh, height, entropy);
  return 0;
}
