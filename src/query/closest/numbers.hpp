// Which doubles are nearest to the coordinates of a foot, and to its distance?  The end of every closest point.
//
// Laws: each number is the exact one rounded once.  Pairs of doubles answer where they leave one double, integers
// otherwise; what is not asked for is not computed.
// Source: docs/proof.md.
// Cost: some 100 ns by pairs of doubles, some microseconds by integers.
#pragma once

#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/exact_distance.hpp"
#include "query/closest/foot.hpp"

namespace plumb::query {

/// How a foot is made over integers, where doubles do not tell.
class ExactFoot {
 public:
  template <class Make>
  explicit ExactFoot(const Make& make)
      : maker_(&make), make_([](const void* m) { return (*static_cast<const Make*>(m))(); }) {}
  Foot<BigDyadic> operator()() const { return make_(maker_); }

 private:
  const void* maker_;
  Foot<BigDyadic> (*make_)(const void*);
};

enum class Wanted : unsigned char { point = 1, distance = 2, both = 3 };

struct NearestNumbers {
  Point3 point{};
  double distance = 0;
};

/// The point of the ball of this radius about the foot that is nearest to p, which is outside of the ball.  A radius of
/// zero asks for the foot.
NearestNumbers numbers(Wanted wanted, const Foot<Ball>& foot, const Point3& p, double radius, const ExactFoot& exactly);

Rational rational_square(const Foot<BigDyadic>& foot);

/// part / whole.
double rounded_part(const Foot<Ball>& foot, const ExactFoot& exactly);

}  // namespace plumb::query
