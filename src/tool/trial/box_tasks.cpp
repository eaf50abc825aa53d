#include <algorithm>
#include <cmath>

#include "plumb/figure/aabb_relation.hpp"
#include "plumb/figure/obb.hpp"
#include "tool/trial/box_tests.hpp"
#include "tool/trial/float_methods.hpp"
#include "tool/trial/rational_judge.hpp"

namespace plumb::tool::trial {
namespace {

struct Boxes {
  Aabb3 a, b;
};
struct OrientedBoxes {
  Obb3 a, b;
};

/// From two corners in any order.
void in_order(std::span<double> q) {
  for (const std::size_t box : {0U, 6U}) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (q[box + k] > q[box + 3 + k]) std::swap(q[box + k], q[box + 3 + k]);
    }
  }
}

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

Obb3 box_at(const double* x) {
  return {{x[0], x[1], x[2]}, {{{x[3], x[4], x[5]}, {x[6], x[7], x[8]}, {x[9], x[10], x[11]}}}, {x[12], x[13], x[14]}};
}

}  // namespace

Task box_box_task() {
  Task task{"box-box", "do two boxes along the axes meet?", 12, AnswerKind::decision, {}, {}, {}, {}};
  task.symmetries = {reordered(3, {2, 3, 0, 1})};
  task.classes = refilled(shape_classes(3), in_order);
  task.judge = [](std::span<const double> q) {
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k) {
      all = all && mpq_class(q[k]) <= mpq_class(q[9 + k]) && mpq_class(q[6 + k]) <= mpq_class(q[3 + k]);
    }
    return as_answer(all);
  };
  task.methods = float_methods<12>(BoxAgainstBox{});
  task.methods.push_back(each_made<12>(
      "exact", "ours, one at a time",
      [](const std::array<double, 12>& q) {
        return Boxes{{{q[0], q[1], q[2]}, {q[3], q[4], q[5]}}, {{q[6], q[7], q[8]}, {q[9], q[10], q[11]}}};
      },
      [](const Boxes& q) { return intersects(q.a, q.b); }));
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
  task.methods = float_methods<30>(OrientedAgainstOriented{});
  task.methods.push_back(each_made<30>(
      "exact", "ours, one at a time",
      [](const std::array<double, 30>& q) {
        return OrientedBoxes{box_at(q.data()), box_at(&q[15])};
      },
      [](const OrientedBoxes& q) { return intersects(q.a, q.b); }));
  return task;
}

}  // namespace plumb::tool::trial
