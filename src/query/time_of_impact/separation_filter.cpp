#include "query/time_of_impact/separation_filter.hpp"

#include <cstddef>
#include <utility>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"
#include "query/time_of_impact/moving_hulls.hpp"
#include "query/time_of_impact/separation_time.hpp"
#include "query/time_of_impact/vector_length.hpp"

namespace plumb::query::moving {
namespace {

using T = Approximate;
using V = Vec3<double>;
using quick::come_nearer;

template <template <class> class Figures>
class Filter {
  using HullA = typename Figures<double>::HullA;
  using HullB = typename Figures<double>::HullB;

 public:
  Filter(const ContactQuestion& question, double separation)
      : question_(question),
        quick_(question),
        sure_(question),
        separation_(separation),
        differences_(differences(question)) {}

  ContactVerdict answer() {
    Pieces waiting;
    waiting.push(0, 1);
    bool doubt = false;
    for (int steps = 0; waiting.any(); ++steps) {
      const auto [from, to] = waiting.pop();
      const double middle = 0.5 * (from + to);
      find_nearest(middle);
      if (within(middle)) return ContactVerdict::yes;
      if (beyond(from, to)) continue;
      if (to - from <= finest || steps > most_steps) {
        doubt = true;
        continue;
      }
      waiting.push(middle, to);
      waiting.push(from, middle);
    }
    return doubt ? ContactVerdict::unsure : ContactVerdict::no;
  }

  /// The first time, and the features that are at the distance then.
  NearContact first() {
    find_nearest(0);
    if (within(0)) return contact_at_start<Figures>(sure_, of_a_, of_b_);
    Pieces waiting;
    waiting.push(0, 1);
    double sure_by = 2, tried = widest_tried;
    for (int steps = 0; waiting.any(); ++steps) {
      const auto [from, to] = waiting.pop();
      if (to == sure_by && to - from <= tried) {
        tried = (to - from) * next_tried;
        find_nearest(0.5 * (from + to));
        const NearContact c = first_contact_within<Figures>(question_, separation_, {from, to}, of_a_, of_b_);
        if (c.verdict == ContactVerdict::yes) return c;
      }
      const double middle = 0.5 * (from + to);
      find_nearest(middle);
      const bool near = within(middle);
      if (!near && beyond(from, to)) continue;
      if (to - from <= finest || steps > most_steps) return {};
      if (near) {
        sure_by = middle;
        waiting.clear();
        waiting.push(from, middle);
        continue;
      }
      waiting.push(middle, to);
      waiting.push(from, middle);
    }
    return {ContactVerdict::no, {}};
  }

 private:
  // Guesses at what pays.
  static constexpr double finest = 0x1p-30, widest_tried = 0x1p-6, next_tried = 0x1p-5;
  static constexpr int most_steps = 100;

  /// Of time, the next one last.
  class Pieces {
   public:
    void push(double from, double to) { all_[count_++] = {from, to}; }
    std::pair<double, double> pop() { return all_[--count_]; }
    void clear() { count_ = 0; }
    [[nodiscard]] bool any() const { return count_ > 0; }

   private:
    std::array<std::pair<double, double>, 40> all_;  // one for each size
    std::size_t count_ = 0;
  };
  static constexpr std::size_t of_a = HullA::way_count + 1, of_b = 4 - of_a, count = of_a * of_b;  // vertices, pairs

  /// Of all vertices of one and the other.
  static std::array<Linear<T>, count> differences(const ContactQuestion& q) {
    if constexpr (of_a == 2) {
      return {linear<T>(q, 0, 2), linear<T>(q, 0, 3), linear<T>(q, 1, 2), linear<T>(q, 1, 3)};
    } else {
      return {linear<T>(q, 0, 1), linear<T>(q, 0, 2), linear<T>(q, 0, 3)};
    }
  }
  /// The points that are nearest at a time, from where they were.
  void find_nearest(double time) {
    const Moment when{time};
    const HullA a = quick_.hull_a(when);
    const HullB b = quick_.hull_b(when);
    nearest_ = (when(quick_.apart) + b.at(of_b_)) - a.at(of_a_);
    constexpr int sweeps = 6;
    for (int k = 0; k < sweeps; ++k) {
      for (std::size_t i = 0; i < HullB::way_count; ++i) come_nearer(b, of_b_, i, 1, nearest_);
      for (std::size_t i = 0; i < HullA::way_count; ++i) come_nearer(a, of_a_, i, -1, nearest_);
    }
  }
  /// Are they surely within the distance at a time?
  [[nodiscard]] bool within(double time) const {
    if (!(dot(nearest_, nearest_) < separation_ * separation_)) return false;
    const Moment when{time};
    const Vec3<T> d = (when(sure_.apart) + sure_.hull_b(when).at(of_b_)) - sure_.hull_a(when).at(of_a_);
    return certain_sign(T(separation_) * T(separation_) - dot(d, d)) > 0;
  }
  /// Do all differences reach beyond the distance along the nearest one, from one time to another?
  [[nodiscard]] bool beyond(double from, double to) const {
    const Vec3<T> n = arith::vec<T>(nearest_);
    const T needed = T(separation_) * T(length_above(n));
    bool all = true;
    for (const Linear<T>& d : differences_) {
      const T at_0 = dot(n, d.at_0), at_1 = dot(n, d.at_1);
      all &= certain_sign((at_0 * T(1 - from) + at_1 * T(from)) - needed) > 0;
      all &= certain_sign((at_0 * T(1 - to) + at_1 * T(to)) - needed) > 0;
    }
    return all;
  }

  const ContactQuestion& question_;
  Figures<double> quick_;
  Figures<T> sure_;
  double separation_;
  std::array<Linear<T>, count> differences_;
  quick::Parts of_a_ = HullA::middle();
  quick::Parts of_b_ = HullB::middle();
  V nearest_{};
};

}  // namespace

void require_separation(std::string_view function, double separation) {
  require_finite_parts(function, {"options.separation"}, separation);
  if (separation < 0)
    throw InvalidShape(std::string(function).append(
        ": options.separation is negative; give a distance, zero for figures that are to touch"));
}

ContactVerdict separation_filter(const ContactQuestion& question, double separation) {
  return question.kind == MovingKind::edge_edge ? Filter<Edges>(question, separation).answer()
                                                : Filter<VertexAndTriangle>(question, separation).answer();
}

NearContact first_near_contact(const ContactQuestion& question, double separation) {
  return question.kind == MovingKind::edge_edge ? Filter<Edges>(question, separation).first()
                                                : Filter<VertexAndTriangle>(question, separation).first();
}

}  // namespace plumb::query::moving
