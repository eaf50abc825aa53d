// The signs of triangle_signs.hpp over posed corners; what has no area as the segment or point that it is.
#include "query/overlap/posed_triangles.hpp"

#include <array>

#include "certify/carried_errors.hpp"
#include "query/overlap/triangle_signs.hpp"

namespace plumb::query {
namespace {

/// Corners 0 to 2 of a, 3 to 5 of b.
template <class T>
class PosedSigns {
 public:
  PosedSigns(const PosedTriangle3& a, const PosedTriangle3& b, CertainSigns& ask)
      : PosedSigns(CornersTogether<T>(a, b), ask) {}

  static constexpr bool doubles_first = false;
  static constexpr std::array<std::size_t, 3> axes() { return {0, 1, 2}; }
  static std::optional<std::size_t> running_axis() { return {}; }

  [[nodiscard]] Sides sides(std::size_t i, std::size_t j) const {
    const Vec3<T> normal = cross(corner_[i + 1] - corner_[i], corner_[i + 2] - corner_[i]);
    return {over(normal, i, j), over(normal, i, j + 1), over(normal, i, j + 2)};
  }
  [[nodiscard]] Sign volume(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    const Vec3<T>& from = corner_[l];
    return ask_(dot(corner_[i] - from, cross(corner_[j] - from, corner_[k] - from)));
  }
  [[nodiscard]] Sign turn_of_b(std::size_t axis) const { return area(axis, 3, 4, 5); }
  [[nodiscard]] TriangleAreas<double> areas(std::size_t axis) const {
    return areas_by([&](std::size_t i, std::size_t j, std::size_t k) { return area(axis, i, j, k); });
  }

 private:
  PosedSigns(const CornersTogether<T>& both, CertainSigns& ask)
      : corner_{both.a[0], both.a[1], both.a[2], both.b[0], both.b[1], both.b[2]}, ask_(ask) {}

  [[nodiscard]] Sign over(const Vec3<T>& normal, std::size_t i, std::size_t j) const {
    return ask_(dot(corner_[j] - corner_[i], normal));
  }
  [[nodiscard]] Sign area(std::size_t axis, std::size_t i, std::size_t j, std::size_t k) const {
    const Vec3<T> to = corner_[j] - corner_[i], on = corner_[k] - corner_[i];
    return axis == 0   ? ask_(to.y * on.z - to.z * on.y)
           : axis == 1 ? ask_(to.z * on.x - to.x * on.z)
                       : ask_(to.x * on.y - to.y * on.x);
  }

  std::array<Vec3<T>, 6> corner_;
  CertainSigns& ask_;
};

template <class T>
bool is_zero(const Vec3<T>& v, CertainSigns& ask) {
  return ask(v.x) == Sign::zero && ask(v.y) == Sign::zero && ask(v.z) == Sign::zero;
}

/// A triangle as the set that it is; of a segment corners 0 and 1 are the ends, of a point corner 0.
template <class T>
struct PosedSet {
  std::array<Vec3<T>, 3> corner;
  Vec3<T> normal;
  int dimension;

