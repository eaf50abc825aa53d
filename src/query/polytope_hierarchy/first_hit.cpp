// Ray cast: the coarsest polytope that is hit, then the planes about the vertices beyond the one through which the ray
// comes in.
//
// What of a finer polytope is beyond a plane that bounds the coarser one is there bounded by the faces about one vertex
// alone: the ray comes in through the last of them that it comes to.
#include <algorithm>
#include <cmath>

#include "certify/carried_errors.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "query/polytope_hierarchy/nearest.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb {
namespace query::hierarchy {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class RayDescent {
 public:
  RayDescent(const PolytopeHierarchy& h, const AnyRay& ray) : h_(h), ray_(ray) {}

  /// The face that the ray comes in by; none of one that begins within.
  [[nodiscard]] std::optional<Triangle> face_from(const NearestOfHierarchy& met) const {
    std::optional<Triangle> face;
    if (met.about) {
      face = last_about(met.level, *met.about);
    } else {
      for (const Triangle& t : h_.coarsest_faces) take_later(face, t);
    }
    if (!face || begins_beyond(*face)) return {};
    for (std::size_t i = met.level; i-- > 0;) {
      const auto beyond = beyond_plane(h_, h_.levels[i], fewest_removed(h_.levels[i], *face), Outward{*this, *face});
      if (!beyond) continue;
      face = last_about(i, *beyond);
      if (!face || begins_beyond(*face)) return {};
    }
    return face;
  }

 private:
  /// The direction outward of a face.
  struct Outward {
    const RayDescent& of;
    const Triangle& face;
    template <class Text>
    [[nodiscard]] Sign sign(const Text& text) const {
      return proved_sign([&]<class T>() { return text(of.normal<T>(face)); });
    }
    [[nodiscard]] Sign beyond(const Point3& a, const Point3& b) const {
      return sign([&]<class T>(const Vec<T>& n) { return dot(n, arith::vec<T>(a) - arith::vec<T>(b)); });
    }
  };

  template <class T>
  [[nodiscard]] Vec<T> place(std::uint32_t v) const {
    return arith::vec<T>(h_.points[v]);
  }
  template <class T>
  [[nodiscard]] Vec<T> normal(const Triangle& t) const {
    const Vec<T> from = place<T>(t[0]);
    return cross(place<T>(t[1]) - from, place<T>(t[2]) - from);
  }
  template <class T>
  [[nodiscard]] Vec<T> direction() const {
    return ray_.kind == AnyRay::Kind::segment ? arith::vec<T>(ray_.end) - arith::vec<T>(ray_.origin)
                                              : arith::vec<T>(ray_.direction);
  }
  /// How far the origin is above the face, and how fast the ray comes down to it: the quotient is when it is there.
  template <class T>
  [[nodiscard]] std::array<T, 2> coming(const Triangle& t) const {
    const Vec<T> n = normal<T>(t);
    return {dot(n, arith::vec<T>(ray_.origin) - place<T>(t[0])), T(0.0) - dot(n, direction<T>())};
  }

  void take_later(std::optional<Triangle>& last, const Triangle& t) const {
    if (proved_sign([&]<class T>() { return coming<T>(t)[1]; }) != Sign::positive) return;
    const auto is_later = [&] {
      return proved_sign([&]<class T>() {
        const auto [p, q] = coming<T>(t);
        const auto [r, s] = coming<T>(*last);
        return p * s - r * q;
      });
    };
    if (!last || is_later() == Sign::positive) last = t;
  }
  /// Of the faces about a vertex that was removed of this polytope.
  [[nodiscard]] std::optional<Triangle> last_about(std::size_t level, std::uint32_t v) const {
    const auto ring = h_.levels[level].neighbors_of_removed(v - h_.levels[level + 1].size);
    std::optional<Triangle> last;
    for (std::size_t k = 0; k < ring.size(); ++k) take_later(last, {v, ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]});
    return last;
  }
  [[nodiscard]] bool begins_beyond(const Triangle& t) const {
    return ray_.kind != AnyRay::Kind::line && proved_sign([&]<class T>() { return coming<T>(t)[0]; }) != Sign::positive;
  }
  const PolytopeHierarchy& h_;
  const AnyRay& ray_;
};

/// Of the ray as much as passes the whole polytope, a length that doubles hold: a guess, which a sign proves.
std::optional<double> length_beyond(const PolytopeHierarchy& h, const Point3& from, const Vector3& direction) {
  const Point3 farthest = support_point(h, direction).point;
  constexpr int longest = 1000, step = 8;  // guesses, of exponents
  for (int exponent = 0; exponent < longest; exponent += step) {
    const double t = std::ldexp(1.0, exponent);
    if (!std::isfinite(direction.x * t + direction.y * t + direction.z * t)) return {};
    const Sign past = proved_sign([&]<class T>() {
      const Vec<T> d = arith::vec<T>(direction);
      return dot(d, arith::vec<T>(from) - arith::vec<T>(farthest)) + dot(d, d) * T(t);
    });
    if (past == Sign::positive) return t;
  }
  return {};
}

/// The part of the ray that can meet the polytope, as a body; nothing where no doubles say it.
std::optional<CoreCorners> body_of(const PolytopeHierarchy& h, const AnyRay& ray) {
  const Vector3& d = ray.direction;
  if (ray.kind == AnyRay::Kind::segment) return CoreCorners::of(view_of(Segment3{ray.origin, ray.end}));
  if (d == Vector3{0, 0, 0}) return {};
  const auto t = length_beyond(h, ray.origin, d);
  if (!t) return {};
  if (ray.kind == AnyRay::Kind::ray) {
    const Lozenge3 along{ray.origin, {Vector3{d.x * *t, d.y * *t, d.z * *t}, Vector3{0, 0, 0}}, 0};
    return CoreCorners::of(view_of(along));
  }
  const auto back = length_beyond(h, ray.origin, {-d.x, -d.y, -d.z});
  if (!back) return {};
  return CoreCorners::of(view_of(Rectangle3{ray.origin, {d, Vector3{0, 0, 0}}, {std::max(*t, *back), 0}}));
}

}  // namespace
}  // namespace query::hierarchy

std::optional<RayParameter> first_hit_parameter(const AnyRay& ray, const PolytopeHierarchy& h) {
  using namespace query::hierarchy;
  constexpr Point3 here{0, 0, 0};
  static_cast<void>(first_hit(ray, Aabb3{here, here}));  // throws where a number of the ray is none
  const auto body = body_of(h, ray);
  const auto met = body ? nearest(h, *body) : std::nullopt;
  if (!met) return first_hit_parameter(ray, h.polyhedron);
  if (!met->meets) return {};
  const auto face = RayDescent(h, ray).face_from(*met);
  if (!face) return first_hit_parameter(ray, Aabb3{ray.origin, ray.origin});
  const auto& p = h.points;
  return first_hit_parameter(ray, ThreePointPlane3{p[(*face)[0]], p[(*face)[1]], p[(*face)[2]]});
}

}  // namespace plumb
