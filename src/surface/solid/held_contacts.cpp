// How do faces meet whose corners may be points that no doubles hold?  What they have in common is spanned by corners of
// either in the other, and by passages of edges of either through the other.
#include <algorithm>
#include <optional>

#include "certify/exact_coordinates.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "surface/solid/face_contacts.hpp"
#include "surface/solid/plane_view.hpp"

namespace plumb::surface {
namespace {

using FaceCorners = TriangleMesh::Triangle;
using HomogeneousPlace = certify::meeting::Weighted<BigDyadic, 3>;

bool has_corner(const FaceCorners& corners, std::uint32_t v) { return std::ranges::find(corners, v) != corners.end(); }

/// Leaves one of a point's four homogeneous coordinates out.
std::array<const BigDyadic*, 3> all_but(std::size_t axis, const HomogeneousPlace& p) {
  std::array<const BigDyadic*, 3> kept{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != axis) kept[count++] = i < 3 ? &p.at[i] : &p.weight;
  return kept;
}

/// Tells where the line through p and q passes the plane, which neither is in.
RationalPoint3 line_through_plane(const HomogeneousPlace& p, const HomogeneousPlace& q,
                                  const std::array<HomogeneousPlace, 3>& plane) {
  std::array<BigDyadic, 4> normal;  // a point is in the plane where its products with these are 0 in sum
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto a = all_but(axis, plane[0]), b = all_but(axis, plane[1]), c = all_but(axis, plane[2]);
    const BigDyadic minor = *a[0] * (*b[1] * *c[2] - *b[2] * *c[1]) + *a[1] * (*b[2] * *c[0] - *b[0] * *c[2]) +
                            *a[2] * (*b[0] * *c[1] - *b[1] * *c[0]);
    normal[axis] = axis % 2 == 0 ? minor : BigDyadic() - minor;
  }
  const auto height = [&](const HomogeneousPlace& at) {
    return normal[0] * at.at[0] + normal[1] * at.at[1] + normal[2] * at.at[2] + normal[3] * at.weight;
  };
  const BigDyadic of_p = height(p), of_q = height(q);
  const auto between = [&](const BigDyadic& x, const BigDyadic& y) { return x * of_q - y * of_p; };
  return certify::meeting::rational(HomogeneousPlace{
      {between(p.at[0], q.at[0]), between(p.at[1], q.at[1]), between(p.at[2], q.at[2])}, between(p.weight, q.weight)});
}

class HeldContacts {
 public:
  HeldContacts(const FacePool& pool, PointTable& table) : pool_(pool), points_(pool.points()), table_(table) {}

  void meet(std::uint32_t f, std::uint32_t g) {
    const FaceCorners &a = pool_.mesh.triangles[f], &b = pool_.mesh.triangles[g];
    const Sides of_b = sides(a, b);
    if (is_flat(of_b)) {
      if (!is_apart_in_plane(a, b) && !is_apart_in_plane(b, a)) found_.coplanar.push_back({f, g});
      return;
    }
    if (meets_in_shared_alone(a, b, of_b)) return;
    const Sides of_a = sides(b, a);
    if (meets_in_shared_alone(b, a, of_a)) return;
    ends_.clear();
    add_ends(a, b, of_b);
    add_ends(b, a, of_a);
    std::ranges::sort(ends_);
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    if (ends_.empty() || (ends_.size() == 1 && has_corner(a, ends_[0]) && has_corner(b, ends_[0]))) return;
    const auto [least, most] = std::ranges::minmax(
        ends_, [&](std::uint32_t l, std::uint32_t r) { return table_.points().order(l, r) == Sign::negative; });
    found_.across.push_back({{f, g}, {std::min(least, most), std::max(least, most)}});
  }

  FaceContacts take() { return std::move(found_); }

 private:
  using Sides = std::array<Sign, 3>;

  static bool is_flat(const Sides& s) { return s[0] == Sign::zero && s[1] == Sign::zero && s[2] == Sign::zero; }

  /// The sides of the plane on which the corners are.
  [[nodiscard]] Sides sides(const FaceCorners& plane, const FaceCorners& corners) const {
    Sides of{};
    const std::optional<Level> level = level_of(plane);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = corners[k];
      if (has_corner(plane, p) || (level && is_at(p, *level))) continue;  // zero
      of[k] = points_.orient(plane[0], plane[1], plane[2], p);
    }
    return of;
  }

