#include "lab/trial/branching_methods.hpp"
#include "lab/trial/lattice_method.hpp"
#include "lab/trial/rational_judge.hpp"
#include "lab/trial/segment_tests.hpp"
#include "plumb/query/overlap/overlap.hpp"

namespace plumb::lab::trial {
namespace {

struct SegmentAgainstSegment {
  template <class T>
  bool operator()(const std::array<T, 8>& q, T epsilon) const {
    return meet_by_signs(Segment<T>{{q[0], q[1]}, {q[2], q[3]}}, Segment<T>{{q[4], q[5]}, {q[6], q[7]}}, epsilon);
  }
};

}  // namespace

Task segment_segment_task() {
  Task task{"segment-segment", "do two segments of the plane meet?", 8, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(2, {2, 3, 0, 1}), reordered(2, {1, 0, 2, 3})};
  task.classes = shape_classes(2);
  task.judge = [](std::span<const double> q) {
    const auto point = [q](std::size_t i) { return RationalVec{mpq_class(q[2 * i]), mpq_class(q[2 * i + 1]), 0}; };
    return as_answer(meet({{point(0), point(1)}, {}}, {{point(2), point(3)}, {}}));
  };
  task.methods = branching_methods<AnswerKind::decision, 8>(SegmentAgainstSegment{});
  task.methods.push_back(lattice_method<8>(SegmentAgainstSegment{}));
  task.methods.push_back(
      exact_method<Segment2, Segment2>([](const auto& a, const auto& b) { return intersects(a, b); }));
  return task;
}

}  // namespace plumb::lab::trial
