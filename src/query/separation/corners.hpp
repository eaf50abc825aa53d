// What are the corners of a convex core, over any number type?  Points as given, or sums of a point and some ways; under a
// pose, or at a time of a straight motion.
//
// Laws: (1) corner i of a sum is its point plus or minus every way, plus where bit i is set; of a box as voronoi_region numbers
// it.  (2) Numbers that can be divided (mpq_class, and those of pairs of doubles) are those of the body; all others are so
// many times that (`scale`), of both bodies of a pair, so that a rigid pose's weight divides nothing.
// Source: RTCD 4.4.
// Cost: none.
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <span>

#include "arith/sparse_vec.hpp"
#include "arith/twofold.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/query/separation/convex_body.hpp"
#include "query/body/given_box.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// Numbers that a quotient is made of.
template <class T>
inline constexpr bool can_be_divided = std::is_same_v<T, mpq_class> || std::is_same_v<T, Ball>;
template <bool Fma>
inline constexpr bool can_be_divided<Twofold<Fma>> = true;

class CoreCorners {
 public:
  /// Of points, segments, triangles, tetrahedra, boxes, rectangles, polyhedra, balls, capsules and lozenges.
  static std::optional<CoreCorners> of(const FigureView& figure);
  /// Of a line or ray the part up to a multiple of its direction, on both sides or ahead.
  static CoreCorners straight(const Point3& from, const Vector3& along, double length, bool both_sides) {
    CoreCorners c;
    c.take(std::array{from}), c.take_way(along, length), c.both_ = both_sides;
    return c;
  }
  /// Of polygons and of hulls of any points as well, and under the body's pose.  Nothing of an empty one.
  static std::optional<CoreCorners> of(const BodyView& body);

  [[nodiscard]] std::size_t size() const { return is_swept_ ? 2 * of_body() : of_body(); }
  /// A list of points of which nothing more is known.
  [[nodiscard]] bool is_listed() const { return is_swept_ || !list_.empty(); }
  [[nodiscard]] bool is_finite() const;
  /// How many ways there are; no corner but by them.
  [[nodiscard]] std::size_t ways() const { return is_swept_ ? 0 : ways_; }
  [[nodiscard]] const ConvexPolyhedron3* polyhedron() const { return is_swept_ ? nullptr : polyhedron_; }
  /// The corners before its pose, where they are points as given; none of a sum, and of what moves.
  [[nodiscard]] std::span<const Point3> points() const {
    if (is_swept_ || time_ != 0 || ways_ > 0) return {};
    if (polyhedron_ != nullptr) return polyhedron_->mesh.vertices;
    return list_.empty() ? std::span<const Point3>(points_).first(size_) : list_;
  }

