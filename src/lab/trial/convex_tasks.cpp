#include <algorithm>
#include <cmath>

#include "arith/exact_number.hpp"
#include "lab/trial/branching_methods.hpp"
#include "lab/trial/convex_tests.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/query/gjk/gjk.hpp"
#include "query/convex/exact_gap.hpp"

namespace plumb::lab::trial {
namespace {

constexpr std::size_t set_points = 4, meeting_points = 8;

std::array<Generated, 2> sets_of(std::span<const double> q) {
  std::array<Generated, 2> sets;
  const std::size_t points = q.size() / 3;
  for (std::size_t i = 0; i < points; ++i) sets[2 * i / points].points.push_back(rational_vec(q, i));
  return sets;
}

query::FlatSet set_at(const double* x) {
  return query::flat_set(
      Tetrahedron3{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}});
}

/// What overflows or vanishes when it is squared is the predicates' affair.
std::vector<InputClass> convex_classes() {
  std::vector<InputClass> classes = shape_classes(3);
  std::erase_if(classes, [](const InputClass& c) { return c.name == "extreme"; });
  return classes;
}

std::vector<Point3> points_at(const double* x, std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
  return points;
}

/// The second set moved along x, half of the time: sets that are spread as widely hardly ever are apart.
void move_second(std::span<double> q) {
  double least = q[0], most = q[0];
  for (std::size_t i = 0; i < q.size(); i += 3) least = std::min(least, q[i]), most = std::max(most, q[i]);
  // By a sum, which rounds: what was degenerate then is nearly so.  Of integers it is exact.
  const double by = (q[1] < q[4] ? 0.625 : 1) * (most - least);
  if (!(q[2] < q[5]) || !std::isfinite(most + by)) return;
  for (std::size_t i = q.size() / 2; i < q.size(); i += 3) q[i] += by;
}

}  // namespace

Task convex_meeting_task() {
  constexpr std::size_t numbers = 6 * meeting_points;
  Task task{"convex-convex", "do the hulls of 8 and 8 points meet?", numbers, AnswerKind::decision, {}, {}, {}, {}};
  task.fewer = 8;
  std::vector<std::size_t> others, turned;
  for (std::size_t i = 0; i < 2 * meeting_points; ++i) {
    others.push_back((i + meeting_points) % (2 * meeting_points));
    turned.push_back(i < meeting_points ? meeting_points - 1 - i : i);
  }
  task.symmetries = {reordered(3, others), reordered(3, turned)};
  task.judge = [](std::span<const double> q) {
    const std::array<Generated, 2> sets = sets_of(q);
    return as_answer(meet(sets[0], sets[1]));
  };
  task.classes = refilled(convex_classes(), move_second);
  task.methods = branching_methods<AnswerKind::decision, numbers>(ConvexMeeting{});
  using Hulls = std::array<std::vector<Point3>, 2>;
  task.methods.push_back(each_made<numbers>(
      "exact", "ours, one at a time",
      [](const std::array<double, numbers>& q) {
        return Hulls{points_at(q.data(), meeting_points), points_at(&q[numbers / 2], meeting_points)};
      },
      [](const Hulls& q) { return gjk_intersects(VertexHull3{q[0]}, VertexHull3{q[1]}); }));
  return task;
}

Task convex_distance_task() {
  constexpr std::size_t numbers = 6 * set_points;
  Task task{
      "convex-distance", "how far apart are the hulls of 4 and 4 points?", numbers, AnswerKind::number, {}, {}, {}, {}};
  task.fewer = 8;
  task.symmetries = {reordered(3, {4, 5, 6, 7, 0, 1, 2, 3}), reordered(3, {3, 2, 1, 0, 5, 4, 7, 6})};
  task.judge = [](std::span<const double> q) {
    const std::array<Generated, 2> sets = sets_of(q);
    return nearest_root(square_between_hulls(sets[0].points, sets[1].points));
  };
  task.classes = convex_classes();
  task.methods = branching_methods<AnswerKind::number, numbers>(ConvexDistance{});
  struct Question {
    query::FlatSet a, b;
  };
  task.methods.push_back(each_made<numbers>(
      "exact", "ours, one at a time",
      [](const std::array<double, numbers>& q) {
        return Question{set_at(q.data()), set_at(&q[3 * set_points])};
      },
      [](const Question& q) {
        return rounded_root(Rounding::nearest, exact_number(*query::squared_distance(q.a, q.b)));
      }));
  return task;
}

}  // namespace plumb::lab::trial
