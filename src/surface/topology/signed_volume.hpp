// What is the volume that some triangles of a mesh bound, each as it is or turned over?  Exactly, and its sign.
//
// Law: that of a closed surface; of others it hangs on the first vertex.
// Source: Gauss's theorem, figure/basic/signed_sums.hpp.
// Cost: linear, by pairs of doubles; integers where these leave a doubt.
#pragma once

#include <cstdint>
#include <span>

#include "figure/basic/signed_sums.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::surface {

struct SidedTriangle {
  std::uint32_t triangle;
  bool turned;
};

/// Six times the volume, as a sum over any kind of number (arith/exact_sum.hpp); triangle(i) is a SidedTriangle.
template <class TriangleAt>
auto volume_sum(const TriangleMesh& mesh, std::span<const std::uint32_t> list, const TriangleAt& triangle) {
  return [&mesh, list, &triangle](const auto& number) {
    using namespace figure::signed_sums;
    const auto at = [&](std::uint32_t v) { return vector(number, mesh.vertices[v]); };
    const auto origin = at(mesh.triangles[triangle(list.front()).triangle][0]);
    auto sum = number(0.0);
    for (const std::uint32_t i : list) {
      const SidedTriangle t = triangle(i);
      const auto& [a, b, c] = mesh.triangles[t.triangle];
      const auto part = dot(at(a) - origin, cross(at(b) - origin, at(c) - origin));
      sum = t.turned ? sum - part : sum + part;
    }
    return sum;
  };
}

template <class TriangleAt>
Sign sign_of_volume(const TriangleMesh& mesh, std::span<const std::uint32_t> list, const TriangleAt& triangle) {
  return arith::exact_sum::sign(volume_sum(mesh, list, triangle));
}

}  // namespace plumb::surface
