// The smallest balls of integer boxes: eight corners on every one of them.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "lab/stability/float_ways.hpp"
#include "lab/stability/question_figures.hpp"
#include "lab/trial/ball_tests.hpp"
#include "plumb/degenerate/entropy.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb::lab::stability {
namespace {

constexpr std::size_t lattice_points = 27;
using BallPoints = std::array<double, 3 * lattice_points>;

struct Ball {
  std::array<double, 3> center;
  double radius;
  bool ended;
};
using BallWay = Way<std::tuple_size_v<BallPoints>, Ball>;

/// The corners of a box, the middles of its edges and sides, and its own, shuffled; integers, or tenths rounded.
struct Box {
  BallPoints points;
  mpq_class least;  // the square of the radius that it takes, but for rounding
};

Box box(Entropy& entropy, int bits, bool tenths) {
  Box b{};
  std::array<double, 3> low{}, half{};
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = static_cast<double>(entropy.within(std::int64_t{1} << bits));
    half[k] = static_cast<double>(1 + entropy.below(50));
    b.least += mpq_class(half[k]) * mpq_class(half[k]) / (tenths ? 100 : 1);
  }
  std::array<std::size_t, lattice_points> order{};
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
    std::swap(order[i], order[entropy.below(i + 1)]);
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::array<std::size_t, 3> step{order[i] % 3, order[i] / 3 % 3, order[i] / 9};
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = low[k] + half[k] * static_cast<double>(step[k]);
      b.points[3 * i + k] = tenths ? x / 10 : x;
    }
  }
  return b;
}

template <bool Pivots>
struct BallOfPoints {
  static constexpr int most_steps = 200;

  template <class T>
  Ball operator()(const std::array<T, std::tuple_size_v<BallPoints>>& q, T epsilon) const {
    std::vector<trial::Vec<T>> points, held;
    for (std::size_t i = 0; i < lattice_points; ++i) points.push_back(trial::vec(q, i));
    const trial::BallInNumbers<T> b = Pivots ? trial::pivoted<T>(points, epsilon, most_steps)
                                             : trial::welzl<T>(std::span<const trial::Vec<T>>(points), held, epsilon);
    const auto number = [](const T& x) { return static_cast<double>(x); };
    return {{number(b.center.x), number(b.center.y), number(b.center.z)},
            number(trial::square_root(T(b.square < 0 ? T(0) : b.square))),
            b.ended};
  }
};

Ball exact_ball(const BallPoints& q) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < q.size(); i += 3) points.push_back(point_at(&q[i]));
  const Sphere3 s = minimum_sphere(points).sphere;
  return {{s.center.x, s.center.y, s.center.z}, s.radius, true};
}

/// The square of the distance from the ball's center to the farthest point.
mpq_class farthest(const BallPoints& q, const Ball& ball) {
  mpq_class most = 0;
  for (std::size_t i = 0; i < q.size(); i += 3) {
    mpq_class sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class d = mpq_class(q[i + k]) - mpq_class(ball.center[k]);
      sum += d * d;
    }
    most = std::max(most, sum);
  }
  return most;
}

template <bool Pivots>
Findings balls(const Settings& settings, int bits, bool tenths) {
  std::vector<Box> boxes;
  for (std::uint64_t i = 0, n = settings.quick ? 150 : 5'000; i < n; ++i) {
    Entropy entropy(settings.seed, i);
    boxes.push_back(box(entropy, bits, tenths));
  }
  auto ways = float_ways<std::tuple_size_v<BallPoints>, Ball>(BallOfPoints<Pivots>{});
  ways.push_back({"exact", exact_ball, true});
  const mpq_class more = mpq_class(1'000'001, 1'000'000) * mpq_class(1'000'001, 1'000'000);  // a millionth, squared
  return {outcomes_of(ways,
                      [&](const BallWay& way) {
                        Count circles{"searches that came to no ball"};
                        Count out{"balls that leave a corner out"};
                        Count far_out{"balls that leave a corner out by more than a millionth"};
                        Count large{"balls larger than they need be by more than a millionth"};
                        for (const Box& b : boxes) {
                          const Ball ball = way.ask(b.points);
                          ++circles.of;
                          if (!ball.ended) ++circles.failures;
                          if (!ball.ended) continue;
                          ++out.of, ++far_out.of, ++large.of;
                          const bool number = std::isfinite(ball.center[0] + ball.center[1] + ball.center[2]) &&
                                              std::isfinite(ball.radius);
                          const mpq_class radius(number ? ball.radius : 0), square = radius * radius;
                          const mpq_class far = number ? farthest(b.points, ball) : mpq_class(1);
                          if (far > square) ++out.failures;
                          if (far > square * more) ++far_out.failures;
                          if (square > b.least * more) ++large.failures;
                        }
                        std::vector counts{out, far_out, large};
                        if (Pivots) counts.insert(counts.begin(), circles);
                        return counts;
                      }),
          {}};
}

}  // namespace

Experiment ball_experiment() {
  return {"smallest-balls", "does the smallest ball of a box hold its corners, and is it the smallest?", "RTCD 4.3.5",
          [](const Settings& settings) {
            return std::vector<Scene>{
                {"pivots", "27 points of an integer box; the farthest point joins, until none is outside",
                 [settings] { return balls<true>(settings, 4, false); }},
                {"pivots-in-tenths", "the same boxes in tenths, so that every coordinate rounds",
                 [settings] { return balls<true>(settings, 4, true); }},
                {"recursion", "the integer boxes by Welzl's recursion",
                 [settings] { return balls<false>(settings, 4, false); }},
                {"recursion-in-tenths", "the boxes in tenths by the recursion",
                 [settings] { return balls<false>(settings, 4, true); }},
                {"far-recursion", "boxes in tenths, up to a hundred thousand units from the origin",
                 [settings] { return balls<false>(settings, 20, true); }},
            };
          }};
}

}  // namespace plumb::lab::stability
