// Time of impact, Minkowski difference: where do two shapes in straight motion come nearest, and does the direction
// there keep them apart?
//
// Laws: what is searched for in plain doubles is a guess; apart_along is certain, whatever the direction.
// Source: RTCD 5.1.9, 5.5.2 (coordinate descent; Newton's method on the distance, which is convex in time).
// Cost: a dot product or two for each way, of a step and of a direction.
#pragma once

#include <cmath>
#include <cstddef>

#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {

/// Sums of sizes: of products with a direction, and so of their errors.
inline double size_of(const Vec3<double>& v) { return magnitude_of(v.x) + magnitude_of(v.y) + magnitude_of(v.z); }
inline double largest_of(const Vec3<double>& v) {
  const double x = magnitude_of(v.x), y = magnitude_of(v.y), z = magnitude_of(v.z);
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/// 32 units of 2^-53 of the sum of the sizes of all that is added, and no bound where a part of that may overflow: a
/// sum that was infinite would else be certain.
inline double doubt_of_sum(double sizes) { return sizes < 0x1p1000 ? sizes * 0x1p-48 : HUGE_VAL; }

/// Two shapes and how far they reach together, over any number type.
template <class N, class A, class B>
struct Moved {
  using HullA = decltype(hull_of<N>(std::declval<A>()));
  using HullB = decltype(hull_of<N>(std::declval<B>()));

  Moved(const Translating<A>& of_a, const Translating<B>& of_b)
      : a(hull_of<N>(of_a.shape)),
        b(hull_of<N>(of_b.shape)),
        by(velocity<N>(of_a.by, of_b.by)),
        apart(between<N>(a.place, b.place)),
        reach(N(reach_of(of_a.shape)) + N(reach_of(of_b.shape))) {}

  HullA a;
  HullB b;
  Vec3<N> by, apart;  // the motion of a, seen from b; from the place of a to that of b
  N reach;
};

/// In plain doubles: points of both and a time, which are guesses, and directions, which are proofs.
template <class A, class B>
class MotionSearch : public Moved<double, A, B> {
  using Both = Moved<double, A, B>;

 public:
  using Both::a, Both::b, Both::apart, Both::by, Both::reach;
  using typename Both::HullA, typename Both::HullB;

  MotionSearch(const Translating<A>& first, const Translating<B>& second) : Both(first, second), speed_(dot(by, by)) {
    size = size_of(apart) + size_of(by);
    for (std::size_t i = 0; i < HullA::way_count; ++i) size += size_of(a.way(i));
    for (std::size_t i = 0; i < HullB::way_count; ++i) size += size_of(b.way(i));
    between_them = apart + b.middle_point() - a.middle_point();
    move_in_time();
  }

  /// Do they surely stay beyond reach along the direction between the points?
  [[nodiscard]] bool apart_along() const {
    const Vec3<double>& n = between_them;
    const double square = dot(n, n);
    if (!(square > 0x1p-900 && square < 0x1p900)) return false;
    // Every number is off by 2 units of 2^-53 at most, a dot product by 3 more, at most nine of them are added, and the
    // length and its product with the reach are off by 4: below 20 units of the sum of all sizes.
    const double limit = reach > 0 ? reach * std::sqrt(square) : 0;
    const double off = doubt_of_sum(largest_of(n) * (size + 0x1p-900) + limit) + 0x1p-960;
    const double rest = ((dot(n, apart) + b.along(n).low) - a.along(n).high) - limit;
    return rest > off && rest - dot(n, by) > off;
  }
  /// Comes nearer by each way, one after the other.
  void sweep(bool in_time) {
    for (std::size_t i = 0; i < HullB::way_count; ++i) come_nearer(b, of_b, i, 1, between_them);
    for (std::size_t i = 0; i < HullA::way_count; ++i) come_nearer(a, of_a, i, -1, between_them);
    if (in_time) move_in_time();
  }
  /// The first time at which the distance is the reach, by Newton's method: it is convex in time.
  bool find_first() {
    time = 0;
    see();
    constexpr int most_steps = 20, most_sweeps = 12;
    for (int step = 0; step < most_steps; ++step) {
      for (int i = 0; i < most_sweeps; ++i) {
        const double before = dot(between_them, between_them);
        sweep(false);
        if (dot(between_them, between_them) >= before * (1 - 0x1p-48)) break;
      }
      see();
      const double distance = std::sqrt(dot(between_them, between_them)), closing = dot(between_them, by);
      if (!(closing > 0) || !(distance > reach * 0.5)) return false;
      const double wait = distance * (distance - reach) / closing;
      if (time == 0 && wait < 0) return false;
      time = within_time(time + wait);
      see();
      if (std::fabs(wait) <= time * 0x1p-44) return true;
    }
    return false;
  }

  double size = 0;  // of all coordinates together
  double time = 0;
  Parts of_a = HullA::middle(), of_b = HullB::middle();
  Vec3<double> between_them{};  // from the point of a to that of b, then

 private:
  void see() { between_them = (apart + b.at(of_b)) - (a.at(of_a) + by * time); }
  static double within_time(double t) { return t > 1 ? 1 : t > 0 ? t : 0; }
  void move_in_time() {
    if (!(speed_ > 0)) return;
    const double to = within_time(time + dot(between_them, by) / speed_), wait = to - time;
    time = to;
    between_them = between_them - by * wait;
  }

  double speed_;
};

}  // namespace plumb::query::quick
