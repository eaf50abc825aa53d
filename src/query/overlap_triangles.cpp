// Two triangles in space: by doubles; by the small integers that the corners are on their common lattice; by exact
// signs of the corners; and what has no area as the segment or point that it is.
#include <bit>

#include "overlap_filters.hpp"
#include "overlap_parts.hpp"
#include "overlap_triangle_signs.hpp"
#include "plumb/arith/lattice_integers.hpp"
#include "plumb/arith/wide_int.hpp"
#include "plumb/query/overlap_triangle.hpp"

namespace plumb {
namespace query {

std::optional<Relation> by_doubles(const Triangle3& a, const Triangle3& b) {
  using predicates::cross, predicates::dot;
  const Difference ab = difference(a.a, a.b), ac = difference(a.a, a.c);
  const std::array to{difference(a.a, b.a), difference(a.a, b.b), difference(a.a, b.c)};
  const Difference n = cross(ab, ac);
  const std::array over_a{dot(to[0], n), dot(to[1], n), dot(to[2], n)};
  LargestDifferences largest;
  for (const Difference& d : {ab, ac, to[0], to[1], to[2]}) largest.take(d);
  const double error = largest.threshold<Volume>(over_a[0] + over_a[1] + over_a[2]);
  const auto low = [](const std::array<double, 3>& x) { return std::min(std::min(x[0], x[1]), x[2]); };
  const auto high = [](const std::array<double, 3>& x) { return std::max(std::max(x[0], x[1]), x[2]); };
  if (low(over_a) > error || high(over_a) < -error) return Relation::disjoint;

  // Between any two corners lies at most twice the largest difference from one.
  const Difference m = cross(difference(b.a, b.b), difference(b.a, b.c));
  const std::array over_b{dot(difference(b.a, a.a), m), dot(difference(b.a, a.b), m), dot(difference(b.a, a.c), m)};
  const double sum = over_b[0] + over_b[1] + over_b[2];
  const double twofold = error * (8 * (1 + 0x1p-40)) + (sum - sum);
  if (low(over_b) > twofold || high(over_b) < -twofold) return Relation::disjoint;

  const auto certain = [](const std::array<double, 3>& x, double e) {
    return std::min(std::min(magnitude_of(x[0]), magnitude_of(x[1])), magnitude_of(x[2])) > e;
  };
  if (!(certain(over_a, error) & certain(over_b, twofold))) return {};
  const auto below = [](const std::array<double, 3>& x) {
    return static_cast<unsigned>(x[0] < 0) | static_cast<unsigned>(x[1] < 0) << 1 |
           static_cast<unsigned>(x[2] < 0) << 2;
  };
  const unsigned of_a = below(over_b), of_b = below(over_a);
  const std::size_t i = corner_alone[of_a], j = corner_alone[of_b];
  const bool a_above = over_b[i] > 0, b_above = over_a[j] > 0;
  const Point3* const p[] = {&a.a, &a.b, &a.c, &a.a, &a.b};
  const Point3* const q[] = {&b.a, &b.b, &b.c, &b.a, &b.b};
  const auto volume = [](const Point3& k, const Point3& l, const Point3& o, const Point3& v) {
    return dot(difference(v, k), cross(difference(v, l), difference(v, o)));
  };
  const std::size_t first_a = a_above ? i + 1 : i + 2, first_b = b_above ? j + 1 : j + 2;
  const std::size_t second_a = 2 * i + 3 - first_a, second_b = 2 * j + 3 - first_b;
  const double way = a_above == b_above ? 1 : -1;
  const double starts = way * volume(*p[i], *p[first_a], *q[j], *q[first_b]);
  const double ends = -way * volume(*p[i], *p[second_a], *q[j], *q[second_b]);
  const double limit = twofold + ((starts + ends) - (starts + ends)), least = std::min(starts, ends);
  if (least > limit) return Relation::overlapping;
  if (least < -limit) return Relation::disjoint;
  return {};
}

namespace {

/// Of coordinates as doubles.
struct PointSigns {
  std::array<Point3, 6> p;

  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return orient3d(p[i], p[j], p[k], p[l]);
  }
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    return orient2d(seen(p[i], axis), seen(p[j], axis), seen(p[k], axis));
  }
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    return {-volume(i, i + 1, i + 2, j), -volume(i, i + 1, i + 2, j + 1), -volume(i, i + 1, i + 2, j + 2)};
  }
};

using Integers = LatticeIntegers<18>;

/// Of integers of this many bits.
template <int Bits>
struct IntegerSigns {
  const Integers& all;
  int zeros;

  using Number = WideInt<Bits + 1>;
  using Vector = predicates::Triple<Number>;

  [[nodiscard]] Number number(std::size_t from, std::size_t to, std::size_t axis) const {
    return Number{all.difference(3 * to + axis, 3 * from + axis) >> zeros};
  }
  [[nodiscard]] Vector vector(std::size_t from, std::size_t to) const {
    return {number(from, to, 0), number(from, to, 1), number(from, to, 2)};
  }
  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return predicates::triple(vector(l, i), vector(l, j), vector(l, k)).sign();
  }
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    return (number(i, j, x) * number(i, k, y) - number(i, j, y) * number(i, k, x)).sign();
  }
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    const auto normal = predicates::cross(vector(i, i + 1), vector(i, i + 2));
    const auto side = [&](std::size_t k) { return predicates::dot(vector(i, k), normal).sign(); };
    return {side(j), side(j + 1), side(j + 2)};
  }
};

[[gnu::noinline]] Relation without_area(const Triangle3& a, const Triangle3& b) {
  return telling_axis(b) == 3 ? relate(flattened(b), a) : relate(flattened(a), b);
}

[[gnu::noinline]] Relation by_signs(const Triangle3& a, const Triangle3& b) {
  const Integers all(std::bit_cast<std::array<double, 18>>(std::array{a, b}));
  std::optional<Relation> answer;
  if (all.bits() == 0) {
    require_shapes(a, b);
    answer = relate_by(PointSigns{{a.a, a.b, a.c, b.a, b.b, b.c}});
  } else if (all.bits() - all.zeros() <= integer::short_bits) {
    answer = relate_by(IntegerSigns<integer::short_bits>{all, all.zeros()});
  } else {
    answer = relate_by(IntegerSigns<integer::long_bits>{all, 0});
  }
  return answer ? *answer : without_area(a, b);
}

}  // namespace

Relation relate(const Triangle3& a, const Triangle3& b) {
  if (const auto answer = by_doubles(a, b)) return *answer;
  return by_signs(a, b);
}

}  // namespace query

Relation relate(const Triangle3& a, const Triangle3& b) {
  assert_sound_thread();
  return query::relate(a, b);
}

}  // namespace plumb
