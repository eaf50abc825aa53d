#include "plumb/surface/planar/triangulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plumb/predicates.hpp"
#include "surface/planar/cut_ring.hpp"

namespace plumb {
namespace {

using Corners = std::span<const std::uint32_t>;

Point2 along(const Point3& p, int axis) {
  return axis == 0 ? Point2{p.y, p.z} : axis == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

// Twice the area seen along each axis, rounded: it says where to look first, the signs decide.
std::array<double, 3> rounded_normal(std::span<const Point3> vertices, Corners corners, double scale) {
  std::array<double, 3> normal{};
  const Point3& o = vertices[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Point3 &p = vertices[corners[k]], &q = vertices[corners[k + 1]];
    const double px = p.x * scale - o.x * scale, py = p.y * scale - o.y * scale, pz = p.z * scale - o.z * scale;
    const double qx = q.x * scale - o.x * scale, qy = q.y * scale - o.y * scale, qz = q.z * scale - o.z * scale;
    normal[0] += py * qz - pz * qy;
    normal[1] += pz * qx - px * qz;
    normal[2] += px * qy - py * qx;
  }
  return normal;
}

struct View {
  int axis;
  Sign turn;    // of the face, it seems
  double size;  // of the area seen
};

// The three ways to look, the most promising first: a guess.
std::array<View, 3> views(std::span<const Point3> vertices, Corners corners) {
  auto normal = rounded_normal(vertices, corners, 1);
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(normal.begin(), normal.end(), finite)) normal = rounded_normal(vertices, corners, 0x1p-540);
  if (normal == std::array<double, 3>{}) normal = rounded_normal(vertices, corners, 0x1p+500);
  std::array<View, 3> found{};
  for (int axis = 0; axis < 3; ++axis) {
    const double seen = normal[static_cast<std::size_t>(axis)];
    found[static_cast<std::size_t>(axis)] = {axis, seen < 0 ? Sign::negative : Sign::positive,
                                             std::isfinite(seen) ? std::fabs(seen) : 0};
  }
  std::stable_sort(found.begin(), found.end(), [](const View& l, const View& r) { return l.size > r.size; });
  return found;
}

// The triangles about corner `apex`; true when they all turn as they should, and so cover the face rightly.
bool fan(const std::vector<Point2>& points, Corners corners, Sign turn, std::size_t apex,
         std::vector<TriangleMesh::Triangle>& out) {
  const std::size_t n = corners.size(), before = out.size();
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const std::size_t i = (apex + k) % n, j = (apex + k + 1) % n;
    if (!points.empty() && orient2d(points[apex], points[i], points[j]) != turn) {
      out.resize(before);
      return false;
    }
    out.push_back({corners[apex], corners[i], corners[j]});
  }
  return true;
}

}  // namespace

bool triangulate_face(std::span<const Point3> vertices, Corners corners, std::vector<TriangleMesh::Triangle>& out) {
  if (corners.size() == 3) {
    out.push_back({corners[0], corners[1], corners[2]});
    return true;
  }
  std::vector<Point2> points(corners.size());
  const std::size_t before = out.size();
  for (const View& view : views(vertices, corners)) {
    for (std::size_t k = 0; k < corners.size(); ++k) points[k] = along(vertices[corners[k]], view.axis);
    if (fan(points, corners, view.turn, 0, out)) return true;
    if (corners.size() == 4 && fan(points, corners, view.turn, 1, out)) return true;
    if (!surface::cut_ring(points, out)) continue;
    for (std::size_t t = before; t < out.size(); ++t)
      for (std::uint32_t& corner : out[t]) corner = corners[corner];
    return true;
  }
  fan({}, corners, Sign::zero, 0, out);
  return false;
}

TriangleMesh triangulate(const PolygonMesh& mesh, std::uint64_t* fans) {
  TriangleMesh triangles{mesh.vertices, {}};
  const std::size_t faces = mesh.first.size() - 1;
  triangles.triangles.reserve(mesh.corners.size() - 2 * faces);
  std::uint64_t fanned = 0;
  for (std::size_t f = 0; f < faces; ++f) {
    const Corners corners = Corners(mesh.corners).subspan(mesh.first[f], mesh.first[f + 1] - mesh.first[f]);
    fanned += !triangulate_face(mesh.vertices, corners, triangles.triangles);
  }
  if (fans) *fans = fanned;
  return triangles;
}

}  // namespace plumb
