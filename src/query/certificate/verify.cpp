// The conditions of query/certificate/certificate.hpp, one by one, in rational numbers.  Nothing is searched for.
#include "plumb/query/certificate/verify.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "arith/exact_number.hpp"
#include "query/certificate/span.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query {
namespace {

/// Is this the double nearest to root(square) - inset, or to zero where that is negative?  What is in the middle goes to the
/// even one (IEEE 754-2019, 4.3.1), and beyond the middle between the last one and 2^1024 to infinity.
bool is_rounded(double r, const mpq_class& square, const mpq_class& inset) {
  if (std::isnan(r) || std::signbit(r)) return false;
  constexpr auto infinity = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity());
  const auto bits = std::bit_cast<std::uint64_t>(r);
  const auto value = [](std::uint64_t of) {
    if (of != infinity) return mpq_class(std::bit_cast<double>(of));
    return mpq_class(mpz_class(1) << 1024);
  };
  const auto beyond_middle = [&](std::uint64_t neighbor) {  // is the distance?
    const mpq_class middle = (value(bits) + value(neighbor)) / 2 + inset;
    return cmp(square, mpq_class(middle * middle));
  };
  const int in_middle = (bits & 1) == 0 ? 0 : 1;
  if (bits > 0 && beyond_middle(bits - 1) < in_middle) return false;
  return bits == infinity || beyond_middle(bits + 1) <= -in_middle;
}

using Exact = arith::Vec<mpq_class>;
using Pairs = std::vector<WeightedPair>;

Exact vertex(const Body& body, std::size_t i) { return body.corners.at<mpq_class>(i); }
Exact difference(const Body& a, const Body& b, const WeightedPair& pair) {
  return vertex(a, pair.of_a) - vertex(b, pair.of_b);
}
mpq_class square(const Exact& v) { return dot(v, v); }

/// Weights above zero of sum 1 make a point of a, one of b, and d, the first less the second.
struct Weighed {
  std::string flaw;
  Exact d{0, 0, 0};
};
Weighed weighed(const Pairs& pairs, const Body& a, const Body& b) {
  Weighed w;
  mpq_class sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto flawed = [&](const char* what) { return Weighed{"pair " + std::to_string(i) + what}; };
    if (pairs[i].of_a >= a.corners.size()) return flawed(" names a vertex that a has not");
    if (pairs[i].of_b >= b.corners.size()) return flawed(" names a vertex that b has not");
    const mpq_class& weight = gmp_number(pairs[i].weight);
    if (sgn(weight) <= 0) return flawed(" has a weight that is not above zero");
    sum += weight;
    w.d = w.d + difference(a, b, pairs[i]) * weight;
  }
  if (sum != 1) w.flaw = "the weights of the pairs do not add up to 1";
  return w;
}

/// From the farthest of a along n to the nearest of b: no point of a is beyond its end, none of b before.
struct Gap {
  mpq_class width;
  bool is_everything;  // all vertices of both are at the ends
};
Gap gap_along(const Exact& n, const Body& a, const Body& b) {
  mpq_class end = dot(n, vertex(a, 0)), begin = dot(n, vertex(b, 0));
  bool level = true;
  for (std::size_t i = 1; i < a.corners.size(); ++i) {
    const mpq_class x = dot(n, vertex(a, i));
    level = level && x == end;
    if (x > end) end = x;
  }
  for (std::size_t j = 1; j < b.corners.size(); ++j) {
    const mpq_class x = dot(n, vertex(b, j));
    level = level && x == begin;
    if (x < begin) begin = x;
  }
  return {begin - end, level};
}

/// Does every way from one vertex of a body to another lie in the span of the pairs' differences?
bool span_all(const Pairs& pairs, const Body& a, const Body& b) {
  Span<mpq_class> span;
  for (const WeightedPair& pair : pairs) span.add(difference(a, b, pair));
  for (const Body* body : {&a, &b}) {
    for (std::size_t i = 1; i < body->corners.size(); ++i) {
      if (!span.holds(vertex(*body, i) - vertex(*body, 0))) return false;
    }
  }
  return true;
}

