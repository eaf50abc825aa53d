// Cylinders around cylinders, merged or moved.  An axis is guessed in doubles; planes of the ends and the radius are
// then found for certain, by intervals: of the two disks at the ends how far each reaches along the axis and from it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "arith/vec.hpp"
#include "figure/basic/finite_parts.hpp"
#include "figure/basic/frame.hpp"
#include "figure/basic/pose_numbers.hpp"
#include "plumb/figure/basic/sound.hpp"
#include "plumb/figure/sphere/minimum_sphere.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"

namespace plumb {
namespace {

using arith::Vec;

constexpr double largest = std::numeric_limits<double>::max();

/// Times 2^e, by powers of two, outward.
Interval scaled(Interval x, int e) {
  constexpr int step = 1000;
  constexpr double up = 0x1p1000, down = 1 / up;  // powers of two
  for (; e > step; e -= step) x = x * Interval(up);
  for (; e < -step; e += step) x = x * Interval(down);
  return x * Interval(std::ldexp(1.0, e));
}
Vec<Interval> scaled(const Vec<Interval>& v, int e) { return {scaled(v.x, e), scaled(v.y, e), scaled(v.z, e)}; }

double size(Interval x) { return std::max(std::fabs(x.lower), std::fabs(x.upper)); }
double size(const Vec<Interval>& v) { return std::max({size(v.x), size(v.y), size(v.z)}); }
double middle(Interval x) { return x.lower / 2 + x.upper / 2; }
Vector3 middle(const Vec<Interval>& v) { return {middle(v.x), middle(v.y), middle(v.z)}; }

Interval length(const Vec<Interval>& v) { return root(dot(v, v)); }

/// The image of a disk perpendicular to an axis, or of a ball: center + matrix of all vectors of length radius.
struct Disk {
  Vec<Interval> center;
  Vec<Interval> axis;  // of size about one; zero for a ball
  std::array<Vec<Interval>, 3> columns;
  Interval radius;   // times the matrix, whose size is about one
  Interval stretch;  // of the matrix, at least

  /// How far it reaches from its center along a vector, times the vector's length.
  [[nodiscard]] Interval reach(const Vec<Interval>& along) const {
    if (radius.upper == 0) return Interval(0.0);
    if (size(axis) == 0) return radius * stretch * length(along);
    const Vec<Interval> back{dot(columns[0], along), dot(columns[1], along), dot(columns[2], along)};
    const Vec<Interval> c = cross(back, axis);
    return radius * root(quotient(dot(c, c), dot(axis, axis)));
  }
};

/// v over a number, which is not zero.
Vec<Interval> over(const Vec<Interval>& v, const Interval& by) {
  if (by.lower == 1 && by.upper == 1) return v;
  return {quotient(v.x, by), quotient(v.y, by), quotient(v.z, by)};
}

/// At both ends; all of the cylinder is between them.
std::array<Disk, 2> disks(const Cylinder3& cylinder, PoseView pose) {
  const auto& [a, b, radius] = cylinder;
  const Vec<Interval> along = arith::vec<Interval>(b) - arith::vec<Interval>(a);
  const auto numbers = figure::pose_numbers<Interval>(pose);
  std::array<Vec<Interval>, 3> columns = numbers.columns;
  double most = 0;
  for (Vec<Interval>& c : columns) {
    c = over(c, numbers.weight);
    most = std::max(most, size(c));
  }
  const int e = figure::frame::exponent(most);
  for (Vec<Interval>& c : columns) c = scaled(c, -e);
  const auto image = [&](const Point3& p) { return over(numbers.image(arith::vec<Interval>(p)), numbers.weight); };
  const Disk disk{image(a), scaled(along, -figure::frame::exponent(std::min(size(along), largest))), columns,
                  scaled(Interval(radius), e), scaled(Interval(largest_stretch(pose)), -e)};
  Disk other = disk;
  other.center = image(b);
  return {disk, other};
}

/// Around all disks along a direction of length about one; nothing where no double holds it.
std::optional<Cylinder3> enclosing(std::span<const Disk> disks, const Vector3& direction, int exponent) {
  const auto axes = figure::frame::orthonormal({direction, {0, 0, 0}, {0, 0, 0}});
  std::vector<Circle2> across;
  double least = largest, most = -largest;
  for (const Disk& d : disks) {
    const Vector3 c = middle(scaled(d.center, -exponent));
    const double reach = scaled(d.reach(arith::vec<Interval>(axes[0])), -exponent).upper,
                 around = scaled(d.radius * d.stretch, -exponent).upper;
    if (!(reach < largest && around < largest)) return {};
    across.push_back({{figure::frame::dot(c, axes[1]), figure::frame::dot(c, axes[2])}, around});
    least = std::min(least, figure::frame::dot(c, axes[0]) - reach),
    most = std::max(most, figure::frame::dot(c, axes[0]) + reach);
  }
  const Point2 spot = minimum_circle(across).circle.center;
  const auto end = [&](double along) {
    const auto world = [&](auto part) {
      const double x = part(axes[0]) * along + part(axes[1]) * spot.x + part(axes[2]) * spot.y;
      return std::clamp(std::ldexp(x, exponent), -largest, largest);
    };
    return Point3{world([](const Vector3& v) { return v.x; }), world([](const Vector3& v) { return v.y; }),
                  world([](const Vector3& v) { return v.z; })};
  };
  const auto local = [&](const Point3& p) { return scaled(arith::vec<Interval>(p), -exponent); };
  for (double margin = figure::frame::first_margin(exponent); margin < 4; margin *= 4) {
    Cylinder3 c{end(least - margin), end(most + margin), 0};
    const Vec<Interval> a = local(c.a), b = local(c.b), along = b - a;
    double radius = 0;
    bool holds = dot(along, along).lower > 0;
    for (const Disk& d : disks) {
      if (!holds) break;
      const Vec<Interval> center = scaled(d.center, -exponent);
      const Interval reach = scaled(d.reach(along), -exponent);
      holds = (dot(center - a, along) - reach).lower >= 0 && (dot(b - center, along) - reach).lower >= 0;
      const Vec<Interval> beside = cross(center - a, along);
      const Interval off =
          root(quotient(dot(beside, beside), dot(along, along))) + scaled(d.radius * d.stretch, -exponent);
      radius = std::max(radius, off.upper);
    }
    if (!holds) continue;
    c.radius = scaled(Interval(radius), exponent).upper;
    if (c.radius <= largest) return c;
  }
  return {};
}

Cylinder3 around(std::string_view function, std::span<const Disk> disks, std::vector<Vector3> directions) {
  double most = 0;
  for (const Disk& d : disks) most = std::max({most, size(d.center), size(d.radius * d.stretch)});
  const int exponent = figure::frame::exponent(figure::within_doubles(most, function, "a corner"));
  directions.push_back({1, 0, 0});
  std::optional<Cylinder3> best;
  double best_volume = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector3 u = figure::frame::unit(directions[i]);
    if (!(figure::frame::largest(u) > 0) || (best && i + 1 == directions.size())) continue;
    const auto c = enclosing(disks, u, exponent);
    if (!c) continue;
    const double r = std::ldexp(c->radius, -exponent),
                 h = std::ldexp(figure::frame::largest({c->b.x - c->a.x, c->b.y - c->a.y, c->b.z - c->a.z}),
                                -exponent) /
                     figure::frame::largest(u);
    if (!best || r * r * h < best_volume) best = c, best_volume = r * r * h;
  }
  if (!best) figure::within_doubles(HUGE_VAL, function, "radius");
  return *best;
}

Vector3 halved_difference(const Point3& a, const Point3& b) {
  return {b.x / 2 - a.x / 2, b.y / 2 - a.y / 2, b.z / 2 - a.z / 2};
}

Capsule3 capsule_around(const Cylinder3& c) { return {c.a, c.b, c.radius}; }

/// Does a plane across the axis of one, at an end of it, leave all of the other beyond?
bool are_parted_by_an_end(const Cylinder3& one, const Cylinder3& other, int exponent) {
  const auto local = [&](const Point3& p) { return scaled(arith::vec<Interval>(p), -exponent); };
  const Vec<Interval> from = local(one.a), along = local(one.b) - from;
  const Interval length = dot(along, along);
  if (!(length.lower > 0)) return false;
  bool beyond = true, before = true;
  for (const Disk& d : disks(other, identity_pose)) {
    const Interval at = dot(scaled(d.center, -exponent) - from, along), reach = scaled(d.reach(along), -exponent);
    beyond = beyond && (at - reach - length).lower > 0;
    before = before && (at + reach).upper < 0;
  }
  return beyond || before;
}

}  // namespace

