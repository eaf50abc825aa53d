// Where does a pose lead, over any number type?  To (columns p + translation) / weight, of which nothing is divided.
//
// A turn by a quaternion is a matrix of products of its numbers over the sum of their squares.  What is compared with
// another figure, or meets it, may as well be larger: each is multiplied by the weight of the other, and directions,
// features, orders and times stay what they are.
// Laws: (1) exact over numbers that are; the weight is above zero.  (2) Where a quaternion's matrix is one of doubles
// (arith/rigid_pose.hpp) its numbers are given, without an error.  (3) A chain is the product of its links; of more than
// `few_links` numbers that know their errors tell nothing.
// Source: RTCD 3.1.1, 3.2.
// Cost: none for a matrix; of a turn nine products, of a chain 27 more for each further link.
#pragma once

#include <limits>
#include <span>

#include "arith/running_error.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/short_dyadic.hpp"
#include "plumb/arith/stack_dyadic.hpp"
#include "plumb/query/body/posed.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

/// figure/basic/pose_numbers.hpp has the numbers; here is what a question can leave out.
template <class T>
struct WeightedPose : figure::PoseNumbers<T> {
  WeightedPose(figure::PoseNumbers<T> n = figure::pose_numbers<T>(identity_pose))
      : figure::PoseNumbers<T>(std::move(n)) {}

  bool has_weight = false;  // other than one
  bool stands = false;      // whatever is posed

  /// Times the weight.
  [[nodiscard]] Vec3<T> image(const Vec3<T>& p) const { return stands ? p : figure::PoseNumbers<T>::image(p); }
};

/// Running errors hold through 2^11 operations in a row (arith/running_error.hpp), of which a link takes about eight.
inline constexpr std::size_t few_links = 64;
template <class T>
inline constexpr bool knows_its_error =
    !std::is_same_v<T, double> && !std::is_same_v<T, mpq_class> && !requires(const T& x) {
  { x.sign() } -> std::same_as<Sign>;
};

/// A turn of the plane turns the plane z = 0, and leaves z alone.
inline Rotation rotation_of(const Rotation2& q) { return {q.w, 0, 0, q.z}; }
inline Rotation rotation_of(const Rotation& q) { return q; }

template <class T, class Turn>
WeightedPose<T> weighted_turn(const Turn& turn) {
  const Rotation q = rotation_of(turn);
  WeightedPose<T> r;
  if (const auto m = exact_matrix(q)) {
    r.columns = {vector_of<T>(m->columns[0]), vector_of<T>(m->columns[1]), vector_of<T>(m->columns[2])};
    r.weight = T(m->weight);
    r.has_weight = m->weight != 1;
  } else {
    r = figure::turn_of(figure::quaternion<T>(q));
    r.has_weight = true;
  }
  return r;
}

template <class T, class Rigid>
WeightedPose<T> weighted_links(std::span<const Rigid> links) {
  WeightedPose<T> all;
  all.stands = links.empty();
  if (links.size() > few_links && knows_its_error<T>) {
    const T unknown(std::numeric_limits<double>::quiet_NaN());
    const Vec3<T> nowhere{unknown, unknown, unknown};
    all.columns = {nowhere, nowhere, nowhere}, all.translation = nowhere;
    return all;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    WeightedPose<T> r = weighted_turn<T>(links[i].turn);
    r.translation = arith::vec<T>(links[i].translation);
    if (r.has_weight) r.translation = r.translation * r.weight;
    if (i == 0) {
      all = r;
      continue;
    }
    const bool has_weight = all.has_weight || r.has_weight;
    all = figure::composition<T>(all, r);
    all.has_weight = has_weight;
  }
  return all;
}

// Their text is long, and the same wherever poses become numbers of these types: weighted_pose.cpp has it.
#define PLUMB_LINKS(how, T)                                                   \
  how template WeightedPose<T> weighted_links<T>(std::span<const RigidPose>); \
  how template WeightedPose<T> weighted_links<T>(std::span<const RigidPose2>);
#define PLUMB_ALL_LINKS(how)    \
  PLUMB_LINKS(how, double)      \
  PLUMB_LINKS(how, Approximate) \
  PLUMB_LINKS(how, Ball)        \
  PLUMB_LINKS(how, Running)     \
  PLUMB_LINKS(how, ShortDyadic) \
  PLUMB_LINKS(how, StackDyadic) \
  PLUMB_LINKS(how, BigDyadic)
PLUMB_ALL_LINKS(extern)

template <class T>
WeightedPose<T> weighted_pose(const AnyPoseView& pose) {
  return std::visit(
      [&]<class By>(const By& by) -> WeightedPose<T> {
        if constexpr (std::is_same_v<By, std::monostate>) {
          return weighted_links<T>(std::span<const RigidPose>());
        } else if constexpr (requires { by->columns; }) {
          return figure::pose_numbers<T>(*by);
        } else if constexpr (requires { by->links; }) {
          return weighted_links<T>(std::span(by->links));
        } else {
          return weighted_links<T>(std::span(by, 1));
        }
      },
      pose.by);
}

/// Does it keep all lengths, whatever its numbers?
inline bool is_rigid(const AnyPoseView& pose) {
  return !std::holds_alternative<const Pose*>(pose.by) && !std::holds_alternative<const Pose2*>(pose.by);
}

}  // namespace plumb::query
