// Closest points of boxes, rectangles, capsules, segments, balls and points, as they stand or under rigid poses: on which
// faces of their cores are they, and where?
//
// Such a core is a middle and up to three edges, each taken between minus a half and a half.  So is the difference of two,
// and what of it is nearest to the origin lies in a face: some edges free, at most two of them, all others at an end.  The
// face is guessed in doubles and proved by pairs of doubles, of which every number of the body is made once.  What the poses
// translate is taken from one another first, so that nothing grows with the way from the origin.
// Laws: what is told is so, and every number the nearest double of the exact one (Ziv's test).  Of nearest pairs that are the
// only ones, where each edge at an end leads away strictly; else nothing, and nothing of what is no figure.
// Source: Lawson and Hanson 1974 (least squares within bounds); RTCD 4.4, 5.1.9.
// Cost: docs/rigid_motion.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "plumb/query/body/posed.hpp"
#include "plumb/query/closest/result.hpp"

namespace plumb::query {

/// What there is of a pose: nothing, a matrix of doubles over a weight, or numbers that doubles do not hold.
enum class PoseForm : std::uint8_t { none, doubles, other };

/// The numbers of a core, as given: twice its corners are 2 at + columns (to - from +- the edges) / weight.
struct EdgeSum {
  /// In each coordinate `axis` (to - from).
  struct Edge {
    Vector3 axis, from, to;
    std::uint32_t number;
  };
  Vector3 at, from, to;
  std::array<Edge, 3> edges;  // those that have a length
  std::uint32_t size = 0;
  std::uint32_t all = 0;  // and how many the figure has
  double radius = 0;
  PoseForm form = PoseForm::none;
  std::array<Vector3, 3> columns;  // about these, as `at`, of the pose that is of other numbers
  double weight = 1;
  AnyPoseView pose;

  /// False where it is none.
  bool set(const PosedView& v);

 private:
  template <class Shape>
  bool take(const Shape& s);
  bool take_pose(const AnyPoseView& pose);
  bool take_pose(const RigidPose& pose);
  void take_edge(const Vector3& axis, const Vector3& begin, const Vector3& end);
};

/// Of a (0) and b (1), bit by bit of their edges: those that are free, and of the others those at the upper end.
struct EdgeFace {
  std::array<std::uint32_t, 2> along{}, upper{};
};

/// A guess; nothing where they are likely to meet or have parallel edges.
std::optional<EdgeFace> guessed_face(const EdgeSum& a, const EdgeSum& b);

struct SumNumbers {
  double distance = 0;
  Point3 on_a{}, on_b{};
};
/// What is nearest, where it is on this face, which may be any; without `points` the distance alone, and 0 where radii reach
/// farther.
std::optional<SumNumbers> nearest_on(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face, bool points);

std::optional<Closest> closest_of_sums(const PosedView& a, const PosedView& b);
std::optional<double> distance_of_sums(const PosedView& a, const PosedView& b);

}  // namespace plumb::query
