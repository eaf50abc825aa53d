#include "query/overlap/lattice3.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include "plumb/arith/coordinate_pairs.hpp"
#include "plumb/certify/certainly.hpp"
#include "query/overlap/lattice_worlds.hpp"
#include "query/overlap/linear3.hpp"
#include "query/overlap/quick2.hpp"

namespace plumb::query {
namespace {

/// The corners of the triangle are 0, 1, 2, the ends of the segment 3, 4.
template <class Points, class Step>
class SegmentSigns : public VolumeSigns<Points, Step> {
 public:
  using VolumeSigns<Points, Step>::VolumeSigns;

  [[nodiscard]] SegmentAreas<double> areas(std::size_t axis) const {
    const std::size_t right = (axis + 1) % 3, up = (axis + 2) % 3;
    const auto told_all = [](const auto& at, const auto& told) {
      return told_areas(segment_areas(at(1), at(2), at(3), at(4)), told);
    };
    if constexpr (requires { this->points_.seen(0, 1, told_all); }) {
      return this->points_.seen(right, up, told_all);
    } else {
      const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
        return static_cast<double>(this->points_.turn(right, up, i, j, k));
      };
      const double all = at(0, 1, 2);
      if (all == 0) return {};
      const auto with = [&](std::size_t i) { return Three<double>{at(0, 1, i), at(1, 2, i), at(2, 0, i)}; };
      return {all, with(3), with(4), {at(3, 4, 0), at(3, 4, 1), at(3, 4, 2)}};
    }
  }
};

template <class Signs>
std::optional<Relation> relate_in_plane(const Segment3& s, const Triangle3& t, const Signs& signs) {
  if constexpr (Signs::doubles_first) {
    const std::size_t likely = likely_axis(t);
    if (const auto answer = by_doubles(Segment2{seen(s.a, likely), seen(s.b, likely)}, seen(t, likely))) return answer;
  }
  for (const std::size_t axis : signs.axes()) {
    const SegmentAreas<double> areas = signs.areas(axis);
    if (areas.of_triangle == 0) continue;
    if (s.a == s.b) return {};
    return relation(sign_of_number(depth(areas)));
  }
  const auto axis = signs.running_axis();
  if (!axis) return {};
  return relate_straight<3>(std::bit_cast<std::array<double, 6>>(s), std::bit_cast<std::array<double, 9>>(t), *axis);
}

template <class Signs>
std::optional<Relation> relate_by_signs(const Segment3& s, const Triangle3& t, const Signs& signs) {
  const auto [from, to] = signs.template over<2>(0, 3);
  const Sign reaches = -(from * to);
  if (reaches == Sign::negative) return Relation::disjoint;
  if (from == to) return relate_in_plane(s, t, signs);  // both are zero
  const Sign ab = signs.volume(3, 4, 0, 1), bc = signs.volume(3, 4, 1, 2), ca = signs.volume(3, 4, 2, 0);
  const Sign low = least(ab, least(bc, ca)), high = most(ab, most(bc, ca));
  if (low * high == Sign::negative) return Relation::disjoint;
  return low * high == Sign::zero ? Relation::touching : relation(reaches);
}

constexpr int short_bits = 24;
static_assert(2 * (short_bits + 1) <= exact_area_bits, "areas of differences are exact in doubles");

/// Differences from the first corner, in units of the lattice; products and sums wrap around.
struct WordPlace {
  std::uint64_t x, y, z;

