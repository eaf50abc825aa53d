// Edge clipping: what of an edge is within the planes of a Voronoi region, and does it come nearer beyond them?
//
// An edge is tail + t (head - tail).  A plane with the values p at the tail and q at the head is crossed at t = p / (p
// - q), and everything that is asked there is a sign of what is over that denominator.
// Laws: signs are exact.  `low` is the plane at the least t that is left, nothing where that is 0; `high` that at the
// greatest.
// Source: Mirtich 1998; RTCD 5.3.8 (Cyrus-Beck).
// Cost: two signs a plane; one more, of degree up to 8, for each that cuts.
#pragma once

#include "query/vclip/voronoi_planes.hpp"

namespace plumb::query::vclipping {

/// Sign is a callable that tells the sign of a text over number types.
template <class SignOf>
class ClippedEdge {
 public:
  /// The edge of one solid that leaves this corner, and the solid whose planes these are.
  ClippedEdge(const Solid& of, std::uint32_t corner, const Solid& by, SignOf& sign)
      : of_(of), by_(by), sign_(sign), tail_(corner), head_(of.next(corner)) {}

  /// False where the plane has all of the edge beyond it; then nothing more is to be asked but `simply`.
  bool cut(const VoronoiPlane& plane) {
    const Sign at_tail = side(plane, tail_), at_head = side(plane, head_);
    if (at_tail == Sign::negative && at_head == Sign::negative) {
      simply_ = plane;
      return false;
    }
    if (at_tail == Sign::negative && (!low_ || order(*low_, plane) == Sign::negative)) low_ = plane;
    if (at_head == Sign::negative && (!high_ || order(*high_, plane) == Sign::positive)) high_ = plane;
    return true;
  }

  [[nodiscard]] const std::optional<VoronoiPlane>& simply() const { return simply_; }
  [[nodiscard]] const std::optional<VoronoiPlane>& low() const { return low_; }
  [[nodiscard]] const std::optional<VoronoiPlane>& high() const { return high_; }
  [[nodiscard]] bool is_excluded() const {
    return simply_ || (low_ && high_ && order(*low_, *high_) == Sign::negative);
  }

  /// The feature beyond a plane that cuts where the edge comes nearer to it, or beyond that which excludes it.
  [[nodiscard]] std::optional<MeshFeature> nearer_beyond(std::optional<std::uint32_t> vertex = {}) const {
    if (simply_) return simply_->beyond;
    if (low_ && slope_at(*low_, vertex) == Sign::positive) return low_->beyond;
    if (high_ && slope_at(*high_, vertex) == Sign::negative) return high_->beyond;
    return {};
  }

  /// The height over a face of `by` where the edge crosses the plane, or at its tail or head where there is none.
  [[nodiscard]] Sign height_at(const std::optional<VoronoiPlane>& plane, std::uint32_t face, bool at_head) const {
    if (!plane) return height(face, at_head ? head_ : tail_);
    const Sign over = sign_([&]<class T>() {
      const auto [p, q] = ends<T>(*plane);
      return p * by_.height(face, at<T>(head_)) - q * by_.height(face, at<T>(tail_));
    });
    return over * run_sign(*plane);
  }
  [[nodiscard]] Sign climb(std::uint32_t face) const {
    return sign_([&]<class T>() { return dot(by_.normal<T>(face), at<T>(head_) - at<T>(tail_)); });
  }

 private:
  template <class T>
  [[nodiscard]] Vec<T> at(std::uint32_t corner) const {
    return of_.place<T>(corner);
  }
  template <class T>
  [[nodiscard]] std::array<T, 2> ends(const VoronoiPlane& p) const {
    return {p.value(by_, at<T>(tail_)), p.value(by_, at<T>(head_))};
  }
  [[nodiscard]] Sign side(const VoronoiPlane& p, std::uint32_t corner) const {
    return sign_([&]<class T>() { return p.value(by_, at<T>(corner)); });
  }
  [[nodiscard]] Sign height(std::uint32_t face, std::uint32_t corner) const {
    return sign_([&]<class T>() { return by_.height(face, at<T>(corner)); });
  }
  /// Of p - q: negative where the edge comes in, positive where it leaves.
  [[nodiscard]] Sign run_sign(const VoronoiPlane& p) const {
    return side(p, tail_) == Sign::negative ? Sign::negative : Sign::positive;
  }
  /// Negative where the second is crossed later than the first, of two planes at which the edge comes in, or leaves; of
  /// one of each where the first is crossed later.
  [[nodiscard]] Sign order(const VoronoiPlane& first, const VoronoiPlane& second) const {
    return sign_([&]<class T>() {
      const auto [p, q] = ends<T>(first);
      const auto [r, s] = ends<T>(second);
      return r * q - p * s;
    });
  }
  /// Of the distance to what is beyond, a vertex or the plane of a face, or to the vertex that is given.
  [[nodiscard]] Sign slope_at(const VoronoiPlane& plane, std::optional<std::uint32_t> vertex) const {
    if (!vertex && plane.beyond.kind == FeatureKind::face) {
      const std::uint32_t face = by_.face_of(plane.beyond.corner);
      return height_at(plane, face, false) * climb(face);
    }
    const std::uint32_t to = vertex.value_or(plane.beyond.corner);
    const Sign over = sign_([&]<class T>() {
      const auto [p, q] = ends<T>(plane);
      const Vec<T> tail = at<T>(tail_), u = at<T>(head_) - tail;
      return dot(u, tail - by_.place<T>(to)) * (p - q) + p * dot(u, u);
    });
    return over * run_sign(plane);
  }

  const Solid &of_, &by_;
  SignOf& sign_;
  std::uint32_t tail_, head_;
  std::optional<VoronoiPlane> simply_, low_, high_;
};

}  // namespace plumb::query::vclipping
