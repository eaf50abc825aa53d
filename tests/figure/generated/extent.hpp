// How far does a generated shape reach along a normal?  In rationals, from the definition of each kind.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <optional>
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

/// What bounds a set: all x with normal . x <= offset.  Normals are integers of at most 30 bits.
struct Bound {
  std::array<long, 3> normal;
  mpq_class offset;
};

/// The greatest value of n . x in what lies in all of them, if there is one: the least sum of offsets whose normals add
/// up to n with weights that are not negative (Farkas), of three of them at most.
class Farkas {
 public:
  Farkas(std::span<const Bound> bounds, const Rational3& n) : bounds_(bounds) {
    for (std::size_t i = 0; i < 3; ++i) n_[i] = n[i].get_num().get_si();
  }
  std::optional<mpq_class> greatest() {
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      one(i);
      for (std::size_t j = 0; j < i; ++j) {
        two(i, j);
        for (std::size_t k = 0; k < j; ++k) three(i, j, k);
      }
    }
    return least_;
  }

 private:
  __extension__ using Wide = __int128;
  using Wide3 = std::array<Wide, 3>;
  static Wide inner(const Wide3& a, const Wide3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Wide3 outer(const Wide3& a, const Wide3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  [[nodiscard]] Wide3 at(std::size_t i) const {
    const auto& n = bounds_[i].normal;
    return {n[0], n[1], n[2]};
  }
  static mpq_class quotient(Wide a, Wide b) {
    const auto integer = [](Wide x) {
      const bool negative = x < 0;
      if (negative) x = -x;
      mpz_class z = static_cast<unsigned long>(static_cast<unsigned __int128>(x) >> 64);
      z <<= 64;
      z += static_cast<unsigned long>(x);
      return negative ? mpz_class(-z) : z;
    };
    mpq_class q(integer(a), integer(b));
    q.canonicalize();
    return q;
  }
  static bool is_weight(Wide a, Wide b) { return a == 0 || (a > 0) == (b > 0); }
  void propose(const mpq_class& sum) {
    if (!least_ || sum < *least_) least_ = sum;
  }

  void one(std::size_t i) {
    const Wide3 u = at(i);
    const Wide length = inner(u, u), along = inner(u, n_);
    if (length == 0 || along < 0 || outer(u, n_) != Wide3{}) return;
    propose(quotient(along, length) * bounds_[i].offset);
  }
  void two(std::size_t i, std::size_t j) {
    const Wide3 u = at(i), v = at(j), c = outer(u, v);
    if (c == Wide3{} || inner(c, n_) != 0) return;
    const Wide all = inner(c, c), of_u = inner(outer(n_, v), c), of_v = inner(outer(u, n_), c);
    if (of_u < 0 || of_v < 0) return;
    propose(quotient(of_u, all) * bounds_[i].offset + quotient(of_v, all) * bounds_[j].offset);
  }
  void three(std::size_t i, std::size_t j, std::size_t k) {
    const Wide3 u = at(i), v = at(j), w = at(k);
    const Wide all = inner(u, outer(v, w));
    if (all == 0) return;
    const Wide of_u = inner(n_, outer(v, w)), of_v = inner(u, outer(n_, w)), of_w = inner(u, outer(v, n_));
    if (!is_weight(of_u, all) || !is_weight(of_v, all) || !is_weight(of_w, all)) return;
    propose(quotient(of_u, all) * bounds_[i].offset + quotient(of_v, all) * bounds_[j].offset +
            quotient(of_w, all) * bounds_[k].offset);
  }

  std::span<const Bound> bounds_;
  Wide3 n_{};
  std::optional<mpq_class> least_;
};

/// Of what is made of points alone, or is the hull of some, these: place after place in the row.
inline std::vector<std::span<const double>> points_of(ShapeKind kind, std::size_t dimension,
                                                      std::span<const double> numbers) {
  std::vector<std::span<const double>> points;
  const auto add = [&](std::size_t from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) points.push_back(numbers.subspan(from + i * dimension, dimension));
  };
  switch (kind) {
    case ShapeKind::point:
    case ShapeKind::segment:
    case ShapeKind::triangle:
    case ShapeKind::quadrilateral:
    case ShapeKind::polygon:
    case ShapeKind::tetrahedron:
    case ShapeKind::points:
      add(0, numbers.size() / dimension);
      break;
    case ShapeKind::holed_polygon:
      for (std::size_t at = 1; at < numbers.size(); at += 1 + static_cast<std::size_t>(numbers[at]) * dimension) {
        add(at + 1, static_cast<std::size_t>(numbers[at]));
      }
      break;
    case ShapeKind::mesh:
      add(1, static_cast<std::size_t>(numbers[0]));
      break;
    default:
      break;
  }
  return points;
}

