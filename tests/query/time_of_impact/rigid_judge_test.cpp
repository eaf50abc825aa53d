// Posed pairs against rational numbers by another statement: Hamilton's product q p q* / |q|^2 moves each point, and the
// distance of balls, capsules and boxes is the least of that between ends, edges and faces.  Degenerate ones first: radii
// of zero, capsules that are points, flat boxes, turns of a cube, pairs that touch.  The long form asks a million.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/sanitized.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/separation/posed.hpp"
#include "query/body/rigid_cases.hpp"

namespace plumb::pair_cases {
namespace {

using Number = mpq_class;
struct Place {
  Number x, y, z;
};
Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Place times(const Number& t, const Place& a) { return {t * a.x, t * a.y, t * a.z}; }
Number dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Quaternion {
  Number w;
  Place v;
};
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Place cross{a.v.y * b.v.z - a.v.z * b.v.y, a.v.z * b.v.x - a.v.x * b.v.z, a.v.x * b.v.y - a.v.y * b.v.x};
  return {a.w * b.w - dot(a.v, b.v), times(a.w, b.v) + times(b.w, a.v) + cross};
}
/// q p q* / |q|^2, or q* p q.
Place turned(const Rotation& turn, const Place& p, bool back) {
  const Quaternion q{turn.w, {turn.x, turn.y, turn.z}}, other{turn.w, {-q.v.x, -q.v.y, -q.v.z}};
  const Number square = q.w * q.w + dot(q.v, q.v);
  return times(1 / square, back ? product(product(other, {0, p}), q).v : product(product(q, {0, p}), other).v);
}
Place place(const Vector3& v) { return {v.x, v.y, v.z}; }
Place place(const Point3& p) { return {p.x, p.y, p.z}; }

using Links = std::vector<RigidPose>;
Place image(const Links& links, Place p) {
  for (std::size_t i = links.size(); i-- > 0;) p = turned(links[i].turn, p, false) + place(links[i].translation);
  return p;
}
Place before(const Links& links, Place p) {
  for (const RigidPose& link : links) p = turned(link.turn, p - place(link.translation), true);
  return p;
}

Number to_segment(const Place& p, const Place& a, const Place& b) {
  const Place u = b - a;
  const Number length = dot(u, u);
  Number t = length == 0 ? Number(0) : Number(dot(p - a, u) / length);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Place d = p - (a + times(t, u));
  return dot(d, d);
}
/// Of two segments: between ends, or where both are at right angles to the way.
Number between(const Place& a, const Place& b, const Place& c, const Place& d) {
  Number least = std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
  const Place u = b - a, v = d - c, w = a - c;
  const Number uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), whole = uu * vv - uv * uv;
  if (whole == 0) return least;
  const Number s = (uv * dot(v, w) - vv * dot(u, w)) / whole, t = (uu * dot(v, w) - uv * dot(u, w)) / whole;
  if (s < 0 || s > 1 || t < 0 || t > 1) return least;
  const Place n = w + times(s, u) - times(t, v);
  return std::min(least, dot(n, n));
}

struct Corners {
  Place low, high;
  [[nodiscard]] Place at(unsigned i) const {
    return {(i & 1u) != 0 ? high.x : low.x, (i & 2u) != 0 ? high.y : low.y, (i & 4u) != 0 ? high.z : low.z};
  }
};
Number beyond(const Number& x, const Number& low, const Number& high) {
  return x < low ? Number(low - x) : x > high ? Number(x - high) : Number(0);
}
Number to_box(const Place& p, const Corners& b) {
  const Number x = beyond(p.x, b.low.x, b.high.x), y = beyond(p.y, b.low.y, b.high.y),
               z = beyond(p.z, b.low.z, b.high.z);
  return x * x + y * y + z * z;
}
/// Does a part of the segment lie within the box?
bool enters(const Place& a, const Place& b, const Corners& box) {
  Number from = 0, to = 1;
  const auto clip = [&](const Number& p, const Number& q, const Number& low, const Number& high) {
    const Number d = q - p;
    if (d == 0) return p >= low && p <= high;
    Number s = (low - p) / d, t = (high - p) / d;
    if (s > t) std::swap(s, t);
    from = std::max(from, s), to = std::min(to, t);
    return from <= to;
  };
  return clip(a.x, b.x, box.low.x, box.high.x) && clip(a.y, b.y, box.low.y, box.high.y) &&
         clip(a.z, b.z, box.low.z, box.high.z);
}
Number between(const Place& a, const Place& b, const Corners& box) {
  if (enters(a, b, box)) return 0;
  Number least = std::min(to_box(a, box), to_box(b, box));
  for (unsigned i = 0; i < 8; ++i) {
    for (unsigned bit = 1; bit < 8; bit *= 2) {
      if ((i & bit) == 0) least = std::min(least, between(a, b, box.at(i), box.at(i | bit)));
    }
  }
  return least;
}

