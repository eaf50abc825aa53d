// Do coplanar faces have the areas of their triangles, each triangle in one, exactly and within a tolerance, and do new triangles
// keep the outline?
#include "plumb/arith/rational.hpp"
#include "plumb/surface/repair/merge_coplanar.hpp"
#include "triangle_heap.hpp"

namespace plumb::fuzz {
namespace {

using VectorArea = std::array<Rational, 3>;  // twice

VectorArea operator+(const VectorArea& a, const VectorArea& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
bool are_same(const VectorArea& a, const VectorArea& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

VectorArea area_of(const TriangleMesh& mesh, std::span<const std::uint32_t> ring) {
  VectorArea sum{Rational(0), Rational(0), Rational(0)};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point3 &p = mesh.vertices[ring[i]], &q = mesh.vertices[ring[(i + 1) % ring.size()]];
    const auto cross = [](double a, double b, double c, double d) {
      return Rational(a) * Rational(d) - Rational(b) * Rational(c);
    };
    sum = sum + VectorArea{cross(p.y, p.z, q.y, q.z), cross(p.z, p.x, q.z, q.x), cross(p.x, p.y, q.x, q.y)};
  }
  return sum;
}

VectorArea area_of(const TriangleMesh& mesh) {
  VectorArea sum{Rational(0), Rational(0), Rational(0)};
  for (const TriangleMesh::Triangle& t : mesh.triangles) sum = sum + area_of(mesh, t);
  return sum;
}

void ask_faces(const TriangleMesh& mesh, const CoplanarOptions& options) {
  const CoplanarFaces faces = merge_coplanar(mesh, options);
  std::vector<int> times(mesh.triangles.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    VectorArea outline{Rational(0), Rational(0), Rational(0)}, covered = outline;
    for (const auto& ring : faces.rings_of(f)) outline = outline + area_of(mesh, ring);
    for (const std::uint32_t t : faces.triangles_of(f)) {
      ++times[t];
      covered = covered + area_of(mesh, mesh.triangles[t]);
    }
    if (!are_same(outline, covered)) fail("a face has another area than its triangles");
    if (std::ranges::count(faces.triangles_of(f), faces.plane[f]) != 1) fail("a face is in the plane of another");
  }
  if (std::ranges::count(times, 1) != std::ssize(times)) fail("a triangle is in no face, or in two");
  const TriangleMesh fewer = triangulated(mesh, faces);
  if (fewer.triangles.size() > mesh.triangles.size()) fail("there are more triangles");
  if (!are_same(area_of(fewer), area_of(mesh))) fail("new triangles have another area");
  if (fewer.vertices != mesh.vertices) fail("a vertex was changed");
  std::set<std::array<double, 3>> places;
  for (const Point3& p : mesh.vertices) places.insert({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  if (places.size() != mesh.vertices.size()) return;
  const TriangleMesh other = turned_round(mesh);
  if (triangles_of(triangulated(other, merge_coplanar(other, options))) != triangles_of(fewer))
    fail("the order of the input changes the faces");
}

}  // namespace
}  // namespace plumb::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace plumb;
  Entropy entropy = Entropy::from_bytes({data, size});
  const TriangleMesh mesh = fuzz::heap_from(entropy);
  for (const CollinearVertices collinear : {CollinearVertices::kept, CollinearVertices::dropped})
    for (const double tolerance : {0.0, 0.5, 2.0}) fuzz::ask_faces(mesh, {tolerance, collinear});
  return 0;
}
