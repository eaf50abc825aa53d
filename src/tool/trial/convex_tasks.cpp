#include <algorithm>

#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"
#include "query/convex/exact_gap.hpp"
#include "tool/trial/branching_methods.hpp"
#include "tool/trial/convex_tests.hpp"
#include "tool/trial/rational_judge.hpp"

namespace plumb::tool::trial {
namespace {

/// The least of all distances between points, edges and triangles of either set, unless the hulls meet.
mpq_class square_between_hulls(std::span<const double> q) {
  std::array<Generated, 2> sets;
  for (std::size_t i = 0; i < 2 * set_points; ++i) sets[i / set_points].points.push_back(rational_vec(q, i));
  if (meet(sets[0], sets[1])) return 0;
  const auto square = [](const RationalVec& v) { return mpq_class(dot(v, v)); };
  mpq_class least = square(sets[0].points[0] - sets[1].points[0]);
  const auto& a = sets[0].points;
  const auto& b = sets[1].points;
  for (std::size_t i = 0; i < set_points; ++i) {
    for (std::size_t j = i + 1; j < set_points; ++j) {
      for (std::size_t k = 0; k < set_points; ++k) {
        for (std::size_t l = k + 1; l < set_points; ++l)
          least = std::min(least, square_distance_of_segments(a[i], a[j], b[k], b[l]));
      }
      for (std::size_t k = j + 1; k < set_points; ++k) {
        for (const RationalVec& p : b) least = std::min(least, square_distance(p, a[i], a[j], a[k]));
        for (const RationalVec& p : a) least = std::min(least, square_distance(p, b[i], b[j], b[k]));
      }
    }
  }
  return least;
}

query::FlatSet set_at(const double* x) {
  return query::flat_set(
      Tetrahedron3{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}});
}

}  // namespace

Task convex_distance_task() {
  constexpr std::size_t numbers = 6 * set_points;
  Task task{
      "convex-distance", "how far apart are the hulls of 4 and 4 points?", numbers, AnswerKind::number, {}, {}, {}, {}};
  task.fewer = 8;
  task.symmetries = {reordered(3, {4, 5, 6, 7, 0, 1, 2, 3}), reordered(3, {3, 2, 1, 0, 5, 4, 7, 6})};
  task.judge = [](std::span<const double> q) { return nearest_root(square_between_hulls(q)); };
  task.classes = shape_classes(3);
  // Without what the squares of which overflow or vanish: that is the predicates' affair.
  std::erase_if(task.classes, [](const InputClass& c) { return c.name == "extreme"; });
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
        return rounded_root(Rounding::nearest, Rational(BigRational{*query::squared_distance(q.a, q.b)}));
      }));
  return task;
}

}  // namespace plumb::tool::trial
