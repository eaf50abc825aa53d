// Which ways out does a translation of a given direction have, or one within a cone?  Aims for the search of the
// nearest plane.
//
// A plane n . x = h, h > 0, is left by the translations t with -n . t >= h.  Of those in a cone the shortest leads
// along the point of the cone that is nearest to -n, which is a sum of up to three of the cone's directions.
// Laws: signs are exact.  Of several such sums the one of the fewest directions is taken, then of the first.
// Source: RTCD 9.3.8; Moreau 1962 (the projection on a cone).
// Cost: of a direction one sign a facet; of a cone of n some n^3.
#pragma once

#include <span>

#include "query/penetration/search.hpp"

namespace plumb::query::parting {

/// As many times the direction as lead out.
class OneWay {
 public:
  explicit OneWay(const Vector3& direction) : direction_(direction) {}

  template <class T>
  [[nodiscard]] T along(const Vec<T>& normal) const {
    return T(0.0) - dot(normal, arith::vec<T>(direction_));
  }
  /// The square of the multiple.
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t) const {
    const T h = plane.height(), w = along(plane.normal);
    return {h * h, w * w};
  }
  template <class PlaneIn>
  [[nodiscard]] std::uint32_t passage(const PlaneIn& plane) const {
    return sign_of([&]<class T>() -> T { return along(plane.template operator()<T>().normal); }) == Sign::positive ? 1
                                                                                                                   : 0;
  }

 private:
  Vector3 direction_;
};

/// Up to three directions of a cone, which are independent.
struct ConePart {
  std::array<std::uint32_t, 3> index{};
  std::uint32_t size = 0;
};

/// The point of the span of a part that is nearest to v: the sum of the directions times weight / whole, whole above
/// zero.
template <class T>
struct InPart {
  std::array<Vec<T>, 3> direction;
  std::array<T, 3> weight, share;  // share: the direction's product with v
  T whole;

  InPart(const ConePart& part, std::span<const Vector3> all, const Vec<T>& v)
      : direction{of(part, all, 0), of(part, all, 1), of(part, all, 2)},
        weight{T(0.0), T(0.0), T(0.0)},
        share{dot(direction[0], v), dot(direction[1], v), dot(direction[2], v)},
        whole(T(0.0)) {
    const auto& g = direction;
    if (part.size == 1) {
      whole = dot(g[0], g[0]), weight[0] = share[0];
    } else if (part.size == 2) {
      const T uu = dot(g[0], g[0]), uv = dot(g[0], g[1]), vv = dot(g[1], g[1]);
      whole = uu * vv - uv * uv;
      weight[0] = share[0] * vv - share[1] * uv, weight[1] = share[1] * uu - share[0] * uv;
    } else {
      const T turn = dot(g[0], cross(g[1], g[2]));  // times itself, so that the whole is above zero
      whole = turn * turn;
      weight[0] = dot(v, cross(g[1], g[2])) * turn, weight[1] = dot(g[0], cross(v, g[2])) * turn,
      weight[2] = dot(g[0], cross(g[1], v)) * turn;
    }
  }
  /// The point times the whole, and its product with v, which is the square of its length times the whole.
  [[nodiscard]] Vec<T> point() const {
    return direction[0] * weight[0] + direction[1] * weight[1] + direction[2] * weight[2];
  }
  [[nodiscard]] T square() const { return weight[0] * share[0] + weight[1] * share[1] + weight[2] * share[2]; }

 private:
  static Vec<T> of(const ConePart& part, std::span<const Vector3> all, std::size_t i) {
    if (i < part.size) return arith::vec<T>(all[part.index[i]]);
    return no_way<T>();
  }
};

/// By the shortest translation in the cone.
class InCone {
 public:
  explicit InCone(std::span<const Vector3> directions);

  [[nodiscard]] const ConePart& part(std::uint32_t passage) const { return parts_[passage - 1]; }
  [[nodiscard]] std::span<const Vector3> directions() const { return directions_; }

  /// The square of its length.
  template <class T>
  [[nodiscard]] Fraction<T> measure(const PlaneOf<T>& plane, std::uint32_t passage) const {
    const InPart<T> in(part(passage), directions_, inward(plane.normal));
    const T h = plane.height();
    return {h * h * in.whole, in.square()};
  }
  /// The part of the cone that the translation is in, by its number; 0 where no translation leads out.
  template <class PlaneIn>
  [[nodiscard]] std::uint32_t passage(const PlaneIn& plane) const {
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      if (is_nearest_in(parts_[p], plane)) return p + 1;
    }
    return 0;
  }

 private:
  template <class T>
  static Vec<T> inward(const Vec<T>& normal) {
    return no_way<T>() - normal;
  }
  /// With weights above zero, and no direction of the cone leads nearer.
  template <class PlaneIn>
  [[nodiscard]] bool is_nearest_in(const ConePart& part, const PlaneIn& plane) const {
    const auto in_part = [&]<class T>() {
      return InPart<T>(part, directions_, inward(plane.template operator()<T>().normal));
    };
    for (std::size_t i = 0; i < part.size; ++i) {
      if (sign_of([&]<class T>() -> T { return in_part.template operator()<T>().weight[i]; }) != Sign::positive)
        return false;
    }
    for (const Vector3& d : directions_) {
      const Sign nearer = sign_of([&]<class T>() -> T {
        const InPart<T> in = in_part.template operator()<T>();
        const Vec<T> left = inward(plane.template operator()<T>().normal) * in.whole - in.point();
        return dot(left, arith::vec<T>(d));
      });
      if (nearer == Sign::positive) return false;
    }
    return true;
  }

  std::span<const Vector3> directions_;
  std::vector<ConePart> parts_;
};

}  // namespace plumb::query::parting
