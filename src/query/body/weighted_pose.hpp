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

#include "plumb/arith/big.hpp"
#include "plumb/query/body/posed.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

template <class T>
struct WeightedPose {
  std::array<Vec3<T>, 3> columns{{{T(1.0), T(0.0), T(0.0)}, {T(0.0), T(1.0), T(0.0)}, {T(0.0), T(0.0), T(1.0)}}};
  Vec3<T> translation{T(0.0), T(0.0), T(0.0)};
  T weight{1.0};
  bool has_weight = false;  // other than one
  bool stands = false;      // whatever is posed

  [[nodiscard]] Vec3<T> turned(const Vec3<T>& v) const {
    return columns[0] * v.x + columns[1] * v.y + columns[2] * v.z;
  }
  /// Times the weight.
  [[nodiscard]] Vec3<T> image(const Vec3<T>& p) const { return stands ? p : turned(p) + translation; }
};

/// Running errors are carried through some operations alone; a link takes about eight in a row.
inline constexpr std::size_t few_links = 64;
template <class T>
inline constexpr bool knows_its_error =
    !std::is_same_v<T, double> && !std::is_same_v<T, mpq_class> && !requires(const T& x) {
  { x.sign() } -> std::same_as<Sign>;
};

/// Of the plane in the plane z = 0, and as it is along z.
inline Rotation rotation_of(const Rotation2& q) { return {q.w, 0, 0, q.z}; }
inline Rotation rotation_of(const Rotation& q) { return q; }

template <class T, class Turn>
WeightedPose<T> weighted_turn(const Turn& turn) {
  const auto& [w, x, y, z] = rotation_of(turn);
  WeightedPose<T> r;
  r.has_weight = true;
  if (const auto m = exact_matrix(Rotation{w, x, y, z})) {
    r.columns = {vector_of<T>(m->columns[0]), vector_of<T>(m->columns[1]), vector_of<T>(m->columns[2])};
    r.weight = T(m->weight);
    r.has_weight = m->weight != 1;
    return r;
  }
  const T ww = T(w) * T(w), xx = T(x) * T(x), yy = T(y) * T(y), zz = T(z) * T(z), two(2.0);
  const T xy = two * (T(x) * T(y)), xz = two * (T(x) * T(z)), yz = two * (T(y) * T(z));
  const T wx = two * (T(w) * T(x)), wy = two * (T(w) * T(y)), wz = two * (T(w) * T(z));
  r.columns = {{{(ww + xx) - (yy + zz), xy + wz, xz - wy},
                {xy - wz, (ww + yy) - (xx + zz), yz + wx},
                {xz + wy, yz - wx, (ww + zz) - (xx + yy)}}};
  r.weight = (ww + xx) + (yy + zz);
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
    all.translation = all.turned(r.translation) + (r.has_weight ? all.translation * r.weight : all.translation);
    all.columns = {all.turned(r.columns[0]), all.turned(r.columns[1]), all.turned(r.columns[2])};
    if (r.has_weight) all.weight = all.weight * r.weight;
    all.has_weight = all.has_weight || r.has_weight;
  }
  return all;
}

template <class T>
WeightedPose<T> weighted_pose(const PoseView& pose) {
  const auto matrix = [](const auto& by) {
    WeightedPose<T> r;
    for (std::size_t k = 0; k < by.columns.size(); ++k) r.columns[k] = arith::vec<T>(by.columns[k]);
    r.translation = arith::vec<T>(by.translation);
    return r;
  };
  return std::visit(
      [&]<class By>(const By& by) -> WeightedPose<T> {
        if constexpr (std::is_same_v<By, std::monostate>) {
          return weighted_links<T>(std::span<const RigidPose>());
        } else if constexpr (requires { by->columns; }) {
          return matrix(*by);
        } else if constexpr (requires { by->links; }) {
          return weighted_links<T>(std::span(by->links));
        } else {
          return weighted_links<T>(std::span(by, 1));
        }
      },
      pose.by);
}

/// Of a rigid pose all lengths are kept.
inline bool is_rigid(const PoseView& pose) { return pose.by.index() != 1 && pose.by.index() != 2; }

}  // namespace plumb::query
