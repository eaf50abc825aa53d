// During which part of [0, 1] are two features within reach of each other, one of them moving along a line?
//
// Each pair of features has its condition: a polynomial of degree 2 that is not positive where the lines or planes of
// the two are within reach, and linear ones that are not negative where the nearest points are in the features.
// Laws: (1) two bodies, whose hulls do not meet at time 0, meet at time t exactly when the condition of some pair holds
// there, for distance is reached between features.  (2) A condition holds during one interval, as both sets are convex.
// (3) A feature without length or area has no condition of its own; its vertices and edges have.
// Source: RTCD 5.5.2.  Cost: 30 to 100 operations a pair.
#pragma once

#include <optional>

#include "plumb/query/root.hpp"
#include "query/moving_body.hpp"

namespace plumb::query {

enum class FeaturePair : unsigned char { vertex_vertex, vertex_edge, edge_vertex, edge_edge, vertex_face, face_vertex };

struct PairIndex {
  FeaturePair kind;
  std::uint32_t a, b;
};

template <class T>
struct Condition {
  std::array<T, 3> not_positive;                 // coefficients of 1, t, t^2
  std::vector<std::array<T, 2>> not_negative{};  // of 1, t
};

/// Nothing for a pair without a condition of its own.  `velocity` is that of a, seen from b.
template <class T>
std::optional<Condition<T>> condition(const Body<T>& a, const Body<T>& b, const Vec3<T>& velocity, PairIndex pair);
extern template std::optional<Condition<Interval>> condition(const Body<Interval>&, const Body<Interval>&,
                                                             const Vec3<Interval>&, PairIndex);
extern template std::optional<Condition<BigDyadic>> condition(const Body<BigDyadic>&, const Body<BigDyadic>&,
                                                              const Vec3<BigDyadic>&, PairIndex);

/// No time before this one meets the condition; infinite where none in [0, 1] does.
double earliest(const Condition<Interval>& condition);

/// The first time in [0, 1] that meets the condition.
std::optional<Root> first_time(const Condition<BigDyadic>& condition);

}  // namespace plumb::query