  friend WordPlace cross(const WordPlace& a, const WordPlace& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend std::uint64_t dot(const WordPlace& a, const WordPlace& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  [[nodiscard]] bool is_zero() const { return (x | y | z) == 0; }
  /// Along which a plane of this normal is not seen edge on.
  [[nodiscard]] std::size_t axis() const { return x != 0 ? 0 : y != 0 ? 1 : 2; }
};

class ShortCorners {
 public:
  ShortCorners(const Triangle3& a, const Triangle3& b) {
    // Most of which corners take more bits are told by the patterns of few.
    const auto pattern = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    constexpr std::uint64_t too_low = (1ull << (53 - short_bits)) - 1;
    if (((pattern(a.a.x) | pattern(a.b.y) | pattern(b.a.z) | pattern(b.c.x)) & too_low) != 0) return;
    using Pairs = CoordinatePairs<18>;
    using Bits = Pairs::Bits;
    const Pairs x(std::bit_cast<std::array<double, 18>>(std::array{a, b}));
    const std::uint64_t exponent = x.largest_exponent();  // all are below 2^short_bits units of 2^unit
    unit_ = static_cast<int>(exponent) - 1022 - short_bits;
    constexpr int handy = 400;  // a guess: others are left to what follows
    if (unit_ < -handy || unit_ > handy) return;
    // What is added to 1.5 * 2^52 units is rounded to whole ones, which are the low bits of the sum.
    const auto addend = Pairs::both(static_cast<std::uint64_t>(unit_ + 1023 + 52) << 52 | 1ull << 51);
    Bits exact = ~Bits{};
#pragma GCC unroll 9
    for (std::size_t i = 0; i < Pairs::count; ++i) {
      const auto whole = x.pair[i] + addend;
      exact &= std::bit_cast<Bits>(whole - addend == x.pair[i]);
      Pairs::store(std::bit_cast<Bits>(whole), i, raw_);
    }
    are_short_ = (exact[0] & exact[1]) != 0;
  }

  [[nodiscard]] bool are_short() const { return are_short_; }
  [[nodiscard]] double to_units_of_volume(double x) const {
    const double times = power_of_two(-unit_);
    return x * times * times * times;
  }
  [[nodiscard]] WordPlace from_to(std::size_t i, std::size_t j) const {
    return {raw_[3 * j] - raw_[3 * i], raw_[3 * j + 1] - raw_[3 * i + 1], raw_[3 * j + 2] - raw_[3 * i + 2]};
  }
  [[nodiscard]] WordPlace from_first(std::size_t i) const { return from_to(0, i); }

 private:
  std::array<std::uint64_t, 18> raw_;
  int unit_;
  bool are_short_ = false;
};

/// Where all corners lie on one line.
[[gnu::noinline]] std::optional<Relation> by_one_line(const Triangle3& a, const Triangle3& b,
                                                      const ShortCorners& corners) {
  WordPlace along = corners.from_first(1);
  for (std::size_t i = 2; i < 6; ++i) {
    const WordPlace at = corners.from_first(i);
    if (along.is_zero()) along = at;
    if (!cross(along, at).is_zero()) return {};  // exact: areas are below 2^51
  }
  return relate_straight<3>(std::bit_cast<std::array<double, 9>>(a), std::bit_cast<std::array<double, 9>>(b),
                            along.axis());
}

/// Of a triangle with an area and one of its plane that has none, seen along an axis.
std::optional<Relation> with_straight(const Triangle3& t, const Linear3& s, std::size_t axis) {
  if (s.is_point()) return {};
  const Point2 from = seen(t.a, axis);
  const auto at = [&](const Point3& p) { return from_to(from, seen(p, axis)); };
  return relation(sign_of_number(depth(segment_areas(at(t.b), at(t.c), at(s.p), at(s.q)))));
}

/// Where a has no area, and may be off the plane of b: its volumes are any.
[[gnu::noinline]] std::optional<Relation> by_straight_a(const Triangle3& a, const Triangle3& b,
                                                        const ShortCorners& corners) {
  const WordPlace normal = cross(corners.from_to(3, 4), corners.from_to(3, 5));  // exact: areas are below 2^51
  if (normal.is_zero()) return {};
  const auto is_off = [&](std::size_t i) {
    const WordPlace to = corners.from_to(3, i);
    const auto product = [](std::uint64_t p, std::uint64_t q) {
      return static_cast<Int128>(static_cast<std::int64_t>(p)) * static_cast<std::int64_t>(q);
    };
    return product(to.x, normal.x) + product(to.y, normal.y) + product(to.z, normal.z) != 0;
  };
  if (is_off(0) || is_off(1) || is_off(2)) return {};
  return with_straight(b, flattened(a), normal.axis());
}

}  // namespace

std::optional<Relation> by_lattice(const Segment3& s, const Triangle3& t) {
  struct Both {
    Triangle3 t;
    Segment3 s;
  };
  return certainly<LatticeWorlds<SegmentSigns, 5>>([&](const auto& signs) { return relate_by_signs(s, t, signs); },
                                                   std::bit_cast<std::array<double, 15>>(Both{t, s}),
                                                   [] { return std::optional<Relation>(); });
}

std::optional<Relation> by_short_plane(const Triangle3& a, const Triangle3& b, double error) {
  const ShortCorners corners(a, b);
  // A word is all of an integer below 2^63.
  if (!corners.are_short() || !(corners.to_units_of_volume(error) < 0x1p61)) return {};
  const WordPlace normal = cross(corners.from_first(1), corners.from_first(2));  // exact: areas are below 2^51
  if ((dot(corners.from_first(3), normal) | dot(corners.from_first(4), normal) | dot(corners.from_first(5), normal)) !=
      0)
    return {};
  if (normal.is_zero()) {
    if (const auto answer = by_one_line(a, b, corners)) return answer;
    return by_straight_a(a, b, corners);
  }
  const std::size_t axis = normal.axis();
  const Point2 from = seen(a.a, axis);
  const auto at = [&](const Point3& p) { return from_to(from, seen(p, axis)); };
  const auto areas = triangle_areas(at(a.b), at(a.c), {at(b.a), at(b.b), at(b.c)});
  if (areas.of_b == 0) return with_straight(a, flattened(b), axis);
  return relation(sign_of_number(depth(areas)));
}

}  // namespace plumb::query
