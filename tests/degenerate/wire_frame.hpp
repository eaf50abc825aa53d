// How does a generated shape look?  Its corners and edges, outlines of what is round, and of what has no end as much as
// a window shows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "plumb/degenerate/shape.hpp"

namespace plumb_test {

using plumb::degenerate::ShapeKind;
using Vec3 = std::array<double, 3>;

inline Vec3 plus(const Vec3& a, const Vec3& b, double by = 1) {
  return {a[0] + by * b[0], a[1] + by * b[1], a[2] + by * b[2]};
}
inline Vec3 crossed(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double along(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vec3& a) { return std::sqrt(along(a, a)); }
inline Vec3 unit(const Vec3& a) { return plus({}, a, 1 / length(a)); }

/// Chains of points to be joined, and points to be marked.
struct Wires {
  std::vector<std::vector<Vec3>> chains;
  std::vector<Vec3> corners;
};

/// Makes the wires of one shape; in the plane the third coordinate is zero.
class WireFrame {
 public:
  /// `apart`: of an empty shape each bound on its own.
  WireFrame(ShapeKind kind, int dimension, std::vector<double> numbers, bool apart = false)
      : dimension_(static_cast<std::size_t>(dimension)), x_(std::move(numbers)), apart_(apart) {
    draw(kind);
    if (!has_window_) return;
    // The window is set about the corners that a far larger one shows.
    Vec3 low{}, high{};
    if (wires_.corners.empty()) wires_.corners.push_back(middle_ = somewhere_);
    low = high = wires_.corners[0];
    for (const Vec3& p : wires_.corners) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::fmin(low[axis], p[axis]), high[axis] = std::fmax(high[axis], p[axis]);
      }
    }
    middle_ = plus(plus({}, low, 0.5), high, 0.5);
    const Vec3 spread = plus(high, low, -1);
    window_ = 0.8 * std::fmax(std::fmax(spread[0], spread[1]), spread[2]);
    if (window_ == 0) window_ = std::fmax(2 * thickness_, 1);
    wires_ = {};
    draw(kind);
  }
  [[nodiscard]] const Wires& wires() const { return wires_; }

 private:
  [[nodiscard]] Vec3 at(std::size_t i, std::size_t from = 0) const {
    Vec3 p{};
    for (std::size_t axis = 0; axis < dimension_; ++axis) p[axis] = x_[from + i * dimension_ + axis];
    return p;
  }
  void join(std::vector<Vec3> chain) { wires_.chains.push_back(std::move(chain)); }
  void mark(const Vec3& p) { wires_.corners.push_back(p); }
  void closed(std::size_t count, std::size_t from = 0) {
    std::vector<Vec3> chain;
    for (std::size_t i = 0; i <= count; ++i) chain.push_back(at(i % count, from));
    for (std::size_t i = 0; i < count; ++i) mark(chain[i]);
    join(std::move(chain));
  }

