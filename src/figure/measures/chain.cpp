#include <cmath>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/signed_sums.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb {
namespace {

using arith::exact_sum::nearest;
using arith::exact_sum::nearest_quotients;
using arith::exact_sum::nearest_root;
using arith::exact_sum::Number;
using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::twice_area;
using figure::signed_sums::twice_vector_area;
using figure::signed_sums::vector;
using figure::signed_sums::VectorOf;

using Chain2 = std::span<const Point2>;
using Chain3 = std::span<const Point3>;

double chain_area(Chain2 chain) {
  return nearest([&](const auto& number) { return twice_area(number, chain); }, 2);
}

auto vector_area(const auto& number, Chain3 chain) {
  return twice_vector_area(number, chain.size(), [&](std::size_t i) -> const Point3& { return chain[i]; });
}

double chain_area(Chain3 chain) {
  return nearest_root(
      [&](const auto& number) {
        const auto n = vector_area(number, chain);
        return dot(n, n);
      },
      2);
}

/// 1, or -1 for a chain that is clockwise.
int side_of(Chain2 chain) { return figure::signed_sums::area_sign(chain) == Sign::negative ? -1 : 1; }

/// What chain k of the polygon counts, so that the outer one counts as positive and the holes as negative.
std::vector<int> weights(const HoledPolygon2& polygon) {
  std::vector<int> weight{side_of(polygon.outer.vertices)};
  for (const Polygon2& hole : polygon.holes) weight.push_back(-side_of(hole.vertices));
  return weight;
}

Chain2 chain_of(const HoledPolygon2& polygon, std::size_t k) {
  return k == 0 ? polygon.outer.vertices : polygon.holes[k - 1].vertices;
}

/// `sign` times the area that the holes leave.
double area_left(const HoledPolygon2& polygon, bool with_sign) {
  const std::vector<int> weight = weights(polygon);
  const int sign = with_sign ? weight[0] : 1;
  return nearest(
      [&](const auto& number) {
        auto sum = number(0.0);
        for (std::size_t k = 0; k < weight.size(); ++k)
          sum = sum + number(sign * weight[k]) * twice_area(number, chain_of(polygon, k));
        return sum;
      },
      2);
}

/// Adds weight times: x and y of the centroid times six times the area, both from the origin; six times the area.
template <class Maker>
void add_moments(const Maker& number, Chain2 chain, const Point2& origin, int weight,
                 std::array<Number<Maker>, 3>& sums) {
  using T = Number<Maker>;
  const T x = number(origin.x), y = number(origin.y), by = number(weight), three = number(3.0);
  T ax = number(chain.back().x) - x, ay = number(chain.back().y) - y;
  for (const Point2& p : chain) {
    const T bx = number(p.x) - x, cy = number(p.y) - y;
    const T part = by * (ax * cy - ay * bx);
    sums = {sums[0] + (ax + bx) * part, sums[1] + (ay + cy) * part, sums[2] + three * part};
    ax = bx;
    ay = cy;
  }
}

/// Of chains 0 ... count - 1, chain(k) with weight(k).
template <class ChainAt, class WeightAt>
Point2 area_centroid(std::size_t count, const ChainAt& chain, const WeightAt& weight) {
  const Point2 origin = chain(0)[0];
  const auto found = nearest_quotients<2>([&](const auto& number) {
    using T = Number<std::decay_t<decltype(number)>>;
    std::array<T, 3> sums{number(0.0), number(0.0), number(0.0)};
    for (std::size_t k = 0; k < count; ++k) add_moments(number, chain(k), origin, weight(k), sums);
    return std::array<T, 3>{sums[0] + number(origin.x) * sums[2], sums[1] + number(origin.y) * sums[2], sums[2]};
  });
  if (found.degenerate) {
    std::vector<Point2> all;
    for (std::size_t k = 0; k < count; ++k) all.insert(all.end(), chain(k).begin(), chain(k).end());
    return centroid(all);
  }
  const Point2 c{found.value[0], found.value[1]};
  if (!std::isfinite(c.x) || !std::isfinite(c.y))
    throw BeyondDoubles("centroid: the polygon's centroid is beyond all doubles");
  return c;
}

Point2 chain_centroid(Chain2 chain) {
  return area_centroid(
      1, [&](std::size_t) { return chain; }, [](std::size_t) { return 1; });
}

/// Of chains with weights; parts (triangles from the first vertex of all) are weighed by their share of the first
/// chain's normal.
Point3 area_centroid(std::span<const Chain3> chains, std::span<const int> weights) {
  const auto found = nearest_quotients<3>([&](const auto& number) {
    using Maker = std::decay_t<decltype(number)>;
    using V = VectorOf<Maker>;
    const V origin = vector(number, chains[0][0]), normal = vector_area(number, chains[0]);
    V sum = figure::signed_sums::zero(number);
    Number<Maker> whole = number(0.0);
    for (std::size_t k = 0; k < chains.size(); ++k) {
      const V weighed = number(weights[k]) * normal;
      V a = vector(number, chains[k].back()) - origin;
      for (const Point3& p : chains[k]) {
        const V b = vector(number, p) - origin;
        const auto part = dot(cross(a, b), weighed);
        sum = sum + part * (a + b);
        whole = whole + part;
        a = b;
      }
    }
    whole = number(3.0) * whole;
    const V moved = sum + whole * origin;
    return std::array<Number<Maker>, 4>{moved.x, moved.y, moved.z, whole};
  });
  if (found.degenerate) {
    std::vector<Point3> all;
    for (const Chain3& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
    return centroid(all);
  }
  const Point3 c{found.value[0], found.value[1], found.value[2]};
  if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z))
    throw BeyondDoubles("centroid: the polygon's centroid is beyond all doubles");
  return c;
}

