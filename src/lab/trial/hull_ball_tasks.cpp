#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "lab/trial/ball_tests.hpp"
#include "lab/trial/branching_methods.hpp"
#include "lab/trial/hull_tests.hpp"
#include "lab/trial/lattice_method.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/figure/hull/hull2.hpp"
#include "plumb/figure/hull/hull3.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"

namespace plumb::lab::trial {
namespace {

constexpr std::size_t ball_points = 5;

template <class Point, std::size_t N>
std::vector<Point> points_of(const std::array<double, N>& q) {
  std::vector<Point> points(N * sizeof(double) / sizeof(Point));
  std::memcpy(points.data(), q.data(), sizeof(q));
  return points;
}

template <class Point>
double corners_of(const std::vector<Point>& points) {
  std::uint32_t corners = 0;
  for (const std::uint32_t vertex : convex_hull(std::span(points)).vertices) {
    const auto first = std::ranges::find(points, points[vertex]) - points.begin();
    corners |= std::uint32_t{1} << first;
  }
  return corners;
}

template <std::size_t N, class Point>
Method exact_hull() {
  return each_made<N>("exact", "ours, one hull at a time", points_of<Point, N>, corners_of<Point>);
}

/// Each point's coordinates change places: the same points are corners.
Symmetry axes_in_turn(std::size_t dimension, std::size_t points) {
  Symmetry s{{}, 1};
  for (std::size_t i = 0; i < points * dimension; ++i)
    s.from.push_back(static_cast<std::uint8_t>(i - i % dimension + (i + 1) % dimension));
  return s;
}

/// Each point is a corner that is not in the hull of the others.
double corners_by_definition(const std::vector<RationalVec>& p) {
  std::uint32_t corners = 0;
  const auto same = [](const RationalVec& a, const RationalVec& b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto is_same = [&](const RationalVec& other) { return same(p[i], other); };
    if (std::any_of(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(i), is_same)) continue;
    Generated others;
    std::ranges::remove_copy_if(p, std::back_inserter(others.points), is_same);
    if (others.points.empty() || !meet({{p[i]}, {}}, others)) corners |= std::uint32_t{1} << i;
  }
  return corners;
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
    return root_as_double(least_square(p, epsilon));
  }
};

}  // namespace

Task hull2_task() {
  constexpr std::size_t numbers = 2 * hull_points;
  Task task{"hull-2d", "which of 16 points are the corners of their hull?", numbers, AnswerKind::set, {}, {}, {}, {}};
  task.symmetries = {axes_in_turn(2, hull_points)};
  task.classes = shape_classes(2);
  task.fewer = 8;
  task.judge = [](std::span<const double> q) {
    std::vector<RationalVec> points;
    for (std::size_t i = 0; i < q.size(); i += 2)
      points.push_back({mpq_class(q[i]), mpq_class(q[i + 1]), mpq_class(0)});
    return corners_by_definition(points);
  };
  task.methods = branching_methods<AnswerKind::set, numbers>(HullInPlane{});
  task.methods.push_back(lattice_method<numbers>(HullInPlane{}));
  task.methods.push_back(exact_hull<numbers, Point2>());
  return task;
}

Task hull3_task() {
  constexpr std::size_t numbers = 3 * hull3_points;
  Task task{"hull-3d", "which of 12 points are the corners of their hull?", numbers, AnswerKind::set, {}, {}, {}, {}};
  task.symmetries = {axes_in_turn(3, hull3_points)};
  task.classes = shape_classes(3);
  task.fewer = 8;
  task.judge = [](std::span<const double> q) {
    std::vector<RationalVec> points;
    for (std::size_t i = 0; i < hull3_points; ++i) points.push_back(rational_vec(q, i));
    return corners_by_definition(points);
  };
  task.methods = branching_methods<AnswerKind::set, numbers>(HullInSpace{});
  task.methods.push_back(lattice_method<numbers>(HullInSpace{}));
  task.methods.push_back(exact_hull<numbers, Point3>());
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
  task.fewer = 4;
  task.symmetries = {reordered(3, {4, 3, 2, 1, 0})};
  task.classes = shape_classes(3);
  // Without those that may hold points farther apart than doubles reach.
  std::erase_if(task.classes, [](const InputClass& c) { return c.name == "extreme" || c.name == "repeated"; });
  task.judge = [](std::span<const double> q) {
    std::array<RationalVec, ball_points> p{};
    for (std::size_t i = 0; i < ball_points; ++i) p[i] = rational_vec(q, i);
    return nearest_root(least_square(p, mpq_class(0)));
  };
  task.methods = branching_methods<AnswerKind::number, 3 * ball_points>(BallOfPoints{});
  task.methods.push_back(each_made<3 * ball_points>(
      "exact", "ours, one ball at a time", points_of<Point3, 3 * ball_points>,
      [](const std::vector<Point3>& points) { return radius(Rounding::nearest, minimum_sphere(points).exact); }));
  return task;
}

}  // namespace plumb::lab::trial
