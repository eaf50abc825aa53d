// Constructs points in rationals: lines and planes as equations, solved by Cramer's rule.
#include <mpfr.h>

#include <array>
#include <stdexcept>

#include "oracle/constructed.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/predicates/in_sphere.hpp"
#include "plumb/predicates/orient.hpp"

namespace plumb::oracle {
namespace {

using Vector = std::vector<mpq_class>;
using Numbers = std::span<const double>;

Vector exact(Numbers x) { return {x.begin(), x.end()}; }

mpq_class dot(const Vector& a, const Vector& b) {
  mpq_class sum;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}
Vector difference(const Vector& a, const Vector& b) {
  Vector d(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return d;
}

/// a . x = b, row by row.
struct System {
  std::vector<Vector> a;
  Vector b;
};

mpq_class determinant(std::vector<Vector> m) {  // by elimination
  mpq_class d = 1;
  for (std::size_t k = 0; k < m.size(); ++k) {
    std::size_t r = k;
    while (r < m.size() && m[r][k] == 0) ++r;
    if (r == m.size()) return 0;
    if (r != k) {
      std::swap(m[r], m[k]);
      d = -d;
    }
    d *= m[k][k];
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const mpq_class f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= f * m[k][j];
    }
  }
  return d;
}

std::optional<Vector> solve(const System& s) {
  const mpq_class d = determinant(s.a);
  if (d == 0) return {};
  Vector x;
  for (std::size_t k = 0; k < s.b.size(); ++k) {
    std::vector<Vector> m = s.a;
    for (std::size_t i = 0; i < m.size(); ++i) m[i][k] = s.b[i];
    x.emplace_back(determinant(m) / d);
  }
  return x;
}

void add_line(System& s, Numbers line) {
  const Vector a = exact(line.first(2)), u = difference(exact(line.subspan(2, 2)), a);
  s.a.push_back({u[1], -u[0]});
  s.b.push_back(dot(s.a.back(), a));
}

void add_plane(System& s, Numbers plane) {
  const Vector a = exact(plane.first(3));
  const Vector u = difference(exact(plane.subspan(3, 3)), a), v = difference(exact(plane.subspan(6, 3)), a);
  s.a.push_back({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]});
  s.b.push_back(dot(s.a.back(), a));
}

Vector on_segment(Numbers x, std::size_t dimension) {
  Vector p = exact(x.first(dimension));
  const Vector u = difference(exact(x.subspan(dimension, dimension)), p);
  for (std::size_t i = 0; i < dimension; ++i) p[i] += mpq_class(x.back()) * u[i];
  return p;
}

Vector posed(Numbers x, std::size_t dimension) {
  Vector p = exact(x.last(dimension));
  for (std::size_t column = 0; column < dimension; ++column) {
    for (std::size_t i = 0; i < dimension; ++i) {
      p[i] += mpq_class(x[(column + 1) * dimension + i]) * mpq_class(x[column]);
    }
  }
  return p;
}

std::optional<Vector> construct(const Constructed& point) {
  const Numbers x = point.numbers;
  System s;
  switch (point.by) {
    case Construction::explicit2:
    case Construction::explicit3:
      return exact(x);
    case Construction::line_line2:
      add_line(s, x.first(4));
      add_line(s, x.last(4));
      return solve(s);
    case Construction::three_plane3:
      for (const std::size_t i : {0u, 9u, 18u}) add_plane(s, x.subspan(i, 9));
      return solve(s);
    case Construction::line_plane3: {
      add_plane(s, x.last(9));
      const Vector p = exact(x.first(3)), u = difference(exact(x.subspan(3, 3)), p);
      const mpq_class slope = dot(s.a[0], u);
      if (slope == 0) return {};
      const mpq_class t = (s.b[0] - dot(s.a[0], p)) / slope;
      return Vector{p[0] + t * u[0], p[1] + t * u[1], p[2] + t * u[2]};
    }
    case Construction::segment2:
    case Construction::segment3:
      return on_segment(x, x.size() / 2);
    case Construction::posed2:
      return posed(x, 2);
    case Construction::posed3:
      return posed(x, 3);
  }
  return {};
}

template <class F>
Sign run(const std::vector<Vector>& points) {
  std::array<BigRational, static_cast<std::size_t>(F::points * F::dimension)> p;
  std::size_t i = 0;
  for (const Vector& point : points) {
    for (const mpq_class& x : point) p[i++].value = x;
  }
  return F{}(p).sign();
}

}  // namespace

std::optional<Sign> rational_sign(Question question, std::span<const Constructed> points) {
  std::vector<Vector> exact_points;
  for (const Constructed& point : points) {
    const std::optional<Vector> p = construct(point);
    if (!p) return {};
    exact_points.push_back(*p);
  }
  const std::size_t dimension = exact_points.at(0).size();
  if (question == Question::orient) {
    return dimension == 2 ? run<predicates::Orient2d>(exact_points) : run<predicates::Orient3d>(exact_points);
  }
  return dimension == 2 ? run<predicates::InCircle>(exact_points) : run<predicates::InSphere>(exact_points);
}

std::optional<Order> rational_order(const Constructed& p, const Constructed& q) {
  const std::optional<Vector> a = construct(p), b = construct(q);
  if (!a || !b) return {};
  for (std::size_t i = 0; i < a->size(); ++i) {
    const int sign = cmp((*a)[i], (*b)[i]);
    if (sign != 0) return Order{sign_of_number(sign), static_cast<int>(i)};
  }
  return Order{Sign::zero, static_cast<int>(a->size())};
}

std::optional<Nearest> nearest_coordinate(const Constructed& point, int axis) {
  const std::optional<Vector> p = construct(point);
  if (!p) return {};
  // MPFR rounds a rational once, also to subnormal numbers when told of them.
  const mpfr_exp_t lowest = mpfr_get_emin(), highest = mpfr_get_emax();
  mpfr_set_emin(-1073);
  mpfr_set_emax(1024);
  mpfr_t x;
  mpfr_init2(x, 53);
  const int direction = mpfr_set_q(x, (*p)[static_cast<std::size_t>(axis)].get_mpq_t(), MPFR_RNDN);
  mpfr_subnormalize(x, direction, MPFR_RNDN);
  const Nearest nearest{mpfr_get_d(x, MPFR_RNDN), mpfr_inf_p(x) != 0};
  mpfr_clear(x);
  mpfr_set_emin(lowest);
  mpfr_set_emax(highest);
  return nearest;
}

}  // namespace plumb::oracle
