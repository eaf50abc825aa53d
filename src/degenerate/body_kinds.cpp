#include <algorithm>
#include <cstdlib>
#include <utility>

#include "degenerate/body_drawing.hpp"

namespace plumb::degenerate {

namespace {

/// Builds one body.
class Builder {
 public:
  Builder(const BodyOrder& order, Entropy& entropy) : order_(order), entropy_(entropy) { body_.kind = order.kind; }

  Body made() && {
    switch (order_.kind) {
      case ShapeKind::point:
        vertices(1);
        break;
      case ShapeKind::segment:
        vertices(2);
        break;
      case ShapeKind::triangle:
        vertices(3);
        break;
      case ShapeKind::tetrahedron:
        vertices(4);
        break;
      case ShapeKind::points:
        vertices(4 + entropy_.below(5));
        break;
      case ShapeKind::capsule:
        vertices(2);
        lift();
        break;
      case ShapeKind::line:
      case ShapeKind::ray:
        straight();
        break;
      case ShapeKind::plane:
      case ShapeKind::halfspace:
      case ShapeKind::three_point_plane:
      case ShapeKind::slab:
        ground();
        break;
      case ShapeKind::polygon:
      case ShapeKind::quadrilateral:
      case ShapeKind::holed_polygon:
        return chain_body(draw_);
      case ShapeKind::halfspaces:
        return halfspaces_body(draw_);
      case ShapeKind::k_dop:
        return k_dop_body(draw_);
      case ShapeKind::mesh:
        return mesh_body(draw_);
      case ShapeKind::ellipsoid:
        return ellipsoid_body(draw_);
      case ShapeKind::rectangle:
      case ShapeKind::aabb:
      case ShapeKind::obb:
        box();
        break;
      case ShapeKind::lozenge:
        lozenge();
        break;
      case ShapeKind::ball:
        body_.points = {{0, 0, 0}};
        lift();
        break;
      case ShapeKind::cylinder:
        cylinder();
        break;
      case ShapeKind::cone:
        cone();
        break;
    }
    return std::move(body_);
  }

 private:
  static constexpr Int fraction = Drawing::fraction;

  [[nodiscard]] Int length(std::size_t axis) const { return draw_.length(axis); }
  [[nodiscard]] Int somewhere(std::size_t axis) const { return draw_.somewhere(axis); }

  void lift() {
    body_.radius = length(0);
    body_.move({0, 0, body_.radius});
  }

  void vertices(std::size_t count) { body_.points = vertices_of(draw_, count, 1); }

