// Ellipsoids: images of the ball under a matrix of columns g_i = half_i axes_i.  With w from the center to a point, by
// Cauchy and Binet (figure/containment/contains_ellipsoid.cpp), in space, in a plane and on a line,
//   sum of det(w, g_i, g_j)^2 <= D = det(g_0, g_1, g_2)^2,
//   sum of det(w, g_i)^2 <= D = sum of det(g_i, g_j)^2,
//   w^2 <= D = sum of g_i^2.
// In space the discriminant is D (|B d|^2 - |A^T (w x d)|^2), of the matrix A and its adjugate B; in a plane it is
// D (sum of det(d, g_i)^2 - det(w, d)^2), on a line D d^2.
#include <algorithm>
#include <span>

#include "query/ray/answers.hpp"
#include "query/ray/round_parts.hpp"

namespace plumb::query {
namespace {

template <class T>
T part(const Vec3<T>& v, std::size_t k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

/// What the columns span: the first of them that do, and a coordinate that tells.
struct EllipsoidSpan {
  int dimension = 0;
  std::size_t first = 0, second = 0;
  std::size_t telling = 0;  // left out of a plane; kept of a line
};

struct EllipsoidModel {
  const Ellipsoid3& ellipsoid;
  EllipsoidSpan span{};

  template <class T>
  [[nodiscard]] Vec3<T> column(std::size_t i) const {
    const double half = i == 0 ? ellipsoid.half.x : i == 1 ? ellipsoid.half.y : ellipsoid.half.z;
    return times(vector_of<T>(ellipsoid.axes[i]), T(half));
  }
  /// Rows of the adjugate times v.
  template <class T>
  [[nodiscard]] Vec3<T> adjugate(const Vec3<T>& v) const {
    const Vec3<T> a = column<T>(0), b = column<T>(1), c = column<T>(2);
    return {dot(v, cross(b, c)), dot(v, cross(c, a)), dot(v, cross(a, b))};
  }
  template <class T>
  [[nodiscard]] Vec3<T> adjugate_transposed(const Vec3<T>& v) const {
    const Vec3<T> a = column<T>(0), b = column<T>(1), c = column<T>(2);
    return times(cross(b, c), v.x) + times(cross(c, a), v.y) + times(cross(a, b), v.z);
  }
  template <class T>
  [[nodiscard]] T determinant() const {
    return dot(column<T>(0), cross(column<T>(1), column<T>(2)));
  }
  template <class T>
  [[nodiscard]] Vec3<T> plane_normal() const {
    return cross(column<T>(span.first), column<T>(span.second));
  }
  /// In the plane, without the coordinate that is left out.
  template <class T>
  [[nodiscard]] T flat(const Vec3<T>& u, const Vec3<T>& v) const {
    return part(cross(u, v), span.telling);
  }

  /// Constraints in pairs of opposite ones: what is zero of the points of a flat one.
  [[nodiscard]] std::size_t size() const { return span.dimension == 3 ? 0 : span.dimension == 2 ? 2 : 6; }
  template <class T>
  Linear<T> linear(const ShotLine<T>& line, std::uint32_t i, RaySigns&) const {
    const Vec3<T> w = line.origin_from(ellipsoid.center), &d = line.direction;
    const auto off = [&](const Vec3<T>& v) {
      if (span.dimension == 2) return dot(v, plane_normal<T>());
      return part(span.dimension == 1 ? cross(v, column<T>(span.first)) : v, i / 2);
    };
    const T constant = off(w), slope = off(d), zero(0.0);
    return i % 2 == 1 ? Linear<T>{zero - constant, zero - slope} : Linear<T>{constant, slope};
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line) const {
    const Vec3<T> w = line.origin_from(ellipsoid.center), &d = line.direction;
    if (span.dimension == 3) {
      const Vec3<T> at = adjugate(w), by = adjugate(d), turn = cross(w, d);
      const Vec3<T> swept{dot(column<T>(0), turn), dot(column<T>(1), turn), dot(column<T>(2), turn)};
      const T det = determinant<T>(), dd = det * det, square = length2(by);
      return {square, dot(at, by), length2(at) - dd, dd * (square - length2(swept))};
    }
    T square(0.0), half(0.0), reached(0.0), all(0.0);
    const auto add = [&](const T& at, const T& by) {
      square = square + by * by, half = half + at * by, reached = reached + at * at;
    };
    if (span.dimension == 2) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Vec3<T> g = column<T>(i);
        const T area = flat(g, column<T>((i + 1) % 3));
        add(flat(w, g), flat(d, g)), all = all + area * area;
      }
      const T turn = flat(w, d);
      return {square, half, reached - all, all * (square - turn * turn)};
    }
    if (span.dimension == 0) return {square, half, reached, all};
    add(part(w, span.telling), part(d, span.telling));
    for (std::size_t i = 0; i < 3; ++i) {
      const T g = part(column<T>(i), span.telling);
      all = all + g * g;
    }
    return {square, half, reached - all, all * square};
  }
  static Feature feature(std::span<const std::uint32_t>) { return {FeatureKind::face, 0}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided& decided, RaySigns&) const {
    if (span.dimension < 2) return still_normal(vector_of<T>(Vector3{0, 0, 0}));
    if (span.dimension == 2) {
      const Vec3<T> n = plane_normal<T>();
      return still_normal(decided.normal == 1 ? times(n, T(-1.0)) : n);
    }
    const T det = determinant<T>();
    const Vec3<T> w = line.origin_from(ellipsoid.center);
    return {adjugate_transposed(adjugate(w)), adjugate_transposed(adjugate(line.direction)), det * det, true};
  }
};

EllipsoidSpan span_of(const Ellipsoid3& ellipsoid) {
  const EllipsoidModel model{ellipsoid};
  return certainly<RayWorlds>([&]<class T>(RayWorld<T>& ask) -> EllipsoidSpan {
    if (ask(model.determinant<T>()) != Sign::zero) return {3, 0, 1, 0};
    const auto telling = [&](const Vec3<T>& v) -> std::optional<std::size_t> {
      for (std::size_t k = 0; k < 3; ++k) {
        if (ask(part(v, k)) != Sign::zero) return k;
      }
      return {};
    };
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
      if (const auto k = telling(cross(model.column<T>(i), model.column<T>(j)))) return {2, i, j, *k};
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (const auto k = telling(model.column<T>(i))) return {1, i, 0, *k};
    }
    return {};
  });
}

}  // namespace

template <class F>
auto with_model(const Ellipsoid3& ellipsoid, const RayQuestion&, const F& f) {
  return f(EllipsoidModel{ellipsoid, span_of(ellipsoid)});
}

template struct RayAnswers<Ellipsoid3>;

}  // namespace plumb::query