  /// Is it a sum of a point and edges, and no list of corners: a box of any kind, a rectangle, a segment, a point?
  [[nodiscard]] bool is_sum() const {
    return !is_swept_ && polyhedron_ == nullptr && list_.empty() && (ways_ > 0 || size_ <= 2);
  }
  /// Of a sum: edge k leads from a corner to the one whose number has bit k besides.
  [[nodiscard]] std::size_t edges() const { return ways_ > 0 ? ways_ : size_ - 1; }
  template <class T>
  [[nodiscard]] arith::Vec<T> edge(std::size_t k) const {
    if (ways_ == 0) return at<T>(1) - at<T>(0);
    const arith::Vec<T> w = way<T>(k);
    return both_ && !aligned_ ? w + w : w;
  }
  /// Along an axis of space, of an edge that is along one (axis_of_edge) without a pose.
  template <class T>
  [[nodiscard]] T length_of_edge(std::size_t k, int axis) const {
    const auto part = [&](const auto& v) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
    if (ways_ == 0 || aligned_) return magnitude(T(part(points_[1])) - T(part(points_[0])));
    const T half = magnitude(T(part(axes_[k])) * T(half_[k]));
    return both_ ? half + half : half;
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> twice_middle() const {
    if (ways_ == 0 || aligned_ || !both_ || time_ != 0) return at<T>(0) + at<T>(size_ - 1);
    const arith::Vec<T> p = arith::vec<T>(points_[0]);
    const arith::Vec<T> middle = stands_ ? p : image(p);
    return middle + middle;
  }
  /// Which way an edge leads by what is given, without arithmetic: a multiple above zero of an axis under the pose, and
  /// of the axis that is zero where it has no length; nothing where two points differ in several coordinates.
  [[nodiscard]] std::optional<Vector3> axis_of_edge(std::size_t k) const;
  /// The same under the pose, where it is along a column of its matrix.
  [[nodiscard]] std::optional<Vector3> axis_in_space(std::size_t k) const;
  [[nodiscard]] const AnyPoseView& pose() const { return pose_; }
  /// A box along the axes of space, before its pose?
  [[nodiscard]] bool is_aligned() const { return aligned_; }
  /// Neither posed, nor moved, nor scaled?
  [[nodiscard]] bool stands() const { return stands_; }
  /// Each of the two is multiplied by the weight of the other's pose, where that is not one.
  friend void bring_to_one_weight(CoreCorners& a, CoreCorners& b);
  [[nodiscard]] bool has_scale() const { return has_scale_; }
  template <class T>
  [[nodiscard]] T scale() const {
    if constexpr (can_be_divided<T>) {
      return T(1.0);
    } else {
      if (!has_scale_) return T(1.0);
      if (is_far_) return weighted_pose<T>(pose_).weight * weighted_pose<T>(beside_).weight;
      return T(weight_) * T(beside_weight_);
    }
  }
  /// Of a box as it stands, without a pose.
  [[nodiscard]] std::optional<GivenBox> given_box() const;
  /// And of one under a pose, or beside one that is, where doubles hold its axes.
  [[nodiscard]] std::optional<PosedBox> posed_box() const;

  /// The same at a time of a straight motion.
  void move(const Vector3& by, double time) { by_ = by, time_ = time, stands_ = stands_ && time == 0; }

  /// All that it is on a straight way, less another one: those before it, then as many after it.
  void sweep(const Vector3& by, const Vector3& less) { is_swept_ = true, by_ = by, less_ = less; }

  template <class T>
  [[nodiscard]] arith::Vec<T> at(std::size_t i) const {
    if (is_swept_) return swept_at<T>(i);
    return of_body_at<T>(i);
  }
  /// From one corner to the other along way k, but for its length.
  template <class T>
  [[nodiscard]] arith::Vec<T> way(std::size_t k) const {
    return stands_ ? way_at_rest<T>(k) : turned(way_at_rest<T>(k));
  }
  /// Before its pose.
  [[nodiscard]] bool has_length(std::size_t k) const {
    if (!aligned_) return half_[k] != 0 && axes_[k] != Vector3{};
    const auto [a, b] = std::pair(points_[0], points_[1]);
    return k == 0 ? a.x != b.x : k == 1 ? a.y != b.y : a.z != b.z;
  }

 private:
  [[nodiscard]] std::size_t of_body() const {
    return polyhedron_ != nullptr ? polyhedron_->mesh.vertices.size() : size_;
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> of_body_at(std::size_t i) const {
    if (stands_) return at_rest<T>(i);
    const arith::Vec<T> p = image(at_rest<T>(i));
    return time_ == 0 ? p : p + scaled(arith::vec<T>(by_)) * T(time_);
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> swept_at(std::size_t i) const {
    const std::size_t n = of_body();
    if (i < n) return of_body_at<T>(i);
    return of_body_at<T>(i - n) + scaled(arith::vec<T>(by_)) - scaled(arith::vec<T>(less_));
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> scaled(const arith::Vec<T>& v) const {
    return has_scale_ && !can_be_divided<T> ? v * scale<T>() : v;
  }
  /// What is times the pose's own weight as it is, or times that of the other as well.
  template <class T>
  [[nodiscard]] arith::Vec<T> weighted(const arith::Vec<T>& v, const T& own, const T& other) const {
    if constexpr (std::is_same_v<T, mpq_class>) {
      return {T(v.x / own), T(v.y / own), T(v.z / own)};
    } else if constexpr (can_be_divided<T>) {
      return {quotient(v.x, own), quotient(v.y, own), quotient(v.z, own)};
    } else {
      return v * other;
    }
  }
  /// By the matrix of the pose.
  template <class T>
  [[nodiscard]] arith::Vec<T> turned(const arith::Vec<T>& v) const {
    if (is_far_) return far_image(v, false);
    const auto& c = columns_;
    if constexpr (can_be_divided<T>) {
      if (has_scale_) return is_turned_ ? divided(v) : v;
    }
    const auto r = is_turned_ ? arith::vec<T>(c[0]) * v.x + arith::vec<T>(c[1]) * v.y + arith::vec<T>(c[2]) * v.z : v;
    return has_scale_ ? weighted(r, T(weight_), T(beside_weight_)) : r;
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> image(const arith::Vec<T>& p) const {
    if (is_far_) return far_image(p, true);
    const auto& c = columns_;
    if constexpr (can_be_divided<T>) {
      if (has_scale_) return is_turned_ ? arith::sparse_sum(divided(p), arith::vec<T>(translation_)) : p;
    }
    if (!has_scale_) return is_turned_ ? turned(p) + arith::vec<T>(translation_) : p;
    if (!is_turned_) return weighted(p, T(1.0), T(beside_weight_));
    const arith::Vec<T> r = arith::vec<T>(c[0]) * p.x + arith::vec<T>(c[1]) * p.y + arith::vec<T>(c[2]) * p.z +
                            arith::vec<T>(translation_) * T(weight_);
    return weighted(r, T(weight_), T(beside_weight_));
  }
  /// Which coordinate of the body's is a coordinate of space, before it is moved?  It counts from 1 on, and is below zero
  /// for the opposite.
  [[nodiscard]] int along_of(std::size_t row) const {
    const auto part = [row](const Vector3& c) { return row == 0 ? c.x : row == 1 ? c.y : c.z; };
    const std::array x{part(columns_[0]), part(columns_[1]), part(columns_[2])};
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_it = x[(k + 1) % 3] == 0 && x[(k + 2) % 3] == 0 && (x[k] == weight_ || x[k] == -weight_);
      if (is_it) return x[k] > 0 ? static_cast<int>(k) + 1 : -static_cast<int>(k) - 1;
    }
    return 0;
  }
  /// It goes by the matrix over its weight.  Where a coordinate of space is one of the body's, or its opposite, nothing is
  /// divided.
  template <class T>
  [[nodiscard]] arith::Vec<T> divided(const arith::Vec<T>& v) const {
    const arith::Vec<T> u = arith::vec<T>(columns_[0]), w = arith::vec<T>(columns_[1]), x = arith::vec<T>(columns_[2]);
    const auto part = [&](std::size_t row, const T& of_u, const T& of_w, const T& of_x) -> T {
      if (const int along = along_of(row); along != 0) {
        const T& same = std::abs(along) == 1 ? v.x : std::abs(along) == 2 ? v.y : v.z;
        return along > 0 ? same : T(0.0) - same;
      }
      const T sum = of_u * v.x + of_w * v.y + of_x * v.z;
      if constexpr (std::is_same_v<T, mpq_class>) {
        return sum / T(weight_);
      } else {
        return weight_ == 1 ? sum : quotient(sum, T(weight_));
      }
    };
    return {part(0, u.x, w.x, x.x), part(1, u.y, w.y, x.y), part(2, u.z, w.z, x.z)};
  }
  /// Where one of the poses has a matrix that is none of doubles.  It is called, for it is rare, and its text for every kind
  /// of pose, put inline wherever pairs of doubles want all inline, were most of a library.
  template <class T>
  [[nodiscard]] [[gnu::noinline]] arith::Vec<T> far_image(const arith::Vec<T>& p, bool is_point) const {
    if constexpr (std::is_same_v<T, mpq_class>) {
      const ExactMap map = exact_map(pose_);
      const Exact3 r =
          is_point ? plumb::query::image(map, {p.x, p.y, p.z}) : plumb::query::turned(map, {p.x, p.y, p.z});
      return {r[0], r[1], r[2]};
    } else {
      const WeightedPose<T> by = weighted_pose<T>(pose_);
      const arith::Vec<T> r = is_point ? by.image(p) : by.turned(p);
      return can_be_divided<T> ? weighted(r, by.weight, T(1.0)) : weighted(r, T(1.0), weighted_pose<T>(beside_).weight);
    }
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> way_at_rest(std::size_t k) const {
    if (aligned_) {
      const auto along = [&](std::size_t axis, double from, double to) { return k == axis ? T(to) - T(from) : T(0.0); };
      return {along(0, points_[0].x, points_[1].x), along(1, points_[0].y, points_[1].y),
              along(2, points_[0].z, points_[1].z)};
    }
    return arith::sparse_scaled(arith::vec<T>(axes_[k]), T(half_[k]));
  }
  template <class T>
  [[nodiscard]] arith::Vec<T> at_rest(std::size_t i) const {
    if (polyhedron_ != nullptr) return arith::vec<T>(polyhedron_->mesh.vertices[i]);
    if (!list_.empty()) return arith::vec<T>(list_[i]);
    if (ways_ == 0) return arith::vec<T>(points_[i]);
    if (aligned_) return {T(points_[i & 1].x), T(points_[i >> 1 & 1].y), T(points_[i >> 2 & 1].z)};
    arith::Vec<T> p = arith::vec<T>(points_[0]);
    for (std::size_t k = 0; k < ways_; ++k) {
      if ((i >> k & 1) != 0) {
        p = arith::sparse_sum(p, way_at_rest<T>(k));
      } else if (both_) {
        p = arith::sparse_difference(p, way_at_rest<T>(k));
      }
    }
    return p;
  }
  void take_pose(const AnyPoseView& pose);
  template <class Points>
  void take(const Points& points) {
    for (const Point3& p : points) points_[size_++] = p;
  }
  void take_way(const Vector3& axis, double half) {
    axes_[ways_] = axis, half_[ways_++] = half;
    size_ = std::size_t{1} << ways_;
  }

  const ConvexPolyhedron3* polyhedron_ = nullptr;
  std::span<const Point3> list_;
  AnyPoseView pose_{}, beside_{};
  std::array<Vector3, 3> columns_;
  Vector3 translation_;
  double weight_ = 1, beside_weight_ = 1;
  bool is_turned_ = false;  // the columns are those of a pose
  bool is_far_ = false;     // instead of them, of either pose
  bool has_scale_ = false;
  std::array<Point3, 4> points_;
  std::array<Vector3, 3> axes_;
  std::array<double, 3> half_;
  std::size_t size_ = 0, ways_ = 0;
  bool both_ = true, aligned_ = false, is_swept_ = false;
  bool stands_ = true;  // no pose, no motion, no scale
  Vector3 by_{}, less_{};
  double time_ = 0;
};

}  // namespace plumb::query
