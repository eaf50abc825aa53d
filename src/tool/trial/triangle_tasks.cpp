#include "plumb/query/overlap.hpp"
#include "tool/trial/float_methods.hpp"
#include "tool/trial/rational_judge.hpp"
#include "tool/trial/triangle_tests.hpp"

namespace plumb::tool::trial {
namespace {

Triangle3 triangle_at(const double* x) { return {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, {x[6], x[7], x[8]}}; }

Generated triangle_at(std::span<const double> q, std::size_t first) {
  return {{rational_vec(q, first), rational_vec(q, first + 1), rational_vec(q, first + 2)}, {}};
}

/// The task without its methods and classes.
Task asked(std::string name, std::string question, std::size_t numbers, std::vector<Symmetry> symmetries,
           bool (*judge)(std::span<const double> question)) {
  Task task{std::move(name), std::move(question), numbers, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = std::move(symmetries);
  task.judge = [judge](std::span<const double> q) { return as_answer(judge(q)); };
  return task;
}

/// From the first point toward the second.
void toward(std::span<double> q) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double d = q[3 + axis] - q[axis];
    q[3 + axis] = d - d == 0 ? d : q[3 + axis];
  }
}

}  // namespace

Task ray_triangle_task() {
  Task task = asked("ray-triangle", "does a ray hit a triangle?", 15,
                    {reordered(3, {0, 1, 3, 4, 2}), reordered(3, {0, 1, 2, 4, 3})}, [](std::span<const double> q) {
                      return meet({{rational_vec(q, 0)}, {rational_vec(q, 1)}}, triangle_at(q, 2));
                    });
  task.classes = refilled(shape_classes(3), toward);
  task.methods = float_methods<15>(RayAgainstTriangle<false>{});
  struct Question {
    Ray3 ray;
    Triangle3 triangle;
  };
  task.methods.push_back(each_made<15>(
      "exact", "ours, one at a time",
      [](const std::array<double, 15>& q) {
        return Question{{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}}, triangle_at(&q[6])};
      },
      [](const Question& q) { return intersects(q.ray, q.triangle); }));
  return task;
}

Task segment_triangle_task() {
  Task task = asked("segment-triangle", "does a segment meet a triangle?", 15,
                    {reordered(3, {1, 0, 2, 3, 4}), reordered(3, {0, 1, 3, 4, 2})}, [](std::span<const double> q) {
                      return meet({{rational_vec(q, 0), rational_vec(q, 1)}, {}}, triangle_at(q, 2));
                    });
  task.classes = shape_classes(3);
  task.methods = float_methods<15>(RayAgainstTriangle<true>{});
  struct Question {
    Segment3 segment;
    Triangle3 triangle;
  };
  task.methods.push_back(each_made<15>(
      "exact", "ours, one at a time",
      [](const std::array<double, 15>& q) {
        return Question{{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}}, triangle_at(&q[6])};
      },
      [](const Question& q) { return intersects(q.segment, q.triangle); }));
  return task;
}

Task triangle_triangle_task() {
  Task task = asked("triangle-triangle", "do two triangles meet?", 18,
                    {reordered(3, {3, 4, 5, 0, 1, 2}), reordered(3, {1, 2, 0, 3, 5, 4})},
                    [](std::span<const double> q) { return meet(triangle_at(q, 0), triangle_at(q, 3)); });
  task.classes = shape_classes(3);
  task.methods = float_methods<18>(TriangleAgainstTriangle{});
  struct Question {
    Triangle3 a, b;
  };
  task.methods.push_back(each_made<18>(
      "exact", "ours, one at a time",
      [](const std::array<double, 18>& q) {
        return Question{triangle_at(q.data()), triangle_at(&q[9])};
      },
      [](const Question& q) { return intersects(q.a, q.b); }));
  return task;
}

}  // namespace plumb::tool::trial