/// The flaw of a proof that a and b are disjoint; the others likewise.  `reach` is the square of both radii together.
std::string flaw_of_disjoint(const Exact& n, const Body& a, const Body& b, const mpq_class& reach) {
  const mpq_class gap = gap_along(n, a, b).width;
  if (sgn(gap) > 0 && gap * gap > reach * square(n)) return {};
  return "the direction leaves no gap as wide as the radii";
}

std::string flaw_of_touching(const Exact& n, const Exact& d, const Body& a, const Body& b, const mpq_class& reach) {
  if (Span<mpq_class>::is_zero(n)) return "the direction is zero";
  if (square(d) != reach) return "the points of the pairs are not as far apart as the radii reach";
  const Gap gap = gap_along(n, a, b);
  if (sgn(gap.width) < 0 || gap.width * gap.width != reach * square(n))
    return "the gap along the direction is not as wide as the radii reach";
  if (sgn(reach) == 0 && gap.is_everything) return "the direction's plane holds all of both bodies";
  return {};
}

std::string flaw_of_overlapping(const Pairs& pairs, const Exact& d, const Body& a, const Body& b,
                                const mpq_class& reach) {
  if (sgn(reach) > 0) return square(d) < reach ? "" : "the points of the pairs are not nearer than the radii reach";
  if (!Span<mpq_class>::is_zero(d)) return "the pairs make no common point";
  return span_all(pairs, a, b) ? "" : "the differences of the pairs do not span the bodies";
}

std::string flaw_of_intersecting(const Exact& d, const mpq_class& reach) {
  return square(d) <= reach ? "" : "the points of the pairs are farther apart than the radii reach";
}

Exact exact(const ExactVector3& n) { return {gmp_number(n.x), gmp_number(n.y), gmp_number(n.z)}; }

}  // namespace

ProofVerdict verdict_on(const Certificate& c, const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = bodies_of("verify", view_a, view_b);
  const mpq_class radii = a.radius + b.radius, reach = radii * radii;
  const bool wants_direction = c.claim == Claim::disjoint || c.claim == Claim::touching;
  if (c.claim < Claim::disjoint || c.claim > Claim::intersecting) return {"it claims nothing that there is a proof of"};
  if (wants_direction != c.direction.has_value())
    return {wants_direction ? "a direction is missing" : "a direction is of no use"};
  if (c.claim == Claim::disjoint && !c.pairs.empty()) return {"pairs are of no use"};
  if (c.claim == Claim::disjoint) return {flaw_of_disjoint(exact(*c.direction), a, b, reach)};
  const auto [flaw, d] = weighed(c.pairs, a, b);
  if (!flaw.empty()) return {flaw};
  if (c.claim == Claim::touching) return {flaw_of_touching(exact(*c.direction), d, a, b, reach)};
  if (c.claim == Claim::overlapping) return {flaw_of_overlapping(c.pairs, d, a, b, reach)};
  return {flaw_of_intersecting(d, reach)};
}

ProofVerdict verdict_on(const DistanceCertificate& c, const BodyView& view_a, const BodyView& view_b) {
  const auto [a, b] = bodies_of("verify", view_a, view_b);
  const auto [flaw, d] = weighed(c.pairs, a, b);
  if (!flaw.empty()) return {flaw};
  if (gmp_number(c.exact.inset) != a.radius + b.radius) return {"the inset is not the sum of the radii"};
  if (gmp_number(c.exact.square) != square(d)) return {"the square is not that of the points of the pairs"};
  if (!is_rounded(c.distance, square(d), a.radius + b.radius))
    return {"the distance is not rounded to the nearest double"};
  if (Span<mpq_class>::is_zero(d)) return {c.direction ? "a direction is of no use" : ""};
  if (!c.direction) return {"a direction is missing"};
  const Exact n = exact(*c.direction);
  const mpq_class gap = gap_along(n, a, b).width;
  if (sgn(gap) > 0 && gap * gap == square(d) * square(n)) return {};
  return {"the gap along the direction is not as wide as the points of the pairs are apart"};
}

}  // namespace plumb::query
