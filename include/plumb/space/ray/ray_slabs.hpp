// Slab test: may a ray meet what is in a node's box, and from which parameter on?
//
//   const RaySlabs slabs(ray, tree);
//   double limit = slabs.limit();
//   descend_nearer_first(tree, limit, slabs, [&](std::uint32_t first, std::uint32_t count, double& now) {
//     ... now = std::min(now, slabs.limit_at(t));       // something is hit at t: what is farther may be left out
//   });
//
// Keys are parameters of the ray in the tree's own numbers: its frame's, with the direction scaled to about 1, and from
// the place on where a line, or a ray from far away, comes to the root's box.
// Laws: (1) slabs(node) is at most the key of every place where the ray meets the node's box, as real arithmetic has
// it; infinite, and so above every limit, only where it meets none.  (2) limit_at(t) is at least the key of every place
// at parameters up to t, and limit() that of all places of the ray; so what is left out where slabs(node) > limit holds no place at such a
// parameter.  (3) Rays without a direction are the points that they are.
// Of what numbers are too far apart for (beyond 2^1000 in the frame, or a tree whose boxes are infinite) nothing is told:
// every box is met.
// A plane's parameter is (place - from) rate.  `from` and `rate` are rounded outward by interval arithmetic, widened by
// the error constant that arith/bound.hpp derives from that formula; its guard is subtracted and added.  Comparisons of
// results then err to one side alone, because rounding is monotone.
// A ray that is NaN or infinite throws NonFinite.
// Source: RTCD 5.3.3, 6.3.1; for robustness Ize 2013.
// Cost: six subtractions and products a box; some 100 ns to make.  Nothing is searched.
#pragma once

#include <array>
#include <limits>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/space/bvh/box_tree.hpp"

namespace plumb {

struct SlabSetting;

class RaySlabs {
 public:
  RaySlabs(const AnyRay& ray, const BoxTree& tree) : RaySlabs(ray, tree.frame, tree.box()) {}
  /// Of a tree that has this frame, and all of whose boxes lie in this one.
  RaySlabs(const AnyRay& ray, const BoxFrame& frame, const FloatBox3& all);
  /// Of every ray, segment or line from a place to a place a direction farther, which are known to be in these balls; the
  /// laws hold for all of them.
  RaySlabs(AnyRay::Kind kind, const std::array<Ball, 3>& from, const std::array<Ball, 3>& way, const BoxTree& tree)
      : RaySlabs(kind, from, way, tree.frame, tree.box()) {}
  RaySlabs(AnyRay::Kind kind, const std::array<Ball, 3>& from, const std::array<Ball, 3>& way, const BoxFrame& frame,
           const FloatBox3& all);

  [[nodiscard]] double operator()(const BoxNode& node) const {
    if (all_met_) return -infinity;
    const Pair low = parameter<Pair>(two(node.min.data()), low_from_, low_rate_);
    const Pair high = parameter<Pair>(two(node.max.data()), high_from_, high_rate_);
    const Pair z = parameter<Pair>(Pair{node.min[2], node.max[2]}, z_from_, z_rate_);
    const Pair in = low < high ? low : high, out = low < high ? high : low;
    const double enters = larger(larger(in[0], in[1]), larger(lesser(z[0], z[1]), 0)) - underflow_guard;
    const double leaves = lesser(lesser(out[0], out[1]), larger(z[0], z[1])) + underflow_guard;
    return enters <= leaves ? enters : infinity;
  }

  /// The planes at the boxes' min and max, for who asks many boxes at once; a rate below 0 is that of a ray that goes down.
  struct Planes {
    std::array<double, 3> low_from, low_rate, high_from, high_rate;
    bool all_met;
  };
  [[nodiscard]] Planes planes() const {
    return {{low_from_[0], low_from_[1], z_from_[0]},
            {low_rate_[0], low_rate_[1], z_rate_[0]},
            {high_from_[0], high_from_[1], z_from_[1]},
            {high_rate_[0], high_rate_[1], z_rate_[1]},
            all_met_};
  }

  /// How keys and parameters go together, and the key of the ray's end.
  struct Keys {
    double limit = std::numeric_limits<double>::max();
    std::array<double, 2> starts{};  // together, where keys begin
    int exponent = 0;                // t = (key + starts) 2^exponent

    [[nodiscard]] double limit_at(double t) const {
      constexpr double most = std::numeric_limits<double>::max();
      if (exponent == 0 && starts[0] == 0) return t < most ? t : most;
      return moved_limit_at(t);
    }

   private:
    [[nodiscard]] double moved_limit_at(double t) const;
  };
  [[nodiscard]] const Keys& keys() const { return keys_; }

  /// Are numbers too far apart for any box to be left out?
  [[nodiscard]] bool all_met() const { return all_met_; }
  [[nodiscard]] double limit() const { return keys_.limit; }
  [[nodiscard]] double limit_at(double t) const { return keys_.limit_at(t); }

  /// The statement: where a ray from `from`, of which 1 / rate is the direction, is at `place`.
  template <class T, class Coordinate>
  static constexpr T parameter(Coordinate place, Coordinate from, Coordinate rate) {
    return (place - from) * rate;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  friend struct SlabSetting;
  void set(SlabSetting setting, bool begins, bool ends, const FloatBox3& all);

  /// Two numbers, of which one operation of the machine makes two others.
  using Pair = double __attribute__((vector_size(16)));
  static Pair two(const float* numbers) {
    float __attribute__((vector_size(8))) both;
    __builtin_memcpy(&both, numbers, sizeof both);
    return __builtin_convertvector(both, Pair);
  }
  static double larger(double a, double b) { return a > b ? a : b; }
  static double lesser(double a, double b) { return a < b ? a : b; }

  // Of the planes at a box's min and max, for x and y; for z both together.
  Pair low_from_{}, low_rate_{}, high_from_{}, high_rate_{}, z_from_{}, z_rate_{};
  bool all_met_ = false;
  Keys keys_;
};

}  // namespace plumb
