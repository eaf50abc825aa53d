// Closest points: which points of the cores of two figures are nearest to one another, exactly, whatever the figures?
//
// A polygon is its edges and, where it has an inside, what of its plane is in it: a nearest pair whose point is inside
// is one of the plane's, and all pairs next to it are until they leave the polygon across an edge.
// Laws: (1) the distance is that of the sets.  (2) Of several nearest pairs that one is told whose points come first in
// lexicographic order: the earlier of its two points, then the later, whichever figure is named first; where none comes
// first, of figures that go on, one of them, the same whichever is named first.
// Source: query/convex/nearest_pair.hpp.
// Cost: that of nearest_pair; with polygons that of each pair of edges whose boxes are near enough.
#pragma once

#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/nearest_pair.hpp"

namespace plumb::query {

/// A figure at a time of a straight motion, or under a map.
struct FigureAt {
  FigureView figure;
  Vector3 by{};
  double time = 0;
  const ExactMap* map = nullptr;

  FigureAt(const FigureView& f) : figure(f) {}  // NOLINT: one at rest
  FigureAt(const FigureView& f, const ExactMap& under) : figure(f), map(&under) {}
  FigureAt(const FigureView& f, const Vector3& way, double t) : figure(f), by(way), time(t) {}
};

/// Nothing where one of the figures has no point.
std::optional<NearestPair> nearest_of_cores(const FigureAt& a, const FigureAt& b, WhichPair which);

}  // namespace plumb::query
