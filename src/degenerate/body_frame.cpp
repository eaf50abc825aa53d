#include "degenerate/body_frame.hpp"

namespace plumb::degenerate {

namespace {

Int determinant(const IntMap& map) { return dot(map.columns[0], cross(map.columns[1], map.columns[2])); }

/// Neither lengths nor angles are kept.
IntMap any_map(int dimension, Entropy& entropy) {
  IntMap map{IntMap{}.columns, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (dimension == 3 || (i != 1 && j != 1)) map.columns[i][j] += entropy.within(3);
    }
  }
  return determinant(map) == 0 ? IntMap{} : map;
}

/// The ground is a plane x + y + z = 0 or like it.
IntMap slab_map(Entropy& entropy) {
  const IntMap diagonal{{{{1, -1, 0}, {0, 1, -1}, {1, 1, 1}}}, 0};
  return after(any_permutation(3, entropy), diagonal);
}

/// So that a k-DOP stands on a face, an edge or a vertex, and a box beside it on no less than that.
IntMap k_dop_frame(const FrameOrder& order, const IntMap& permuted, Entropy& entropy) {
  const bool face = order.aligned_feature == order.dimension - 1;
  const bool slab = order.dimension == 3 && !order.rigid && !order.aabb;
  switch (entropy.below(slab ? 3 : face ? 1 : 2)) {
    case 2:
      return slab_map(entropy);
    case 1:
      if (face) return permuted;
      if (order.dimension == 2) return after(permuted, turned_about_y(entropy));
      return order.aligned_feature == 1 ? after(permuted, turned_about_x(entropy)) : any_turn(entropy);
    default:
      return permuted;
  }
}

}  // namespace

IntMap frame_of(const FrameOrder& order, Entropy& entropy) {
  const IntMap permuted = any_permutation(order.dimension, entropy);
  if (order.k_dop) return k_dop_frame(order, permuted, entropy);
  if (order.aabb && order.aligned_feature == order.dimension - 1) return permuted;
  const std::uint64_t choice = entropy.below(order.rigid ? 2 : order.slabs && order.dimension == 3 ? 4 : 3);
  if (choice == 0 && !(order.aabb && order.aligned_feature == 0)) return permuted;
  if (choice == 2) return any_map(order.dimension, entropy);
  if (choice == 3) return slab_map(entropy);
  if (order.dimension == 2) return after(permuted, turned_about_y(entropy));
  if (order.aabb && order.aligned_feature == 1) return after(permuted, turned_about_x(entropy));
  return any_turn(entropy);
}

std::array<Int3, 3> axes_of_space(const IntMap& frame, bool mirrored) {
  std::array<Int3, 3> axes{};
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i] = frame.row(i);
    if (mirrored) axes[i][2] = -axes[i][2];
  }
  return axes;
}

Int3 normal_of(const IntMap& frame, int dimension) {
  if (frame.stretch != 0) return frame.columns[2];
  const Int3 normal = cross(frame.columns[0], dimension == 2 ? Int3{0, 1, 0} : frame.columns[1]);
  return dot(normal, frame.columns[2]) < 0 ? -1 * normal : normal;
}

}  // namespace plumb::degenerate
