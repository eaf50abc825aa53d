// Do they meet while they move, and when first?  By Sturm sequences in GMP rationals, from definitions alone and
// independent of the library: no isolation by Descartes' rule, no projections, no greatest common divisors.
//
// The contact set in [0, 1] is closed and given by signs of polynomials of time, so its least time is 0 or a root of
// one of them: all are tried.  The sign of q at a root of p that is alone in an interval is the Cauchy index of
// p' q / p there (Sturm, Tarski).
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb::lab::contact_judge {

using Poly = std::vector<mpq_class>;  // ascending, without leading zeros

inline Poly trimmed(Poly p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}
inline Poly operator*(const Poly& a, const Poly& b) {
  if (a.empty() || b.empty()) return {};
  Poly r(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) r[i + j] += a[i] * b[j];
  }
  return r;
}
inline Poly plus(const Poly& a, const Poly& b, int sign) {
  Poly r(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < a.size(); ++i) r[i] = a[i];
  for (std::size_t i = 0; i < b.size(); ++i) r[i] += sign * b[i];
  return trimmed(std::move(r));
}
inline Poly operator+(const Poly& a, const Poly& b) { return plus(a, b, 1); }
inline Poly operator-(const Poly& a, const Poly& b) { return plus(a, b, -1); }

inline mpq_class value(const Poly& p, const mpq_class& x) {
  mpq_class v;
  for (std::size_t i = p.size(); i-- > 0;) v = v * x + p[i];
  return v;
}
inline Poly slope(const Poly& p) {
  Poly d;
  for (std::size_t i = 1; i < p.size(); ++i) d.emplace_back(p[i] * static_cast<unsigned long>(i));
  return d;
}
inline Poly remainder(Poly p, const Poly& q) {
  while (p.size() >= q.size()) {
    const mpq_class factor = p.back() / q.back();
    for (std::size_t i = 1; i <= q.size(); ++i) p[p.size() - i] -= factor * q[q.size() - i];
    p = trimmed(std::move(p));
  }
  return p;
}

/// The sum of the signs of q at the roots of p strictly between; no end may be a root.
inline int sign_sum(const Poly& p, const Poly& q, const mpq_class& from, const mpq_class& to) {
  int changes = 0, last_from = 0, last_to = 0;
  const auto count = [&](const Poly& s) {
    const auto step = [&](const mpq_class& x, int& last, int weight) {
      const int sign = sgn(value(s, x));
      if (sign == 0) return;
      if (last == -sign) changes += weight;
      last = sign;
    };
    step(from, last_from, 1);
    step(to, last_to, -1);
  };
  Poly a = p, b = slope(p) * q;
  count(a);
  while (!b.empty()) {
    const mpq_class size = abs(b.back());
    for (mpq_class& c : b) c /= size;
    count(b);
    Poly next = remainder(a, b);
    for (mpq_class& c : next) c = -c;
    a = std::move(b);
    b = std::move(next);
  }
  return changes;
}
inline int roots_between(const Poly& p, const mpq_class& from, const mpq_class& to) {
  return sign_sum(p, {1}, from, to);
}

/// A root of p: alone strictly between two numbers, or the number where these are equal; and the features that meet.
struct Time {
  Poly p;
  mpq_class from, to;
  Feature a{}, b{};
};

inline int sign_at(const Poly& q, const Time& t) {
  if (q.empty()) return 0;
  return t.from == t.to ? sgn(value(q, t.from)) : sign_sum(t.p, q, t.from, t.to);
}

/// The roots of a polynomial that is not zero in [0, 1], in no order.
inline std::vector<Time> roots(const Poly& p) {
  std::vector<Time> all;
  Poly rest = p;
  const auto take_out = [&](const mpq_class& x) {
    if (value(rest, x) != 0) return;
    all.push_back({{-x, 1}, x, x, {}, {}});
    while (value(rest, x) == 0) {
      Poly quotient(rest.size() - 1);
      mpq_class carry;
      for (std::size_t i = rest.size(); i-- > 1;) quotient[i - 1] = carry = rest[i] + carry * x;
      rest = quotient;
    }
  };
  const std::function<void(const mpq_class&, const mpq_class&)> split = [&](const mpq_class& from,
                                                                            const mpq_class& to) {
    const int count = roots_between(rest, from, to);
    if (count == 0) return;
    if (count == 1) return all.push_back({rest, from, to, {}, {}});
    const mpq_class middle = (from + to) / 2;
    take_out(middle);
    split(from, middle);
    split(middle, to);
  };
  take_out(0);
  take_out(1);
  split(0, 1);
  return all;
}

