// Which meshes are trees built of?  Generated ones: a closed surface of any size, and what is hard for builders.
#pragma once

#include <cmath>
#include <numbers>

#include "figure/basic/shape_cases.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::meshes {

/// A closed wavy ring of 4 n^2 triangles.
inline TriangleMesh ring(std::uint32_t n) {
  TriangleMesh mesh;
  const std::uint32_t around = 2 * n;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * k / around;
      const double r = 1 + 0.4 * std::cos(u) + 0.05 * std::sin(17 * u) * std::cos(23 * v);
      mesh.vertices.push_back({r * std::cos(v), r * std::sin(v), 0.4 * std::sin(u)});
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) { return i % n * around + k % around; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < around; ++k) {
      mesh.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  return mesh;
}

/// Triangles of any shape, segments and points among them, anywhere in the doubles.
inline TriangleMesh soup(shape_cases::Material& m, std::size_t vertices, std::size_t triangles) {
  TriangleMesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) mesh.vertices.push_back(m.point3());
  const auto any = [&] { return static_cast<std::uint32_t>(m.below(vertices)); };
  for (std::size_t i = 0; i < triangles; ++i) mesh.triangles.push_back({any(), any(), any()});
  return mesh;
}

/// So many times the same triangle.
inline TriangleMesh repeated(std::size_t n) { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {n, {0, 1, 2}}}; }

/// Points whose distances from the origin double from one to the next: a chain for any builder by areas.
inline TriangleMesh doubling(std::uint32_t n, int first, int step) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double x = std::ldexp(1.0, first + step * static_cast<int>(i));
    mesh.vertices.push_back({x, -x, x});
    mesh.triangles.push_back({i, i, i});
  }
  return mesh;
}

}  // namespace plumb::meshes
