#include "plumb/figure/measures/width.hpp"

#include <map>
#include <optional>

#include "arith/big_rounding.hpp"
#include "figure/basic/chain_input.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb {
namespace {

using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::Vector;
using figure::signed_sums::vector;
namespace exact_sum = arith::exact_sum;

/// An edge of the hull, and a vertex of each face beside it that is not on it.
struct HullEdge {
  std::uint32_t from, to;
  std::array<std::uint32_t, 2> beside;
};

/// Planes whose normal is the cross product of two edges, through points `low` and `high`.
struct SlabOfHull {
  std::array<std::uint32_t, 2> u, v;
  std::uint32_t low, high;
  bool by_face;
};

class WidthSearch {
 public:
  explicit WidthSearch(std::span<const Point3> points) : points_(points), hull_(convex_hull(points)) {
    if (hull_.dimension < 3) return;
    look_at_faces();
    look_at_edges();
  }
  [[nodiscard]] const std::optional<SlabOfHull>& best() const { return best_; }

 private:
  template <class Maker>
  auto edge(const Maker& number, const std::array<std::uint32_t, 2>& e) const {
    return vector(number, points_[e[1]]) - vector(number, points_[e[0]]);
  }
  template <class Maker>
  auto normal(const Maker& number, const SlabOfHull& s) const {
    return cross(edge(number, s.u), edge(number, s.v));
  }
  template <class Maker>
  auto across(const Maker& number, const SlabOfHull& s) const {
    return dot(normal(number, s), edge(number, {s.low, s.high}));
  }

  void take(const SlabOfHull& s) {
    const bool thinner = !best_ || exact_sum::sign([&](const auto& number) {
                                     const auto l = across(number, s), r = across(number, *best_);
                                     const auto m = normal(number, s), n = normal(number, *best_);
                                     return (l * l) * dot(n, n) - (r * r) * dot(m, m);
                                   }) == Sign::negative;
    if (thinner) best_ = s;
  }

  void look_at_faces() {
    for (std::size_t f = 0; f < hull_.face_count(); ++f) {
      const auto corners = hull_.face(f);
      const std::uint32_t a = corners[0], b = corners[1], c = corners[2];
      std::uint32_t far = hull_.vertices[0];
      for (const std::uint32_t v : hull_.vertices)
        if (compare_distance_to_plane(points_[a], points_[b], points_[c], points_[v], points_[far]) == Sign::positive)
          far = v;
      take({{a, b}, {a, c}, a, far, true});
    }
  }

  void look_at_edges() {
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> third;  // of the face that runs along an edge
    std::vector<HullEdge> edges;
    for (std::size_t f = 0; f < hull_.face_count(); ++f) {
      const auto corners = hull_.face(f);
      const std::size_t n = corners.size();
      for (std::size_t k = 0; k < n; ++k) third[{corners[k], corners[(k + 1) % n]}] = corners[(k + 2) % n];
    }
    for (const auto& [e, v] : third)
      if (e[0] < e[1]) edges.push_back({e[0], e[1], {v, third.at({e[1], e[0]})}});
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (are_opposite(edges[i], edges[k]))
          take({{edges[i].from, edges[i].to}, {edges[k].from, edges[k].to}, edges[i].from, edges[k].from, false});
  }

  /// Do parallel planes through both hold the hull between them?
  [[nodiscard]] bool are_opposite(const HullEdge& e, const HullEdge& f) const {
    const auto side = [&](std::uint32_t origin, std::uint32_t p) {
      return exact_sum::sign([&](const auto& number) {
        return dot(cross(edge(number, {e.from, e.to}), edge(number, {f.from, f.to})), edge(number, {origin, p}));
      });
    };
    const Sign s = side(e.from, e.beside[0]), t = side(e.from, e.beside[1]);
    if (s * t == Sign::negative || (s == Sign::zero && t == Sign::zero)) return false;
    const Sign inward = s == Sign::zero ? t : s;
    return side(f.from, f.beside[0]) * inward != Sign::positive &&
           side(f.from, f.beside[1]) * inward != Sign::positive && side(e.from, f.from) == inward;
  }

  std::span<const Point3> points_;
  Hull3 hull_;
  std::optional<SlabOfHull> best_;
};

Vector<Rational> between(const Point3& a, const Point3& b) {
  return {Rational(b.x) - Rational(a.x), Rational(b.y) - Rational(a.y), Rational(b.z) - Rational(a.z)};
}

}  // namespace

PointsWidth least_width(std::span<const Point3> points) {
  if (points.empty()) throw InvalidShape("least_width: there are no points; give at least one");
  require_finite_points<Point3>("least_width", "points", points);
  PointsWidth found;
  const auto best = WidthSearch(points).best();
  if (!best) return found;
  const auto& [u, v, low, high, by_face] = *best;
  const Vector<Rational> normal = cross(between(points[u[0]], points[u[1]]), between(points[v[0]], points[v[1]]));
  const Rational across = dot(normal, between(points[low], points[high]));
  found.squared = across * across / dot(normal, normal);
  found.normal_edges = {u, v};
  if (by_face) {
    found.one = {u[0], u[1], v[1]}, found.other = {high};
  } else {
    found.one = {u[0], u[1]}, found.other = {v[0], v[1]};
  }
  const auto number = exact_sum::to_big;
  const auto edge = [&](const std::array<std::uint32_t, 2>& e) {
    return vector(number, points[e[1]]) - vector(number, points[e[0]]);
  };
  const auto n = cross(edge(u), edge(v));
  const BigDyadic size = dot(n, edge({low, high}));
  found.width = rounded_root(Rounding::up, size * size, dot(n, n));
  return found;
}

}  // namespace plumb
