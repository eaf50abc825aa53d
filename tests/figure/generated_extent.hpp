// How far does a generated shape reach along a normal?  In rationals, from the definition of each kind.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>
#include <vector>

#include "plumb/degenerate/shape.hpp"

namespace plumb_test {

using plumb::degenerate::ShapeKind;
using Rational3 = std::array<mpq_class, 3>;

inline mpq_class dot(const Rational3& a, const Rational3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Whether a value lies on no further side than all, some or none of the shape does.
struct Reach {
  bool within = true;   // the shape does not go beyond the plane
  bool leaves = false;  // nor lies in it altogether
};

/// Of a shape against the plane normal . x = offset, the shape being wanted where normal . x <= offset.
class Reaching {
 public:
  Reaching(ShapeKind kind, int dimension, std::span<const double> numbers, Rational3 normal, mpq_class offset)
      : kind_(kind),
        dimension_(static_cast<std::size_t>(dimension)),
        numbers_(numbers),
        normal_(std::move(normal)),
        offset_(std::move(offset)) {}

  Reach found() {
    const std::size_t count = numbers_.size() / dimension_;
    switch (kind_) {
      case ShapeKind::line:
        point(at(0));
        if (dot(normal_, at(1)) != 0) reach_.within = false;
        break;
      case ShapeKind::ray:
        point(at(0));
        if (dot(normal_, at(1)) > 0) reach_.within = false;
        if (dot(normal_, at(1)) < 0) reach_.leaves = true;
        break;
      case ShapeKind::plane:
      case ShapeKind::halfspace:
        halfspace();
        break;
      case ShapeKind::aabb:
        box_corners();
        break;
      case ShapeKind::rectangle:
      case ShapeKind::obb:
        oriented();
        break;
      case ShapeKind::ball:
        ball(at(0));
        break;
      case ShapeKind::capsule:
        ball(at(0));
        ball(at(1));
        break;
      case ShapeKind::lozenge:
        ball(at(0));
        ball(sum(at(0), at(1)));
        ball(sum(at(0), at(2)));
        ball(sum(sum(at(0), at(1)), at(2)));
        break;
      case ShapeKind::cylinder:
        disk(at(0));
        disk(at(1));
        break;
      case ShapeKind::cone:
        point(at(0));
        disk(at(1));
        break;
      default:
        for (std::size_t i = 0; i < count; ++i) point(at(i));
    }
    return reach_;
  }

  /// The corners of a shape that has some.
  [[nodiscard]] Rational3 at(std::size_t i) const {
    Rational3 p{0, 0, 0};
    for (std::size_t axis = 0; axis < dimension_; ++axis) p[axis] = numbers_[i * dimension_ + axis];
    return p;
  }

 private:
  static Rational3 sum(const Rational3& a, const Rational3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

  void point(const Rational3& p) {
    const mpq_class height = dot(normal_, p) - offset_;
    if (height > 0) reach_.within = false;
    if (height < 0) reach_.leaves = true;
  }
  /// Of distances whose square, times that of the normal, is known.
  void around(const Rational3& p, const mpq_class& square) {
    const mpq_class room = offset_ - dot(normal_, p);
    if (room < 0 || room * room < square) reach_.within = false;
    if (room > 0) reach_.leaves = true;
  }
  [[nodiscard]] mpq_class radius() const { return numbers_.back(); }
  void ball(const Rational3& p) { around(p, radius() * radius() * dot(normal_, normal_)); }
  void disk(const Rational3& p) {
    Rational3 axis = at(1);
    for (std::size_t i = 0; i < 3; ++i) axis[i] -= at(0)[i];
    const mpq_class length = dot(axis, axis), along = dot(axis, normal_);
    const mpq_class slant = length == 0 ? mpq_class(0) : mpq_class(along * along / length);
    around(p, radius() * radius() * (dot(normal_, normal_) - slant));
  }
  void halfspace() {
    const Rational3 own = at(0);
    const mpq_class own_offset = numbers_.back();
    // Own and normal are parallel, and the plane is the same or further in.
    const mpq_class along = dot(own, normal_);
    if (along * along != dot(own, own) * dot(normal_, normal_)) reach_.within = false;
    if (kind_ == ShapeKind::halfspace) reach_.leaves = true;
    if (kind_ == ShapeKind::halfspace && along < 0) reach_.within = false;
    const mpq_class height = own_offset * dot(normal_, normal_) / along - offset_;
    if (height > 0) reach_.within = false;
    if (height < 0) reach_.leaves = true;
  }
  void box_corners() {
    for (unsigned corner = 0; corner < (1u << dimension_); ++corner) {
      Rational3 p{0, 0, 0};
      for (std::size_t axis = 0; axis < dimension_; ++axis) {
        p[axis] = at((corner >> axis) & 1)[axis];
      }
      point(p);
    }
  }
  void oriented() {
    const std::size_t axes = kind_ == ShapeKind::rectangle ? 2 : dimension_;
    for (unsigned corner = 0; corner < (1u << axes); ++corner) {
      Rational3 p = at(0);
      for (std::size_t i = 0; i < axes; ++i) {
        const mpq_class half = numbers_[(1 + axes) * dimension_ + i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const mpq_class step = half * at(1 + i)[axis];
          p[axis] += ((corner >> i) & 1) != 0 ? step : mpq_class(-step);
        }
      }
      point(p);
    }
  }

  ShapeKind kind_;
  std::size_t dimension_;
  std::span<const double> numbers_;
  Rational3 normal_;
  mpq_class offset_;
  Reach reach_;
};

}  // namespace plumb_test
