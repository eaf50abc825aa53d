// Closest points: what is nearest, where sixteen more digits than a double has tell all?  Four lanes at once, no
// allocation, no call.
//
// Laws: true only where the feature is certain and each number is the exact one rounded once; false says nothing: then
// signs and integers answer.  Input that is NaN or infinite is never answered.
// Source: Dekker 1971, Ziv 1991; docs/proof.md, "Twofold", "Tracked errors".
// Cost: 3 to 45 ns with fused multiply-adds; machines without them get false at once.
#pragma once

#include <concepts>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/closest/result.hpp"

namespace plumb::query {

/// The nearest point, its distance, or both and the feature: on_b, distance and feature_b of a Closest.
template <class Shape, class To>
bool quickly(const Shape& s, const Point3& p, To& to);

template <class Shape>
concept HasQuick = std::same_as<Shape, Segment3> || std::same_as<Shape, Triangle3> || std::same_as<Shape, Aabb3> ||
    std::same_as<Shape, Obb3>;

}  // namespace plumb::query
