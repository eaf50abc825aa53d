// Zonotope: which edges is the Minkowski difference of two boxes, rectangles, segments or points a sum of, and which of
// them are parallel by what is given?
//
// Laws: edges that one axis is given for, or whose opposite is, and those along one axis of space, are one group: as a pose of
// doubles turns them, else under one pose, without arithmetic.  Edges without a length are in none.  Others may be parallel, too.
// Source: RTCD 4.4.1, 5.2.1.
// Cost: comparisons.
#pragma once

#include "query/penetration/difference.hpp"

namespace plumb::query::parting {

/// Edge `bit` of the first body (0) or of the second.
struct EdgeName {
  std::uint32_t body, bit;
};

struct SumEdge {
  std::uint32_t body, bit;
  std::uint32_t group;
  bool against;  // the first of its group
};

/// Groups as vectors, and the middle; of the difference times two.
template <class T>
struct SumParts {
  std::array<Vec<T>, 6> group;
  Vec<T> middle;
};

class EdgeSum {
 public:
  /// Of sums (CoreCorners::is_sum).
  explicit EdgeSum(const Difference& d);

  [[nodiscard]] std::size_t groups() const { return groups_; }
  [[nodiscard]] std::span<const SumEdge> edges() const { return {edges_.data(), size_}; }
  [[nodiscard]] const SumEdge& first_of(std::size_t group) const {
    std::size_t i = 0;
    while (edges_[i].group != group) ++i;
    return edges_[i];
  }
  /// Nothing where there is no such edge.
  [[nodiscard]] std::optional<std::uint32_t> group_of(const EdgeName& name) const {
    for (const SumEdge& e : edges()) {
      if (e.body == name.body && e.bit == name.bit) return e.group;
    }
    return {};
  }
  /// The axis of space that a group is along, unless it is along none by what is given.
  [[nodiscard]] std::optional<int> axis(std::size_t group) const { return axis_[group]; }
  /// Which way the first edge of a group leads by what is given, but for its length: in space, else before its pose.
  [[nodiscard]] const std::optional<Vector3>& along(std::size_t group) const { return along_[group]; }
  /// Of one body: does it have all its edges, each in a group of its own?
  [[nodiscard]] bool has_its_own(std::uint32_t body) const;
  [[nodiscard]] const Difference& difference() const { return of_; }

  template <class T>
  [[nodiscard]] SumParts<T> parts() const {
    const Vec<T> none{T(0.0), T(0.0), T(0.0)};
    SumParts<T> p{{none, none, none, none, none, none}, none};
    std::array<bool, 6> is_begun{};
    for (const SumEdge& e : edges()) {
      const Vec<T> v = edge_of<T>(e.body == 0 ? of_.a : of_.b, e.bit);
      Vec<T>& sum = p.group[e.group];
      sum = !is_begun[e.group] ? v : e.against ? sum - v : sum + v;
      is_begun[e.group] = true;
    }
    p.middle = twice_middle_of<T>(of_.a) - twice_middle_of<T>(of_.b);
    return p;
  }

 private:
  void add(std::uint32_t body, const CoreCorners& c, std::uint32_t bit);

  const Difference& of_;
  std::array<SumEdge, 6> edges_{};
  std::array<std::optional<Vector3>, 6> along_;  // of the first of each group
  std::array<AnyPoseView, 6> pose_{};
  std::array<std::optional<int>, 6> axis_;
  std::size_t size_ = 0, groups_ = 0;
};

/// What of a sum lies in a plane that touches it: the corner of the lowest number there, and as bits the edges from it.
struct SumLevel {
  std::uint32_t first = 0, free = 0;
};
/// In the plane that is furthest along a direction, by the sign of what each group leads along it.
template <class SignOf>
std::array<SumLevel, 2> furthest_of(const EdgeSum& sum, const SignOf& sign_of_group) {
  std::array<SumLevel, 2> level;
  const Difference& d = sum.difference();
  for (std::uint32_t body = 0; body < 2; ++body) {
    level[body].free = (1U << (body == 0 ? d.a : d.b).edges()) - 1;  // what is in no group leads nowhere
  }
  for (const SumEdge& e : sum.edges()) {
    const Sign of_group = sign_of_group(e.group), of_edge = e.against == (e.body == 0) ? -of_group : of_group;
    if (of_edge == Sign::zero) continue;
    level[e.body].free &= ~(1U << e.bit);
    if (of_edge == Sign::positive) level[e.body].first |= 1U << e.bit;
  }
  return level;
}

}  // namespace plumb::query::parting
