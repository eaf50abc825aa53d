#include "figure/obb/frame_volume.hpp"

#include <algorithm>
#include <cmath>

#include "arith/running_error.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/interval.hpp"

namespace plumb::figure::frame {
namespace {

using arith::cross, arith::dot, arith::vec, arith::Vec;

Running rough(const Ball& x) { return {x.high, Ball::widened(std::fabs(x.low) + x.radius)}; }

// The greatest of what is added, known no better than what cannot be told apart from it.
class Greatest {
 public:
  void add(const Ball& x) {
    const Ball more = x - greatest_;
    const Unsure<Sign> sign = more.sign();
    if (is_empty_ || (sign.certain() && sign.value() == Sign::positive)) {
      greatest_ = x;
      is_empty_ = false;
    } else if (!sign.certain()) {
      greatest_.radius = Ball::widened(greatest_.radius + std::fabs(more.high) + std::fabs(more.low) + more.radius);
    }
  }
  [[nodiscard]] const Ball& operator()() const { return greatest_; }

 private:
  Ball greatest_{0};
  bool is_empty_ = true;
};

double above(const Ball& x) { return Interval::sum_up(x.high, Interval::sum_up(x.low, x.radius)); }

}  // namespace

RightAngle right_angle(const std::array<Vector3, 3>& axes) {
  const auto first = vec<Ball>(axes[0]), beside = vec<Ball>(axes[1]);
  return {first, beside * dot(first, first) - first * dot(first, beside)};
}

double volume_above(const FlushArcs& flush, const RightAngle& axes) {
  const auto& [first, second] = axes;
  Ball volume(1);
  std::vector<Interval> far(flush.vertices.size(), Interval(0));
  for (const Vec<Ball>& axis : {first, second, cross(first, second)}) {
    const Vec<Running> n{rough(axis.x), rough(axis.y), rough(axis.z)};
    Interval least(Interval::infinity), most(-Interval::infinity);
    for (std::size_t i = 0; i < far.size(); ++i) {
      const Vector3& v = flush.vertices[i];
      const auto at = [&](double x) { return Running(x, flush.vertex_error); };
      const Running along = dot(Vec<Running>{at(v.x), at(v.y), at(v.z)}, n);
      far[i] = {along.lower(), along.upper()};
      least = {std::min(least.lower, far[i].lower), std::min(least.upper, far[i].upper)};
      most = {std::max(most.lower, far[i].lower), std::max(most.upper, far[i].upper)};
    }
    Greatest ahead, behind;
    for (std::size_t i = 0; i < far.size(); ++i) {
      if (far[i].lower > least.upper && far[i].upper < most.lower) continue;
      const Ball along = dot(flush.places[i], axis);
      ahead.add(along);
      behind.add(Ball(0) - along);
    }
    volume = volume * (ahead() + behind());
  }
  return above(quotient(volume, dot(first, first) * dot(second, second)));
}

}  // namespace plumb::figure::frame
