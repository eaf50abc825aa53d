#include "figure/sphere/tangent_ball.hpp"

#include "arith/rounded_radical.hpp"

namespace plumb::figure::sphere {
namespace {

mpq_class dot(const Rationals& u, const Rationals& v) {
  mpq_class sum = 0;
  for (std::size_t a = 0; a < u.size(); ++a) sum += u[a] * v[a];
  return sum;
}

/// Solves rows = (matrix | two right-hand sides); false where the matrix is singular.
bool eliminate(std::vector<Rationals>& rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return false;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t j = n + 2; j-- > k;) rows[k][j] /= rows[k][k];
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpq_class factor = rows[i][k];
      for (std::size_t j = k; j < n + 2; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  return true;
}

}  // namespace

Sign TangentBall::sign(const mpq_class& a, const mpq_class& b) const {
  const mpq_class x = a + b * p_, y = b * q_;
  const int s = sgn(x), t = sgn(y) * sgn(d_);
  if (s == t || t == 0) return sign_of_number(s);
  if (s == 0) return sign_of_number(t);
  // x^2 against y^2 d without fractions in lowest terms, which cost most.
  const mpz_class left = x.get_num() * y.get_den(), right = y.get_num() * x.get_den();
  return sign_of_number(s * cmp(mpz_class(left * left * d_.get_den()), mpz_class(right * right * d_.get_num())));
}

std::optional<TangentBall> TangentBall::around(std::span<const RationalBall> balls) {
  const std::size_t n = balls.size() - 1, axes = balls[0].center.size();
  TangentBall ball;
  ball.first_ = balls[0];
  ball.u_.resize(axes), ball.v_.resize(axes);
  if (n == 0) return ball;
  std::vector<Rationals> e(n, Rationals(axes)), rows(n, Rationals(n + 2));
  Rationals s(n), h(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t a = 0; a < axes; ++a) e[i][a] = balls[i + 1].center[a] - balls[0].center[a];
    s[i] = balls[i + 1].radius - balls[0].radius;
    h[i] = (dot(e[i], e[i]) - s[i] * s[i]) / 2;
  }
  // y = sum w_i e_i with the weights w = f + g rho.
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(e[i], e[j]);
    rows[i][n] = h[i];
    rows[i][n + 1] = s[i];
  }
  if (!eliminate(rows)) return std::nullopt;
  Rationals f(n), g(n);
  mpq_class f_sum = 0, g_sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    f[i] = rows[i][n], g[i] = rows[i][n + 1];
    f_sum += f[i], g_sum += g[i];
    for (std::size_t a = 0; a < axes; ++a) ball.u_[a] += f[i] * e[i][a], ball.v_[a] += g[i] * e[i][a];
  }
  const auto fits = [&] {
    bool all = ball.sign(0, 1) != Sign::negative && ball.sign(1 - f_sum, -g_sum) == Sign::positive;
    for (std::size_t i = 0; i < n && all; ++i)
      all = ball.sign(-s[i], 1) != Sign::negative && ball.sign(f[i], g[i]) == Sign::positive;
    return all;
  };
  // |y|^2 = rho^2: a rho^2 + 2 b rho + c = 0.
  const mpq_class a = dot(g, s) - 1, b = dot(g, h), c = dot(f, h);
  if (a == 0) {
    if (b == 0) return std::nullopt;
    ball.p_ = -c / (2 * b);
    return fits() ? std::optional(ball) : std::nullopt;
  }
  ball.d_ = b * b - a * c;
  if (ball.d_ < 0) return std::nullopt;
  ball.p_ = -b / a;
  for (const int way : {-1, 1}) {
    ball.q_ = way / a;
    if (fits()) return ball;
  }
  return std::nullopt;
}

Sign TangentBall::side(const RationalBall& ball) const {
  Rationals e = ball.center;
  for (std::size_t a = 0; a < e.size(); ++a) e[a] -= first_.center[a];
  const mpq_class s = ball.radius - first_.radius;
  if (sign(-s, 1) == Sign::negative) return Sign::negative;
  // (rho - s)^2 - |y - e|^2, where |y|^2 = rho^2.
  return sign(s * s - dot(e, e) + 2 * dot(u_, e), 2 * (dot(v_, e) - s));
}

// With p, q, d the fractions of the radius, (first + u + v p) + v q sqrt(d) over one denominator.
double TangentBall::center(std::size_t axis) const {
  const mpq_class plain = first_.center[axis] + u_[axis] + v_[axis] * p_, times_root = v_[axis] * q_;
  const mpz_class over = times_root.get_den() * d_.get_den();
  return rounded_radical(Rounding::nearest, BigDyadic(mpz_class(plain.get_num() * over)),
                         BigDyadic(mpz_class(times_root.get_num() * plain.get_den())),
                         BigDyadic(mpz_class(d_.get_num() * d_.get_den())),
                         BigDyadic(mpz_class(plain.get_den() * over)));
}

}  // namespace plumb::figure::sphere
