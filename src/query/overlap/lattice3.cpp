#include "query/overlap/lattice3.hpp"

#include <bit>

#include "query/overlap/lattice_volumes.hpp"
#include "query/overlap/quick2.hpp"
#include "query/overlap/wide_volumes.hpp"

namespace plumb::query {
namespace {

/// The corners of the triangle are 0, 1, 2, the ends of the segment 3, 4.
template <class Step>
class SegmentSigns : public LatticeVolumes<Step, 5> {
 public:
  using LatticeVolumes<Step, 5>::LatticeVolumes;

  [[nodiscard]] SegmentAreas<double> areas(std::size_t axis) const {
    return this->seen_along(axis, [](const auto& at, const auto& told) {
      return told_areas(segment_areas(at(1), at(2), at(3), at(4)), told);
    });
  }
  [[nodiscard]] std::optional<Relation> straight(const Segment3& s, const Triangle3& t) const {
    const auto axis = running_axis(this->points_);
    if (!axis) return {};
    return relate_straight<3>(std::bit_cast<std::array<double, 6>>(s), std::bit_cast<std::array<double, 9>>(t), *axis);
  }
};

/// Of which doubles alone tell what lies in a plane.
struct WideSigns : WideVolumes<5> {
  using WideVolumes<5>::WideVolumes;
  static constexpr bool doubles_first = true;
  static constexpr std::array<std::size_t, 0> axes() { return {}; }
  static SegmentAreas<double> areas(std::size_t) { return {}; }
  static std::optional<Relation> straight(const Segment3&, const Triangle3&) { return {}; }
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
  return signs.straight(s, t);
}

template <class Signs>
std::optional<Relation> relate_by(const Segment3& s, const Triangle3& t, const Signs& signs) {
  const auto [from, to] = signs.template over<2>(0, 3);
  const Sign reaches = -(from * to);
  if (reaches == Sign::negative) return Relation::disjoint;
  if (from == to) return relate_in_plane(s, t, signs);  // both are zero
  const Sign ab = signs.volume(3, 4, 0, 1), bc = signs.volume(3, 4, 1, 2), ca = signs.volume(3, 4, 2, 0);
  const Sign low = least(ab, least(bc, ca)), high = most(ab, most(bc, ca));
  if (low * high == Sign::negative) return Relation::disjoint;
  return low * high == Sign::zero ? Relation::touching : relation(reaches);
}

}  // namespace

std::optional<Relation> by_lattice(const Segment3& s, const Triangle3& t) {
  struct Both {
    Triangle3 t;
    Segment3 s;
  };
  const auto coordinates = std::bit_cast<std::array<double, 15>>(Both{t, s});
  const auto ask = [&](const auto& signs) { return relate_by(s, t, signs); };
  if (const LatticePoints<5, 3> points(coordinates); points.is_lattice()) return by_lattice<SegmentSigns>(points, ask);
  if (const WideSigns wide(coordinates); wide.is_lattice()) return ask(wide);
  return {};
}

}  // namespace plumb::query
