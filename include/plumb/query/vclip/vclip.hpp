// V-Clip: which features of two convex polyhedra are nearest to one another, from those that were so a moment ago?
//
//   VClipResult r = vclip(a, b);                       // r.meet, r.closest, r.at
//   r = vclip(a, Posed{b, pose}, {.start = r.at});     // b has moved a little: as a rule no step or one
//
// A walk over pairs of a vertex, an edge or a face of each: where the one is not within the other's Voronoi region, or
// an edge, clipped by the planes of that region, comes nearer beyond one of them, it goes on to the feature beyond.
// Laws: (1) what it ends at is proved: the closest points of the two features, and a slab between planes through them
// that has all of a on one side and all of b on the other; or a point that both have.  (2) `closest` has the features
// of the lowest dimension that hold these points, as closest_points numbers them; coordinates and the distance are the
// exact ones rounded once.  It is that of closest_points where one pair alone is nearest, else one of the nearest
// pairs; of polyhedra that meet one of their common points, with the features that the walk ended at.  (3) The start
// changes the time, never the distance. (4) The walk ends: it is a function of the pair, and one that comes back to a
// pair is left to the exact search, as is what a singular pose flattens.  Polyhedra, one or both under a pose, and figures
// that are of that kind when they are asked.  One without faces and a start that is no corner of its mesh throw
// InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 9.2.1 (figure 9.4); Mirtich, V-Clip: fast and robust polyhedral collision detection, 1998.
// Cost: docs/convex.md.  Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span: no
// pair of features comes twice, for the distance falls with each.
#pragma once

#include <optional>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/separation/posed.hpp"

namespace plumb {

/// A vertex by a corner of the mesh that is at it, an edge by the corner that it leaves, a face by one of its corners.
struct MeshFeature {
  FeatureKind kind = FeatureKind::vertex;
  std::uint32_t corner = 0;
  friend bool operator==(const MeshFeature&, const MeshFeature&) = default;
};
struct MeshFeaturePair {
  MeshFeature a, b;
  friend bool operator==(const MeshFeaturePair&, const MeshFeaturePair&) = default;
};

struct VClipOptions {
  std::optional<MeshFeaturePair> start{};           // else vertices toward one another, by a guess
  bool squared_distance = false;                    // is the exact one wanted?
  std::vector<MeshFeaturePair>* history = nullptr;  // every pair of the walk is appended
};

struct VClipResult {
  bool meet = false;
  Closest closest{};
  MeshFeaturePair at{};  // where the walk ended: a start for the next
  std::uint32_t steps = 0;
  bool by_search = false;  // the walk came back to a pair, and the exact search answered
  std::optional<Rational> squared_distance{};
};

namespace query {

/// A convex polyhedron as it stands or under a pose.
struct ClipView {
  const ConvexPolyhedron3* polyhedron;
  AnyPoseView pose{};
};

template <class Shape>
concept ClipBody = std::same_as<Shape, AnyFigure> ||
    (std::same_as<UnposedType<Shape>, ConvexPolyhedron3>&& has_its_pose<Shape>);

/// Of any other kind there is none: Unsupported.
inline ClipView clip_view(const AnyFigure& s) {
  const auto* polyhedron = get_if<ConvexPolyhedron3>(s);
  if (polyhedron == nullptr) refuse_figure("what takes convex polyhedra", s.figure());
  return {polyhedron, s.view().pose};
}

template <ClipBody Shape>
requires(!std::same_as<Shape, AnyFigure>) ClipView clip_view(const Shape& s) {
  if constexpr (is_posed<Shape>) {
    return {&s.shape, &s.pose};
  } else {
    return {&s};
  }
}

VClipResult vclip_of(const ClipView& a, const ClipView& b, const VClipOptions& options);

}  // namespace query

template <query::ClipBody A, query::ClipBody B>
VClipResult vclip(const A& a, const B& b, const VClipOptions& options = {}) {
  return query::vclip_of(query::clip_view(a), query::clip_view(b), options);
}

}  // namespace plumb
