// Closest points: how far apart are two segments, or two lines, rays or segments, or a vertex and a face, whose nearest
// features are known?  Four lanes at once.
//
// Laws: true only where each number is the exact one rounded once: on_a, on_b and distance of a Closest, of a vertex
// and a face on_b and distance; or the distance alone.  Inside both never of what is parallel.  False says nothing.
// Source: as query/closest/quick.hpp.
// Cost: 15 to 30 ns with fused multiply-adds; machines without them get false at once.
#pragma once

#include "plumb/query/closest/result.hpp"
#include "query/closest/linear_pair.hpp"

namespace plumb::query {

/// Where a line, ray or segment lies in memory: nothing of it is copied before it is read in lanes.
struct LineAt {
  const Point3* from;
  const Point3* to;  // of segments
  const Vector3* direction;

  explicit LineAt(const Segment3& s) : LineAt(s.a, s.b) {}
  explicit LineAt(const Ray3& r) : from(&r.origin), to(nullptr), direction(&r.direction) {}
  explicit LineAt(const Line3& l) : from(&l.point), to(nullptr), direction(&l.direction) {}
  LineAt(const Point3& a, const Point3& b) : from(&a), to(&b), direction(nullptr) {}
  [[nodiscard]] const Point3& at(SpotOnLine place) const { return place == SpotOnLine::end ? *to : *from; }
};

template <class To>
bool quickly(const LineAt& p, const LineAt& q, SpotsOnLines places, To& to);
template <class To>
bool quickly(const Point3& vertex, const Triangle3& face, To& to);
/// The features as well.
template <class To>
bool quickly(const Segment3& p, const Segment3& q, To& to);

}  // namespace plumb::query
