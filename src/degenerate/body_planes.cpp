#include <algorithm>

#include "degenerate/body_drawing.hpp"

namespace plumb::degenerate {

namespace {

constexpr Int3 along_x{1, 0, 0}, along_y{0, 1, 0}, along_z{0, 0, 1};

// The halfspace through p whose plane goes along u and v, where `within` leads into it.
void add_halfspace(Body& body, const Int3& p, const Int3& u, const Int3& v, const Int3& within) {
  for (const Int3& at : {p, p + u, p + v, p + within}) body.points.push_back(at);
}

/// A cone or wedge that stands on the origin, and what cuts it from above and from the sides.
class Halfspaces {
 public:
  explicit Halfspaces(const Drawing& draw) : draw_(draw), flat_(draw.order.dimension == 2) {}

  Body made() {
    body_.kind = draw_.order.kind;
    if (!draw_.order.around) stand();
    const std::size_t standing = body_.points.size();
    for (std::size_t axis = 0; axis < 3; axis += flat_ ? 2 : 1) {
      const std::array<Int3, 3> axes{along_x, along_y, along_z};
      const Int3 u = axis == 0 ? along_z : along_x, v = flat_ || axis == 2 ? along_y : axis == 0 ? along_y : along_z;
      for (const Int side : {-1, 1}) {
        const Int long_as = draw_.length(axis);
        if (axis == 2 && side < 0 && !draw_.order.around && long_as != 0) continue;
        const bool open = !draw_.order.bounded && draw_.order.extent[axis] != 0 && draw_.entropy.below(4) == 3;
        if (!open) add_halfspace(body_, side * long_as * axes[axis], u, v, -side * axes[axis]);
      }
    }
    if (body_.points.empty()) add_halfspace(body_, Int3{0, 0, draw_.length(2)}, along_x, along_y, -1 * along_z);
    if (standing != 0 && draw_.entropy.below(4) == 3) {  // one of them twice
      const std::size_t at = 4 * draw_.entropy.below(standing / 4);
      for (std::size_t i = 0; i < 4; ++i) body_.points.push_back(Int3(body_.points[at + i]));
    }
    return std::move(body_);
  }

 private:
  void stand() {
    const auto some = [&] { return 1 + static_cast<Int>(draw_.entropy.below(3)); };
    if (draw_.order.feature == 2 || (flat_ && draw_.order.feature == 1)) {
      add_halfspace(body_, {}, along_x, along_y, along_z);
    } else if (draw_.order.feature == 1) {
      const Int3 right{0, some(), some()}, left{0, -some(), some()};
      for (const Int3& side : {right, left}) add_halfspace(body_, {}, along_x, side, right + left);
    } else if (flat_) {
      const Int3 right{some(), 0, some()}, left{-some(), 0, some()};
      for (const Int3& side : {right, left}) add_halfspace(body_, {}, along_y, side, right + left);
    } else {
      cone();
    }
  }
  // Three or four rays in turn about the axis upwards.
  void cone() {
    const auto some = [&] { return 1 + static_cast<Int>(draw_.entropy.below(3)); };
    const Int wide = some(), deep = some(), high = some();
    std::vector<Int3> rays = {{wide, deep, high}, {-wide, deep, high}, {-wide, -deep, high}, {wide, -deep, high}};
    if (draw_.entropy.coin()) rays = {{wide, -deep, high}, {0, some(), some()}, {-wide, -deep, some()}};
    Int3 middle{};
    for (const Int3& ray : rays) middle = middle + ray;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      add_halfspace(body_, {}, rays[i], rays[(i + 1) % rays.size()], middle);
    }
  }

  const Drawing& draw_;
  bool flat_;
  Body body_{};
};

}  // namespace

Body halfspaces_body(const Drawing& draw) { return Halfspaces(draw).made(); }

std::vector<std::array<int, 3>> k_dop_normals(int dimension) {
  if (dimension == 2) return {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, -1, 0}};
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
}

std::vector<Int3> k_dop_normals(int dimension, const std::array<Int3, 3>& axes) {
  std::vector<Int3> normals;
  for (const auto& [x, y, z] : k_dop_normals(dimension)) {
    const Int3& second = dimension == 2 ? axes[2] : axes[1];
    normals.push_back(Int{x} * axes[0] + Int{y} * second + Int{z} * axes[2]);
  }
  return normals;
}

// Halfspaces n . x <= 0 whose n do not point up, and among whose positive sums is the one straight down, keep it above
// the ground: through the origin, or along an edge.
Body k_dop_body(const Drawing& draw) {
  const BodyOrder& order = draw.order;
  Entropy& entropy = draw.entropy;
  const std::size_t axes = static_cast<std::size_t>(order.dimension);
  const Int3 edge = order.across ? along_y : along_x;
  const bool face = order.feature == order.dimension - 1, along_edge = order.feature == 1 && !face;
  const bool corner = entropy.coin();
  Body body{order.kind, {}};
  const std::vector<Int3> normals = k_dop_normals(order.dimension, order.axes);
  const auto is_straight_down = [](const Int3& n) { return n[0] == 0 && n[1] == 0; };
  std::size_t down = 0;  // directions that hold it up, along an edge
  for (const Int3& n : normals) down += along_edge && dot(n, edge) == 0 && n[2] != 0 ? 1u : 0u;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Int3& n = normals[i];
    const bool of_axis = i < axes;
    const bool side = entropy.coin();  // of what stands upright
    for (const Int sign : {-1, 1}) {
      const Int3 outward = sign * n;
      const Int height = outward[2];
      const bool chosen_side = height == 0 && (sign > 0) == side;
      bool touches = false;
      if (order.around) {
        // The origin is inside.
      } else if (face) {
        touches = is_straight_down(n) && height < 0;
      } else if (along_edge) {
        touches = dot(n, edge) == 0 && (height < 0 || (chosen_side && of_axis && down < 2));
      } else {
        touches = height < 0 ? of_axis || corner || is_straight_down(n) : chosen_side && of_axis;
      }
      Int3 place{};
      for (std::size_t k = 0; k < 3 && !touches; ++k) {
        const Int long_as = draw.length(k);
        place[k] = outward[k] < 0 ? -long_as : outward[k] > 0 ? long_as : 0;
      }
      body.points.push_back(place);
    }
  }
  return body;
}

}  // namespace plumb::degenerate