  void draw(ShapeKind kind) {
    const std::size_t points = x_.size() / dimension_;
    switch (kind) {
      case ShapeKind::point:
        return mark(at(0));
      case ShapeKind::line:
      case ShapeKind::ray: {
        const Vec3 way = plus({}, at(1), 16 / length(at(1)));
        mark(at(0));
        return join({kind == ShapeKind::ray ? at(0) : plus(at(0), way, -1), plus(at(0), way)});
      }
      case ShapeKind::plane:
      case ShapeKind::three_point_plane:
      case ShapeKind::halfspace:
      case ShapeKind::slab:
      case ShapeKind::halfspaces:
      case ShapeKind::k_dop:
        return bounded(kind);
      case ShapeKind::segment:
      case ShapeKind::triangle:
      case ShapeKind::polygon:
      case ShapeKind::quadrilateral:
        return closed(points);
      case ShapeKind::tetrahedron:
      case ShapeKind::points:
        for (std::size_t i = 0; i < points; ++i) {
          mark(at(i));
          for (std::size_t j = 0; j < i && kind == ShapeKind::tetrahedron; ++j) join({at(i), at(j)});
        }
        return;
      case ShapeKind::holed_polygon:
        for (std::size_t from = 1; from < x_.size();) {
          const auto count = static_cast<std::size_t>(x_[from]);
          closed(count, from + 1);
          from += 1 + count * dimension_;
        }
        return;
      case ShapeKind::mesh: {
        const std::size_t end = 1 + 3 * static_cast<std::size_t>(x_[0]);
        for (std::size_t i = 0; 1 + 3 * i < end; ++i) mark(at(i, 1));
        const auto corner = [&](std::size_t i) { return static_cast<std::size_t>(x_[i]); };
        for (std::size_t t = end; t < x_.size(); t += 3) {
          for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = corner(t + k), b = corner(t + (k + 1) % 3);
            if (a < b) join({at(a, 1), at(b, 1)});
          }
        }
        return;
      }
      case ShapeKind::aabb: {
        const Vec3 half = plus(plus({}, at(1), 0.5), at(0), -0.5);
        return box(plus(at(0), half), {{{half[0], 0, 0}, {0, half[1], 0}, {0, 0, half[2]}}}, dimension_);
      }
      case ShapeKind::rectangle:
        return box(at(0), {plus({}, at(1), x_[9]), plus({}, at(2), x_[10]), {}}, 2);
      case ShapeKind::obb: {
        std::array<Vec3, 3> arms{};
        for (std::size_t i = 0; i < dimension_; ++i) {
          arms[i] = plus({}, at(1 + i), x_[(1 + dimension_) * dimension_ + i]);
        }
        return box(at(0), arms, dimension_);
      }
      case ShapeKind::ellipsoid: {
        const std::array arms{plus({}, at(1), x_[12]), plus({}, at(2), x_[13]), plus({}, at(3), x_[14])};
        for (std::size_t i = 0; i < 3; ++i) oval(at(0), arms[i], arms[(i + 1) % 3]);
        return mark(at(0));
      }
      default:
        return round(kind, x_.back());
    }
  }

  void box(const Vec3& center, const std::array<Vec3, 3>& arms, std::size_t count) {
    for (unsigned corner = 0; corner < (1u << count); ++corner) {
      Vec3 p = center;
      for (std::size_t i = 0; i < count; ++i) p = plus(p, arms[i], ((corner >> i) & 1) != 0 ? 1 : -1);
      mark(p);
      for (std::size_t i = 0; i < count; ++i) {
        if (((corner >> i) & 1) == 0) join({p, plus(p, arms[i], 2)});
      }
    }
  }

  void oval(const Vec3& center, const Vec3& u, const Vec3& v) {
    std::vector<Vec3> chain;
    constexpr int steps = 32;
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      chain.push_back(plus(plus(center, u, std::cos(angle)), v, std::sin(angle)));
    }
    join(std::move(chain));
  }
  void sphere(const Vec3& center, double r) {
    oval(center, {r, 0, 0}, {0, r, 0});
    if (dimension_ == 3) {
      oval(center, {r, 0, 0}, {0, 0, r});
      oval(center, {0, r, 0}, {0, 0, r});
    }
  }
  void round(ShapeKind kind, double r) {
    if (kind == ShapeKind::lozenge) {
      const std::array corners{at(0), plus(at(0), at(1)), plus(plus(at(0), at(1)), at(2)), plus(at(0), at(2))};
      for (const Vec3& c : corners) sphere(c, r);
      return join({corners[0], corners[1], corners[2], corners[3], corners[0]});
    }
    mark(at(0));
    if (kind == ShapeKind::ball) return sphere(at(0), r);
    mark(at(1));
    const Vec3 axis = plus(at(1), at(0), -1);
    const bool point = length(axis) == 0;
    const Vec3 side = dimension_ == 2                           ? Vec3{0, 0, 1}
                      : std::fabs(axis[2]) < std::fabs(axis[0]) ? Vec3{0, 0, 1}
                                                                : Vec3{1, 0, 0};
    const Vec3 u = point ? Vec3{r, 0, 0} : plus({}, unit(crossed(axis, side)), r);
    const Vec3 v = dimension_ == 2 ? Vec3{} : point ? Vec3{0, r, 0} : plus({}, unit(crossed(axis, u)), r);
    const bool cone = kind == ShapeKind::cone, capsule = kind == ShapeKind::capsule;
    for (const Vec3& way : {u, plus({}, u, -1), v, plus({}, v, -1)}) {
      join({cone ? at(0) : plus(at(0), way), plus(at(1), way)});
    }
    if (capsule) {
      sphere(at(0), r);
      sphere(at(1), r);
    } else {
      if (!cone) oval(at(0), u, v);
      oval(at(1), u, v);
    }
  }

  struct Side {
    Vec3 normal;
    double offset;
    bool of_window;
  };
  // All x with normal . x <= offset, and what the window adds: faces as polygons, each cut by all others.
  void bounded(ShapeKind kind) {
    has_window_ = true;
    std::vector<Side> sides;
    const auto add = [&](const Vec3& n, double offset) { sides.push_back({n, offset, false}); };
    const double tail = x_.back();
    if (kind == ShapeKind::halfspace || kind == ShapeKind::halfspaces) {
      for (std::size_t i = 0; i < x_.size(); i += dimension_ + 1) add(at(0, i), x_[i + dimension_]);
    } else if (kind == ShapeKind::plane) {
      add(at(0), tail);
    } else if (kind == ShapeKind::three_point_plane) {
      const Vec3 n = crossed(plus(at(1), at(0), -1), plus(at(2), at(0), -1));
      for (std::size_t i = 0; i < 3; ++i) mark(at(i));
      add(n, along(n, at(0)));
    } else if (kind == ShapeKind::slab) {
      add(plus({}, at(0), -1), -x_[dimension_]);
      add(at(0), tail);
    } else {
      const auto normals = plumb::degenerate::k_dop_normals(static_cast<int>(dimension_));
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3 n{double(normals[i][0]), double(normals[i][1]), double(normals[i][2])};
        add(plus({}, n, -1), -x_[i]);
        add(n, x_[normals.size() + i]);
      }
    }
    const std::size_t own = sides.size();
    somewhere_ = plus({}, sides[0].normal, sides[0].offset / along(sides[0].normal, sides[0].normal));
    if (kind == ShapeKind::slab) thickness_ = std::fabs(x_[dimension_] - tail) / length(at(0));
    const bool ticks = kind == ShapeKind::halfspace || kind == ShapeKind::halfspaces || kind == ShapeKind::slab;
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        Vec3 n{};
        n[axis] = sign;
        sides.push_back({n, sign * middle_[axis] + window_, true});
      }
    }
    for (std::size_t i = 0; i < own; ++i) {
      const Vec3 n = unit(sides[i].normal);
      // The foot of the middle on the plane, and a square about it that is larger than the window.
      const double far = 4 * window_, away = along(n, middle_) - sides[i].offset / length(sides[i].normal);
      const Vec3 foot = plus(middle_, n, -away);
      const Vec3 u = dimension_ == 2 ? Vec3{-n[1], n[0], 0}
                                     : unit(crossed(n, std::fabs(n[0]) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
      const Vec3 v = dimension_ == 2 ? Vec3{} : crossed(n, u);
      std::vector<Vec3> face{plus(plus(foot, u, far), v, far), plus(plus(foot, u, -far), v, far)};
      if (dimension_ == 3) {
        face.push_back(plus(plus(foot, u, -far), v, -far));
        face.push_back(plus(plus(foot, u, far), v, -far));
      }
      for (std::size_t k = 0; k < sides.size(); ++k) {
        if (k != i && !(apart_ && k < own)) face = cut(face, sides[k]);
      }
      if (face.size() < 2) continue;
      for (const Vec3& p : face) {
        const bool on_window =
            std::any_of(sides.begin() + static_cast<std::ptrdiff_t>(own), sides.end(),
                        [&](const Side& s) { return std::fabs(along(s.normal, p) - s.offset) < window_ / 1000; });
        const bool again = std::any_of(wires_.corners.begin(), wires_.corners.end(),
                                       [&](const Vec3& q) { return length(plus(p, q, -1)) < window_ / 1000; });
        if (!on_window && !again) mark(p);
      }
      if (ticks) {  // into the shape
        Vec3 center{};
        for (const Vec3& p : face) center = plus(center, p, 1 / static_cast<double>(face.size()));
        join({center, plus(center, n, -window_ / 6)});
      }
      face.push_back(face[0]);
      join(std::move(face));
    }
  }
  [[nodiscard]] std::vector<Vec3> cut(const std::vector<Vec3>& face, const Side& side) const {
    std::vector<Vec3> kept;
    const double slack = length(side.normal) * window_ / 4096;  // what a pixel does not show
    const auto above = [&](const Vec3& p) { return along(side.normal, p) - side.offset - slack; };
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 &p = face[i], &q = face[(i + 1) % face.size()];
      const double of_p = above(p), of_q = above(q);
      if (of_p <= 0) kept.push_back(p);
      if ((of_p < 0) != (of_q < 0) && of_p != of_q && face.size() > 1) {
        kept.push_back(plus(p, plus(q, p, -1), of_p / (of_p - of_q)));
      }
    }
    if (face.size() == 2 && kept.size() > 2) kept.resize(2);
    return kept;
  }

  std::size_t dimension_;
  std::vector<double> x_;
  bool apart_, has_window_ = false;
  Vec3 middle_{}, somewhere_{};
  double window_ = 0x1p14, thickness_ = 0;
  Wires wires_;
};

}  // namespace plumb_test
