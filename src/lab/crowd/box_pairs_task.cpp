// Which boxes overlap?  All pairs of a set.
#include <algorithm>
#include <memory>
#include <numeric>

#include "lab/crowd/crowds.hpp"
#include "lab/trial/float_methods.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb::lab::trial {
namespace {

InputClass boxes_spread(std::string name, std::string about, Spread spread) {
  return {std::move(name), std::move(about), [spread](std::span<double> q, Entropy& e) {
            const std::array<double, box_crowd_numbers> numbers{crowd_name(spread, e.below(1U << 30)), 0, 1, 2};
            std::ranges::copy(numbers, q.begin());
          }};
}

std::vector<InputClass> box_crowd_classes() {
  return {
      boxes_spread("uniform", "512 boxes in space, each meets some eight others", Spread::uniform),
      boxes_spread("clustered", "512 boxes in eight clusters", Spread::clustered),
      boxes_spread("sizes", "512 boxes of lengths from 1 to 1,000", Spread::sizes),
      boxes_spread("touching", "8 x 8 x 8 boxes side by side, which share the doubles of their walls",
                   Spread::touching),
      boxes_spread("off_by_ulps", "as touching, each side an ulp up or down, or not", Spread::nudged),
      boxes_spread("degenerate", "512 boxes of small integers, rectangles, segments and points among them",
                   Spread::degenerate),
      boxes_spread("far_away", "as uniform, a million from the origin", Spread::far),
  };
}

/// The answers in full are kept, for they are counted pair by pair.  Doubles are compared as they are, pair by pair.
class BoxPairJudge {
 public:
  const Pairs& pairs(std::span<const double> q) {
    const auto [at, is_new] = found_.try_emplace(key_of(q));
    if (!is_new) return at->second;
    const std::vector<Aabb3> boxes = box_crowd(at->first);
    const auto meet = [](const Aabb3& a, const Aabb3& b) {
      return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
             a.min.z <= b.max.z && b.min.z <= a.max.z;
    };
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t k = i + 1; k < boxes.size(); ++k) {
        if (meet(boxes[i], boxes[k])) at->second.push_back({i, k});
      }
    }
    return at->second;
  }

 private:
  std::map<MeshKey, Pairs> found_;
};

/// A box as common code keeps it: by its corners, or by its center and half of its lengths.
template <class T>
struct Corners {
  using Number = T;
  std::array<T, 3> low, high;

  explicit Corners(const Aabb3& b)
      : low{T(b.min.x), T(b.min.y), T(b.min.z)}, high{T(b.max.x), T(b.max.y), T(b.max.z)} {}
  [[nodiscard]] T from() const { return low[0]; }
  [[nodiscard]] T to() const { return high[0]; }
  [[nodiscard]] bool meets(const Corners& b) const {
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k) all = all && low[k] <= b.high[k] && b.low[k] <= high[k];
    return all;
  }
};
struct Centered {
  using Number = double;
  std::array<double, 3> center, half;
  double epsilon;

  Centered(const Aabb3& b, double about) : epsilon(about) {
    const std::array low{b.min.x, b.min.y, b.min.z}, high{b.max.x, b.max.y, b.max.z};
    for (std::size_t k = 0; k < 3; ++k) center[k] = (low[k] + high[k]) / 2, half[k] = (high[k] - low[k]) / 2;
  }
  [[nodiscard]] double from() const { return center[0] - half[0] - epsilon; }
  [[nodiscard]] double to() const { return center[0] + half[0]; }
  [[nodiscard]] bool meets(const Centered& b) const {
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k)
      all = all && magnitude(center[k] - b.center[k]) <= half[k] + b.half[k] + epsilon;
    return all;
  }
};

/// Sort and sweep along x, as commonly written.
template <class Box>
Pairs swept(const std::vector<Box>& boxes) {
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return boxes[i].from(); });
  Pairs pairs;
  for (std::size_t s = 0; s < order.size(); ++s) {
    const Box& a = boxes[order[s]];
    for (std::size_t t = s + 1; t < order.size() && boxes[order[t]].from() <= a.to(); ++t) {
      if (a.meets(boxes[order[t]])) pairs.push_back({std::min(order[s], order[t]), std::max(order[s], order[t])});
    }
  }
  return pairs;
}

/// `make` turns a box into another.
template <class Make>
Method swept_method(std::string name, std::string about, Make make) {
  return of_box_crowds(std::move(name), std::move(about), [make](const std::vector<Aabb3>& boxes) -> FindPairs {
    std::vector<std::invoke_result_t<Make, const Aabb3&>> made;
    for (const Aabb3& b : boxes) made.push_back(make(b));
    return [made] { return swept(made); };
  });
}

Method our_boxes(std::string name, std::string about, BroadPhaseMethod method) {
  return of_box_crowds(std::move(name), std::move(about), [method](const std::vector<Aabb3>& boxes) -> FindPairs {
    return [=] {
      const auto found = overlapping_pairs(boxes, BroadPhaseOptions{.execution = Execution::serial, .method = method});
      Pairs pairs(found.size());
      std::ranges::transform(found, pairs.begin(), [](const BoxPair& p) { return std::array{p.a, p.b}; });
      return pairs;
    };
  });
}

}  // namespace

Task box_pairs_task() {
  Task task{"box-pairs", "which boxes of a set overlap?", box_crowd_numbers, AnswerKind::set, {}, {}, {}, {}, 256};
  task.classes = box_crowd_classes();
  task.symmetries = {mesh_axes_in_turn(1, 0)};
  const auto judge = std::make_shared<BoxPairJudge>();
  task.judge = [judge](std::span<const double> q) { return as_answer(judge->pairs(q)); };
  task.tallies = {{"false pairs", "pairs that do not overlap and are named",
                   [judge](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(round.given_pairs(i), judge->pairs(q));
                   }},
                  {"missed pairs", "pairs that overlap and are not named",
                   [judge](std::span<const double> q, double, const Round& round, std::size_t i) {
                     return count_lacking(judge->pairs(q), round.given_pairs(i));
                   }}};
  task.methods.push_back(swept_method("float32", "sort and sweep in single precision, of corners rounded to it",
                                      [](const Aabb3& b) { return Corners<float>(b); }));
  task.methods.push_back(swept_method("double", "sort and sweep, of centers and half lengths",
                                      [](const Aabb3& b) { return Centered(b, 0); }));
  task.methods.push_back(swept_method("absolute", "double, with an epsilon of 1e-9",
                                      [](const Aabb3& b) { return Centered(b, customary_epsilon); }));
  task.methods.push_back(our_boxes("exact", "ours, the method that it chooses", BroadPhaseMethod::automatic));
  task.methods.push_back(our_boxes("columns", "ours, swept columns", BroadPhaseMethod::swept_columns));
  task.methods.push_back(our_boxes("sweep", "ours, sort and sweep along one axis", BroadPhaseMethod::sort_and_sweep));
  task.methods.push_back(our_boxes("brute-force", "ours, every pair", BroadPhaseMethod::brute_force));
  return task;
}

}  // namespace plumb::lab::trial
