#include "figure/sphere/tangent_ball_guess.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "plumb/certify/sign_of.hpp"

namespace plumb::figure::sphere {
namespace {

constexpr int most_steps = 100;
// Guesses: what does not reach beyond a ball by more than this part of it counts as within: of the balls that held the last one,
// and of all others.
constexpr double of_basis = 0x1p-40, of_all = 0x1p-46;

template <std::size_t N>
struct Plain {
  std::array<double, N> center;
  double radius;
};
template <std::size_t N>
using Some = std::array<Plain<N>, N + 2>;
using Basis = std::vector<std::uint32_t>;

template <class Ball>
auto plain(const Ball& ball) {
  const auto c = coordinates(ball.center);
  return Plain<c.size()>{c, ball.radius};
}

template <std::size_t N>
double reach(const std::array<double, N>& from, const Plain<N>& ball) {
  double sum = 0;
  for (std::size_t a = 0; a < N; ++a) sum += (from[a] - ball.center[a]) * (from[a] - ball.center[a]);
  return std::sqrt(sum) + ball.radius;
}

/// As TangentBall::around.
template <std::size_t N>
std::optional<Plain<N>> around(const Some<N>& balls, std::size_t count) {
  const std::size_t n = count - 1;
  Plain<N> ball = balls[0];
  if (n == 0) return ball;
  std::array<std::array<double, N>, N> e{};
  std::array<std::array<double, N + 2>, N> rows{};
  std::array<double, N> s{}, h{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t a = 0; a < N; ++a) e[i][a] = balls[i + 1].center[a] - balls[0].center[a];
    s[i] = balls[i + 1].radius - balls[0].radius;
  }
  const auto dot = [](const auto& u, const auto& v) {
    double sum = 0;
    for (std::size_t a = 0; a < N; ++a) sum += u[a] * v[a];
    return sum;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) rows[i][j] = dot(e[i], e[j]);
    h[i] = (rows[i][i] - s[i] * s[i]) / 2;
    rows[i][N] = h[i], rows[i][N + 1] = s[i];
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (!(rows[k][k] > 0)) return {};
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double by = rows[i][k] / rows[k][k];
      for (std::size_t j = 0; j < N + 2; ++j) rows[i][j] -= by * rows[k][j];
    }
  }
  std::array<double, N> f{}, g{};
  for (std::size_t i = 0; i < n; ++i) f[i] = rows[i][N] / rows[i][i], g[i] = rows[i][N + 1] / rows[i][i];
  const double a = dot(g, s) - 1, b = dot(g, h), c = dot(f, h), root = std::sqrt(std::max(b * b - a * c, 0.0));
  for (const double rho : {(-b - root) / a, (-b + root) / a}) {
    double rest = 1;
    bool fits = rho >= 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double weight = f[i] + g[i] * rho;
      rest -= weight;
      fits = fits && weight > 0 && rho >= s[i];
    }
    if (!fits || !(rest > 0)) continue;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < N; ++k) ball.center[k] += (f[i] + g[i] * rho) * e[i][k];
    }
    ball.radius += rho;
    return ball;
  }
  return {};
}

/// The basis of the old one and p, which is beyond its ball; false where doubles find none.
template <std::size_t N>
bool take_in(std::vector<Plain<N>>& basis, Basis& indices, const Plain<N>& p, std::uint32_t index, Plain<N>& ball) {
  const std::size_t old = basis.size();
  for (int count = 0; count <= static_cast<int>(N); ++count) {
    for (unsigned chosen = 0; chosen < 1u << old; ++chosen) {
      if (std::popcount(chosen) != count) continue;
      Some<N> some{p};
      std::size_t taken = 1;
      for (std::size_t i = 0; i < old; ++i) {
        if ((chosen >> i & 1u) != 0) some[taken++] = basis[i];
      }
      const auto found = around<N>(some, taken);
      if (!found) continue;
      const double most = found->radius * (1 + of_basis);
      if (!std::ranges::all_of(basis, [&](const Plain<N>& b) { return reach(found->center, b) <= most; })) continue;
      Basis kept{index};
      for (std::size_t i = 0; i < old; ++i) {
        if ((chosen >> i & 1u) != 0) kept.push_back(indices[i]);
      }
      basis.assign(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(taken));
      indices = std::move(kept);
      ball = *found;
      return true;
    }
  }
  return false;
}

template <class Ball>
Basis guess(std::span<const Ball> balls) {
  const auto largest = std::ranges::max_element(balls, {}, &Ball::radius);
  Basis indices{static_cast<std::uint32_t>(largest - balls.begin())};
  auto ball = plain(*largest);
  std::vector basis{ball};
  for (int step = 0; step < most_steps; ++step) {
    double most = -1;
    std::uint32_t farthest = 0;
    for (std::uint32_t i = 0; i < balls.size(); ++i) {
      const double r = reach(ball.center, plain(balls[i]));
      if (r > most) most = r, farthest = i;
    }
    if (!(most > ball.radius * (1 + of_all)) || std::ranges::find(indices, farthest) != indices.end()) break;
    if (!take_in(basis, indices, plain(balls[farthest]), farthest, ball)) break;
  }
  return indices;
}

}  // namespace

Basis guess_touched(std::span<const Circle2> balls) { return guess(balls); }
Basis guess_touched(std::span<const Sphere3> balls) { return guess(balls); }

}  // namespace plumb::figure::sphere
