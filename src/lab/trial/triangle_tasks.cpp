#include <algorithm>
#include <bit>

#include "lab/trial/branching_methods.hpp"
#include "lab/trial/rational_judge.hpp"
#include "lab/trial/triangle_tests.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/batch.hpp"

namespace plumb::lab::trial {
namespace {

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

/// One ray or segment against the triangles of all questions.
template <class One>
class OneAgainstMany final : public Round {
 public:
  OneAgainstMany(const One& one, std::span<const Triangle3> many) : one_(one), many_(many), hit_(many.size()) {}
  void answer() override { hits(one_, many_, hit_); }
  [[nodiscard]] double given(std::size_t i) const override { return hit_[i]; }

 private:
  const AnyRay one_;
  const TriangleBatch many_;
  std::vector<std::uint8_t> hit_;
};

/// The batch, and a class that it can be asked: the same ray or segment in all questions.
template <class One>
void add_batch(Task& task) {
  task.classes.push_back({"one_for_all", "small integers, and in all questions the same ray or segment",
                          [](std::span<double> q, Entropy& entropy) {
                            constexpr std::array<double, 6> one{-3, 1, 0, 2, -1, 0};
                            for (double& x : q) x = static_cast<double>(entropy.within(2));
                            std::ranges::copy(one, q.begin());
                          }});
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            std::vector<Triangle3> many;
                            for (const auto& q : questions_in<double, 15>(questions)) {
                              if (!std::ranges::equal(std::span(q).first(6), questions.first(6))) return nullptr;
                              std::array<double, 9> triangle{};
                              std::ranges::copy(std::span(q).last(9), triangle.begin());
                              many.push_back(std::bit_cast<Triangle3>(triangle));
                            }
                            std::array<double, 6> one{};
                            std::ranges::copy(questions.first(6), one.begin());
                            return std::make_unique<OneAgainstMany<One>>(std::bit_cast<One>(one), many);
                          }});
}

}  // namespace

Task ray_triangle_task() {
  Task task = asked("ray-triangle", "does a ray hit a triangle?", 15,
                    {reordered(3, {0, 1, 3, 4, 2}), reordered(3, {0, 1, 2, 4, 3})}, [](std::span<const double> q) {
                      return meet({{rational_vec(q, 0)}, {rational_vec(q, 1)}}, triangle_at(q, 2));
                    });
  task.classes = refilled(shape_classes(3), toward);
  task.methods = branching_methods<AnswerKind::decision, 15>(RayAgainstTriangle<false>{});
  task.methods.push_back(exact_method<Ray3, Triangle3>(meet_exactly));
  add_batch<Ray3>(task);
  return task;
}

Task segment_triangle_task() {
  Task task = asked("segment-triangle", "does a segment meet a triangle?", 15,
                    {reordered(3, {1, 0, 2, 3, 4}), reordered(3, {0, 1, 3, 4, 2})}, [](std::span<const double> q) {
                      return meet({{rational_vec(q, 0), rational_vec(q, 1)}, {}}, triangle_at(q, 2));
                    });
  task.classes = shape_classes(3);
  task.methods = branching_methods<AnswerKind::decision, 15>(RayAgainstTriangle<true>{});
  task.methods.push_back(exact_method<Segment3, Triangle3>(meet_exactly));
  add_batch<Segment3>(task);
  return task;
}

Task triangle_triangle_task() {
  Task task = asked("triangle-triangle", "do two triangles meet?", 18,
                    {reordered(3, {3, 4, 5, 0, 1, 2}), reordered(3, {1, 2, 0, 3, 5, 4})},
                    [](std::span<const double> q) { return meet(triangle_at(q, 0), triangle_at(q, 3)); });
  task.classes = shape_classes(3);
  task.methods = branching_methods<AnswerKind::decision, 18>(TriangleAgainstTriangle{});
  task.methods.push_back(exact_method<Triangle3, Triangle3>(meet_exactly));
  return task;
}

}  // namespace plumb::lab::trial
