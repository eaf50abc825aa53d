// Stand-ins for a mesh: what they keep is exact or rounded up.
#include "plumb/figure/bound/proxy.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

std::span<const Point3> vertices_of(std::string_view function, const TriangleMesh& mesh) {
  if (mesh.vertices.empty())
    throw InvalidShape(std::string(function).append(": the mesh has no vertices; give at least one"));
  figure::require_finite_points<Point3>(function, "vertices", mesh.vertices);
  return mesh.vertices;
}

struct SquaredDistance {
  static constexpr std::string_view name = "quantized_proxy";
  static constexpr int points = 2, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return predicates::squared(predicates::difference(p, 0, 1));
  }
};

/// The multiple of 2^exponent that is nearest to x, away from zero from halfway.
double snapped(double x, int exponent) {
  // In doubles a scaled x may be beyond all of them, or lose bits below the least: only where it is far from a half.
  if (x == 0) return 0;
  if (std::ilogb(x) - exponent >= 52) return x;  // a multiple: its last bit counts more than the step
  if (std::ilogb(x) < exponent - 1) return 0;
  return std::ldexp(std::round(std::ldexp(x, -exponent)), exponent) + 0.0;
}

}  // namespace

HullProxy hull_proxy(const TriangleMesh& mesh) {
  const auto vertices = vertices_of("hull_proxy", mesh);
  HullProxy proxy;
  proxy.hull = convex_hull(vertices);
  std::vector<std::uint32_t> number(vertices.size());
  for (const std::uint32_t v : proxy.hull.vertices) {
    number[v] = static_cast<std::uint32_t>(proxy.vertices.size());
    proxy.vertices.push_back(vertices[v]);
  }
  for (std::uint32_t& corner : proxy.hull.corners) corner = number[corner];
  for (std::uint32_t& v : proxy.hull.vertices) v = number[v];
  return proxy;
}

KDop3 k_dop_proxy(const TriangleMesh& mesh, int k) { return fit_k_dop(vertices_of("k_dop_proxy", mesh), k); }

QuantizedProxy quantized_proxy(const TriangleMesh& mesh, int bits) {
  const auto vertices = vertices_of("quantized_proxy", mesh);
  if (bits < 1 || bits > 52) throw InvalidShape("quantized_proxy: bits must be from 1 to 52");
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v < vertices.size()) continue;
      throw InvalidShape(std::string("quantized_proxy: triangle ")
                             .append(std::to_string(t))
                             .append(" names vertex ")
                             .append(std::to_string(v))
                             .append(" of ")
                             .append(std::to_string(vertices.size())));
    }
  }
  double largest = 0;
  for (const Point3& p : vertices) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  QuantizedProxy proxy{mesh, 0, 0, 0};
  if (largest == 0) return proxy;
  proxy.exponent = std::max(std::ilogb(largest) + 1 - bits, -1074);
  // Rounding the largest coordinate may carry into one more bit.
  if (std::ilogb(snapped(largest, proxy.exponent)) != std::ilogb(largest)) ++proxy.exponent;
  if (!std::isfinite(snapped(largest, proxy.exponent)))
    throw BeyondDoubles("quantized_proxy: the lattice point nearest to the largest coordinate is beyond all doubles");
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    Point3& p = proxy.mesh.vertices[i];
    p = {snapped(p.x, proxy.exponent), snapped(p.y, proxy.exponent), snapped(p.z, proxy.exponent)};
    if (compare_distance(vertices[i], p, vertices[farthest], proxy.mesh.vertices[farthest]) == Sign::positive)
      farthest = i;
  }
  proxy.largest_displacement =
      rounded_root(Rounding::up, SquaredDistance{}, vertices[farthest], proxy.mesh.vertices[farthest]);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto one_place = [&](std::uint32_t u, std::uint32_t v) {
      return proxy.mesh.vertices[u] == proxy.mesh.vertices[v] && vertices[u] != vertices[v];
    };
    proxy.collapsed += static_cast<std::uint32_t>(one_place(a, b) || one_place(b, c) || one_place(c, a));
  }
  return proxy;
}

}  // namespace plumb
