#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "figure/sphere/ball_reach.hpp"
#include "figure/sphere/tangent_ball.hpp"
#include "figure/sphere/tangent_ball_guess.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/sphere/sphere.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

template <class Ball>
RationalBall rational(const Ball& ball) {
  RationalBall to;
  for (const double x : coordinates(ball.center)) to.center.emplace_back(x);
  to.radius = mpq_class(ball.radius);
  return to;
}

using Basis = std::vector<std::uint32_t>;

struct Held {
  Basis basis;
  TangentBall ball;
};

/// The smallest ball around those of the basis and p, which is not within theirs: p is in its basis, and what else is
/// is found by looking at all choices, the smaller first.
template <class Ball>
Held with(std::span<const Ball> balls, const Basis& old, std::uint32_t p) {
  std::vector<RationalBall> all;
  for (const std::uint32_t i : old) all.push_back(rational(balls[i]));
  const RationalBall last = rational(balls[p]);
  for (int count = 0; count <= static_cast<int>(last.center.size()); ++count) {
    for (unsigned chosen = 0; chosen < 1u << old.size(); ++chosen) {
      if (std::popcount(chosen) != count) continue;
      std::vector<RationalBall> taken{last};
      Basis basis{p};
      for (std::size_t i = 0; i < old.size(); ++i) {
        if ((chosen >> i & 1) != 0) taken.push_back(all[i]), basis.push_back(old[i]);
      }
      const auto ball = TangentBall::around(taken);
      const auto is_within = [&](const RationalBall& b) { return ball->side(b) != Sign::negative; };
      if (ball && std::ranges::all_of(all, is_within)) return {basis, *ball};
    }
  }
  std::abort();  // finitely many balls always have a smallest one around them
}

/// Distance and radius together, in doubles.
template <class Ball>
auto plain_reach(const decltype(Ball::center)& from, const Ball& ball) {
  return plus_given(root(square_of_distance(from, ball.center)), ball.radius);
}

template <class Ball>
class BallSearch {
 public:
  using Point = decltype(Ball::center);
  explicit BallSearch(std::span<const Ball> balls) : balls_(balls) {
    // As far as doubles tell; from there exact steps go on, and mostly there is none.
    const Basis guess = guess_touched(balls);
    std::vector<RationalBall> touched;
    for (const std::uint32_t i : guess) touched.push_back(rational(balls[i]));
    auto ball = TangentBall::around(touched);
    become(ball ? Held{guess, std::move(*ball)} : with(balls, {}, guess[0]));
  }

  /// Indices of the balls that the smallest ball touches.
  Basis run() {
    // Ends, for each turn but the last takes in a ball that is outside, exactly, and the one around it is larger: of
    // the finitely many that some of the balls hold none comes twice.
    for (;;) {
      double most = -1;
      std::uint32_t farthest = 0;
      for (std::uint32_t i = 0; i < balls_.size(); ++i) {
        const double r = plain_reach(center_, balls_[i]).value;
        if (r > most) most = r, farthest = i;
      }
      if (side(farthest) == Sign::negative) {
        become(with(balls_, held_.basis, farthest));
        continue;
      }
      Basis touched;
      if (look_at_all(touched)) return touched;
    }
  }

  [[nodiscard]] const Held& held() const { return held_; }
  [[nodiscard]] const Point& center() const { return center_; }

 private:
  [[nodiscard]] Sign side(std::uint32_t i) const { return held_.ball.side(rational(balls_[i])); }

  bool look_at_all(Basis& touched) {
    for (std::uint32_t i = 0; i < balls_.size(); ++i) {
      if (plain_reach(center_, balls_[i]).value <= certain_) continue;
      const Sign s = side(i);
      if (s == Sign::zero) touched.push_back(i);
      if (s == Sign::negative) {
        become(with(balls_, held_.basis, i));
        return false;
      }
    }
    return true;
  }

  void become(Held held) {
    held_ = std::move(held);
    auto c = coordinates(center_);
    Interval off(0);  // the rounded center off the exact one
    for (std::size_t a = 0; a < c.size(); ++a) {
      c[a] = held_.ball.center(a);
      off = off + Interval(Interval::step(c[a]));
    }
    center_ = std::apply([](auto... x) { return Point{x...}; }, c);
    // The exact radius is that of a touched ball; both reaches change by what the center is off.
    const auto reach = plain_reach(center_, balls_[held_.basis[0]]);
    certain_ = reach.certainly_within((Interval(reach.lower()) - off - off).lower);
  }

  std::span<const Ball> balls_;
  Held held_;
  Point center_{};
  double certain_ = -1;  // a ball of this plain reach or less is within
};

/// As of points: the touched ones in their order go around until all are within.
template <class Ball>
Basis support_of(std::span<const Ball> balls, Basis touched, const Basis& basis) {
  std::ranges::sort(touched, [&](std::uint32_t a, std::uint32_t b) {
    return comes_first(balls[a], balls[b]) || (balls[a] == balls[b] && a < b);
  });
  const auto equal = [&](std::uint32_t a, std::uint32_t b) { return balls[a] == balls[b]; };
  touched.erase(std::unique(touched.begin(), touched.end(), equal), touched.end());
  if (touched.size() == basis.size()) return touched;
  Held held = with(balls, {}, touched[0]);
  // Ends, for each ball is larger than the one before.
  for (std::size_t i = 0, in = 0; in < touched.size(); i = (i + 1) % touched.size(), ++in) {
    if (held.ball.side(rational(balls[touched[i]])) != Sign::negative) continue;
    held = with(balls, held.basis, touched[i]);
    in = 0;
  }
  std::ranges::sort(held.basis, [&](std::uint32_t a, std::uint32_t b) { return comes_first(balls[a], balls[b]); });
  return held.basis;
}

template <class Result, class Ball>
Result minimum(std::string_view function, std::string_view name, std::span<const Ball> balls, Ball Result::*round) {
  if (balls.empty())
    throw InvalidShape(std::string(function).append(": no ").append(name).append("; give at least one"));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball& b = balls[i];
    double none = b.radius - b.radius;
    for (const double x : coordinates(b.center)) none += x - x;
    if (none != 0 || b.radius < 0)
      require_ball(function, std::string(name).append("[").append(std::to_string(i)).append("]"), b);
  }
  BallSearch<Ball> search(balls);
  Basis touched = search.run();
  Result result{};
  result.support = support_of(balls, std::move(touched), search.held().basis);
  const auto& center = search.center();
  auto most = plain_reach(center, balls[0]);
  double radius = 0;
  for (const Ball& b : balls) most.value = std::max(most.value, plain_reach(center, b).value);
  const double certain = most.value < HUGE_VAL ? most.certainly_within(most.lower()) : -1;  // is not the farthest
  for (const Ball& b : balls) {
    if (plain_reach(center, b).value > certain) radius = std::max(radius, reach(center, b));
  }
  result.*round = {center, figure::within_doubles(radius, function, "radius")};
  return result;
}

}  // namespace
}  // namespace figure::sphere

MinimumCircleOfCircles minimum_circle(std::span<const Circle2> circles) {
  return figure::sphere::minimum("minimum_circle", "circles", circles, &MinimumCircleOfCircles::circle);
}
MinimumSphereOfSpheres minimum_sphere(std::span<const Sphere3> spheres) {
  return figure::sphere::minimum("minimum_sphere", "spheres", spheres, &MinimumSphereOfSpheres::sphere);
}

}  // namespace plumb
