// What is asked of the fuzz targets on meshes?  Heaps of triangles in special position, many of them on the same points.
//
// Law: the same bytes are the same heap.
// Source: none.
// Cost: none, some 17 points and 60 triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>

#include "plumb/degenerate/points.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::fuzz {

[[noreturn]] inline void fail(const char* text) {
  std::cerr << text << std::endl;
  std::abort();
}

inline TriangleMesh heap_from(Entropy& entropy) {
  TriangleMesh mesh;
  const std::size_t points = 3 + entropy.below(14);
  if (entropy.coin()) {
    mesh.vertices = points3(any_family(entropy), degeneracies[entropy.below(degeneracies.size())], points, entropy);
  } else {
    const auto coordinate = [&] { return static_cast<double>(entropy.within(2)); };
    for (std::size_t i = 0; i < points; ++i) {
      const double x = coordinate(), y = coordinate();
      mesh.vertices.push_back({x, y, coordinate()});
    }
  }
  const auto vertex = [&] { return static_cast<std::uint32_t>(entropy.below(points)); };
  for (std::uint64_t n = entropy.below(30); n > 0; --n) {
    const std::uint32_t a = vertex(), b = vertex();
    mesh.triangles.push_back({a, b, vertex()});
  }
  for (std::uint32_t v = 0; v + 3 < points && entropy.coin(); v += 2)
    for (const TriangleMesh::Triangle& t : {TriangleMesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
      mesh.triangles.push_back({t[0] + v, t[1] + v, t[2] + v});
  return mesh;
}

/// Vertices the other way round, triangles as well, each from another corner on.
inline TriangleMesh turned_round(const TriangleMesh& mesh) {
  TriangleMesh other = mesh;
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  std::ranges::reverse(other.vertices);
  std::ranges::reverse(other.triangles);
  for (auto& [a, b, c] : other.triangles) {
    const std::uint32_t first = last - a;
    a = last - b, b = last - c, c = first;
  }
  return other;
}

/// Each from its least corner on.
using PlacedCorners = std::array<std::array<double, 3>, 3>;
inline std::multiset<PlacedCorners> triangles_of(const TriangleMesh& mesh) {
  std::multiset<PlacedCorners> all;
  for (const auto& t : mesh.triangles) {
    PlacedCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = mesh.vertices[t[k]];
      corners[k] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    }
    const auto turned = [&](std::size_t k) {
      return PlacedCorners{corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]};
    };
    all.insert(std::min({turned(0), turned(1), turned(2)}));
  }
  return all;
}

}  // namespace plumb::fuzz
