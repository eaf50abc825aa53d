// Time of impact, separating axes: during which part of [0, 1] can two bodies meet, as far as their projections tell?
//
// Along an axis two bodies in straight motion overlap during one interval of time; they can meet only while they do on
// every axis.  Axes are those of the coordinates, the normals of faces, and the cross products of edges.
// Laws: the bodies do not meet outside of [from, to], whatever rounds; all times are outside where from > to.
// Source: RTCD 5.5.2.
// Cost: a product with every vertex for each axis.
#pragma once

#include "query/time_of_impact/feature_slabs.hpp"

namespace plumb::query {

struct TimeWindow {
  double from = 0, to = 1;
  [[nodiscard]] bool empty() const { return !(from <= to); }
};

/// `velocity` is that of a, seen from b.
TimeWindow time_window(const MovingBody<Running>& a, const MovingBody<Running>& b, const Vec3<Running>& velocity);

/// The box around a shape, not rounded inward.
FeatureBox bounding_box(const BodyShape& shape);

}  // namespace plumb::query
