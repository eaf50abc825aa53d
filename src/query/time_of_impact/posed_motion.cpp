// Points rounded, and how far off, for what stays apart; integers for all else.
#include "query/time_of_impact/posed_motion.hpp"

#include <algorithm>

#include "arith/running_error.hpp"
#include "plumb/arith/interval.hpp"
#include "query/body/posed_corners.hpp"
#include "query/time_of_impact/separation_filter.hpp"

namespace plumb::query::moving {
namespace {

/// A point of doubles near to the image, and how far from it that may be.
struct NearbyPoint {
  Point3 point;
  double off;
};

NearbyPoint nearby(const Point3& p, const Pose& pose) {
  const Vec3<Running> image = posed<Running>(p, pose);
  const auto off = [](const Running& x) {
    const Interval value(x.value);
    return Interval(std::max((Interval(x.upper()) - value).upper, (value - Interval(x.lower())).upper));
  };
  const Point3 point{image.x.value, image.y.value, image.z.value};
  const bool is_real = point.x - point.x == 0 && point.y - point.y == 0 && point.z - point.z == 0;
  return {point, is_real ? (off(image.x) + off(image.y) + off(image.z)).upper : Interval::infinity};
}

/// Do the rounded images stay farther apart than the separation and what rounding may have moved them?  Between the
/// ends of the motion they are no farther off than at the ends.
bool stay_apart(const PosedQuestion& question, double separation) {
  ContactQuestion rounded = question.given;
  double off_a = 0, off_b = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const NearbyPoint from = nearby(question.given.at_0[i], question.pose_0);
    const NearbyPoint to = nearby(question.given.at_1[i], question.pose_1);
    rounded.at_0[i] = from.point, rounded.at_1[i] = to.point;
    const bool is_of_a = i < (rounded.kind == MovingKind::edge_edge ? 2u : 1u);
    double& off = is_of_a ? off_a : off_b;
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
  std::array<std::array<Vec3<BigDyadic>, 2>, 4> images;
  PosedLattice lattice;
  for (std::size_t i = 0; i < 4; ++i) {
    images[i] = {posed<BigDyadic>(question.given.at_0[i], question.pose_0),
                 posed<BigDyadic>(question.given.at_1[i], question.pose_1)};
    for (const Vec3<BigDyadic>& p : images[i]) lattice.include(p);
  }
  const BigDyadic reach(separation);
  lattice.include(reach);
  FourMoving points;
  for (std::size_t i = 0; i < 4; ++i) points[i] = lattice.moving(images[i][0], images[i][1]);
  return exact_first_contact(question.given.kind, points, lattice.integer(reach));
}

}  // namespace plumb::query::moving