  void straight() {
    if (order_.feature == 0) {
      const Int x = order_.upright ? 0 : somewhere(0), y = order_.upright ? 0 : somewhere(1);
      body_.points = {{0, 0, 0}, {x, y, length(2)}};
      return;
    }
    const Int start = order_.kind == ShapeKind::ray ? -length(0) : somewhere(0), along = length(0);
    body_.points = {{start, 0, 0}, {start + along, 0, 0}};
    if (entropy_.coin()) body_.map({{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1});
  }

  void ground() {
    const Int x = std::max<Int>(length(0), 1), y = std::max<Int>(length(1), 1);
    body_.points = {{0, 0, 0}, {x, 0, 0}, {somewhere(0), order_.dimension == 2 ? 0 : y, 0}};
    if (order_.kind == ShapeKind::halfspace) body_.points.push_back({0, 0, 1});
    if (order_.kind == ShapeKind::slab) body_.points.push_back({somewhere(0), 0, length(2)});
    // Three points may as well be those of a line, or one.
    if (order_.kind == ShapeKind::three_point_plane && order_.extent[1] == 0) {
      body_.points = {{0, 0, 0}, {length(0), 0, 0}, {somewhere(0), 0, 0}};
    }
  }

  /// The axes of a box, the first `feature` of which lie.
  std::array<Int3, 3> axes() {
    if (order_.kind == ShapeKind::aabb) return order_.axes;
    if (order_.shared != 0 || order_.upright || order_.feature == 2) {
      // Of a rectangle that stands upright the second axis does.
      if (order_.upright && order_.feature < 2) return {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
      return IntMap{}.columns;
    }
    if (order_.dimension == 2) return order_.feature == 1 ? IntMap{}.columns : turned_about_y(entropy_).columns;
    return order_.feature == 1 ? turned_about_x(entropy_).columns : any_turn(entropy_).columns;
  }

  void box() {
    const std::array<Int3, 3> directions = axes();
    std::vector<std::size_t> used = {0, 1, 2};
    if (order_.kind == ShapeKind::rectangle || order_.kind == ShapeKind::lozenge) used = {0, 1};
    if (order_.dimension == 2) used = {0, 2};
    Int3 center{};
    std::vector<std::size_t> lying;
    std::vector<Int> sizes;
    for (const std::size_t i : used) {
      const Int size = order_.shared != 0 ? order_.shared : length(i);
      sizes.push_back(size);
      body_.half.push_back(fraction * size);
      if (directions[i][2] == 0) {
        lying.push_back(sizes.size() - 1);
      } else {
        center = center + (directions[i][2] > 0 ? fraction * size : -fraction * size) * directions[i];
      }
    }
    // Of what lies, as many directions as the feature has: the origin is within them, and at an end of the others.
    std::stable_sort(lying.begin(), lying.end(), [&](std::size_t i, std::size_t j) {
      const auto comes_last = [&](std::size_t k) { return (directions[used[k]][0] == 0) != order_.across; };
      return comes_last(i) < comes_last(j);
    });
    for (std::size_t k = 0; k < lying.size(); ++k) {
      const std::size_t i = lying[k];
      Int part = order_.shared != 0 ? 0 : entropy_.within(fraction - 1);
      if (k >= static_cast<std::size_t>(order_.feature)) part = entropy_.coin() ? -fraction : fraction;
      center = center + part * sizes[i] * directions[used[i]];
    }
    body_.points = {center};
    for (const std::size_t i : used) {
      const bool backward = order_.kind != ShapeKind::aabb && entropy_.coin();
      body_.points.push_back(center + (backward ? -1 : 1) * directions[i]);
    }
  }

  void lozenge() {
    box();
    const Int3 c = body_.points[0], u = body_.arm(0), v = body_.arm(1);
    body_.points = {c - u - v, c + u - v, c - u + v};
    body_.half.clear();
    lift();
  }

  // Right triangles of Pythagoras: p^2 + q^2 = h^2.
  std::array<Int, 3> slope() {
    constexpr std::array<std::array<Int, 3>, 4> slopes = {{{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}}};
    return slopes[entropy_.below(slopes.size())];
  }
  Int some(std::size_t axis) { return std::max<Int>(length(axis), 1); }

  void cylinder() {
    if (order_.extent[0] == 0) {
      body_.points = {{0, 0, 0}, {0, 0, 0}};
    } else if (order_.feature == 2) {
      const Int unit = length(0), x = unit * entropy_.within(fraction / 2), y = unit * entropy_.within(fraction / 2);
      body_.radius = fraction * unit;
      body_.points = {{x, y, 0}, {x, y, some(2)}};
    } else if (order_.feature == 1) {
      body_.radius = some(2);
      body_.points = {{-length(0), 0, body_.radius}, {length(0), 0, body_.radius}};
    } else {
      const auto [p, q, h] = slope();
      const Int wide = length(0), tall = some(2);
      body_.radius = wide * h;
      body_.points = {{-wide * p, 0, wide * q}, {-wide * p + tall * q, 0, wide * q + tall * p}};
    }
    if (entropy_.coin()) std::swap(body_.points[0], body_.points[1]);
  }

  void cone() {
    if (order_.extent[0] == 0) {
      body_.points = {{0, 0, 0}, {0, 0, 0}};
    } else if (order_.feature == 2) {
      const Int unit = length(0), x = unit * entropy_.within(fraction / 2), y = unit * entropy_.within(fraction / 2);
      body_.radius = fraction * unit;
      body_.points = {{x, y, some(2)}, {x, y, 0}};
    } else if (order_.feature == 1) {  // along its side, from the apex to the rim
      const auto [p, q, h] = slope();
      const Int size = length(0);
      const Int at = 1 + static_cast<Int>(entropy_.below(static_cast<std::uint64_t>(size * h * h - 1)));
      body_.radius = size * p * h;
      body_.points = {{-at, 0, 0}, {size * q * q - at, 0, size * q * p}};
    } else if (order_.upright || entropy_.coin()) {
      body_.radius = length(0);
      body_.points = {{0, 0, 0}, {0, 0, some(2)}};
    } else {  // on its rim
      const auto [p, q, h] = slope();
      const Int wide = length(0), tall = some(2);
      body_.radius = wide * h;
      body_.points = {{-wide * p + tall * q, 0, wide * q + tall * p}, {-wide * p, 0, wide * q}};
    }
  }

  const BodyOrder& order_;
  Entropy& entropy_;
  Drawing draw_{order_, entropy_};
  Body body_{};
};

}  // namespace

std::vector<Int3> vertices_of(const Drawing& draw, std::size_t count, Int unit) {
  const BodyOrder& order = draw.order;
  Entropy& entropy = draw.entropy;
  const auto length = [&](std::size_t axis) { return unit * draw.length(axis); };
  const auto somewhere = [&](std::size_t axis) { return unit * draw.somewhere(axis); };
  std::vector<Int3> p;
  const Int size = Drawing::fraction * order.shared;
  switch (std::min<int>(order.feature, static_cast<int>(count) - 1)) {
    case 0:
      p = {{0, 0, 0}};
      break;
    case 1:
      p = order.shared != 0 ? std::vector<Int3>{{-size, 0, 0}, {size, 0, 0}}
                            : std::vector<Int3>{{-length(0), 0, 0}, {length(0), 0, 0}};
      break;
    default:
      if (order.shared != 0) {
        p = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
      } else {
        const auto [right, over] = draw.corners(1);
        p = {{unit * right[0], unit * right[1], 0}, {unit * over[0], unit * over[1], 0}};
        const Int first = 1 + static_cast<Int>(entropy.below(2)), second = 1 + static_cast<Int>(entropy.below(2));
        p.push_back(-1 * (first * p[0] + second * p[1]));
      }
  }
  const std::size_t below = p.size();
  while (p.size() < count) {
    const Int3 over = p[entropy.below(below)];
    const Int x = order.upright ? over[0] : somewhere(0), y = order.upright ? over[1] : somewhere(1);
    p.push_back({x, y, length(2)});
  }
  for (std::size_t i = count - 1; i > 0; --i) std::swap(p[i], p[i - entropy.below(i + 1)]);
  return p;
}

Body body_of(const BodyOrder& order, Entropy& entropy) { return Builder(order, entropy).made(); }

}  // namespace plumb::degenerate