/// Of what planes bound.
inline std::vector<Bound> bounds_of(ShapeKind kind, std::size_t dimension, std::span<const double> numbers) {
  std::vector<Bound> bounds;
  if (kind == ShapeKind::halfspaces) {
    for (std::size_t i = 0; i < numbers.size(); i += dimension + 1) {
      Bound& bound = bounds.emplace_back(Bound{{}, numbers[i + dimension]});
      for (std::size_t axis = 0; axis < dimension; ++axis) bound.normal[axis] = static_cast<long>(numbers[i + axis]);
    }
    return bounds;
  }
  std::vector<std::array<long, 3>> normals{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, -1, 0}};
  if (dimension == 3) {
    normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const auto& [x, y, z] = normals[i];
    bounds.push_back({{-x, -y, -z}, -mpq_class(numbers[i])});
    bounds.push_back({normals[i], numbers[normals.size() + i]});
  }
  return bounds;
}

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
      case ShapeKind::three_point_plane:
        for (std::size_t i = 0; i < 3; ++i) {
          point(at(i));
          if (dot(normal_, at(i)) != dot(normal_, at(0))) reach_.within = false;
        }
        break;
      case ShapeKind::slab:
        slab();
        break;
      case ShapeKind::halfspaces:
      case ShapeKind::k_dop:
        bounded();
        break;
      case ShapeKind::ellipsoid: {
        mpq_class square = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const mpq_class along = numbers_[12 + i] * dot(normal_, at(1 + i));
          square += along * along;
        }
        around(at(0), square);
        break;
      }
      default:
        for (const std::span<const double> each : points_of(kind_, dimension_, numbers_)) point(rational(each));
    }
    return reach_;
  }

  /// The corners of a shape that has some.
  [[nodiscard]] Rational3 at(std::size_t i) const { return rational(numbers_.subspan(i * dimension_, dimension_)); }

 private:
  static Rational3 rational(std::span<const double> point) {
    Rational3 p{0, 0, 0};
    for (std::size_t axis = 0; axis < point.size(); ++axis) p[axis] = point[axis];
    return p;
  }
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
  void slab() {
    const Rational3 own = at(0);
    const mpq_class along = dot(own, normal_), square = dot(normal_, normal_);
    if (along * along != dot(own, own) * square) reach_.within = false;
    const std::array<mpq_class, 2> ends{numbers_[dimension_], numbers_[dimension_ + 1]};
    for (const mpq_class& end : ends) {
      const mpq_class height = end * square / along - offset_;
      if (height > 0) reach_.within = false;
      if (height < 0) reach_.leaves = true;
    }
  }
  void bounded() {
    const std::vector<Bound> bounds = bounds_of(kind_, dimension_, numbers_);
    const std::optional<mpq_class> above = Farkas(bounds, normal_).greatest();
    reach_.within = above && *above <= offset_;
    const std::optional<mpq_class> below = Farkas(bounds, {-normal_[0], -normal_[1], -normal_[2]}).greatest();
    reach_.leaves = !below || *below > -offset_;
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
