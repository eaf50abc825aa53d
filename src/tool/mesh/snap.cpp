#include "tool/mesh/snap.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/predicates.hpp"
#include "plumb/predicates/cross.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb::tool {
namespace {

/// Corners a, b, c and d, e, f: the dot product of the two triangles' normals.
struct NormalsAgree {
  static constexpr std::string_view name = "normals_agree";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    using namespace predicates;
    return dot(cross(difference(p, 0, 1), difference(p, 0, 2)), cross(difference(p, 3, 4), difference(p, 3, 5)));
  }
};

std::vector<Point3> snapped(const std::vector<Point3>& points, int exponent) {
  std::vector<Point3> result;
  result.reserve(points.size());
  for (const Point3& p : points) {
    result.push_back(
        {nearest_multiple(p.x, exponent), nearest_multiple(p.y, exponent), nearest_multiple(p.z, exponent)});
  }
  return result;
}

}  // namespace

double nearest_multiple(double x, int exponent) {
  const OddForm f = odd_form(x);
  if (f.mantissa == 0) return 0;
  const int shift = exponent - f.exponent;
  if (shift <= 0) return x;
  if (shift > 54) return 0;  // below half a step: the integer has 53 bits at most
  const std::int64_t magnitude = std::abs(f.mantissa), half = std::int64_t{1} << (shift - 1);
  const std::int64_t down = magnitude >> shift, rest = magnitude - (down << shift);
  const std::int64_t multiple = down + static_cast<std::int64_t>(rest > half || (rest == half && down % 2 != 0));
  if (multiple == 0) return 0;
  return std::copysign(std::ldexp(static_cast<double>(multiple), exponent), x);
}

std::optional<SnapDamage> snap_damage(const TriangleMesh& mesh, int exponent) {
  const std::vector<Point3>& before = mesh.vertices;
  const std::vector<Point3> after = snapped(before, exponent);
  SnapDamage damage;
  ExponentSpan span;
  std::vector<bool> moved(before.size());
  for (std::size_t v = 0; v < before.size(); ++v) {
    for (const auto axis : {&Point3::x, &Point3::y, &Point3::z}) {
      const double from = before[v].*axis, to = after[v].*axis;
      if (!std::isfinite(to)) return std::nullopt;
      span.include(odd_form(to));
      moved[v] = moved[v] || from != to;
      damage.greatest_move = std::max(damage.greatest_move, std::fabs(from - to));
    }
    if (moved[v]) damage.greatest_distance = std::max(damage.greatest_distance, distance(before[v], after[v]));
  }
  damage.lattice = span.lattice();
  const std::vector<std::uint32_t> first_before = first_equal(before), first_after = first_equal(after);
  for (std::uint32_t v = 0; v < before.size(); ++v) {
    if (first_before[v] == v && first_after[v] != v) damage.merged.push_back({v, first_after[v]});
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (!moved[a] && !moved[b] && !moved[c]) continue;
    if (collinear(before[a], before[b], before[c])) continue;
    const Sign agree = sign_of(NormalsAgree{}, before[a], before[b], before[c], after[a], after[b], after[c]);
    if (agree == Sign::negative) damage.turned_over.push_back(t);
    if (agree == Sign::zero && collinear(after[a], after[b], after[c])) damage.collapsed.push_back(t);
  }
  return damage;
}

std::optional<int> exponent_for_bits(std::span<const std::span<const Point3>> scene, const Lattice& lattice, int bits) {
  // Rounding up to a power of two may take one bit more than the first guess leaves.
  const int guess = lattice.exponent + lattice.bits - bits;
  for (int exponent = guess; exponent <= guess + 1; ++exponent) {
    ExponentSpan span;
    bool finite = true;
    for (const std::span<const Point3> vertices : scene) {
      for (const Point3& p : vertices) {
        for (const double x : {p.x, p.y, p.z}) {
          const double to = nearest_multiple(x, exponent);
          finite = finite && std::isfinite(to);
          span.include(odd_form(to));
        }
      }
    }
    if (finite && span.lattice().bits <= bits) return exponent;
  }
  return std::nullopt;
}

}  // namespace plumb::tool
