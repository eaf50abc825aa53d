// All areas of a pair at once, by doubles and by integers: no branch but that on whether they tell.
#include "query/overlap/quick2.hpp"

#include <bit>

#include "query/overlap/lattice_points.hpp"

namespace plumb::query {
namespace {

using Seen = Seen2<double>;

// What two figures are, whose areas that must not be zero are known.
std::optional<Relation> told(double least, double known, double error) {
  if (!(std::min(magnitude_of(least), known) > error)) return {};
  return least > 0 ? Relation::overlapping : Relation::disjoint;
}

// The pair as it is given, on a lattice: from one figure's first point.
template <class A, class B>
struct OnLattice {
  static constexpr std::size_t numbers_a = sizeof(A) / sizeof(double), numbers_b = sizeof(B) / sizeof(double);
  using Points = LatticePoints<(numbers_a + numbers_b) / 2, 2>;
  struct Both {
    B first;
    A second;
  };
  const A& a;
  const B& b;
  Points points{std::bit_cast<std::array<double, numbers_a + numbers_b>>(Both{b, a})};

  [[nodiscard]] std::optional<Relation> straight() const {
    if (!is_straight(points, 0, 1)) return {};
    return relate_straight<2>(std::bit_cast<std::array<double, numbers_a>>(a),
                              std::bit_cast<std::array<double, numbers_b>>(b), is_level(points, 0) ? 1 : 0);
  }
};

std::optional<Relation> relate(const OnLattice<Segment2, Segment2>& on) {
  const double least = on.points.seen(0, 1, [](const auto& at, const auto& told) {
    return depth(told_areas(crossing_areas(at(1), at(2), at(3)), told));
  });
  if (least == 0) {
    if (const auto straight = on.straight()) return straight;
  }
  return relation(sign_of_number(least));
}
std::optional<Relation> relate(const OnLattice<Segment2, Triangle2>& on) {
  const auto areas = on.points.seen(0, 1, [](const auto& at, const auto& told) {
    return told_areas(segment_areas(at(1), at(2), at(3), at(4)), told);
  });
  if (areas.of_triangle == 0 || on.a.a == on.a.b) return on.straight();
  return relation(sign_of_number(depth(areas)));
}
std::optional<Relation> relate(const OnLattice<Triangle2, Triangle2>& on) {
  return on.points.seen(0, 1, [&](const auto& at, const auto& told) -> std::optional<Relation> {
    if (told(area(at(1), at(2))) == 0) return on.straight();
    const auto areas = told_areas(triangle_areas(at(1), at(2), {at(3), at(4), at(5)}), told);
    if (areas.of_b == 0) return {};
    return relation(sign_of_number(depth(areas)));
  });
}

template <class A, class B>
[[gnu::noinline]] std::optional<Relation> by_lattice(const A& a, const B& b) {
  const OnLattice<A, B> on{a, b};
  if (!on.points.is_lattice()) return {};
  return relate(on);
}

template <class A, class B>
std::optional<Relation> quickly_told(const A& a, const B& b) {
  if (const auto answer = by_doubles(a, b)) return answer;
  return by_lattice(a, b);
}

}  // namespace

std::optional<Relation> by_doubles(const Segment2& s, const Segment2& t) {
  const Seen p = from_to(s.a, s.b), c = from_to(s.a, t.a), d = from_to(s.a, t.b);
  return told(depth(crossing_areas(p, c, d)), std::numeric_limits<double>::infinity(), area_error_of(p, c, d));
}
std::optional<Relation> by_doubles(const Triangle2& a, const Triangle2& b) {
  const auto at = [&](const Point2& p) { return from_to(a.a, p); };
  const Seen p = at(a.b), q = at(a.c), u = at(b.a), v = at(b.b), w = at(b.c);
  const auto areas = triangle_areas(p, q, {u, v, w});
  return told(depth(areas), std::min(magnitude_of(areas.of_a), magnitude_of(areas.of_b)), area_error_of(p, q, u, v, w));
}
std::optional<Relation> by_doubles(const Segment2& s, const Triangle2& t) {
  const auto at = [&](const Point2& p) { return from_to(t.a, p); };
  const Seen b = at(t.b), c = at(t.c), p = at(s.a), q = at(s.b);
  const auto areas = segment_areas(b, c, p, q);
  return told(depth(areas), magnitude_of(areas.of_triangle), area_error_of(b, c, p, q));
}

std::optional<Relation> quickly(const Segment2& s, const Segment2& t) { return quickly_told(s, t); }
std::optional<Relation> quickly(const Segment2& s, const Triangle2& t) { return quickly_told(s, t); }
std::optional<Relation> quickly(const Triangle2& a, const Triangle2& b) { return quickly_told(a, b); }

}  // namespace plumb::query