/// Is it the double nearest to root(square) - radii, or zero where that is none above zero?
bool is_rounded(double d, const Number& square, const Number& radii) {
  if (square <= radii * radii) return d == 0;
  if (!(d > 0)) return false;
  const auto middle = [](double p, double q) { return Number((Number(p) + Number(q)) / 2); };
  const Number low = radii + middle(std::nextafter(d, 0), d), high = radii + middle(d, std::nextafter(d, INFINITY));
  return low * low <= square && square <= high * high;
}

struct Drawn {
  RigidCase by;
  Links links;
};
Drawn drawn_pose(Material& m, bool is_simple) {
  Drawn d{rigid_case(m), {}};
  if (is_simple) {
    const auto part = [&] { return static_cast<double>(m.below(3)) - 1; };
    RigidPose pose{{1, part(), 0, 0}, {part(), 2 * part(), part()}};
    if (m.below(2) == 0) std::swap(pose.turn.x, m.below(2) == 0 ? pose.turn.y : pose.turn.z);
    d.by = {pose, flat_of(pose)};
  }
  if (const auto* pose = std::get_if<RigidPose>(&d.by.space)) d.links = {*pose};
  if (const auto* chain = std::get_if<RigidChain>(&d.by.space)) d.links = chain->links;
  return d;
}

TEST(RigidJudge, DistancesAndRelationsAreThoseOfRationalNumbers) {
  int cases = 0, touching = 0, apart = 0, simple = 0;
  shape_cases::on_shapes(7001, battery::sanitized ? 500 : 20'000, [&](Material& m) {
    const bool is_simple = m.below(5) < 3;
    const auto number = [&] {
      const double whole = static_cast<double>(m.below(9)) - 4;
      return is_simple ? whole : whole + 0.1 * static_cast<double>(m.below(10));
    };
    const Drawn p = drawn_pose(m, is_simple), q = drawn_pose(m, is_simple);
    Capsule3 a{{number(), number(), number()}, {number(), number(), number()}, std::fabs(number()) / 2};
    if (m.below(4) == 0) a.b = a.a;
    if (m.below(4) == 0) a.radius = 0;
    const std::string about = m.about();
    const auto expect = [&](const auto& b, const Number& square, double other) {
      const query::PosedView posed{query::view_of(a), p.by.view(3)}, second{query::view_of(b), q.by.view(3)};
      const Number radii = Number(a.radius) + Number(other);
      ++cases, simple += is_simple ? 1 : 0, touching += square == radii * radii ? 1 : 0;
      apart += square > radii * radii ? 1 : 0;
      EXPECT_TRUE(is_rounded(query::posed_distance(posed, second, query::Question::distance), square, radii)) << about;
      EXPECT_TRUE(is_rounded(query::posed_closest_points(posed, second).distance, square, radii)) << about;
      const Relation r = query::relate_posed("relate", posed, second);
      if (sgn(radii) > 0) {
        EXPECT_EQ(static_cast<int>(r), sgn(Number(radii * radii - square))) << about;
      } else {
        EXPECT_EQ(r == Relation::disjoint, sgn(square) > 0) << about;
      }
    };
    if (m.below(2) == 0) {
      Capsule3 b{{number(), number(), number()}, {number(), number(), number()}, std::fabs(number()) / 2};
      if (m.below(4) == 0) b.b = b.a;
      const Place s = image(p.links, place(a.a)), t = image(p.links, place(a.b)), u = image(q.links, place(b.a)),
                  v = image(q.links, place(b.b));
      expect(b, between(s, t, u, v), b.radius);
    } else {
      const Point3 low{number(), number(), number()};
      const Aabb3 b{low, {low.x + std::fabs(number()), low.y + std::fabs(number()), low.z + std::fabs(number())}};
      const Place s = before(q.links, image(p.links, place(a.a))), t = before(q.links, image(p.links, place(a.b)));
      expect(b, between(s, t, Corners{place(b.min), place(b.max)}), 0);
    }
  });
  std::printf("%d pairs, %d of them simple; %d apart, %d touching\n", cases, simple, apart, touching);
  EXPECT_GT(touching * 100, cases);
  EXPECT_GT(apart * 4, cases);
}

}  // namespace
}  // namespace plumb::pair_cases