bool may_overlap(const Cylinder3& a, const Cylinder3& b) {
  figure::require_sound("may_overlap", "a", a);
  figure::require_sound("may_overlap", "b", b);
  if (!intersects(capsule_around(a), capsule_around(b))) return false;
  double most = std::max(a.radius, b.radius);
  for (const Point3& p : {a.a, a.b, b.a, b.b}) most = std::max(most, figure::frame::largest({p.x, p.y, p.z}));
  const int exponent = figure::frame::exponent(most);
  return !are_parted_by_an_end(a, b, exponent) && !are_parted_by_an_end(b, a, exponent);
}

Cylinder3 merge(const Cylinder3& a, const Cylinder3& b) {
  figure::require_sound("merge", "a", a);
  figure::require_sound("merge", "b", b);
  if (a == b) return a;
  std::vector<Disk> all;
  for (const Cylinder3* c : {&a, &b}) {
    for (const Disk& d : disks(*c, identity_pose)) all.push_back(d);
  }
  const auto middle_of = [](const Cylinder3& c) {
    return Point3{c.a.x / 2 + c.b.x / 2, c.a.y / 2 + c.b.y / 2, c.a.z / 2 + c.b.z / 2};
  };
  return around(
      "merge", all,
      {halved_difference(a.a, a.b), halved_difference(b.a, b.b), halved_difference(middle_of(a), middle_of(b))});
}

Cylinder3 transform(const Cylinder3& cylinder, PoseView pose) {
  figure::require_sound("transform", cylinder);
  figure::require_sound("transform", pose);
  const auto all = disks(cylinder, pose);
  // Along the image of the axis; where that is a point, across the image of the disk.
  const auto axes = figure::frame::orthonormal({halved_difference(cylinder.a, cylinder.b), {0, 0, 0}, {0, 0, 0}});
  const auto turned = [&](const Vector3& v) {
    const auto column = [&](std::size_t k, double by) {
      return figure::frame::times(figure::frame::unit(middle(all[0].columns[k])), by);
    };
    return figure::frame::plus(figure::frame::plus(column(0, v.x), column(1, v.y)), column(2, v.z));
  };
  const Vector3 along = halved_difference({middle(all[0].center.x), middle(all[0].center.y), middle(all[0].center.z)},
                                          {middle(all[1].center.x), middle(all[1].center.y), middle(all[1].center.z)});
  return around("transform", all, {along, figure::frame::cross(turned(axes[1]), turned(axes[2]))});
}

}  // namespace plumb
