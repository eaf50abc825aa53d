// Slices a mesh into layers for a printer: slicer [MESH HEIGHT].
//
// Every layer is a set of closed contours, nested, whose corners are exact; without arguments it slices a hollow box on
// which a roof stands, at heights where it has faces that lie flat.
#include <cstdio>
#include <cstdlib>
#include <plumb/surface.hpp>
#include <string>
#include <vector>

namespace {

// A box that is hollow, and a roof on it; the roof is a solid of its own that shares the box's top.
const char* const part = R"(
v 0 0 0
v 10 0 0
v 10 10 0
v 0 10 0
v 0 0 6
v 10 0 6
v 10 10 6
v 0 10 6
v 2 2 2
v 8 2 2
v 8 8 2
v 2 8 2
v 2 2 4
v 8 2 4
v 8 8 4
v 2 8 4
v 5 0 9
v 5 10 9
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
f 9 10 11 12
f 16 15 14 13
f 13 14 10 9
f 14 15 11 10
f 15 16 12 11
f 16 13 9 12
f 8 7 6 5
f 6 7 18 17
f 8 5 17 18
f 5 6 17
f 7 8 18
)";

// The exact area that the layer covers: half the sum of cross products of exact corners.
plumb::Rational area(const plumb::TriangleMesh& mesh, const plumb::Section& layer) {
  plumb::Rational doubled;
  for (const plumb::Contour& contour : layer.contours) {
    std::vector<plumb::RationalPoint3> corners;
    for (const plumb::SectionCorner& corner : contour.corners)
      corners.push_back(rational_point(exact_corner(mesh, layer.plane, corner)));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
      doubled = doubled + (p.x * q.y - q.x * p.y);
    }
  }
  return doubled / plumb::Rational(2.0);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 1 && argc != 3) {
    std::fprintf(stderr, "usage: slicer [MESH HEIGHT]\n");
    return 2;
  }
  const plumb::TriangleMesh mesh = argc == 3
                                       ? plumb::read_mesh(argv[1])
                                       : plumb::triangulate(plumb::parse_mesh(part, plumb::MeshFormat::obj, "part"));
  const double height = argc == 3 ? std::atof(argv[2]) : 1;
  double low = mesh.vertices.front().z, high = low;
  for (const plumb::Point3& p : mesh.vertices) {
    low = p.z < low ? p.z : low;
    high = p.z > high ? p.z : high;
  }
  if (!(height > 0) || (high - low) / height > 1e6) {
    std::fprintf(stderr, "slicer: '%s' is no height of layers for this mesh\n", argv[2]);
    return 2;
  }

  // The section at a height is what lies just below it: every layer is printed once, the last at the very top.
  std::vector<plumb::AnyPlane3> planes;
  for (int i = 1; low + (i - 1) * height < high; ++i) planes.push_back(plumb::Plane3{{0, 0, 1}, low + i * height});

  for (const plumb::Section& layer : sections(mesh, planes)) {
    int outer = 0, holes = 0, open = 0;
    for (const plumb::Contour& contour : layer.contours)
      ++(!contour.closed ? open : contour.turn == plumb::Sign::positive ? outer : holes);
    std::printf("z = %g: %d outer, %d holes", std::get<plumb::Plane3>(layer.plane).offset, outer, holes);
    if (open != 0) std::printf(", %d open: the mesh has a hole there", open);
    std::printf(", area %s", area(mesh, layer).text().c_str());
    if (!layer.coplanar_triangles.empty()) std::printf(", %zu triangles flat in it", layer.coplanar_triangles.size());
    std::printf("\n");
  }
} catch (const plumb::Error& e) {
  std::fprintf(stderr, "slicer: %s\n", e.what());
  return 2;
}
