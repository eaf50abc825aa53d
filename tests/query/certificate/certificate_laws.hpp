// Is it a proof?  The conditions of query/certificate/certificate.hpp, restated over every pair of corners and in other
// arithmetic: a rank by elimination, distances by linear programs and by Wolfe's method.
//
// Laws: exact, and independent of src/query/certificate/.
#pragma once

#include <algorithm>
#include <string>

#include "plumb/arith/gmp.hpp"
#include "plumb/query/certificate/verify.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/flat_set.hpp"
#include "query/separation/convex_body.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::certificate_laws {

using query::dot, query::Exact3, query::FlatSet;
using query::operator-, query::operator+, query::operator*;

/// A body as its corners, written down.
struct Corners {
  std::vector<Exact3> points;
  mpq_class radius = 0;
};
inline Corners corners_of(const query::BodyView& view) {
  const query::Body body = query::body_of("corners_of", "it", view);
  Corners c{{}, body.radius};
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const auto p = body.corners.at<mpq_class>(i);
    c.points.push_back({p.x, p.y, p.z});
  }
  return c;
}

inline mpq_class squared_gap(const Corners& a, const Corners& b) {
  return *query::squared_distance(FlatSet{a.points, {}, {}}, FlatSet{b.points, {}, {}});
}
inline Relation relation_of(const Corners& a, const Corners& b) {
  const mpq_class reach = a.radius + b.radius;
  if (reach == 0) return query::relate(FlatSet{a.points, {}, {}}, FlatSet{b.points, {}, {}});
  return static_cast<Relation>(sgn(mpq_class(reach * reach - squared_gap(a, b))));
}

inline std::size_t rank(std::vector<Exact3> rows) {
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 3; ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const Exact3& row) { return row[column] != 0; });
    if (pivot == rows.end()) continue;
    std::iter_swap(pivot, rows.begin() + static_cast<std::ptrdiff_t>(rank));
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      const mpq_class times = rows[i][column] / rows[rank][column];
      rows[i] = rows[i] - times * rows[rank];
    }
    ++rank;
  }
  return rank;
}

/// A pair of bodies, and how they lie.
class Judge {
 public:
  Judge(Corners a, Corners b)
      : a_(std::move(a)), b_(std::move(b)), relation_(relation_of(a_, b_)), square_(squared_gap(a_, b_)) {
    for (const Exact3& u : a_.points) {
      for (const Exact3& v : b_.points) differences_.push_back(u - v);
    }
  }
  Judge(const query::BodyView& a, const query::BodyView& b) : Judge(corners_of(a), corners_of(b)) {}

  [[nodiscard]] Relation relation() const { return relation_; }
  [[nodiscard]] mpq_class reach() const { return a_.radius + b_.radius; }
  [[nodiscard]] const mpq_class& square() const { return square_; }

  [[nodiscard]] bool is_proof(const Certificate& c) const {
    const mpq_class most = reach() * reach();
    switch (c.claim) {
      case Claim::disjoint:
        return relation_ == Relation::disjoint && c.pairs.empty() && c.direction && all_farther(*c.direction, most);
      case Claim::touching:
        return relation_ == Relation::touching && c.direction && is_wall(*c.direction, most) && sum_of(c.pairs) == most;
      case Claim::overlapping:
        return relation_ == Relation::overlapping && !c.direction && is_within(c.pairs, most);
      case Claim::intersecting:
        return relation_ != Relation::disjoint && !c.direction && sum_of(c.pairs) && *sum_of(c.pairs) <= most;
    }
    return false;
  }

  [[nodiscard]] bool is_proof(const DistanceCertificate& c) const {
    if (mpq(c.exact.square) != square_ || mpq(c.exact.inset) != reach()) return false;
    if (c.distance != query::rounded_distance(square_, reach()) || std::signbit(c.distance)) return false;
    if (sum_of(c.pairs) != square_) return false;
    return square_ == 0 ? !c.direction : c.direction && is_wall(*c.direction, square_);
  }

 private:
  /// From a to b, the step of each pair along n.
  template <class Holds>
  [[nodiscard]] bool every_step(const ExactVector3& n, Holds holds) const {
    const Exact3 way{mpq(n.x), mpq(n.y), mpq(n.z)};
    const mpq_class length = dot(way, way);
    return std::ranges::all_of(differences_, [&](const Exact3& d) {
      const mpq_class step = -dot(way, d);
      return holds(step, length);
    });
  }
  [[nodiscard]] bool all_farther(const ExactVector3& n, const mpq_class& most) const {
    return every_step(
        n, [&](const mpq_class& step, const mpq_class& length) { return step > 0 && step * step > most * length; });
  }
  /// No pair is nearer along n, some is not farther, and of bodies that meet some is.
  [[nodiscard]] bool is_wall(const ExactVector3& n, const mpq_class& square) const {
    bool as_near = false, farther = false;
    const bool none_nearer = every_step(n, [&](const mpq_class& step, const mpq_class& length) {
      const int order = cmp(mpq_class(step * step), mpq_class(square * length));
      as_near = as_near || order == 0, farther = farther || order > 0;
      return length > 0 && step >= 0 && order >= 0;
    });
    return none_nearer && as_near && (farther || square > 0);
  }
  /// The square of the sum of the pairs; nothing where they are none.
  [[nodiscard]] std::optional<mpq_class> sum_of(const std::vector<WeightedPair>& pairs) const {
    mpq_class whole = 0;
    Exact3 on_a{0, 0, 0}, on_b{0, 0, 0};
    for (const WeightedPair& p : pairs) {
      if (p.of_a >= a_.points.size() || p.of_b >= b_.points.size() || p.weight.sign() != Sign::positive) return {};
      whole += mpq(p.weight);
      on_a = on_a + mpq(p.weight) * a_.points[p.of_a];
      on_b = on_b + mpq(p.weight) * b_.points[p.of_b];
    }
    if (whole != 1) return {};
    return dot(on_a - on_b, on_a - on_b);
  }
  [[nodiscard]] bool is_within(const std::vector<WeightedPair>& pairs, const mpq_class& most) const {
    const auto square = sum_of(pairs);
    if (!square) return false;
    if (most > 0) return *square < most;
    std::vector<Exact3> of_pairs;
    for (const WeightedPair& p : pairs) of_pairs.push_back(a_.points[p.of_a] - b_.points[p.of_b]);
    return *square == 0 && rank(of_pairs) == rank(differences_);
  }

  Corners a_, b_;
  Relation relation_;
  mpq_class square_;
  std::vector<Exact3> differences_;  // of every pair
};

}  // namespace plumb::certificate_laws
