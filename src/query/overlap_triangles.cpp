// Two triangles in space: by doubles; by the small integers that the corners are on their common lattice; by exact
// signs of the corners; and what has no area as the segment or point that it is.
#include <bit>

#include "figure_input.hpp"
#include "overlap_filters.hpp"
#include "overlap_signs.hpp"
#include "overlap_triangle_signs.hpp"
#include "plumb/arith/lattice_digits.hpp"
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
  const auto of_axis = [](Pair p, Pair q, double r) { return larger(size(p), larger(size(q), size(Pair{r, r}))); };
  const double error = error_bound<Volume>(of_axis(Pair{ab.x, ac.x}, Pair{to[0].x, to[1].x}, to[2].x),
                                           of_axis(Pair{ab.y, ac.y}, Pair{to[0].y, to[1].y}, to[2].y),
                                           of_axis(Pair{ab.z, ac.z}, Pair{to[0].z, to[1].z}, to[2].z),
                                           over_a[0] + over_a[1] + over_a[2]);
  const auto low = [](const std::array<double, 3>& x) { return std::min(std::min(x[0], x[1]), x[2]); };
  const auto high = [](const std::array<double, 3>& x) { return std::max(std::max(x[0], x[1]), x[2]); };
  if (low(over_a) > error || high(over_a) < -error) return Relation::disjoint;
  if (std::max(high(over_a), -low(over_a)) <= error) return {};  // coplanar, or nearly so

  // Between any two corners lies at most twice the largest difference from one.
  const Difference m = cross(difference(b.a, b.b), difference(b.a, b.c));
  const std::array over_b{dot(difference(b.a, a.a), m), dot(difference(b.a, a.b), m), dot(difference(b.a, a.c), m)};
  const double sum = over_b[0] + over_b[1] + over_b[2];
  const double twofold = error * (8 * (1 + 0x1p-40)) + (sum - sum);
  if (low(over_b) > twofold || high(over_b) < -twofold) return Relation::disjoint;

  const auto certain = [](const std::array<double, 3>& x, double e) {
    return std::min(std::min(magnitude_of(x[0]), magnitude_of(x[1])), magnitude_of(x[2])) > e;
  };
  if (!certain(over_a, error) || !certain(over_b, twofold)) return {};
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
  const double way = std::copysign(1.0, over_b[i]) * std::copysign(1.0, over_a[j]);
  const double starts = way * volume(*p[i], *p[first_a], *q[j], *q[first_b]);
  const double ends = -way * volume(*p[i], *p[second_a], *q[j], *q[second_b]);
  const double limit = twofold + ((starts + ends) - (starts + ends)), least = std::min(starts, ends);
  if (least > limit) return Relation::overlapping;
  if (least < -limit) return Relation::disjoint;
  return {};
}

namespace {

/// Of coordinates as doubles, seen along an axis, and in space.
struct PointAreas {
  std::array<Point2, 6> p;

  [[nodiscard]] Sign area(std::size_t i, std::size_t j, std::size_t k) const { return orient2d(p[i], p[j], p[k]); }
  [[nodiscard]] Sign most_area(std::size_t i, std::size_t j, std::size_t from, Sign turns) const {
    Sign all = turns * area(i, j, from);
    if (all != Sign::positive) all = most(all, turns * area(i, j, from + 1));
    if (all != Sign::positive) all = most(all, turns * area(i, j, from + 2));
    return all;
  }
};
struct PointSigns {
  std::array<Point3, 6> p;

  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    // Of coordinates whose exponents are far apart; the sums of magnitudes tell more of those.
    const auto at = coordinates_of<predicates::Orient3d>(p[i], p[j], p[k], p[l]);
    if (const int s = magnitude_filter<predicates::Orient3d>(at); s != 0) return static_cast<Sign>(s);
    if (const auto s = interval_sign<predicates::Orient3d>(at); s.certain()) return s.value();
    return decide_exactly<predicates::Orient3d>(at).sign;
  }
  [[nodiscard]] PointAreas seen_along(std::size_t axis) const {
    return {
        {seen(p[0], axis), seen(p[1], axis), seen(p[2], axis), seen(p[3], axis), seen(p[4], axis), seen(p[5], axis)}};
  }
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    return {-volume(i, i + 1, i + 2, j), -volume(i, i + 1, i + 2, j + 1), -volume(i, i + 1, i + 2, j + 2)};
  }
};

/// Of integers of this many bits.  Where in a plane is the least predictable of all, so it is asked without a branch.
template <int Bits>
struct IntegerAreas {
  using Number = WideInt<Bits + 1>;
  std::array<Number, 6> x, y;  // from the first corner

