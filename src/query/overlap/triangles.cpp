// Two triangles in space: by doubles; by the integers that the corners are on their common lattice; by exact signs of
// the corners; and what has no area as the segment or point that it is.
#include <bit>
#include <cmath>
#include <limits>

#include "plumb/certify/certainly.hpp"
#include "query/body/figure_input.hpp"
#include "query/overlap/filters.hpp"
#include "query/overlap/lattice3.hpp"
#include "query/overlap/lattice_worlds.hpp"
#include "query/overlap/neighbor_triangles.hpp"
#include "query/overlap/pair_answer.hpp"
#include "query/overlap/signs.hpp"
#include "query/overlap/triangle_signs.hpp"

namespace plumb {
namespace query {

namespace {

enum class InOnePlane : bool { left, told };

template <InOnePlane in_one_plane>
[[gnu::always_inline]] inline std::optional<Relation> told_by_doubles(const Triangle3& a, const Triangle3& b) {
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
  const auto certain = [](const std::array<double, 3>& x, double e) {
    return std::min(std::min(magnitude_of(x[0]), magnitude_of(x[1])), magnitude_of(x[2])) > e;
  };
  const bool certain_a = certain(over_a, error);
  if (!certain_a) {
    if (!(magnitude_of(error) < std::numeric_limits<double>::infinity())) return {};
    if (const auto answer = relate_neighbors(a, b, axis_across(n.x, n.y, n.z), over_a, error)) return answer;
    const bool are_coplanar = std::max(high(over_a), -low(over_a)) <= error;  // or nearly so
    if (are_coplanar) return in_one_plane == InOnePlane::told ? by_short_plane(a, b, error) : std::nullopt;
  }

  const Difference m = cross(difference(b.a, b.b), difference(b.a, b.c));
  const std::array over_b{dot(difference(b.a, a.a), m), dot(difference(b.a, a.b), m), dot(difference(b.a, a.c), m)};
  const double sum = over_b[0] + over_b[1] + over_b[2];
  const double twofold = error * from_any_corner + (sum - sum);
  if (low(over_b) > twofold || high(over_b) < -twofold) return Relation::disjoint;

  if (!certain_a || !certain(over_b, twofold)) return {};
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
  if (const int told = beyond(least, limit); told != 0) [[likely]]
    return static_cast<Relation>(told);
  return {};
}

}  // namespace

std::optional<Relation> by_doubles(const Triangle3& a, const Triangle3& b) {
  return told_by_doubles<InOnePlane::left>(a, b);
}
std::optional<Relation> relation_by_doubles(const Triangle3& a, const Triangle3& b) {
  return told_by_doubles<InOnePlane::told>(a, b);
}

namespace {

/// orient3d, of corners whose exponents may be far apart: the sums of magnitudes tell more of those.
Sign spread_volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  using predicates::Orient3d;
  const auto at = coordinates_of<Orient3d>(a, b, c, d);
  if (const int s = magnitude_filter<Orient3d>(at); s != 0) return static_cast<Sign>(s);
  return decide_exactly<Orient3d>(at).sign;
}

/// Of corners whose coordinates take many bits.  What two equal corners span is zero, however far apart the others are;
/// and where figures have corners in common, the same four are asked for again.
class PointSigns {
 public:
  explicit PointSigns(const std::array<Point3, 6>& p) : p_(p) {
    for (std::size_t i = 1; i < p.size(); ++i) {
      for (std::size_t k = i; k-- > 0;) first_[i] = p[k] == p[i] ? k : first_[i];
    }
  }