Point3 chain_centroid(Chain3 chain) { return area_centroid(std::array{chain}, std::array{1}); }

/// What each chain counts, the outer one first: holes against its normal.
std::vector<int> weights(const HoledPolygon3& polygon) {
  std::vector<int> weight{1};
  for (const Polygon3& hole : polygon.holes) {
    weight.push_back(-static_cast<int>(arith::exact_sum::sign([&](const auto& number) {
      return dot(vector_area(number, polygon.outer.vertices), vector_area(number, hole.vertices));
    })));
  }
  return weight;
}

std::vector<Chain3> chains_of(const HoledPolygon3& polygon) {
  std::vector<Chain3> chains{polygon.outer.vertices};
  for (const Polygon3& hole : polygon.holes) chains.emplace_back(hole.vertices);
  return chains;
}

template <class Point, class Coordinate>
double mean(std::span<const Point> points, Coordinate Point::*coordinate) {
  return nearest(
      [&](const auto& number) {
        auto sum = number(0.0);
        for (const Point& p : points) sum = sum + number(p.*coordinate);
        return sum;
      },
      static_cast<double>(points.size()));
}

Point2 mean(Chain2 points) { return {mean(points, &Point2::x), mean(points, &Point2::y)}; }
Point3 mean(Chain3 points) { return {mean(points, &Point3::x), mean(points, &Point3::y), mean(points, &Point3::z)}; }

template <class Point>
Point checked_mean(std::span<const Point> points) {
  if (points.empty()) throw InvalidShape("centroid: no points; give at least one");
  require_finite_points("centroid", "points", points);
  return mean(points);
}

}  // namespace

double signed_area(const Triangle2& t) {
  figure::require_sound("signed_area", t);
  return chain_area(std::array{t.a, t.b, t.c});
}

double signed_area(const Quadrilateral2& q) {
  figure::require_sound("signed_area", q);
  return chain_area(std::array{q.a, q.b, q.c, q.d});
}

