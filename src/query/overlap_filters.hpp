// Do plain doubles prove how triangles in space lie to one another, and to what is straight?
//
// All numbers of a test are volumes, sums of products of three differences.  Their errors have one bound: a constant
// that is derived from the formulas, times the largest differences of each axis (filter B of certify/filter_stage.hpp).
// So the answer is told by the least of the numbers, without a branch on each.
// Laws: an answer is that of real arithmetic; what is near to zero, or not finite, is nothing.
// Source: Moller and Trumbore 1997, Guigue and Devillers 2003, for which products are shared.  Cost: some 10 to 25 ns.
#pragma once

#include <algorithm>
#include <optional>
#include <plumb/predicates/cross.hpp>

#include "overlap_linear3.hpp"
#include "plumb/certify/filter_stage.hpp"

namespace plumb::query {

using Difference = predicates::Triple<double>;

constexpr Difference difference(const Point3& from, const Point3& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

/// Points a, b, c, d: the volume that the differences from a span.
struct Volume {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    using predicates::difference;
    return predicates::triple(difference(p, 0, 1), difference(p, 0, 2), difference(p, 0, 3));
  }
};
/// As much as is added up of volumes.
struct ThreeVolumes {
  static constexpr std::string_view name = "relate";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto v = Volume{}(p);
    return v - v - v;
  }
};

/// The largest differences of each axis.
class LargestDifferences {
 public:
  void take(const Difference& d) {
    x_ = larger(magnitude_of(d.x), x_);
    y_ = larger(magnitude_of(d.y), y_);
    z_ = larger(magnitude_of(d.z), z_);
  }
  /// The bound of the error; NaN where the sum of all values that it is for is not finite.
  template <Formula F>
  [[nodiscard]] double threshold(double values) const {
    return largest_threshold<F>({opaque(x_), opaque(y_), opaque(z_)}) + (values - values);
  }

 private:
  // A NaN is not kept: it ends in the values.
  static double larger(double a, double b) { return a > b ? a : b; }
  static constexpr double least = largest_floor<Volume>;
  double x_ = least, y_ = least, z_ = least;
};

/// What is straight from p in direction d, which is no zero vector by the way; of a segment it ends at p + d.
inline std::optional<Relation> by_doubles(Reach reach, const Point3& p, const Difference& d, const Triangle3& t) {
  using predicates::cross, predicates::dot;
  const Difference e = difference(t.a, t.b), f = difference(t.a, t.c), w = difference(t.a, p);
  const Difference df = cross(d, f), we = cross(w, e);
  // The crossing is t.a + (u e + v f) / all, at p + d at / all.
  const double all = dot(e, df), u = dot(w, df), v = dot(d, we), at = dot(f, we);
  LargestDifferences largest;
  largest.take(e);
  largest.take(f);
  largest.take(w);
  largest.take(d);
  const double error = largest.threshold<ThreeVolumes>((all + u) + (v + at));
  const double way = all > 0 ? 1 : -1;
  double least = std::min(std::min(way * u, way * v), way * (all - u - v));
  if (reach != Reach::line) least = std::min(least, way * at);
  if (reach == Reach::segment) least = std::min(least, way * (all - at));
  if (least < -error && magnitude_of(all) > error) return Relation::disjoint;
  if (least > error) return Relation::overlapping;  // so u, v and what is left of all have one sign, and all has it
  return {};
}

/// Which corner is alone on its side, by the bits of those below; and the two others in turn.
inline constexpr std::array<unsigned char, 8> corner_alone{0, 0, 1, 2, 2, 1, 0, 0};

std::optional<Relation> by_doubles(const Triangle3& a, const Triangle3& b);

}  // namespace plumb::query
