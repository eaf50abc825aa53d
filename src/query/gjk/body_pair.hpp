// What is said of two bodies whose nearest corners are proved: do they meet, how far apart are they, and where?
//
// Laws: the bodies have been looked at, and what is none has thrown.  Numbers are exact, rounded once; features and the one
// of several nearest pairs are those of query/gjk/gjk.hpp.
// Source: query/separation/told_pair.hpp, query/separation/quick.hpp.
// Cost: pairs of doubles where they tell, else GMP.
#pragma once

#include "query/separation/convex_body.hpp"
#include "query/separation/corner_search.hpp"
#include "query/separation/exact_corners.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query {

/// A body and its corners.
struct SeenBody {
  const BodyView& view;
  const CoreCorners& corners;
};

/// Of a hull's points that span the least face.
Feature least_feature(std::span<const std::uint32_t> of);

/// In pairs of doubles, where they and the corners tell all of it.  Of bodies that meet features are told of the first common
/// point alone.
std::optional<ToldPair> closest_at_once(const QuickPair& pair, const SeenBody& a, const SeenBody& b,
                                        const ProvedCorners& proved, WhichPair common);

std::vector<Exact3> exact_corners(const CoreCorners& c);

class BodyPair {
 public:
  BodyPair(std::string_view function, const BodyView& a, const BodyView& b)
      : views_{a, b}, bodies_(bodies_of(function, a, b)) {}

  /// The first one is what it sweeps, seen from the second: features of it are none.
  void sweep(const Vector3& by_a, const Vector3& by_b) { bodies_[0].corners.sweep(by_a, by_b); }

  [[nodiscard]] const CoreCorners& a() const { return bodies_[0].corners; }
  [[nodiscard]] const CoreCorners& b() const { return bodies_[1].corners; }
  [[nodiscard]] bool meets(const ProvedCorners& proved) const;
  [[nodiscard]] double distance(const ProvedCorners& proved) const;
  [[nodiscard]] Closest closest(const ProvedCorners& proved, WhichPair which) const;
  /// Of the cores, one of the nearest pairs.
  [[nodiscard]] NearestPair nearest(const ProvedCorners& proved) const;

 private:
  [[nodiscard]] mpq_class square(const ProvedCorners& proved) const;
  [[nodiscard]] mpq_class reach() const { return bodies_[0].radius + bodies_[1].radius; }

  std::array<BodyView, 2> views_;
  std::array<Body, 2> bodies_;
};

}  // namespace plumb::query