  static constexpr bool doubles_first = true;
  static constexpr std::array<std::size_t, 3> axes() { return {0, 1, 2}; }
  static std::optional<std::size_t> running_axis() { return {}; }
  /// Are two corners of the triangle from corner i on the same?
  [[nodiscard]] bool repeats_a_corner(std::size_t i) const {
    return are_equal(i, i + 1) || are_equal(i, i + 2) || are_equal(i + 1, i + 2);
  }
  [[nodiscard]] Sign turn_of_b(std::size_t axis) const { return area(axis, 3, 4, 5); }
  [[nodiscard]] TriangleAreas<double> areas(std::size_t axis) const {
    return areas_by([&](std::size_t i, std::size_t j, std::size_t k) { return area(axis, i, j, k); });
  }
  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    std::array of{first_[i], first_[j], first_[k], first_[l]};
    bool odd = false;  // the order in which they are asked for
    for (std::size_t last = 1; last < of.size(); ++last) {
      for (std::size_t n = last; n > 0 && of[n - 1] > of[n]; --n) std::swap(of[n - 1], of[n]), odd = !odd;
    }
    if (of[0] == of[1] || of[1] == of[2] || of[2] == of[3]) return Sign::zero;
    std::optional<Sign>& told = told_[1u << of[0] | 1u << of[1] | 1u << of[2] | 1u << of[3]];
    const auto turned = [odd](Sign s) { return odd ? -s : s; };
    if (!told) told = turned(spread_volume(p_[i], p_[j], p_[k], p_[l]));
    return turned(*told);
  }
  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    return {-volume(i, i + 1, i + 2, j), -volume(i, i + 1, i + 2, j + 1), -volume(i, i + 1, i + 2, j + 2)};
  }

 private:
  [[nodiscard]] bool are_equal(std::size_t i, std::size_t j) const { return first_[i] == first_[j]; }
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    if (are_equal(i, j) || are_equal(j, k) || are_equal(k, i)) return Sign::zero;
    return query::orient2d(seen(p_[i], axis), seen(p_[j], axis), seen(p_[k], axis));
  }
  static constexpr std::array<std::size_t, 6> each_its_own{0, 1, 2, 3, 4, 5};
  const std::array<Point3, 6>& p_;
  std::array<std::size_t, 6> first_ = each_its_own;  // of those that are equal
  mutable std::array<std::optional<Sign>, 64>
      told_{};  // the volumes of four corners in their order, by the set of these
};

template <class Points, class Step>
class TriangleSigns : public VolumeSigns<Points, Step> {
 public:
  using VolumeSigns<Points, Step>::VolumeSigns;

  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const { return this->template over<3>(i, j); }
  [[nodiscard]] Sign turn_of_b(std::size_t axis) const { return turn(axis, 3, 4, 5); }
  [[nodiscard]] TriangleAreas<double> areas(std::size_t axis) const {
    const auto told_all = [](const auto& at, const auto& told) {
      return told_areas(triangle_areas(at(1), at(2), {at(3), at(4), at(5)}), told);
    };
    if constexpr (requires { this->points_.seen(0, 1, told_all); }) {
      return this->points_.seen((axis + 1) % 3, (axis + 2) % 3, told_all);
    } else {
      return areas_by([&](std::size_t i, std::size_t j, std::size_t k) { return turn(axis, i, j, k); });
    }
  }

 private:
  [[nodiscard]] Sign turn(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    return this->points_.turn((axis + 1) % 3, (axis + 2) % 3, i, j, k);
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

[[gnu::noinline]] std::optional<Relation> by_points(const Triangle3& a, const Triangle3& b, Question question) {
  require_figures(question, a, b);
  if (boxes_are_apart(a, b)) return Relation::disjoint;
  const std::array corners{a.a, a.b, a.c, b.a, b.b, b.c};
  const PointSigns signs(corners);
  if (signs.repeats_a_corner(3)) return relate(flattened(b), a);
  if (signs.repeats_a_corner(0)) return relate(flattened(a), b);
  return relate_by(a, b, signs);
}

[[gnu::noinline]] Relation by_signs(const Triangle3& a, const Triangle3& b, Question question) {
  const auto answer = certainly<LatticeWorlds<TriangleSigns, 6>>(
      [&](const auto& signs) { return relate_by(a, b, signs); },
      std::bit_cast<std::array<double, 18>>(std::array{a, b}), [&] { return by_points(a, b, question); });
  return answer ? *answer : without_area(a, b);
}

}  // namespace

Relation relate(const Triangle3& a, const Triangle3& b, Question question) {
  if (const auto answer = relation_by_doubles(a, b)) return *answer;
  return by_signs(a, b, question);
}

Relation relate_pair(PairFunction<Triangle3, Triangle3>, const Triangle3& a, const Triangle3& b, Question question) {
  assert_sound_thread();
  return relate(a, b, question);
}

}  // namespace query

}  // namespace plumb
