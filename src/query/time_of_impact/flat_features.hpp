// Which features of two figures in the plane z = 0 have a point in common?  One of them a segment.
//
// Tells every two: vertices and edges by exact coordinates, and what a figure is as a whole, which holds ends of the
// segment.
// Laws: exact; of figures that meet at least one pair is told.
// Source: RTCD 5.1.9, 5.4.
// Cost: some microseconds; for what overlaps from the start along a line.
#pragma once

#include <concepts>
#include <vector>

#include "plumb/figure/containment/contains.hpp"
#include "query/body/vectors.hpp"
#include "query/time_of_impact/moving_body.hpp"

namespace plumb::query {

struct FlatFeatures {
  template <class Shape>
  explicit FlatFeatures(const Shape& s) : FlatFeatures(moving_body<BigDyadic>(BodyShape(&s))) {}
  explicit FlatFeatures(MovingBody<BigDyadic> given);

  MovingBody<BigDyadic> body;
  Feature whole;
};

struct MeetingFeatures {
  Feature of_a, of_b;
};

/// Adds vertices and edges that meet.
void add_meeting_features(const FlatFeatures& a, const FlatFeatures& b, std::vector<MeetingFeatures>& to);

template <class A, class B>
std::vector<MeetingFeatures> meeting_features(const A& of_a, const B& of_b) {
  const FlatFeatures a(of_a), b(of_b);
  std::vector<MeetingFeatures> all{{a.whole, b.whole}};
  // Ends of a segment that the other holds.
  if constexpr (std::same_as<A, Segment3> && !std::same_as<B, Point3>) {
    if (contains(of_b, of_a.a)) all.push_back({{FeatureKind::vertex, 0}, b.whole});
    if (contains(of_b, of_a.b)) all.push_back({{FeatureKind::vertex, 1}, b.whole});
  } else if constexpr (std::same_as<B, Segment3> && !std::same_as<A, Point3>) {
    if (contains(of_a, of_b.a)) all.push_back({a.whole, {FeatureKind::vertex, 0}});
    if (contains(of_a, of_b.b)) all.push_back({a.whole, {FeatureKind::vertex, 1}});
  }
  add_meeting_features(a, b, all);
  return all;
}

}  // namespace plumb::query
