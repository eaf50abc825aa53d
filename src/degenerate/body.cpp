#include "degenerate/body.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace plumb::degenerate {

namespace {

// Of integers a, b: a right triangle's sides and hypotenuse without a common factor.
std::array<Int, 3> right_triangle(Entropy& entropy) {
  const Int a = 1 + static_cast<Int>(entropy.below(5)), b = entropy.within(5);
  std::array<Int, 3> sides{a * a - b * b, 2 * a * b, a * a + b * b};
  const Int common = std::gcd(sides[0], std::gcd(sides[1], sides[2]));
  for (Int& side : sides) side /= common;
  return sides;
}

IntMap turned_about(std::size_t axis, Entropy& entropy) {
  const auto [c, s, h] = right_triangle(entropy);
  const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
  IntMap map{{}, h};
  map.columns[axis][axis] = h;
  map.columns[next][next] = map.columns[last][last] = c;
  map.columns[next][last] = s;
  map.columns[last][next] = -s;
  return map;
}

}  // namespace

IntMap any_permutation(int dimension, Entropy& entropy) {
  std::array<std::size_t, 3> order{0, 1, 2};
  if (dimension == 2) {
    if (entropy.coin()) std::swap(order[0], order[2]);
  } else {
    for (std::size_t i = 2; i > 0; --i) std::swap(order[i], order[i - entropy.below(i + 1)]);
  }
  IntMap map{{}, 1};
  for (std::size_t i = 0; i < 3; ++i) map.columns[i][order[i]] = entropy.coin() ? -1 : 1;
  return map;
}

IntMap turned_about_x(Entropy& entropy) { return turned_about(0, entropy); }
IntMap turned_about_y(Entropy& entropy) { return turned_about(1, entropy); }
IntMap turned_about_z(Entropy& entropy) { return turned_about(2, entropy); }

IntMap any_turn(Entropy& entropy) {
  const Int a = 1 + static_cast<Int>(entropy.below(3)), b = entropy.within(3), c = entropy.within(3),
            d = entropy.within(3);
  IntMap map{{{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
               {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
               {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d}}},
             a * a + b * b + c * c + d * d};
  Int common = map.stretch;
  for (const Int3& column : map.columns) {
    for (const Int x : column) common = std::gcd(common, x);
  }
  map.stretch /= common;
  for (Int3& column : map.columns) {
    for (Int& x : column) x /= common;
  }
  return map;
}

IntMap after(const IntMap& second, const IntMap& first) {
  IntMap map{{}, second.stretch * first.stretch};
  for (std::size_t i = 0; i < 3; ++i) map.columns[i] = second(first.columns[i]);
  return map;
}

void Body::map(const IntMap& by) {
  for (Int3& p : points) p = by(p);
  radius *= by.stretch;
}

void Body::move(const Int3& by) {
  for (Int3& p : points) p = p + by;
}

void Body::multiply(Int by) {
  const Int3 moved = points.empty() ? Int3{} : (by - 1) * points[0];
  for (Int3& p : points) p = half.empty() ? by * p : p + moved;
  for (Int& h : half) h *= by;
  radius *= by;
}

Int3 extent_of(Form form, int bits, Entropy& entropy) {
  const auto length = [&] { return 1 + static_cast<Int>(entropy.below(std::uint64_t{1} << bits)); };
  const auto long_length = [&] { return (Int{8} << bits) + length(); };
  switch (form) {
    case Form::plain:
      return {length(), length(), length()};
    case Form::needle:
      return {1, 1, long_length()};
    case Form::cap:
      return {long_length(), 1, 1};
    case Form::sliver:
      return {long_length(), long_length(), 1};
    case Form::flat:
      return {length(), length(), 0};
    case Form::straight:
      return {length(), 0, 0};
    case Form::speck:
    case Form::empty:
      break;
  }
  return {};
}

void put_middle_at_origin(Body& body) {
  Int3 sum{};
  Int count = 0;
  const auto add = [&](const Int3& p, Int times) {
    sum = sum + times * p;
    count += times;
  };
  switch (body.kind) {
    case ShapeKind::line:
    case ShapeKind::plane:
    case ShapeKind::three_point_plane:
    case ShapeKind::rectangle:
    case ShapeKind::aabb:
    case ShapeKind::obb:
    case ShapeKind::ellipsoid:
      add(body.points[0], 1);
      break;
    case ShapeKind::slab:
      add(body.points[0], 1);
      add(body.points[3], 1);
      break;
    case ShapeKind::halfspace:
      add(body.points[3], 1);
      break;
    case ShapeKind::lozenge:
      add(body.points[1], 1);
      add(body.points[2], 1);
      break;
    default:
      for (const Int3& p : body.points) add(p, 1);
  }
  body.multiply(count);
  body.move(-1 * sum);
}

int bits_of(const Body& body) {
  Int most = body.radius;
  for (const Int h : body.half) most = std::max(most, h);
  for (std::size_t i = 0; i < body.points.size(); ++i) {
    const Int3 p = i > 0 && has_axes(body.kind) ? body.points[0] + body.arm(i - 1) : body.points[i];
    for (const Int x : p) most = std::max(most, std::abs(x));
  }
  // A box reaches further than its center and the middles of its faces; of a k-DOP sums of coordinates count.
  const bool further = has_axes(body.kind) || body.kind == ShapeKind::k_dop;
  return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(most))) + (further ? 3 : 0);
}

Placement any_placement(int bits, bool longest, Entropy& entropy) {
  Placement placement;
  const int room = 50 - bits;  // three sums of three below 2^53
  const auto below = [&](int most) { return static_cast<Int>(entropy.bits(std::max(most, 0))); };
  switch (longest ? 2 + entropy.below(2) : entropy.below(5)) {
    case 0:
    case 1:
      break;
    case 2:  // far from the origin, the shape small
      for (Int& base : placement.base) {
        base = (Int{1} << 52) + ((below(50) << 1) | 1);
        if (entropy.coin()) base = -base;
      }
      break;
    case 3:  // long mantissas about the origin
      placement.scale = ((Int{1} << std::max(room - 1, 0)) + below(room - 1)) | 1;
      for (Int& base : placement.base) base = below(50);
      break;
    default:  // near the origin
      for (Int& base : placement.base) base = entropy.within(1000);
      break;
  }
  switch (entropy.below(16)) {
    case 12:
    case 13:
      placement.exponent = static_cast<int>(entropy.within(60));
      break;
    case 14:
      placement.exponent = -1074 + static_cast<int>(entropy.below(30));
      break;
    case 15:
      placement.exponent = 969 - static_cast<int>(entropy.below(30));
      break;
    default:
      if (entropy.below(4) == 3) placement.exponent = -53;
      break;
  }
  return placement;
}

}  // namespace plumb::degenerate
