#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "tool/trial/branching_methods.hpp"
#include "tool/trial/distance_tests.hpp"
#include "tool/trial/rational_judge.hpp"

namespace plumb::tool::trial {
namespace {

/// Without what the squares of which overflow or vanish: that is the predicates' affair.
std::vector<InputClass> distance_classes() {
  std::vector<InputClass> classes = shape_classes(3);
  std::erase_if(classes, [](const InputClass& c) { return c.name == "extreme"; });
  return classes;
}

Task asked(std::string name, std::string question, std::vector<Symmetry> symmetries,
           mpq_class (*square)(std::span<const double> question)) {
  Task task{std::move(name), std::move(question), 12, AnswerKind::number, {}, {}, {}, {}};
  task.symmetries = std::move(symmetries);
  task.judge = [square](std::span<const double> q) { return nearest_root(square(q)); };
  task.classes = distance_classes();
  return task;
}

}  // namespace

Task point_triangle_distance_task() {
  Task task =
      asked("point-triangle-distance", "how far is a point from a triangle?",
            {reordered(3, {0, 2, 3, 1}), reordered(3, {0, 1, 3, 2})}, [](std::span<const double> q) {
              return square_distance(rational_vec(q, 0), rational_vec(q, 1), rational_vec(q, 2), rational_vec(q, 3));
            });
  task.methods = branching_methods<AnswerKind::number, 12>(PointTriangleDistance{});
  task.methods.push_back(exact_method<Point3, Triangle3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

Task segment_segment_distance_task() {
  Task task = asked("segment-segment-distance", "how far are two segments apart?",
                    {reordered(3, {2, 3, 0, 1}), reordered(3, {1, 0, 2, 3})}, [](std::span<const double> q) {
                      return square_distance_of_segments(rational_vec(q, 0), rational_vec(q, 1), rational_vec(q, 2),
                                                         rational_vec(q, 3));
                    });
  task.methods = branching_methods<AnswerKind::number, 12>(SegmentSegmentDistance{});
  task.methods.push_back(exact_method<Segment3, Segment3>([](const auto& a, const auto& b) { return distance(a, b); }));
  return task;
}

}  // namespace plumb::tool::trial