  PosedSet(const std::array<Vec3<T>, 3>& corners, CertainSigns& ask)
      : corner(corners), normal(cross(corner[1] - corner[0], corner[2] - corner[0])), dimension(2) {
    if (!is_zero(normal, ask)) return;
    const auto between_others = [&](std::size_t i) {
      return ask(dot(corner[(i + 1) % 3] - corner[i], corner[(i + 2) % 3] - corner[i])) != Sign::positive;
    };
    const std::size_t middle = between_others(2) ? 2 : between_others(0) ? 0 : 1;
    corner = {corner[(middle + 1) % 3], corner[(middle + 2) % 3], corner[middle]};
    dimension = is_zero(along(), ask) ? 0 : 1;
  }
  [[nodiscard]] Vec3<T> along() const { return corner[1] - corner[0]; }
};

/// How deep the point is on the segment, by the nearer end; apart where it is not on its line.
template <class T>
Sign point_on_segment(const Vec3<T>& p, const PosedSet<T>& s, CertainSigns& ask) {
  const Vec3<T> e = s.along(), to = p - s.corner[0];
  if (!is_zero(cross(to, e), ask)) return Sign::negative;
  return least(ask(dot(to, e)), ask(dot(s.corner[1] - p, e)));
}

template <class T>
Sign point_in_triangle(const Vec3<T>& p, const PosedSet<T>& t, CertainSigns& ask) {
  if (ask(dot(p - t.corner[0], t.normal)) != Sign::zero) return Sign::negative;
  Sign all = Sign::positive;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<T>&from = t.corner[i], &to = t.corner[(i + 1) % 3];
    all = least(all, ask(dot(cross(to - from, p - from), t.normal)));
  }
  return all;
}

template <class T>
Sign segments_meet(const PosedSet<T>& s, const PosedSet<T>& t, CertainSigns& ask) {
  const Vec3<T> e = s.along(), f = t.along(), w = t.corner[0] - s.corner[0], n = cross(e, f);
  if (is_zero(n, ask)) {
    if (!is_zero(cross(w, e), ask)) return Sign::negative;
    const T zero(0.0), whole = dot(e, e), from = dot(w, e), to = dot(t.corner[1] - s.corner[0], e);
    const bool forward = ask(to - from) == Sign::positive;
    const T &low = forward ? from : to, &high = forward ? to : from;
    return least(ask(high - zero), ask(whole - low));
  }
  if (ask(dot(w, n)) != Sign::zero) return Sign::negative;
  const T whole = dot(n, n), on_s = dot(cross(w, f), n), on_t = dot(cross(w, e), n);
  return least(least(ask(on_s), ask(whole - on_s)), least(ask(on_t), ask(whole - on_t)));
}

/// In one plane: along the ways that can separate them, across each edge and across the segment.
template <class T>
Sign segment_in_plane(const PosedSet<T>& s, const PosedSet<T>& t, CertainSigns& ask) {
  Sign all = Sign::positive;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<T> inward = cross(t.normal, t.corner[(i + 1) % 3] - t.corner[i]);
    all = least(all, most(ask(dot(inward, s.corner[0] - t.corner[i])), ask(dot(inward, s.corner[1] - t.corner[i]))));
  }
  const Vec3<T> across = cross(t.normal, s.along());
  Sign above = Sign::negative, below = Sign::negative;
  for (const Vec3<T>& corner : t.corner) {
    const Sign side = ask(dot(across, corner - s.corner[0]));
    above = most(above, side), below = most(below, -side);
  }
  return least(all, least(above, below));
}

template <class T>
Sign segment_meets_triangle(const PosedSet<T>& s, const PosedSet<T>& t, CertainSigns& ask) {
  const Sign from = ask(dot(s.corner[0] - t.corner[0], t.normal)), to = ask(dot(s.corner[1] - t.corner[0], t.normal));
  if (from == Sign::zero && to == Sign::zero) return segment_in_plane(s, t, ask);
  Sign all = -(from * to);
  if (all == Sign::negative) return all;
  const Sign up = to != Sign::zero ? to : -from;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<T> p = t.corner[i] - s.corner[0], q = t.corner[(i + 1) % 3] - s.corner[0];
    all = least(all, up * ask(dot(s.along(), cross(p, q))));
  }
  return all;
}

/// At most one of them has an area.
template <class T>
Relation relate_without_area(const PosedTriangle3& a, const PosedTriangle3& b, CertainSigns& ask) {
  const CornersTogether<T> both(a, b);
  const PosedSet<T> p(both.a, ask), q(both.b, ask);
  const PosedSet<T>&low = p.dimension < q.dimension ? p : q, &high = p.dimension < q.dimension ? q : p;
  if (low.dimension == 1) {
    return relation(high.dimension == 1 ? segments_meet(low, high, ask) : segment_meets_triangle(low, high, ask));
  }
  if (high.dimension == 2) return relation(point_in_triangle(low.corner[0], high, ask));
  if (high.dimension == 1) return relation(point_on_segment(low.corner[0], high, ask));
  return is_zero(low.corner[0] - high.corner[0], ask) ? Relation::overlapping : Relation::disjoint;
}

[[gnu::noinline]] Relation relate_flat(const PosedTriangle3& a, const PosedTriangle3& b) {
  return certainly<SignWorlds<Ball, BigDyadic>>(
      [&]<class T>(Carrying<T>& ask) { return relate_without_area<T>(a, b, ask); });
}

}  // namespace

Relation relate(const PosedTriangle3& a, const PosedTriangle3& b) {
  const auto answer = certainly<CarriedErrors<>>(
      [&]<class T>(Carrying<T>& ask) { return relate_by(a.shape, b.shape, PosedSigns<T>(a, b, ask)); });
  return answer ? *answer : relate_flat(a, b);
}

}  // namespace plumb::query
