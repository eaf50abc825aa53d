#include <utility>

#include "lab/trial/box_tests.hpp"
#include "lab/trial/branching_methods.hpp"
#include "lab/trial/distance_tests.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"

namespace plumb::lab::trial {
namespace {

/// Without what the squares of which overflow or vanish: that is the predicates' affair.
std::vector<InputClass> distance_classes() {
  std::vector<InputClass> classes = shape_classes(3);
  std::erase_if(classes, [](const InputClass& c) { return c.name == "extreme"; });
  return classes;
}

/// The box after the point, from two corners in any order.
void box_in_order(std::span<double> q) { corners_in_order(q.subspan(3)); }

Task asked(std::string name, std::string question, std::size_t numbers, std::vector<Symmetry> symmetries,
           mpq_class (*square)(std::span<const double> question)) {
  Task task{std::move(name), std::move(question), numbers, AnswerKind::number, {}, {}, {}, {}};
  task.symmetries = std::move(symmetries);
  task.judge = [square](std::span<const double> q) { return nearest_root(square(q)); };
  task.classes = distance_classes();
  return task;
}

}  // namespace

Task point_segment_distance_task() {
  Task task = asked("point-segment-distance", "how far is a point from a segment?", 9, {reordered(3, {0, 2, 1})},
                    [](std::span<const double> q) {
                      return square_distance(rational_vec(q, 0), rational_vec(q, 1), rational_vec(q, 2));
                    });
  task.methods = branching_methods<AnswerKind::number, 9>(PointSegmentDistance{});
  task.methods.push_back(exact_method<Point3, Segment3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

Task point_box_distance_task() {
  const Symmetry turned{{1, 2, 0, 4, 5, 3, 7, 8, 6}, 1};  // the axes
  Task task = asked("point-box-distance", "how far is a point from a box?", 9, {turned}, [](std::span<const double> q) {
    mpq_class sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const mpq_class off = q[k] < q[3 + k] ? mpq_class(q[3 + k]) - q[k] : mpq_class(q[k]) - q[6 + k];
      if (off > 0) sum += off * off;
    }
    return sum;
  });
  task.classes = refilled(std::move(task.classes), box_in_order);
  task.methods = branching_methods<AnswerKind::number, 9>(PointBoxDistance{});
  task.methods.push_back(exact_method<Point3, Aabb3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

Task point_triangle_distance_task() {
  Task task =
      asked("point-triangle-distance", "how far is a point from a triangle?", 12,
            {reordered(3, {0, 2, 3, 1}), reordered(3, {0, 1, 3, 2})}, [](std::span<const double> q) {
              return square_distance(rational_vec(q, 0), rational_vec(q, 1), rational_vec(q, 2), rational_vec(q, 3));
            });
  task.methods = branching_methods<AnswerKind::number, 12>(PointTriangleDistance{});
  task.methods.push_back(exact_method<Point3, Triangle3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

Task segment_segment_distance_task() {
  Task task = asked("segment-segment-distance", "how far are two segments apart?", 12,
                    {reordered(3, {2, 3, 0, 1}), reordered(3, {1, 0, 2, 3})}, [](std::span<const double> q) {
                      return square_distance_of_segments(rational_vec(q, 0), rational_vec(q, 1), rational_vec(q, 2),
                                                         rational_vec(q, 3));
                    });
  task.methods = branching_methods<AnswerKind::number, 12>(SegmentSegmentDistance{});
  task.methods.push_back(exact_method<Segment3, Segment3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

}  // namespace plumb::lab::trial
