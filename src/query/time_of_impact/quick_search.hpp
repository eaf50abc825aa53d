// Time of impact, Minkowski difference: where do two shapes in straight motion come nearest, and does the direction
// there keep them apart?
//
// Laws: what is searched for in plain doubles is a guess; apart_along is certain, whatever the direction
// (motion_directions.hpp).
// Source: RTCD 5.1.9, 5.5.2 (coordinate descent; Newton's method on the distance, which is convex in time).
// Cost: a dot product or two for each way, of a step and of a direction.
#pragma once

#include <cmath>
#include <cstddef>

#include "query/time_of_impact/motion_directions.hpp"

namespace plumb::query::quick {

/// In plain doubles: points of both and a time, which are guesses, and directions, which are proofs.
template <class A, class B>
class MotionSearch : public Moved<double, A, B> {
  using Both = Moved<double, A, B>;

 public:
  using Both::a, Both::b, Both::apart, Both::by, Both::reach;
  using typename Both::HullA, typename Both::HullB;

  MotionSearch(const Translating<A>& first, const Translating<B>& second) : Both(first, second), speed_(dot(by, by)) {
    size = size_of(apart) + size_of(by) + reach;
    for (std::size_t i = 0; i < HullA::way_count; ++i) size += size_of(a.way(i));
    for (std::size_t i = 0; i < HullB::way_count; ++i) size += size_of(b.way(i));
    between_them = apart + b.middle_point() - a.middle_point();
    move_in_time();
  }

  /// Do they surely stay beyond reach along the direction between the points?
  [[nodiscard]] bool apart_along() const {
    MotionWorld<> w;
    w.template number<0>(size), w.template number<1>(largest_of(between_them));
    return stays_beyond < Round<A> || Round < B >> (w, given<1>(between_them), known_motion(*this)) && w.certain();
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
    // Guesses at where to stop.
    constexpr int most_steps = 20, most_sweeps = 12;
    constexpr double no_nearer = 1 - 0x1p-48, still = 0x1p-44;
    for (int step = 0; step < most_steps; ++step) {
      for (int i = 0; i < most_sweeps; ++i) {
        const double before = dot(between_them, between_them);
        sweep(false);
        if (dot(between_them, between_them) >= before * no_nearer) break;
      }
      see();
      const double distance = std::sqrt(dot(between_them, between_them)), closing = dot(between_them, by);
      if (!(closing > 0) || !(distance > reach * 0.5)) return false;
      const double wait = distance * (distance - reach) / closing;
      if (time == 0 && wait < 0) return false;
      time = within_time(time + wait);
      see();
      if (std::fabs(wait) <= time * still) return true;
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