using Vec = std::array<Poly, 3>;
inline Vec moving(const Point3& p, const Point3& q) {
  const auto one = [](double x, double y) { return trimmed({mpq_class(x), mpq_class(y) - mpq_class(x)}); };
  return {one(p.x, q.x), one(p.y, q.y), one(p.z, q.z)};
}
inline Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Poly dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Poly det(const Vec& a, const Vec& b, const Vec& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}
inline Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Points of two features are near enough where `excess` is at most 0, `positive` above 0, the others at least 0.
struct Condition {
  Poly excess, positive;
  std::vector<Poly> others;
  Feature a, b;
};

inline std::vector<Condition> conditions(bool vertex_face, const std::array<Vec, 4>& p, const mpq_class& d) {
  using enum FeatureKind;
  const Poly square = trimmed({mpq_class(d * d)}), one{1};
  std::vector<Condition> all;
  const auto ends = [&](const Vec& a, const Vec& b, unsigned i, unsigned j) {
    all.push_back({dot(a - b, a - b) - square, one, {}, {vertex, i}, {vertex, j}});
  };
  const auto end_edge = [&](const Vec& a, const Vec& from, const Vec& to, Feature of_a, Feature of_b) {
    // Lagrange: |w x e|^2 = |w|^2 |e|^2 - (w.e)^2.
    const Vec w = a - from, e = to - from;
    const Poly ee = dot(e, e), we = dot(w, e);
    all.push_back({dot(w, w) * ee - we * we - square * ee, ee, {we, dot(to - a, e)}, of_a, of_b});
  };
  if (vertex_face) {
    for (unsigned i = 0; i < 3; ++i) ends(p[0], p[i + 1], 0, i);
    for (unsigned i = 0; i < 3; ++i) end_edge(p[0], p[i + 1], p[(i + 1) % 3 + 1], {vertex, 0}, {edge, i});
    const Vec n = cross(p[2] - p[1], p[3] - p[1]);
    const Poly gap = dot(n, p[0] - p[1]), nn = dot(n, n);
    Condition inside{gap * gap - square * nn, nn, {}, {vertex, 0}, {face, 0}};
    for (std::size_t i = 1; i < 4; ++i) inside.others.push_back(det(n, p[i % 3 + 1] - p[i], p[0] - p[i]));
    all.push_back(inside);
    return all;
  }
  for (unsigned i = 0; i < 4; ++i) ends(p[i / 2], p[2 + i % 2], i / 2, i % 2);
  for (unsigned i = 0; i < 2; ++i) end_edge(p[i], p[2], p[3], {vertex, i}, {edge, 0});
  for (unsigned i = 0; i < 2; ++i) end_edge(p[i + 2], p[0], p[1], {edge, 0}, {vertex, i});
  const Vec e = p[1] - p[0], f = p[3] - p[2], w = p[2] - p[0], n = cross(e, f);
  const Poly gap = dot(n, w), nn = dot(n, n), u = det(w, f, n), v = det(w, e, n);
  all.push_back({gap * gap - square * nn, nn, {u, nn - u, v, nn - v}, {edge, 0}, {edge, 0}});
  return all;
}

/// Every time in [0, 1] that may be the first and at which they meet, with the first features that are near enough.
inline std::vector<Time> contacts(bool vertex_face, const std::array<Point3, 4>& at_0,
                                  const std::array<Point3, 4>& at_1, double separation) {
  std::array<Vec, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = moving(at_0[i], at_1[i]);
  const std::vector<Condition> all = conditions(vertex_face, p, separation);
  std::vector<Time> times{{{0, 1}, 0, 0, {}, {}}};
  const auto add_roots = [&](const Poly& q) {
    if (q.size() < 2) return;
    for (const Time& t : roots(q)) times.push_back(t);
  };
  const Poly cubic = det(p[1] - p[0], p[2] - p[0], p[3] - p[0]);
  if (separation == 0 && !cubic.empty()) {
    add_roots(cubic);  // elsewhere the four points are in no plane
  } else {
    for (const Condition& c : all) {
      add_roots(c.excess);
      add_roots(c.positive);
      for (const Poly& q : c.others) add_roots(q);
    }
  }
  const auto apart = [&](Time& t) {
    const auto holds = [&](const Condition& c) {
      return sign_at(c.excess, t) <= 0 && sign_at(c.positive, t) > 0 &&
             std::ranges::all_of(c.others, [&](const Poly& q) { return sign_at(q, t) >= 0; });
    };
    const auto c = std::ranges::find_if(all, holds);
    if (c == all.end()) return true;
    t.a = c->a;
    t.b = c->b;
    return false;
  };
  std::erase_if(times, apart);
  return times;
}

/// Where is the time to a number: -1 before, 0 at it, 1 after.
inline int side(const Time& t, const mpq_class& x) {
  if (t.from == t.to) return cmp(t.from, x);
  if (x <= t.from) return 1;
  if (x >= t.to) return -1;
  if (value(t.p, x) == 0) return 0;
  return roots_between(t.p, t.from, x) == 1 ? -1 : 1;
}

}  // namespace plumb::lab::contact_judge
