#include "degenerate/body.hpp"

namespace plumb::degenerate {

unsigned features_of(ShapeKind kind, int dimension) {
  const unsigned ground = dimension == 2 ? 2 : 4, all = dimension == 2 ? 3 : 7;
  switch (kind) {
    case ShapeKind::point:
    case ShapeKind::ball:
    case ShapeKind::ellipsoid:
      return 1;
    case ShapeKind::line:
      return 2;
    case ShapeKind::ray:
    case ShapeKind::segment:
    case ShapeKind::capsule:
      return 3;
    case ShapeKind::plane:
    case ShapeKind::three_point_plane:
    case ShapeKind::halfspace:
    case ShapeKind::slab:
      return ground;
    default:
      return all;
  }
}

bool is_box(ShapeKind kind) {
  return kind == ShapeKind::rectangle || kind == ShapeKind::aabb || kind == ShapeKind::obb;
}

bool has_axes(ShapeKind kind) { return is_box(kind) || kind == ShapeKind::ellipsoid; }

bool is_chain(ShapeKind kind) {
  return kind == ShapeKind::polygon || kind == ShapeKind::quadrilateral || kind == ShapeKind::holed_polygon;
}

bool is_aligned(ShapeKind kind) { return kind == ShapeKind::aabb || kind == ShapeKind::k_dop; }

bool is_round(ShapeKind kind) {
  return kind == ShapeKind::ball || kind == ShapeKind::capsule || kind == ShapeKind::lozenge ||
         kind == ShapeKind::cylinder || kind == ShapeKind::cone;
}

bool is_rigid(ShapeKind kind) { return is_box(kind) || is_round(kind); }

bool has_corners(ShapeKind kind) {
  return is_box(kind) || is_chain(kind) || kind == ShapeKind::segment || kind == ShapeKind::triangle ||
         kind == ShapeKind::tetrahedron || kind == ShapeKind::points || kind == ShapeKind::mesh;
}

Body body_around(const BodyOrder& order, Int m, bool loose) {
  Body body{order.kind, {}, 0, {}};
  auto& p = body.points;
  switch (order.kind) {
    case ShapeKind::halfspace:
      p = {{0, 0, -m}, {1, 0, -m}, {0, order.dimension == 2 ? 0 : 1, -m}, {0, 0, 0}};
      break;
    case ShapeKind::triangle:
      p = {{-m, 0, -m}, {3 * m, 0, -m}, {-m, 0, 3 * m}};
      break;
    case ShapeKind::slab:
      p = {{0, 0, -m}, {1, 0, -m}, {0, order.dimension == 2 ? 0 : 1, -m}, {0, 0, m}};
      break;
    case ShapeKind::polygon:
    case ShapeKind::quadrilateral:
    case ShapeKind::holed_polygon:
      p = {{-m, 0, -m}, {m, 0, -m}, {m, 0, m}, {-m, 0, m}};
      if (order.kind == ShapeKind::holed_polygon) body.parts = {p.size()};
      break;
    case ShapeKind::mesh:
    case ShapeKind::tetrahedron:
      if (order.kind == ShapeKind::mesh) body.parts = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
      p = {{-2 * m, -2 * m, -2 * m}, {8 * m, -2 * m, -2 * m}, {-2 * m, 8 * m, -2 * m}, {-2 * m, -2 * m, 8 * m}};
      break;
    case ShapeKind::points:
      for (const Int x : {-m, m}) {
        for (const Int z : {-m, m}) {
          if (order.dimension == 2) {
            p.push_back({x, 0, z});
          } else {
            p.insert(p.end(), {{x, -m, z}, {x, m, z}});
          }
        }
      }
      break;
    case ShapeKind::halfspaces:
      for (const Int side : {-m, m}) {
        for (std::size_t axis = 0; axis < 3; axis += order.dimension == 2 ? 2 : 1) {
          const auto& axes = IntMap{}.columns;
          const Int3 &u = axes[axis == 0 ? 2 : 0], &v = axes[axis == 1 ? 2 : 1];
          const Int3 at = side * axes[axis];
          p.insert(p.end(), {at, at + u, at + v, Int3{}});
        }
      }
      break;
    case ShapeKind::k_dop:
      for (const Int3& n : k_dop_normals(order.dimension, order.axes)) {
        Int3 corner{};
        for (std::size_t axis = 0; axis < 3; ++axis) corner[axis] = n[axis] < 0 ? -m : n[axis] > 0 ? m : 0;
        p.insert(p.end(), {-1 * corner, corner});
      }
      break;
    case ShapeKind::aabb:
    case ShapeKind::obb:
    case ShapeKind::ellipsoid: {
      const bool aligned = order.kind == ShapeKind::aabb;
      const std::array<Int3, 3> axes = aligned ? order.axes : IntMap{}.columns;
      const Int half = (aligned && loose) || order.kind == ShapeKind::ellipsoid ? 2 * m : m;
      p = {{0, 0, 0}};
      for (std::size_t i = 0; i < 3; i += order.dimension == 2 ? 2 : 1) {
        body.half.push_back(half);
        p.push_back(axes[i]);
      }
      break;
    }
    case ShapeKind::ball:
      body.radius = 2 * m;
      p = {{0, 0, 0}};
      break;
    case ShapeKind::capsule:
      body.radius = 2 * m;
      p = {{-m, 0, 0}, {m, 0, 0}};
      break;
    case ShapeKind::lozenge:
      body.radius = 2 * m;
      p = {{-m, -m, 0}, {m, -m, 0}, {-m, m, 0}};
      break;
    case ShapeKind::cylinder:
      body.radius = 2 * m;
      p = {{0, 0, -m}, {0, 0, m}};
      break;
    default:  // a cone, half as wide at the cube's top as at its bottom
      body.radius = 4 * m;
      p = {{0, 0, 3 * m}, {0, 0, -m}};
  }
  return body;
}

}  // namespace plumb::degenerate
