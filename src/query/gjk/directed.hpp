// The simplex of GJK without lengths: in which direction does the nearest point of up to four corners lie?  A guess in
// doubles, which holds no bound.
//
// Laws: a corner that is added is kept, for what it is added to has been left toward it; four are kept where the origin
// seems to be within.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5.1, 5.1.5, 5.1.6.
// Cost: 10 to 80 operations a corner, no quotient and no root.
#pragma once

#include "arith/vec.hpp"
#include "plumb/query/gjk/gjk.hpp"

namespace plumb::query::gjk_search {

using arith::Plain, arith::Vec, arith::cross, arith::dot;

/// A corner of the difference, in doubles or double-doubles.
template <class T>
struct CornerOf {
  GjkCorner ends;
  Vec<T> at;
};
using Corner = CornerOf<double>;

/// The simplex, without lengths: the direction to its nearest point alone.
template <class T>
class DirectedOf {
  using Corner = CornerOf<T>;
  using Way = Vec<T>;

 public:
  explicit DirectedOf(const Corner& first) : size_(1), direction_(first.at) { corners_[0] = first; }

  [[nodiscard]] const Way& direction() const { return direction_; }
  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] const Corner& operator[](std::size_t i) const { return corners_[i]; }
  [[nodiscard]] bool has(const GjkCorner& ends) const {
    for (std::uint32_t i = 0; i < size_; ++i) {
      if (corners_[i].ends == ends) return true;
    }
    return false;
  }

  /// A fourth corner, if it is one: true where the origin seems to be within.
  bool add(const Corner& c) {
    const Way back = c.at * T(-1);
    switch (size_) {
      case 1:
        edge(corners_[0], c, back);
        return false;
      case 2:
        triangle(corners_[0], corners_[1], c, back);
        return false;
      default:
        return tetrahedron(c, back);
    }
  }

 private:
  static constexpr T zero() { return T(0.0); }
  void take(const Corner& p) { corners_[0] = p, size_ = 1, direction_ = p.at; }
  void take(const Corner& p, const Corner& q, const Way& direction) {
    const std::array<Corner, 2> two{p, q};
    corners_[0] = two[0], corners_[1] = two[1], size_ = 2, direction_ = direction;
  }
  /// Of p and the new corner c, at which the origin lies `back`.
  void edge(const Corner& p, const Corner& c, const Way& back) {
    const Way u = p.at - c.at;
    if (dot(u, back) > zero()) {
      take(p, c, cross(u, cross(c.at, u)));
    } else {
      take(c);
    }
  }
  void triangle(const Corner& p, const Corner& q, const Corner& c, const Way& back) {
    const Way u = p.at - c.at, v = q.at - c.at, n = cross(u, v);
    if (dot(cross(u, n), back) > zero()) {
      if (dot(u, back) > zero()) {
        take(p, c, cross(u, cross(c.at, u)));
      } else {
        edge(Corner(q), Corner(c), back);
      }
    } else if (dot(cross(n, v), back) > zero()) {
      edge(Corner(q), Corner(c), back);
    } else {
      const std::array<Corner, 3> three{p, q, c};
      for (std::size_t i = 0; i < 3; ++i) corners_[i] = three[i];
      size_ = 3, direction_ = n * T(dot(n, back) > zero() ? -1.0 : 1.0);
    }
  }
  bool tetrahedron(const Corner& c, const Way& back) {
    const Way u = corners_[0].at - c.at, v = corners_[1].at - c.at, w = corners_[2].at - c.at;
    const Way uv = cross(u, v), vw = cross(v, w), wu = cross(w, u);
    const T turn(dot(uv, w) > zero() ? -1.0 : 1.0);  // the three look outward
    const std::array outside{dot(uv, back) * turn, dot(vw, back) * turn, dot(wu, back) * turn};
    if (outside[0] <= zero() && outside[1] <= zero() && outside[2] <= zero()) {
      corners_[3] = c, size_ = 4;
      return true;
    }
    // The face that the origin is farthest beyond.
    const std::array lengths{dot(uv, uv), dot(vw, vw), dot(wu, wu)};
    std::size_t face = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      if (outside[i] <= zero()) continue;
      if (face == 3 || outside[i] * outside[i] * lengths[face] > outside[face] * outside[face] * lengths[i]) face = i;
    }
    const Corner p = corners_[face], q = corners_[face == 2 ? 0 : face + 1];
    triangle(p, q, Corner(c), back);
    return false;
  }

  std::array<Corner, 4> corners_{};
  std::uint32_t size_;
  Way direction_;
};
using Directed = DirectedOf<double>;

}  // namespace plumb::query::gjk_search
