// Points rounded, and how far off, for what stays apart; integers for all else.
#include "query/time_of_impact/posed_motion.hpp"

#include <algorithm>
#include <optional>

#include "arith/running_error.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/time_of_impact/separation_filter.hpp"

namespace plumb::query::moving {
namespace {

/// A point of doubles near to the image, and how far from it that may be.
struct NearbyPoint {
  Point3 point;
  double off;
};

/// The poses that differ, over one number type.
template <class T>
class PosesInMotion {
 public:
  explicit PosesInMotion(const PosedQuestion& question) : question_(question) {
    for (const std::array<AnyPoseView, 2>& of : {question.of_a, question.of_b}) {
      for (const AnyPoseView& pose : of) {
        if (which(pose) < count_) continue;
        views_[count_] = pose, poses_[count_] = weighted_pose<T>(pose);
        ++count_;
      }
    }
  }

  /// The pose is the one that the point has at this end.
  [[nodiscard]] std::size_t which(std::size_t point, std::size_t end) const {
    return which(question_.pose(point, end));
  }
  [[nodiscard]] const WeightedPose<T>& of(std::size_t point, std::size_t end) const {
    return *poses_[which(point, end)];
  }
  /// Times the weight of its pose.
  [[nodiscard]] Vec3<T> image(std::size_t point, std::size_t end) const {
    return of(point, end).image(vector_of<T>(question_.place(point, end)));
  }
  static constexpr std::size_t none = 4;
  /// The product of the weights of all poses but one.
  [[nodiscard]] T weight_without(std::size_t left_out) const {
    T product(1.0);
    for (std::size_t i = 0; i < count_; ++i) {
      if (i != left_out && poses_[i]->has_weight) product = product * poses_[i]->weight;
    }
    return product;
  }

 private:
  [[nodiscard]] std::size_t which(const AnyPoseView& pose) const {
    std::size_t i = 0;
    while (i < count_ && !(views_[i] == pose)) ++i;
    return i;
  }

  const PosedQuestion& question_;
  std::array<AnyPoseView, 4> views_;
  std::array<std::optional<WeightedPose<T>>, 4> poses_;
  std::size_t count_ = 0;
};

NearbyPoint nearby(const Vec3<Running>& image, const WeightedPose<Running>& pose) {
  double off = 0;
  const auto near = [&](const Running& x) {
    Interval range(x.lower(), x.upper());
    double middle = x.value;
    if (pose.has_weight) {
      range = quotient(range, Interval(pose.weight.lower(), pose.weight.upper()));
      middle = x.value / pose.weight.value;
    }
    const Interval value(middle);
    off = (Interval(off) +
           Interval(std::max((Interval(range.upper) - value).upper, (value - Interval(range.lower)).upper)))
              .upper;
    return middle;
  };
  const Point3 point{near(image.x), near(image.y), near(image.z)};
  const bool is_real = point.x - point.x == 0 && point.y - point.y == 0 && point.z - point.z == 0;
  return {point, is_real && off >= 0 ? off : Interval::infinity};
}

/// Do the rounded images stay farther apart than the separation and what rounding may have moved them?  Between the
/// ends of the motion they are no farther off than at the ends.
bool stay_apart(const PosedQuestion& question, double separation) {
  const PosesInMotion<Running> poses(question);
  ContactQuestion rounded = question.given;
  double off_a = 0, off_b = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const NearbyPoint from = nearby(poses.image(i, 0), poses.of(i, 0)), to = nearby(poses.image(i, 1), poses.of(i, 1));
    rounded.at_0[i] = from.point, rounded.at_1[i] = to.point;
    double& off = i < (rounded.kind == MovingKind::edge_edge ? 2U : 1U) ? off_a : off_b;
    off = std::max({off, from.off, to.off});
  }
  const double reach = (Interval(separation) + Interval(off_a) + Interval(off_b)).upper;
  return reach > 0 && reach < Interval::infinity && separation_filter(rounded, reach) == ContactVerdict::no;
}

/// Coordinates as integers on one lattice.
class PosedLattice {
 public:
  void include(const BigDyadic& x) {
    if (x.sign() != Sign::zero) exponent_ = any_ ? std::min(exponent_, x.exponent()) : x.exponent(), any_ = true;
  }
  void include(const Vec3<BigDyadic>& p) { include(p.x), include(p.y), include(p.z); }
  [[nodiscard]] mpz_class integer(const BigDyadic& x) const {
    mpz_class m = x.mantissa();
    if (x.sign() != Sign::zero) m <<= static_cast<mp_bitcnt_t>(x.exponent() - exponent_);
    return m;
  }
  [[nodiscard]] MovingVector moving(const Vec3<BigDyadic>& from, const Vec3<BigDyadic>& to) const {
    const auto one = [&](const BigDyadic& x, const BigDyadic& y) {
      mpz_class start = integer(x), end = integer(y);
      return trimmed(arith::Polynomial{start, mpz_class(end - start)});
    };
    return {one(from.x, to.x), one(from.y, to.y), one(from.z, to.z)};
  }

 private:
  long exponent_ = 0;
  bool any_ = false;
};

}  // namespace

std::optional<TimedContact> posed_first_contact(const PosedQuestion& question, double separation) {
  if (stay_apart(question, separation)) return {};
  const PosesInMotion<BigDyadic> poses(question);  // all are brought to the product of the weights
  std::array<std::array<Vec3<BigDyadic>, 2>, 4> images;
  PosedLattice lattice;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t end = 0; end < 2; ++end) {
      images[i][end] = poses.image(i, end) * poses.weight_without(poses.which(i, end));
      lattice.include(images[i][end]);
    }
  }
  const BigDyadic reach = BigDyadic(separation) * poses.weight_without(poses.none);
  lattice.include(reach);
  FourMoving points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = lattice.moving(images[i][0], images[i][1]);
  return exact_first_contact(question.given.kind, points, lattice.integer(reach));
}

}  // namespace plumb::query::moving