double signed_area(const Polygon2& polygon) {
  figure::require_sound("signed_area", polygon);
  return chain_area(Chain2(polygon.vertices));
}

double signed_area(const HoledPolygon2& polygon) {
  figure::require_sound("signed_area", polygon);
  return area_left(polygon, true);
}

double area(const Triangle2& triangle) { return std::fabs(signed_area(triangle)); }
double area(const Quadrilateral2& quadrilateral) { return std::fabs(signed_area(quadrilateral)); }
double area(const Polygon2& polygon) { return std::fabs(signed_area(polygon)); }

double area(const HoledPolygon2& polygon) {
  figure::require_sound("area", polygon);
  return area_left(polygon, false);
}

double area(const Triangle3& t) {
  figure::require_sound("area", t);
  return chain_area(std::array{t.a, t.b, t.c});
}

double area(const Quadrilateral3& q) {
  figure::require_sound("area", q);
  return chain_area(std::array{q.a, q.b, q.c, q.d});
}

double area(const Polygon3& polygon) {
  figure::require_sound("area", polygon);
  return chain_area(Chain3(polygon.vertices));
}

double area(const HoledPolygon3& polygon) {
  figure::require_sound("area", polygon);
  const std::vector<Chain3> chains = chains_of(polygon);
  const std::vector<int> weight = weights(polygon);
  return nearest_root(
      [&](const auto& number) {
        auto sum = figure::signed_sums::zero(number);
        for (std::size_t k = 0; k < chains.size(); ++k) sum = sum + number(weight[k]) * vector_area(number, chains[k]);
        return dot(sum, sum);
      },
      2);
}

double signed_volume(const Tetrahedron3& t) {
  figure::require_sound("signed_volume", t);
  return nearest(
      [&](const auto& number) {
        const auto d = vector(number, t.d);
        return dot(vector(number, t.a) - d, cross(vector(number, t.b) - d, vector(number, t.c) - d));
      },
      6);
}

double volume(const Tetrahedron3& tetrahedron) { return std::fabs(signed_volume(tetrahedron)); }

Point2 centroid(std::span<const Point2> points) { return checked_mean(points); }
Point3 centroid(std::span<const Point3> points) { return checked_mean(points); }

Point2 centroid(const Triangle2& t) {
  figure::require_sound("centroid", t);
  return mean(std::array{t.a, t.b, t.c});
}

Point3 centroid(const Triangle3& t) {
  figure::require_sound("centroid", t);
  return mean(std::array{t.a, t.b, t.c});
}

Point3 centroid(const Tetrahedron3& t) {
  figure::require_sound("centroid", t);
  return mean(std::array{t.a, t.b, t.c, t.d});
}

Point2 centroid(const Quadrilateral2& q) {
  figure::require_sound("centroid", q);
  return chain_centroid(std::array{q.a, q.b, q.c, q.d});
}

Point3 centroid(const Quadrilateral3& q) {
  figure::require_sound("centroid", q);
  return chain_centroid(std::array{q.a, q.b, q.c, q.d});
}

Point2 centroid(const Polygon2& polygon) {
  figure::require_sound("centroid", polygon);
  return chain_centroid(Chain2(polygon.vertices));
}

Point3 centroid(const Polygon3& polygon) {
  figure::require_sound("centroid", polygon);
  return chain_centroid(Chain3(polygon.vertices));
}

Point2 centroid(const HoledPolygon2& polygon) {
  figure::require_sound("centroid", polygon);
  const std::vector<int> weight = weights(polygon);
  return area_centroid(
      weight.size(), [&](std::size_t k) { return chain_of(polygon, k); }, [&](std::size_t k) { return weight[k]; });
}

Point3 centroid(const HoledPolygon3& polygon) {
  figure::require_sound("centroid", polygon);
  return area_centroid(chains_of(polygon), weights(polygon));
}

}  // namespace plumb
