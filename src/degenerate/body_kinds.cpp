#include <algorithm>
#include <cstdlib>
#include <utility>

#include "degenerate/body.hpp"

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
        ground();
        break;
      case ShapeKind::polygon:
        polygon();
        break;
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
  static constexpr Int fraction = 8;  // sizes are multiples, so that points between are integers

  Int length(std::size_t axis) {  // in [1, extent]; 0 where there is none
    const Int most = order_.extent[axis];
    return most == 0 ? 0 : 1 + static_cast<Int>(entropy_.below(static_cast<std::uint64_t>(most)));
  }
  Int somewhere(std::size_t axis) {
    if (axis == 1 && order_.dimension == 2) return 0;
    return entropy_.within(order_.extent[axis]);
  }

  using Flat = std::array<Int, 2>;
  /// The second to the left of the first, about the origin.
  std::pair<Flat, Flat> corners(std::size_t second) {
    const Flat right{length(0), somewhere(second)};
    const Int x = somewhere(0);
    return {right, {(x > 0) == (right[1] > 0) ? -x : x, length(second)}};
  }

  void lift() {
    body_.radius = length(0);
    body_.move({0, 0, body_.radius});
  }

  void vertices(std::size_t count) {
    auto& p = body_.points;
    const Int size = fraction * order_.shared;
    switch (std::min<int>(order_.feature, static_cast<int>(count) - 1)) {
      case 0:
        p = {{0, 0, 0}};
        break;
      case 1:
        p = order_.shared != 0 ? std::vector<Int3>{{-size, 0, 0}, {size, 0, 0}}
                               : std::vector<Int3>{{-length(0), 0, 0}, {length(0), 0, 0}};
        break;
      default:
        if (order_.shared != 0) {
          p = {{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
        } else {
          const auto [right, over] = corners(1);
          p = {{right[0], right[1], 0}, {over[0], over[1], 0}};
          const Int first = 1 + static_cast<Int>(entropy_.below(2)), second = 1 + static_cast<Int>(entropy_.below(2));
          p.push_back(-1 * (first * p[0] + second * p[1]));
        }
    }
    const std::size_t below = p.size();
    while (p.size() < count) {
      const Int3 over = p[entropy_.below(below)];
      const Int x = order_.upright ? over[0] : somewhere(0), y = order_.upright ? over[1] : somewhere(1);
      p.push_back({x, y, length(2)});
    }
    for (std::size_t i = count - 1; i > 0; --i) std::swap(p[i], p[i - entropy_.below(i + 1)]);
  }

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
  }

  // Simple, as it is a star about the origin: in a plane whose second axis may lie or lean.
  void polygon() {
    const std::size_t count = 3 + entropy_.below(6);
    const std::size_t second = order_.feature == 2 && order_.dimension == 3 ? 1 : 2;
    std::vector<Flat> star;
    if (order_.feature == 2) {
      const auto [right, over] = corners(second);
      star = {right, over};
      star.push_back({-star[0][0] - star[1][0], -star[0][1] - star[1][1]});
    } else if (order_.feature == 1) {
      const Int size = fraction * order_.shared;
      star = {{order_.shared != 0 ? size : length(0), 0}, {order_.shared != 0 ? -size : -length(0), 0}};
    } else {
      star = {{0, 0}};
    }
    while (star.size() < count) {
      const Flat next{somewhere(0), order_.feature == 2 ? somewhere(second) : length(second)};
      star.push_back(order_.feature == 2 && next == Flat{} ? star[0] : next);
    }
    const auto part = [](const Flat& v) { return v == Flat{} ? 0 : v[1] > 0 || (v[1] == 0 && v[0] > 0) ? 1 : 2; };
    // On one ray nearer points come first, on the last one last: a chain that runs back would cross nothing either.
    std::stable_sort(star.begin(), star.end(), [&](const Flat& a, const Flat& b) {
      if (part(a) != part(b)) return part(a) < part(b);
      return a[0] * b[1] - a[1] * b[0] > 0;
    });
    const Int lean = order_.upright ? 0 : entropy_.within(3),
              rise = order_.upright ? 1 : 1 + static_cast<Int>(entropy_.below(3));
    for (const auto& [x, y] : star) {
      if (second == 1) {
        body_.points.push_back({x, y, 0});
      } else if (order_.dimension == 2) {
        body_.points.push_back({x, 0, y});
      } else {
        body_.points.push_back({x, lean * y, rise * y});
      }
    }
    std::rotate(body_.points.begin(), body_.points.begin() + static_cast<std::ptrdiff_t>(entropy_.below(count)),
                body_.points.end());
    if (entropy_.coin()) std::reverse(body_.points.begin(), body_.points.end());
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
    for (std::size_t i = 0; i < used.size(); ++i) {
      const Int by = order_.kind != ShapeKind::aabb && entropy_.coin() ? -body_.half[i] : body_.half[i];
      body_.points.push_back(center + by * directions[used[i]]);
    }
  }

  void lozenge() {
    box();
    const Int3 c = body_.points[0], u = body_.points[1] - c, v = body_.points[2] - c;
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
  Body body_{};
};

}  // namespace

unsigned features_of(ShapeKind kind, int dimension) {
  const unsigned ground = dimension == 2 ? 2 : 4, all = dimension == 2 ? 3 : 7;
  switch (kind) {
    case ShapeKind::point:
    case ShapeKind::ball:
      return 1;
    case ShapeKind::line:
      return 2;
    case ShapeKind::ray:
    case ShapeKind::segment:
    case ShapeKind::capsule:
      return 3;
    case ShapeKind::plane:
    case ShapeKind::halfspace:
      return ground;
    default:
      return all;
  }
}

bool is_box(ShapeKind kind) {
  return kind == ShapeKind::rectangle || kind == ShapeKind::aabb || kind == ShapeKind::obb;
}

bool is_round(ShapeKind kind) {
  return kind == ShapeKind::ball || kind == ShapeKind::capsule || kind == ShapeKind::lozenge ||
         kind == ShapeKind::cylinder || kind == ShapeKind::cone;
}

bool is_rigid(ShapeKind kind) { return is_box(kind) || is_round(kind); }

bool has_corners(ShapeKind kind) {
  return is_box(kind) || kind == ShapeKind::segment || kind == ShapeKind::triangle || kind == ShapeKind::polygon ||
         kind == ShapeKind::tetrahedron || kind == ShapeKind::points;
}

Body body_of(const BodyOrder& order, Entropy& entropy) { return Builder(order, entropy).made(); }

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
    case ShapeKind::polygon:
      p = {{-m, 0, -m}, {m, 0, -m}, {m, 0, m}, {-m, 0, m}};
      break;
    case ShapeKind::tetrahedron:
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
    case ShapeKind::aabb:
    case ShapeKind::obb: {
      const bool aligned = order.kind == ShapeKind::aabb;
      const std::array<Int3, 3> axes = aligned ? order.axes : IntMap{}.columns;
      const Int half = aligned && loose ? 2 * m : m;
      p = {{0, 0, 0}};
      for (std::size_t i = 0; i < 3; i += order.dimension == 2 ? 2 : 1) {
        body.half.push_back(half);
        p.push_back(half * axes[i]);
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
