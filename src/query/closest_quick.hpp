// What is nearest, where sixteen more digits than a double has tell all?  Four lanes at once, no allocation, no call.
//
// Laws: true only where the feature is certain and each number is the exact one rounded once; false says nothing: then
// signs and integers answer.  Input that is NaN or infinite is never answered.
// Source: Dekker 1971, Ziv 1991; the bounds are those of docs/closest.md.  Cost: 15 to 40 ns with fused multiply-adds;
// machines without them get false at once.
#pragma once

#include "plumb/figure/box.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/simplex.hpp"
#include "plumb/figure/voronoi_region.hpp"
#include "query/closest_numbers.hpp"

namespace plumb::query {

struct Quickly {
  Feature feature;
  Numbers numbers;  // those that are wanted
};

bool quickly(Wanted wanted, const Segment3& s, const Point3& p, Quickly& found);
bool quickly(Wanted wanted, const Triangle3& s, const Point3& p, Quickly& found);
bool quickly(Wanted wanted, const Aabb3& s, const Point3& p, Quickly& found);
bool quickly(Wanted wanted, const Obb3& s, const Point3& p, Quickly& found);

}  // namespace plumb::query
