#include "tool/stability/posed_tests.hpp"

#include <algorithm>
#include <array>

#include "plumb/predicates.hpp"

namespace plumb::tool::stability {
namespace {

bool opposite(Sign a, Sign b) { return a != Sign::zero && b == -a; }

class Scene3 {
 public:
  explicit Scene3(const Pose& pose) : pose_(pose) {}

  [[nodiscard]] bool meet(const Segment3& s, const Triangle3& t) const {
    const Sign from = volume(t.a, t.b, t.c, s.a), to = volume(t.a, t.b, t.c, s.b);
    if (from == to && from != Sign::zero) return false;
    if (from != to) {  // through the plane: on which side of the line are the edges?
      const std::array side{volume(s.a, s.b, t.a, t.b), volume(s.a, s.b, t.b, t.c), volume(s.a, s.b, t.c, t.a)};
      return one_way(side);
    }
    return segments_meet(s, {t.a, t.b}) || segments_meet(s, {t.b, t.c}) || segments_meet(s, {t.c, t.a}) ||
           within(s.a, t);
  }

 private:
  [[nodiscard]] Sign volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const {
    return orient3d(Posed{a, pose_}, Posed{b, pose_}, Posed{c, pose_}, Posed{d, pose_});
  }
  [[nodiscard]] Sign order(const Point3& a, const Point3& b) const {
    return compare_xyz(Posed{a, pose_}, Posed{b, pose_});
  }
  static bool one_way(const std::array<Sign, 3>& side) {
    return !opposite(side[0], side[1]) && !opposite(side[1], side[2]) && !opposite(side[2], side[0]);
  }

  /// Off the plane that the points span; any where they are on one line.
  template <std::size_t N>
  [[nodiscard]] Point3 apex(const std::array<Point3, N>& p) const {
    Point3 at{};
    for (const Vector3& by : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
      at = {p[0].x + by.x, p[0].y + by.y, p[0].z + by.z};
      for (std::size_t i = 2; i < N; ++i) {
        if (volume(p[0], p[1], p[i], at) != Sign::zero || volume(p[i - 1], p[i], p[0], at) != Sign::zero) return at;
      }
    }
    return at;
  }

  /// Do two segments meet?  Seen from a place off their plane.
  [[nodiscard]] bool segments_meet(const Segment3& s, const Segment3& t) const {
    if (volume(s.a, s.b, t.a, t.b) != Sign::zero) return false;
    const Point3 top = apex(std::array{s.a, s.b, t.a, t.b});
    const std::array of_t{volume(s.a, s.b, t.a, top), volume(s.a, s.b, t.b, top)};
    const std::array of_s{volume(t.a, t.b, s.a, top), volume(t.a, t.b, s.b, top)};
    if (opposite(of_t[0], of_t[1]) && opposite(of_s[0], of_s[1])) return true;
    return (of_t[0] == Sign::zero && between(t.a, s)) || (of_t[1] == Sign::zero && between(t.b, s)) ||
           (of_s[0] == Sign::zero && between(s.a, t)) || (of_s[1] == Sign::zero && between(s.b, t));
  }

  /// A point on the segment's line.
  [[nodiscard]] bool between(const Point3& p, const Segment3& s) const {
    const Sign a = order(s.a, p), b = order(s.b, p);
    return a == Sign::zero || b == Sign::zero || a != b;
  }

  /// A point in the triangle's plane; false where the triangle has no area.
  [[nodiscard]] bool within(const Point3& p, const Triangle3& t) const {
    const Point3 top = apex(std::array{t.a, t.b, t.c});
    if (volume(t.a, t.b, t.c, top) == Sign::zero) return false;
    return one_way({volume(t.a, t.b, p, top), volume(t.b, t.c, p, top), volume(t.c, t.a, p, top)});
  }

  const Pose& pose_;
};

}  // namespace

bool posed_meet(const Segment3& s, const Triangle3& t, const Pose& pose) { return Scene3(pose).meet(s, t); }

bool posed_meet(const Triangle3& a, const Triangle3& b, const Pose& pose) {
  const Scene3 scene(pose);
  const auto edge_meets = [&](const Triangle3& of, const Triangle3& other) {
    return scene.meet(Segment3{of.a, of.b}, other) || scene.meet(Segment3{of.b, of.c}, other) ||
           scene.meet(Segment3{of.c, of.a}, other);
  };
  return edge_meets(a, b) || edge_meets(b, a);
}

bool posed_in_polygon(std::span<const Point2> polygon, const Point2& p, const Pose2& pose) {
  const auto turn = [&](const Point2& a, const Point2& b, const Point2& c) {
    return orient2d(Posed{a, pose}, Posed{b, pose}, Posed{c, pose});
  };
  const auto order = [&](const Point2& a, const Point2& b) { return compare_xy(Posed{a, pose}, Posed{b, pose}); };
  const Point2 ahead{p.x + 1, p.y};
  const Sign way = turn(p, ahead, {p.x, p.y + 1});  // a mirror turns all that follows
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const Sign side = turn(a, b, p);
    if (side == Sign::zero) {
      const Sign from = order(a, p), to = order(b, p);
      if (from == Sign::zero || to == Sign::zero || from != to) return true;
      continue;
    }
    const bool a_above = turn(p, ahead, a) == way, b_above = turn(p, ahead, b) == way;
    if (a_above != b_above && (side == way) == b_above) inside = !inside;
  }
  return inside;
}

}  // namespace plumb::tool::stability
