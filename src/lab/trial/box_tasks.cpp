#include <algorithm>
#include <cmath>

#include "lab/trial/box_tests.hpp"
#include "lab/trial/branching_methods.hpp"
#include "lab/trial/lattice_method.hpp"
#include "lab/trial/rational_judge.hpp"
#include "plumb/figure/aabb/box_batch.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/obb/obb.hpp"

namespace plumb::lab::trial {
namespace {

class BoxPairs final : public Round {
 public:
  explicit BoxPairs(std::span<const double> questions)
      : a_(boxes(questions, 0)), b_(boxes(questions, 6)), meet_(questions.size() / 12) {}
  void answer() override { intersects(a_, b_, meet_); }
  [[nodiscard]] double given(std::size_t i) const override { return meet_[i]; }

 private:
  static BoxBatch boxes(std::span<const double> questions, std::size_t first) {
    std::vector<Aabb3> all;
    for (std::size_t i = first; i < questions.size(); i += 12) {
      const double* const x = &questions[i];
      all.push_back({{x[0], x[1], x[2]}, {x[3], x[4], x[5]}});
    }
    return BoxBatch(all);
  }
  const BoxBatch a_, b_;
  std::vector<std::uint8_t> meet_;
};

/// Both boxes, from two corners each in any order.
void boxes_in_order(std::span<double> q) { corners_in_order(q), corners_in_order(q.subspan(6)); }

double within_one(Entropy& entropy) { return static_cast<double>(entropy.within(std::int64_t{1} << 52)) * 0x1p-52; }

/// Three perpendicular axes of length one, as well as doubles can.
void fill_axes(std::span<double> nine, Entropy& entropy) {
  double w = within_one(entropy), x = within_one(entropy), y = within_one(entropy), z = within_one(entropy);
  const double length = std::sqrt(w * w + x * x + y * y + z * z);
  if (length == 0) w = 1;
  for (double* const c : {&w, &x, &y, &z}) *c = length == 0 ? *c : *c / length;
  const std::array rotation{1 - 2 * (y * y + z * z), 2 * (x * y + w * z),     2 * (x * z - w * y),
                            2 * (x * y - w * z),     1 - 2 * (x * x + z * z), 2 * (y * z + w * x),
                            2 * (x * z + w * y),     2 * (y * z - w * x),     1 - 2 * (x * x + y * y)};
  std::ranges::copy(rotation, nine.begin());
}

/// Boxes of random size, their centers within reach of each other.
void fill_turned(std::span<double> q, Entropy& entropy) {
  for (const std::size_t box : {0U, 15U}) {
    for (std::size_t k = 0; k < 3; ++k) {
      q[box + k] = 2 * within_one(entropy);
      q[box + 12 + k] = std::fabs(within_one(entropy));
    }
    fill_axes(q.subspan(box + 3, 9), entropy);
  }
}

/// The same axes twice, and the second box moved along one of them by the sum of the half sizes: it touches, but for
/// rounding.
void fill_stacked(std::span<double> q, Entropy& entropy) {
  fill_turned(q, entropy);
  std::ranges::copy(q.subspan(3, 9), q.begin() + 18);
  const std::size_t axis = entropy.below(3);
  for (std::size_t k = 0; k < 3; ++k) q[15 + k] = q[k] + q[3 + 3 * axis + k] * (q[12 + axis] + q[27 + axis]);
}

/// Integers, axes along the coordinates: touching is exact.
void fill_aligned(std::span<double> q, Entropy& entropy) {
  for (const std::size_t box : {0U, 15U}) {
    std::ranges::fill(q.subspan(box, 15), 0.0);
    const std::size_t turn = entropy.below(3);
    for (std::size_t k = 0; k < 3; ++k) {
      q[box + k] = static_cast<double>(entropy.within(4));
      q[box + 3 + 3 * k + (k + turn) % 3] = entropy.coin() ? 1 : -1;
      q[box + 12 + k] = static_cast<double>(entropy.below(4));
    }
  }
}

/// Axes along the coordinates but for one angle of some ulps: edges that are nearly parallel.
void fill_nearly_parallel(std::span<double> q, Entropy& entropy) {
  fill_aligned(q, entropy);
  const std::size_t i = entropy.below(9);
  q[18 + i] += static_cast<double>(entropy.within(8)) * 0x1p-53;
}

Generated corners(std::span<const double> q, std::size_t first) {
  const RationalVec center = rational_vec(q, first);
  Generated box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    RationalVec at = center;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const mpq_class half(q[3 * (first + 4) + axis]);
      at = at + rational_vec(q, first + 1 + axis) * mpq_class((corner >> axis & 1U) != 0 ? half : mpq_class(-half));
    }
    box.points.push_back(at);
  }
  return box;
}

}  // namespace

Task box_box_task() {
  Task task{"box-box", "do two boxes along the axes meet?", 12, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(3, {2, 3, 0, 1})};
  task.classes = refilled(shape_classes(3), boxes_in_order);
  task.judge = [](std::span<const double> q) {
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k) {
      all = all && mpq_class(q[k]) <= mpq_class(q[9 + k]) && mpq_class(q[6 + k]) <= mpq_class(q[3 + k]);
    }
    return as_answer(all);
  };
  task.methods = branching_methods<AnswerKind::decision, 12>(BoxAgainstBox{});
  task.methods.push_back(lattice_method<12>(BoxAgainstBox{}));
  task.methods.push_back(exact_method<Aabb3, Aabb3>(meet_exactly));
  task.methods.push_back({"batch", "ours, over spans, one thread",
                          [](std::span<const double> questions, const Scene&) -> std::unique_ptr<Round> {
                            return std::make_unique<BoxPairs>(questions);
                          }});
  return task;
}

Task oriented_boxes_task() {
  Task task{"obb-obb", "do two oriented boxes meet?", 30, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(3, {5, 6, 7, 8, 9, 0, 1, 2, 3, 4})};
  task.classes = {
      {"uniform", "turned at random", fill_turned},
      {"stacked", "of the same axes, touching but for rounding", fill_stacked},
      {"aligned", "integers, axes along the coordinates", fill_aligned},
      {"nearly_parallel", "as aligned, one axis of the second off by ulps", fill_nearly_parallel},
  };
  task.judge = [](std::span<const double> q) { return as_answer(meet(corners(q, 0), corners(q, 5))); };
  task.methods = branching_methods<AnswerKind::decision, 30>(OrientedAgainstOriented{});
  task.methods.push_back(exact_method<Obb3, Obb3>(meet_exactly));
  return task;
}

}  // namespace plumb::lab::trial
