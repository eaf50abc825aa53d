// Where is a fault planted in a mesh, and what does that touch?
//
// A guess, in doubles, is where it goes; what is there then is judged exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/predicates.hpp"

namespace plumb::planted {

/// What a fault is planted in, and what it touched.
struct Ground {
  TriangleMesh& mesh;
  std::uint32_t triangle;
  double step;         // some units in the last place of the largest coordinate; the tolerance is twice that
  bool closed = true;  // the mesh, before anything was planted
  std::vector<Point3> touched{};
  std::vector<std::uint32_t> gone{};  // triangles to be left out at last, so that numbers stay

  [[nodiscard]] Point3 at(std::size_t corner) const { return mesh.vertices[mesh.triangles[triangle][corner]]; }
  std::uint32_t add(const Point3& p) {
    mesh.vertices.push_back(p);
    touched.push_back(p);
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  }
  [[nodiscard]] Point3 near(const Point3& p) const { return {p.x + step, p.y, p.z}; }
  /// Divides the triangle's first edge at a point, not the neighbor's; the number of the new vertex.
  std::uint32_t divide(const Point3& p) {
    const auto [a, b, c] = mesh.triangles[triangle];
    const std::uint32_t m = add(p);
    mesh.triangles[triangle] = {a, m, c};
    mesh.triangles.push_back({m, b, c});
    return m;
  }
  [[nodiscard]] bool on_edge(const Point3& p) const { return collinear(at(0), p, at(1)); }
  void touch(const TriangleMesh::Triangle& t) {
    for (const std::uint32_t v : t) touched.push_back(mesh.vertices[v]);
  }
  /// Outward whatever the order of its corners.
  void add_tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const auto& v = mesh.vertices;
    if (orient3d(v[a], v[b], v[c], v[d]) != Sign::positive) std::swap(b, c);
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}});
  }
};

inline Point3 middle(const Point3& p, const Point3& q) {
  return {p.x / 2 + q.x / 2, p.y / 2 + q.y / 2, p.z / 2 + q.z / 2};
}

/// A frame at a triangle, in doubles: its middle, its unit normal, its least height.
struct Frame {
  Point3 middle;
  std::array<double, 3> normal;
  double height;

  explicit Frame(const Ground& g) {
    const Point3 a = g.at(0), b = g.at(1), c = g.at(2);
    middle = {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
    const std::array<double, 3> u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    normal = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double area = std::hypot(normal[0], normal[1], normal[2]);
    for (double& x : normal) x /= area;
    const auto length = [](const Point3& p, const Point3& q) { return std::hypot(p.x - q.x, p.y - q.y, p.z - q.z); };
    height = area / std::max({length(a, b), length(b, c), length(c, a)});
  }
  /// So many heights out of the triangle.
  [[nodiscard]] Point3 out(double heights) const {
    const double by = heights * height;
    return {middle.x + by * normal[0], middle.y + by * normal[1], middle.z + by * normal[2]};
  }
};

/// Beside the mesh, a place with free space about it that is as wide as the mesh's greatest coordinate.
inline Point3 beside(const TriangleMesh& mesh) {
  double greatest = 1;
  for (const Point3& p : mesh.vertices) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return {std::ldexp(4.0, std::ilogb(greatest)), 0, 0};
}

}  // namespace plumb::planted
