// The worked example of docs/add_a_decision.md, as it is shown there.
#pragma once

#include <plumb/certify/certainly.hpp>
#include <plumb/figure/basic/box.hpp>

namespace mine {

/// What a guard sees: all that is within an angle of the axis, whose squared cosine is a quotient of two numbers.
struct View {
  plumb::Point3 eye;
  plumb::Vector3 axis;
  double numerator, denominator;
};

/// Is the whole box in view?  A view of less than a right angle is convex: it is where all corners are.
struct SeesBox {
  static constexpr plumb::Scales scales{.count = 3};

  template <class W>
  bool operator()(W& w, const View& v, const plumb::Aabb3& box) const {
    const auto dx = w.template number<1>(v.axis.x), dy = w.template number<1>(v.axis.y),
               dz = w.template number<1>(v.axis.z);
    const auto above = w.template number<2>(v.numerator), below = w.template number<2>(v.denominator);
    const auto square_of_axis = dx * dx + dy * dy + dz * dz;
    for (const double x : {box.min.x, box.max.x}) {
      for (const double y : {box.min.y, box.max.y}) {
        for (const double z : {box.min.z, box.max.z}) {
          const auto px = w.difference(x, v.eye.x), py = w.difference(y, v.eye.y), pz = w.difference(z, v.eye.z);
          const auto along = px * dx + py * dy + pz * dz;
          if (w.sign(along) == plumb::Sign::negative) return false;
          const auto square = px * px + py * py + pz * pz;
          if (w.compare(along * along * below, square * square_of_axis * above) == plumb::Sign::negative) return false;
        }
      }
    }
    return true;
  }
};

}  // namespace mine
