// What changes nothing about how two figures lie?  Other names for the same set, and exact affine maps of both.
//
// Laws: renamed gives the same set of points; mapped gives the exact image, or notes that some number of it is no
// double: then the map is not for this figure.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "query/body/pair_shapes.hpp"

namespace plumb::pair_cases {

/// What a map may do besides permuting and mirroring axes and scaling by a power of two: shear along x, or turn about z
/// by the angle of the triangle of sides 3, 4 and 5, all five times as large.
enum class MapKind : unsigned char { along_axes, sheared, turned };

/// x -> 2^exponent (matrix x) + shift, with a matrix of whole numbers.
class Map {
 public:
  Map(Material& m, int dimension, MapKind kind, bool shift) {
    std::array<std::size_t, 3> order{0, 1, 2};
    if (m.below(2) == 0) std::swap(order[0], order[1]);
    if (dimension == 3 && m.below(2) == 0) std::swap(order[1], order[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const int sign = i < static_cast<std::size_t>(dimension) && m.below(2) == 0 ? -1 : 1;
      matrix_[i][order[i]] = sign;
      of_normals_[i][order[i]] = sign;
    }
    if (kind == MapKind::turned) {
      const Matrix axes = matrix_;
      for (std::size_t j = 0; j < 3; ++j) {
        matrix_[0][j] = 3 * axes[0][j] - 4 * axes[1][j];
        matrix_[1][j] = 4 * axes[0][j] + 3 * axes[1][j];
        matrix_[2][j] = 5 * axes[2][j];
      }
      of_normals_ = matrix_;
      growth_ = 5;
    }
    if (kind == MapKind::sheared) {  // then x += k y; normals y -= k x
      const int k = static_cast<int>(m.below(5)) - 2;
      for (std::size_t j = 0; j < 3; ++j) {
        matrix_[0][j] += k * matrix_[1][j];
        of_normals_[1][j] -= k * of_normals_[0][j];
      }
    }
    exponent_ = static_cast<int>(m.below(9)) - 4;
    for (std::size_t i = 0; shift && i < static_cast<std::size_t>(dimension); ++i) shift_[i] = m.number();
  }

  [[nodiscard]] bool exact() const { return exact_; }
  [[nodiscard]] bool mirrors() const {
    const auto& a = matrix_;
    const int det = a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
                    a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
                    a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
    return det < 0;
  }

  template <class P>
  P point(const P& p) {
    return as<P>(times(matrix_, p, true, true));
  }
  template <class V>
  V vector(const V& v) {  // scaled as points are
    return as<V>(times(matrix_, v, true, false));
  }
  template <class V>
  V axis(const V& v) {  // whose multiples are scaled
    return as<V>(times(matrix_, v, false, false));
  }
  template <class V>
  V normal(const V& v) {
    return as<V>(times(of_normals_, v, false, false));
  }
  double multiple(double x) { return rounded(scaled(mpq_class(x))); }  // of an axis
  double length(double x) { return rounded(scaled(mpq_class(x) * growth_)); }
  /// Of what normal . x is at most, or at least.
  template <class V>
  double offset(const V& v, double x) {
    const auto n = times(of_normals_, v, false, false);
    mpq_class sum = scaled(mpq_class(x) * growth_ * growth_);
    for (std::size_t i = 0; i < 3; ++i) sum += n[i] * mpq_class(shift_[i]);
    return rounded(sum);
  }

 private:
  using Exact = std::array<mpq_class, 3>;
  using Matrix = std::array<std::array<int, 3>, 3>;

  [[nodiscard]] mpq_class scaled(const mpq_class& x) const {
    return exponent_ >= 0 ? mpq_class(x * (1 << exponent_)) : mpq_class(x / (1 << -exponent_));
  }
  template <class P>
  Exact times(const Matrix& matrix, const P& p, bool scale, bool shift) {
    const auto x = coordinates(p);
    Exact image;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < x.size(); ++j) image[i] += matrix[i][j] * mpq_class(x[j]);
      if (scale) image[i] = scaled(image[i]);
      if (shift) image[i] += mpq_class(shift_[i]);
    }
    return image;
  }
  double rounded(const mpq_class& x) {
    const double d = x.get_d();
    exact_ = exact_ && std::isfinite(d) && mpq_class(d) == x;
    return std::isfinite(d) ? d : 0;
  }
  template <class P>
  P as(const Exact& x) {
    if constexpr (requires(P p) { p.z; }) {
      return {rounded(x[0]), rounded(x[1]), rounded(x[2])};
    } else {
      return {rounded(x[0]), rounded(x[1])};
    }
  }

  Matrix matrix_{}, of_normals_{};
  int exponent_ = 0, growth_ = 1;
  std::array<double, 3> shift_{};
  bool exact_ = true;
};

/// Boxes along the axes are only permuted and mirrored, round figures not sheared.
inline MapKind map_kind(FigureKind a, FigureKind b, Material& m) {
  const std::size_t kind = m.below(3);
  if (a == FigureKind::aabb || b == FigureKind::aabb || kind == 0) return MapKind::along_axes;
  return !query::is_flat_kind(a) || !query::is_flat_kind(b) || kind == 1 ? MapKind::turned : MapKind::sheared;
}
template <class A, class B>
MapKind map_kind(Material& m) {
  return map_kind(figure_kind<A>, figure_kind<B>, m);
}

