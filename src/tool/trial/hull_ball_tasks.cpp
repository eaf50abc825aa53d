#include <algorithm>
#include <bit>
#include <cstdint>

#include "plumb/figure/hull2.hpp"
#include "plumb/figure/minimum_sphere.hpp"
#include "tool/trial/float_methods.hpp"
#include "tool/trial/rational_judge.hpp"

namespace plumb::tool::trial {
namespace {

constexpr std::size_t hull_points = 16, ball_points = 5;

/// Which points are corners, as a set of bits; of equal points the first.
struct HullOfPoints {
  template <class T>
  double operator()(const std::array<T, 2 * hull_points>& q, T epsilon) const {
    std::array<std::size_t, hull_points> order{};
    for (std::size_t i = 0; i < hull_points; ++i) order[i] = i;
    const auto x = [&](std::size_t i) { return q[2 * i]; };
    const auto y = [&](std::size_t i) { return q[2 * i + 1]; };
    std::ranges::sort(order, [&](std::size_t i, std::size_t j) {
      return x(i) != x(j) ? x(i) < x(j) : y(i) != y(j) ? y(i) < y(j) : i < j;
    });
    const auto same = [&](std::size_t i, std::size_t j) { return x(i) == x(j) && y(i) == y(j); };
    const auto last = std::unique(order.begin(), order.end(), same);
    std::uint32_t corners = 0;
    std::vector<std::size_t> chain;
    const auto add = [&](std::size_t i) {
      const auto turns_left = [&] {
        const std::size_t a = chain[chain.size() - 2], b = chain.back();
        return T((x(b) - x(a)) * (y(i) - y(a)) - (y(b) - y(a)) * (x(i) - x(a))) > epsilon;
      };
      while (chain.size() >= 2 && !turns_left()) chain.pop_back();
      chain.push_back(i);
    };
    const auto take = [&] {
      for (const std::size_t i : chain) corners |= std::uint32_t{1} << i;
      chain.clear();
    };
    std::for_each(order.begin(), last, add);
    take();
    std::for_each(std::make_reverse_iterator(last), order.rend(), add);
    take();
    return corners;
  }
};

std::uint32_t corners_of(std::span<const Point2> points) {
  std::uint32_t corners = 0;
  for (const std::uint32_t vertex : convex_hull(points).vertices) {
    const auto first = std::ranges::find(points, points[vertex]) - points.begin();
    corners |= std::uint32_t{1} << first;
  }
  return corners;
}

/// The same chain, of which in rationals nothing is rounded.
double corners_in_rationals(std::span<const double> q) {
  std::array<mpq_class, 2 * hull_points> exact;
  std::ranges::transform(q, exact.begin(), [](double x) { return mpq_class(x); });
  return HullOfPoints{}(exact, mpq_class(0));
}

/// The ball through some points whose center lies in their hull's plane; false where they span less.
template <class T>
bool through(std::span<const Vec<T>> p, Vec<T>& center, T& square) {
  center = p[0];
  if (p.size() == 2) {
    center = (p[0] + p[1]) * T(T(1) / T(2));
  } else if (p.size() == 3) {
    const Vec<T> u = p[1] - p[0], v = p[2] - p[0], n = cross(u, v);
    const T whole = 2 * dot(n, n);
    if (whole == 0) return false;
    center = p[0] + (cross(n, u) * dot(v, v) + cross(v, n) * dot(u, u)) * T(1 / whole);
  } else if (p.size() == 4) {
    const Vec<T> u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
    const T whole = 2 * dot(u, cross(v, w));
    if (whole == 0) return false;
    center = p[0] + (cross(v, w) * dot(u, u) + cross(w, u) * dot(v, v) + cross(u, v) * dot(w, w)) * T(1 / whole);
  }
  const Vec<T> r = p[0] - center;
  square = dot(r, r);
  return true;
}

/// The least of the balls through two, three or four of the points, or one, that hold all.
template <class T>
T least_square(const std::array<Vec<T>, ball_points>& p, const T& slack) {
  bool any = false;
  T least{};
  for (unsigned set = 1; set < (1U << ball_points); ++set) {
    const auto of_set = [set](std::size_t i) { return (set >> i & 1U) != 0; };
    const auto count = static_cast<std::size_t>(std::popcount(set));
    if (count > 4) continue;
    std::array<Vec<T>, 4> of{};
    for (std::size_t i = 0, next = 0; i < ball_points; ++i) {
      if (of_set(i)) of[next++] = p[i];
    }
    Vec<T> center{};
    T square{};
    if (!through<T>(std::span(of).first(count), center, square) || (any && square >= least)) continue;
    bool holds = true;  // those that it goes through are held whatever rounding says
    for (std::size_t i = 0; i < ball_points && holds; ++i) {
      const Vec<T> d = p[i] - center;
      holds = of_set(i) || dot(d, d) <= square + slack;
    }
    if (!holds) continue;
    least = square;
    any = true;
  }
  return least;
}

struct BallOfPoints {
  template <class T>
  double operator()(const std::array<T, 3 * ball_points>& q, T epsilon) const {
    std::array<Vec<T>, ball_points> p{};
    for (std::size_t i = 0; i < ball_points; ++i) p[i] = vec(q, i);
    return static_cast<double>(square_root(least_square(p, epsilon)));
  }
};

}  // namespace

Task hull2_task() {
  Task task{
      "hull-2d", "which of 16 points are the corners of their hull?", 2 * hull_points, AnswerKind::decision, {}, {}, {},
      {}};
  task.classes = shape_classes(2);
  task.judge = corners_in_rationals;
  task.methods = float_methods<2 * hull_points>(HullOfPoints{});
  task.methods.push_back(each_made<2 * hull_points>(
      "exact", "ours, one hull at a time",
      [](const std::array<double, 2 * hull_points>& q) {
        std::vector<Point2> points;
        for (std::size_t i = 0; i < q.size(); i += 2) points.push_back({q[i], q[i + 1]});
        return points;
      },
      [](const std::vector<Point2>& points) { return static_cast<double>(corners_of(points)); }));
  return task;
}

Task smallest_ball_task() {
  Task task{"smallest-ball",
            "how large is the smallest ball of 5 points?",
            3 * ball_points,
            AnswerKind::number,
            {},
            {},
            {},
            {}};
  task.symmetries = {reordered(3, {4, 3, 2, 1, 0})};
  task.classes = shape_classes(3);
  // Without those that may hold points farther apart than doubles reach.
  std::erase_if(task.classes, [](const InputClass& c) { return c.name == "extreme" || c.name == "repeated"; });
  task.judge = [](std::span<const double> q) {
    std::array<RationalVec, ball_points> p{};
    for (std::size_t i = 0; i < ball_points; ++i) p[i] = rational_vec(q, i);
    return nearest_root(least_square(p, mpq_class(0)));
  };
  task.methods = float_methods<3 * ball_points>(BallOfPoints{});
  task.methods.push_back(each_made<3 * ball_points>(
      "exact", "ours, one ball at a time",
      [](const std::array<double, 3 * ball_points>& q) {
        std::vector<Point3> points;
        for (std::size_t i = 0; i < q.size(); i += 3) points.push_back({q[i], q[i + 1], q[i + 2]});
        return points;
      },
      [](const std::vector<Point3>& points) { return radius(Rounding::nearest, minimum_sphere(points).exact); }));
  return task;
}

}  // namespace plumb::tool::trial
