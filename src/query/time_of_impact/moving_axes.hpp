// Time of impact, separating axes: during which part of [0, 1] can two bodies meet, as far as their projections tell?
//
// Along an axis two bodies in straight motion overlap during one interval of time; they can meet only while they do on
// every axis.  Axes are those of the coordinates, the normals of faces, and the cross products of edges.
// Laws: the bodies do not meet outside of [from, to], whatever rounds; all times are outside where from > to.
// exact_entry is the exact time before which one axis tells that they do not.
// Source: RTCD 5.5.2.
// Cost: a product with every vertex for each axis.
#pragma once

#include <optional>

#include "plumb/arith/rational.hpp"
#include "query/time_of_impact/feature_slabs.hpp"

namespace plumb::query {

struct TimeAxis {
  enum class Kind : unsigned char { start, coordinate, face_of_a, face_of_b, edges, ways };
  Kind kind = Kind::start;  // no axis: time 0
  std::uint32_t a = 0, b = 0;
};

struct TimeWindow {
  double from = 0, to = 1;
  TimeAxis axis{};  // where they meet at `from`
  [[nodiscard]] bool empty() const { return !(from <= to); }
};

/// `velocity` is that of a, seen from b.
TimeWindow time_window(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity);

/// When two bodies without reach meet along an axis: way / speed, of which speed is positive and way is not negative.
struct AxisEntry {
  BigDyadic way, speed;
  [[nodiscard]] Rational time() const;
  [[nodiscard]] double rounded(Rounding rounding) const;
};
/// No more than any time at which they meet.  Nothing where the axis tells nothing.
std::optional<AxisEntry> exact_entry(const MovingBody<BigDyadic>& a, const MovingBody<BigDyadic>& b,
                                     const Vec3<BigDyadic>& velocity, const TimeAxis& axis);

/// The box around a shape, not rounded inward.
FeatureBox bounding_box(const PosedView& shape);

}  // namespace plumb::query