/// By what the figure says of its members.
template <class Shape>
Shape mapped(const Shape& s, Map& map) {
  Shape t = s;
  constexpr FigureKind kind = figure_kind<Shape>;
  const auto all = [](auto& member, auto f) {
    if constexpr (requires { member.begin(); }) {
      for (auto& one : member) one = f(one);
    } else {
      member = f(member);
    }
  };
  if constexpr (requires { s.normal; }) {
    t = {map.normal(s.normal), map.offset(s.normal, s.offset)};
  } else if constexpr (requires { s.directions; }) {
    using Vector = std::remove_cvref_t<decltype(s.directions.all()[0])>;
    std::vector<Vector> directions;
    for (std::size_t i = 0; i < s.min.size(); ++i) {
      const Vector& d = s.directions.all()[i];
      directions.push_back(map.normal(d));
      t.min[i] = map.offset(d, s.min[i]);
      t.max[i] = map.offset(d, s.max[i]);
    }
    t.directions = Directions<Vector>(directions);
  } else if constexpr (requires { s.mesh; }) {
    PolygonMesh mesh = s.mesh;
    for (Point3& p : mesh.vertices) p = map.point(p);
    for (std::size_t f = 0; map.mirrors() && f + 1 < mesh.first.size(); ++f)
      std::reverse(mesh.corners.begin() + mesh.first[f], mesh.corners.begin() + mesh.first[f + 1]);
    if (map.exact()) t = convex_polyhedron(mesh);
  } else if constexpr (kind == FigureKind::aabb) {
    const auto p = map.point(s.min), q = map.point(s.max);
    const bool empty_x = s.min.x > s.max.x, empty_y = s.min.y > s.max.y;
    t.min.x = std::min(p.x, q.x), t.max.x = std::max(p.x, q.x);
    t.min.y = std::min(p.y, q.y), t.max.y = std::max(p.y, q.y);
    bool empty = empty_x || empty_y;
    if constexpr (requires { s.min.z; }) {
      t.min.z = std::min(p.z, q.z), t.max.z = std::max(p.z, q.z);
      empty = empty || s.min.z > s.max.z;
    }
    if (empty) t.min.x = 1, t.max.x = -1;
  } else {
    change_members(t, [&]<part::Role role>(part::RoleIs<role>, auto& member) {
      all(member, [&map](const auto& x) {
        if constexpr (role == part::Role::place) {
          return map.point(x);
        } else if constexpr (role == part::Role::way) {
          return map.vector(x);
        } else if constexpr (role == part::Role::axis) {
          return map.axis(x);
        } else if constexpr (role == part::Role::length) {
          return map.length(x);
        } else if constexpr (role == part::Role::multiple) {
          auto y = x;
          y.x = map.multiple(x.x), y.y = map.multiple(x.y);
          if constexpr (requires { x.z; }) y.z = map.multiple(x.z);
          return y;
        } else {
          static_assert(role == part::Role::figure);
          return mapped(x, map);
        }
      });
    });
  }
  return t;
}

/// The same set, its parts named otherwise.
template <class Shape>
Shape renamed(Material& m, const Shape& s) {
  Shape t = s;
  constexpr FigureKind kind = figure_kind<Shape>;
  const auto negated = [](auto v) {
    v.x = -v.x, v.y = -v.y;
    if constexpr (requires { v.z; }) v.z = -v.z;
    return v;
  };
  if constexpr (kind == FigureKind::line) {
    t.direction = negated(s.direction);
  } else if constexpr (kind == FigureKind::plane) {
    t = {negated(s.normal), -s.offset};
  } else if constexpr (kind == FigureKind::segment || kind == FigureKind::capsule || kind == FigureKind::cylinder) {
    std::swap(t.a, t.b);
  } else if constexpr (kind == FigureKind::triangle || kind == FigureKind::three_point_plane) {
    t = m.below(2) == 0 ? Shape{s.b, s.c, s.a} : Shape{s.a, s.c, s.b};
  } else if constexpr (kind == FigureKind::quadrilateral) {
    t = m.below(2) == 0 ? Shape{s.b, s.c, s.d, s.a} : Shape{s.a, s.d, s.c, s.b};
  } else if constexpr (kind == FigureKind::tetrahedron) {
    t = m.below(2) == 0 ? Shape{s.b, s.c, s.d, s.a} : Shape{s.b, s.a, s.c, s.d};
  } else if constexpr (requires { s.vertices; }) {
    std::rotate(t.vertices.begin(), t.vertices.begin() + 1, t.vertices.end());
    if (m.below(2) == 0) std::ranges::reverse(t.vertices);
    t.vertices.push_back(t.vertices.back());
  } else if constexpr (requires { s.outer; }) {
    t.outer = renamed(m, s.outer);
  } else if constexpr (requires { s.axes; }) {
    t.axes[0] = negated(s.axes[0]);
    t.half.y = -s.half.y;
  } else if constexpr (requires { s.halfspaces; }) {
    std::ranges::reverse(t.halfspaces);
  }
  return t;
}

}  // namespace plumb::pair_cases
