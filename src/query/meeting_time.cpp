#include "query/meeting_time.hpp"

#include <algorithm>
#include <array>

#include "plumb/arith/big_rounding.hpp"

namespace plumb::query {
namespace {

bool is_zero(const Interval& x) { return x.lower == 0 && x.upper == 0; }
bool is_zero(const BigDyadic& x) { return x.sign() == Sign::zero; }

template <class T>
T negated(const T& x) {
  return T(0.0) - x;
}

/// 0 <= from + change t <= most.
template <class T>
void add_between(Condition<T>& c, const T& from, const T& change, const T& most) {
  c.not_negative.push_back({from, change});
  c.not_negative.push_back({most - from, negated(change)});
}

/// |apart + velocity t|^2 <= limit.
template <class T>
std::array<T, 3> within(const Vec3<T>& apart, const Vec3<T>& velocity, const T& limit) {
  const T middle = dot(apart, velocity);
  return {dot(apart, apart) - limit, middle + middle, dot(velocity, velocity)};
}
/// The same for numbers.
template <class T>
std::array<T, 3> within(const T& apart, const T& velocity, const T& limit) {
  const T middle = apart * velocity;
  return {apart * apart - limit, middle + middle, velocity * velocity};
}

template <class T>
struct Line {
  Vec3<T> from, along;
};
template <class T>
Line<T> line_of(const Body<T>& body, std::uint32_t edge) {
  const auto& [from, to] = body.edges[edge].ends;
  return {body.vertices[from], body.vertices[to] - body.vertices[from]};
}

template <class T>
std::optional<Condition<T>> point_line(const Vec3<T>& p, const Line<T>& e, const Vec3<T>& velocity, const T& square) {
  const T length = dot(e.along, e.along);
  if (is_zero(length)) return {};
  const Vec3<T> d = p - e.from;
  Condition<T> c{within(cross(d, e.along), cross(velocity, e.along), square * length)};
  add_between(c, dot(d, e.along), dot(velocity, e.along), length);
  return c;
}

template <class T>
std::optional<Condition<T>> line_line(const Line<T>& p, const Line<T>& q, const Vec3<T>& velocity, const T& square) {
  const Vec3<T> n = cross(p.along, q.along), w = q.from - p.from;
  const T area = dot(n, n);
  if (is_zero(area)) return {};
  Condition<T> c{within(dot(w, n), negated(dot(velocity, n)), square * area)};
  const Vec3<T> of_p = cross(q.along, n), of_q = cross(p.along, n);
  add_between(c, dot(w, of_p), negated(dot(velocity, of_p)), area);
  add_between(c, dot(w, of_q), negated(dot(velocity, of_q)), area);
  return c;
}

template <class T>
std::optional<Condition<T>> point_face(const Vec3<T>& p, const Body<T>& body, std::uint32_t face,
                                       const Vec3<T>& velocity, const T& square) {
  const auto& f = body.faces[face];
  const T area = dot(f.normal, f.normal);
  if (is_zero(area)) return {};
  Condition<T> c{within(dot(p, f.normal) - f.offset, dot(velocity, f.normal), square * area)};
  for (std::size_t i = 0; i < f.corners.size(); ++i) {
    const Vec3<T>&from = body.vertices[f.corners[i]], &to = body.vertices[f.corners[(i + 1) % f.corners.size()]];
    const Vec3<T> inward = cross(f.normal, to - from);
    c.not_negative.push_back({dot(p - from, inward), dot(velocity, inward)});
  }
  return c;
}

}  // namespace

template <class T>
std::optional<Condition<T>> condition(const Body<T>& a, const Body<T>& b, const Vec3<T>& velocity, PairIndex pair) {
  const T reach = a.reach + b.reach, square = reach * reach;
  const auto back = [&] { return Vec3<T>{negated(velocity.x), negated(velocity.y), negated(velocity.z)}; };
  switch (pair.kind) {
    case FeaturePair::vertex_vertex:
      return Condition<T>{within(a.vertices[pair.a] - b.vertices[pair.b], velocity, square)};
    case FeaturePair::vertex_edge:
      return point_line(a.vertices[pair.a], line_of(b, pair.b), velocity, square);
    case FeaturePair::edge_vertex:
      return point_line(b.vertices[pair.b], line_of(a, pair.a), back(), square);
    case FeaturePair::edge_edge:
      return line_line(line_of(a, pair.a), line_of(b, pair.b), velocity, square);
    case FeaturePair::vertex_face:
      return point_face(a.vertices[pair.a], b, pair.b, velocity, square);
    default:
      return point_face(b.vertices[pair.b], a, pair.a, back(), square);
  }
}
template std::optional<Condition<Interval>> condition(const Body<Interval>&, const Body<Interval>&,
                                                      const Vec3<Interval>&, PairIndex);
template std::optional<Condition<BigDyadic>> condition(const Body<BigDyadic>&, const Body<BigDyadic>&,
                                                       const Vec3<BigDyadic>&, PairIndex);

double earliest(const Condition<Interval>& condition) {
  constexpr double never = Interval::infinity;
  double low = 0, high = 1;
  for (const auto& [from, change] : condition.not_negative) {
    if (change.lower > 0) {
      low = std::max(low, quotient(negated(from), change).lower);
    } else if (change.upper < 0) {
      high = std::min(high, quotient(from, negated(change)).upper);
    } else if ((from + change * Interval{low, high}).upper < 0) {
      return never;
    }
  }
  if (!(low <= high)) return never;
  // From `low` on; the condition is convex.
  const auto& [c0, c1, c2] = condition.not_positive;
  const Interval start(low), slope = c1 + (c2 + c2) * start, value = c0 + (c1 + c2 * start) * start;
  if (!(value.lower > 0)) return low;
  if (slope.lower >= 0) return never;
  const Interval rest = slope * slope - Interval(4.0) * c2 * value;
  if (rest.upper < 0) return never;
  const double wait = quotient(value + value, root(rest) - slope).lower;
  const double first = wait > 0 ? std::max(low, (start + Interval(wait)).lower) : low;
  return first <= high ? first : never;
}

namespace {

mpq_class rational(const BigDyadic& x) {
  mpq_class r = x.mantissa();
  if (x.exponent() < 0) {
    mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-x.exponent()));
  } else {
    mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(x.exponent()));
  }
  return r;
}

}  // namespace

std::optional<Root> first_time(const Condition<BigDyadic>& condition) {
  mpq_class low = 0, high = 1;
  for (const auto& [from, change] : condition.not_negative) {
    if (change.sign() == Sign::zero) {
      if (from.sign() == Sign::negative) return {};
      continue;
    }
    const mpq_class at = -rational(from) / rational(change);
    if (change.sign() == Sign::positive) {
      low = std::max(low, at);
    } else {
      high = std::min(high, at);
    }
  }
  if (low > high) return {};
  const auto& c = condition.not_positive;
  const std::array<mpq_class, 3> q{rational(c[0]), rational(c[1]), rational(c[2])};
  const auto exact = [](const mpq_class& x) { return Rational(BigRational{x}); };
  if (q[0] + (q[1] + q[2] * low) * low <= 0) return Root(exact(low));
  const std::vector<Root> roots =
      real_roots(std::array{exact(q[0]), exact(q[1]), exact(q[2])}, exact(low), exact(high));
  if (roots.empty()) return {};
  return roots.front();
}

}  // namespace plumb::query