  /// All points that have this coordinate, exactly: what is in such a plane is so without a sign.
  struct Level {
    std::size_t axis;
    double at;
  };
  [[nodiscard]] std::optional<Level> level_of(const FaceCorners& corners) const {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Level level{axis, points_.nearest_along(corners[0], axis)};
      if (is_at(corners[0], level) && is_at(corners[1], level) && is_at(corners[2], level)) return level;
    }
    return {};
  }
  [[nodiscard]] bool is_at(std::uint32_t v, const Level& level) const {
    return points_.is_double_along(v, level.axis) && points_.nearest_along(v, level.axis) == level.at;
  }

  /// No corner but shared ones is in the plane, and all others are on one side of it.
  static bool meets_in_shared_alone(const FaceCorners& plane, const FaceCorners& corners, const Sides& of) {
    Sign side = Sign::zero;
    for (std::size_t k = 0; k < 3; ++k) {
      if (of[k] == Sign::zero && !has_corner(plane, corners[k])) return false;
      if (of[k] * side == Sign::negative) return false;
      if (of[k] != Sign::zero) side = of[k];
    }
    return true;
  }

  /// An edge has all of the other triangle beyond it or, of points that both have, on it.
  [[nodiscard]] bool is_apart_in_plane(const FaceCorners& of, const FaceCorners& other) const {
    const PlaneView view(points_, of);
    const FaceCorners& turned = view.plane().corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = turned[k], to = turned[(k + 1) % 3];
      const auto is_beyond = [&](std::uint32_t v) {
        return v == from || v == to || points_.turn_along(view.axis(), from, to, v) == Sign::negative;
      };
      if (std::ranges::all_of(other, is_beyond)) return true;
    }
    return false;
  }

  /// Adds what of the triangle b lies in the triangle a.
  void add_ends(const FaceCorners& a, const FaceCorners& b, const Sides& of_b) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = b[k], q = b[(k + 1) % 3];
      if (of_b[k] == Sign::zero && (has_corner(a, p) || surrounds(a, p))) ends_.push_back(p);
      if (of_b[k] * of_b[(k + 1) % 3] == Sign::negative && is_passed(a, p, q)) ends_.push_back(number_of(a, p, q));
    }
  }

  /// The point is in the triangle's plane.
  [[nodiscard]] bool surrounds(const FaceCorners& a, std::uint32_t p) const {
    const PlaneView view(points_, a);
    const FaceCorners& turned = view.plane().corners;
    for (std::size_t k = 0; k < 3; ++k)
      if (points_.turn_along(view.axis(), turned[k], turned[(k + 1) % 3], p) == Sign::negative) return false;
    return true;
  }

  /// The points are on two sides of the triangle's plane.
  [[nodiscard]] bool is_passed(const FaceCorners& a, std::uint32_t p, std::uint32_t q) const {
    Sign turn = Sign::zero;
    for (std::size_t k = 0; k < 3; ++k) {
      const Sign s = points_.orient(p, q, a[k], a[(k + 1) % 3]);
      if (s * turn == Sign::negative) return false;
      if (s != Sign::zero) turn = s;
    }
    return true;
  }

  [[nodiscard]] std::uint32_t number_of(const FaceCorners& a, std::uint32_t p, std::uint32_t q) {
    const auto place = [&](std::uint32_t v) { return certify::meeting::coordinates_in<BigDyadic>(points_.at(v)); };
    const std::array<std::uint32_t, 2> edge{std::min(p, q), std::max(p, q)};
    const std::uint32_t number =
        table_.number_of(line_through_plane(place(edge[0]), place(edge[1]), {place(a[0]), place(a[1]), place(a[2])}));
    table_.note_line(number, edge);
    return number;
  }

  const FacePool& pool_;
  NumberedPoints points_;
  PointTable& table_;
  std::vector<std::uint32_t> ends_;
  FaceContacts found_;
};

}  // namespace

FaceContacts find_held_contacts(const FacePool& pool, PointTable& table) {
  // Rounding keeps order, so that a point that two faces have in common has its nearest doubles in both boxes.
  std::vector<Aabb3> boxes;
  boxes.reserve(pool.mesh.triangles.size());
  for (std::uint32_t f = 0; f < pool.mesh.triangles.size(); ++f) {
    const auto [a, b, c] = pool.points_of(f);
    boxes.push_back({{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                     {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}});
  }
  HeldContacts contacts(pool, table);
  for (const BoxPair& pair : overlapping_pairs(std::span<const Aabb3>(boxes))) contacts.meet(pair.a, pair.b);
  return contacts.take();
}

}  // namespace plumb::surface