  template <class N>
  [[nodiscard]] auto value(std::size_t i, const N& dx, const N& dy, std::size_t k) const {
    return dx * (y[k] - y[i]) - dy * (x[k] - x[i]);
  }
  [[nodiscard]] Sign area(std::size_t i, std::size_t j, std::size_t k) const {
    return value(i, x[j] - x[i], y[j] - y[i], k).sign();
  }
  [[nodiscard]] Sign most_area(std::size_t i, std::size_t j, std::size_t from, Sign turns) const {
    const auto dx = x[j] - x[i], dy = y[j] - y[i];
    const auto first = value(i, dx, dy, from), second = value(i, dx, dy, from + 1), third = value(i, dx, dy, from + 2);
    if constexpr (decltype(first)::limbs == 1) {
      const auto way = static_cast<std::int64_t>(turns);
      return sign_of_number(std::max(std::max(way * first.low64(), way * second.low64()), way * third.low64()));
    } else {
      return most(turns * first.sign(), most(turns * second.sign(), turns * third.sign()));
    }
  }
};

/// `Source` tells the difference of coordinates i and j, as an integer of so many bits.
template <class Source>
struct IntegerSigns {
  Source all;

  using Number = WideInt<Source::bits + 1>;
  using Vector = predicates::Triple<Number>;

  [[nodiscard]] Number number(std::size_t from, std::size_t to, std::size_t axis) const {
    return all.difference(3 * to + axis, 3 * from + axis);
  }
  [[nodiscard]] Vector vector(std::size_t from, std::size_t to) const {
    return {number(from, to, 0), number(from, to, 1), number(from, to, 2)};
  }
  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return predicates::triple(vector(l, i), vector(l, j), vector(l, k)).sign();
  }
  [[nodiscard]] IntegerAreas<Source::bits> seen_along(std::size_t axis) const {
    IntegerAreas<Source::bits> flat;
    for (std::size_t i = 0; i < 6; ++i) {
      flat.x[i] = number(0, i, (axis + 1) % 3);
      flat.y[i] = number(0, i, (axis + 2) % 3);
    }
    return flat;
  }
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    const auto normal = predicates::cross(vector(i, i + 1), vector(i, i + 2));
    const auto side = [&](std::size_t k) { return predicates::dot(vector(i, k), normal).sign(); };
    return {side(j), side(j + 1), side(j + 2)};
  }
};

template <int Bits>
struct Short {
  static constexpr int bits = Bits;
  const LatticeIntegers<18>& all;
  int zeros;
  [[nodiscard]] WideInt<Bits + 1> difference(std::size_t i, std::size_t j) const {
    return WideInt<Bits + 1>{all.difference(i, j) >> zeros};
  }
};
constexpr int wide_bits = integer::wide_bits.front();
struct Wide {
  static constexpr int bits = wide_bits;
  const LatticeDigits<18, wide_bits>& all;
  [[nodiscard]] WideInt<bits + 1> difference(std::size_t i, std::size_t j) const {
    return all.template difference<bits>(i, j);
  }
};

bool boxes_are_apart(const Triangle3& a, const Triangle3& b) {
  const auto apart = [](const auto& p, const auto& q) { return p.second < q.first || q.second < p.first; };
  const auto range = [](const Triangle3& t, double Point3::*at) { return std::minmax({t.a.*at, t.b.*at, t.c.*at}); };
  return apart(range(a, &Point3::x), range(b, &Point3::x)) || apart(range(a, &Point3::y), range(b, &Point3::y)) ||
         apart(range(a, &Point3::z), range(b, &Point3::z));
}

[[gnu::noinline]] Relation without_area(const Triangle3& a, const Triangle3& b) {
  return telling_axis(b) == 3 ? relate(flattened(b), a) : relate(flattened(a), b);
}

[[gnu::noinline]] std::optional<Relation> by_wide_signs(const Triangle3& a, const Triangle3& b,
                                                        const std::array<double, 18>& coordinates, Asked asked) {
  require_figures(asked, a, b);
  if (boxes_are_apart(a, b)) return Relation::disjoint;
  LatticeDigits<18, wide_bits> digits(coordinates);
  if (digits.extend<wide_bits>()) return relate_by(IntegerSigns<Wide>{{digits}});
  return relate_by(PointSigns{{a.a, a.b, a.c, b.a, b.b, b.c}});
}

[[gnu::noinline]] Relation by_signs(const Triangle3& a, const Triangle3& b, Asked asked) {
  const auto coordinates = std::bit_cast<std::array<double, 18>>(std::array{a, b});
  const LatticeIntegers<18> all(coordinates);
  const auto answer = all.bits() == 0 ? by_wide_signs(a, b, coordinates, asked)
                      : all.bits() - all.zeros() <= integer::short_bits
                          ? relate_by(IntegerSigns<Short<integer::short_bits>>{{all, all.zeros()}})
                          : relate_by(IntegerSigns<Short<integer::long_bits>>{{all, 0}});
  return answer ? *answer : without_area(a, b);
}

}  // namespace

Relation relate(const Triangle3& a, const Triangle3& b, Asked asked) {
  if (const auto answer = by_doubles(a, b)) return *answer;
  return by_signs(a, b, asked);
}

}  // namespace query

Relation relate(const Triangle3& a, const Triangle3& b, Asked asked) {
  assert_sound_thread();
  return query::relate(a, b, asked);
}

}  // namespace plumb
