// Closest points: of two convex cores of points and boxes, without allocations.  Corners that are proved, then pairs of
// doubles for the numbers.
//
// Laws: what is told is exact, or rounded once.  Where it is not told there is no answer here; what is no figure has none.
// Source: query/separation/proved_corners.hpp.
// Cost: docs/measurements.md.
#pragma once

#include "plumb/query/closest/result.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {

struct ToldPair {
  Closest closest;
  bool meets;  // by more than a point
};

class QuickPair {
 public:
  static std::optional<QuickPair> of(const FigureAt& a, const FigureAt& b);
  /// Of cores whose corners are proved, and the radii around them.
  QuickPair(const CoreCorners& a, const CoreCorners& b, double radius_a, double radius_b, const ProvedCorners& proved)
      : a_(a), b_(b), radius_a_(radius_a), radius_b_(radius_b), proved_(proved) {}

  [[nodiscard]] std::optional<double> distance() const;
  /// Of the cores.
  [[nodiscard]] mpq_class square() const;
  /// Of figures whose cores do not meet, and that do not touch; where there is another nearest pair, nothing.
  [[nodiscard]] std::optional<ToldPair> closest(const Feature& feature_a, const Feature& feature_b) const;
  /// A point of both, where the cores meet or the radii reach farther than these are apart; no features.
  [[nodiscard]] std::optional<ToldPair> common() const;
  /// One of them, also of cores that meet.
  [[nodiscard]] NearestPair any_pair() const;

 private:
  CoreCorners a_, b_;
  double radius_a_, radius_b_;
  ProvedCorners proved_;
};

/// Of a point strictly within the hull of these corners of the figure, which a plane touches there.
std::optional<Feature> feature_of_corners(const FigureView& figure, const CoreCorners& c,
                                          std::span<const std::uint32_t> of, const Support& support);
/// The feature holds a point strictly within the hull of a corner and those that `along`, bit by bit, leads to; the figure
/// is a sum of so many edges.
Feature feature_of_sum(const FigureView& figure, std::size_t edges, std::uint32_t corner, std::uint32_t along);
/// The same of up to three vertices of a polyhedron; nothing where they are none of its features.
std::optional<Feature> feature_of_mesh(const ConvexPolyhedron3& solid, std::span<const std::uint32_t> of);

}  // namespace plumb::query
