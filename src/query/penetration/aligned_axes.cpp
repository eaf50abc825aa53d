#include "query/penetration/separating_axes.hpp"

namespace plumb::query::parting {
namespace {

/// Pairs of doubles first: sums of a few numbers are exact in them, and so are ties.
template <class Value>
Sign sign_by_pairs(const Value& value) {
  return sign_in<SignWorlds<Ball, StackDyadic, BigDyadic>>(value);
}

template <class T>
Vec<T> middle_of(const Difference& d) {
  return d.a.twice_middle<T>() - d.b.twice_middle<T>();
}

/// Along one axis of space, times two: how far the bodies reach into one another, and of the difference its middle.
class AxisOverlap {
 public:
  AxisOverlap(const EdgeSum& sum, std::size_t group, const Vec<Ball>& middle)
      : sum_(sum), group_(group), middle_(along_axis(middle, axis())), overlap_(overlap_by(middle_)) {}

  template <class T>
  [[nodiscard]] T middle() const {
    if constexpr (std::is_same_v<T, Ball>) {
      return middle_;
    } else {
      return along_axis(middle_of<T>(sum_.difference()), axis());
    }
  }
  template <class T>
  [[nodiscard]] T overlap() const {
    if constexpr (std::is_same_v<T, Ball>) {
      return overlap_;
    } else {
      return overlap_by(middle<T>());
    }
  }
  [[nodiscard]] int axis() const { return *sum_.axis(group_); }
  [[nodiscard]] std::size_t group() const { return group_; }

 private:
  template <class T>
  [[nodiscard]] T overlap_by(const T& middle) const {
    T reach = T(0.0) - magnitude(middle);
    for (const SumEdge& e : sum_.edges()) {
      if (e.group != group_) continue;
      reach = reach + (e.body == 0 ? sum_.difference().a : sum_.difference().b).length_of_edge<T>(e.bit, axis());
    }
    return reach;
  }

  const EdgeSum& sum_;
  std::size_t group_;
  Ball middle_, overlap_;
};

/// In lexicographic order of the six directions.
int rank(int axis, bool up) { return up ? 5 - axis : axis; }

/// Does the first edge of a group lead up its axis?
Sign up_of_group(const EdgeSum& sum, std::size_t group) {
  const SumEdge& e = sum.first_of(group);
  const Vector3 along = *(e.body == 0 ? sum.difference().a : sum.difference().b).axis_of_edge(e.bit);
  return along.x + along.y + along.z > 0 ? Sign::positive : Sign::negative;  // but one is not zero
}

}  // namespace

SumParting parted_along_axes(const EdgeSum& sum) {
  SumParting told;
  const Vec<Ball> middle = middle_of<Ball>(sum.difference());
  std::optional<AxisOverlap> least;
  std::optional<bool> up;
  bool is_unique = true, are_apart = false;
  for (std::size_t g = 0; g < 3; ++g) {
    const AxisOverlap next(sum, g, middle);
    if (sign_by_pairs([&]<class T>() { return next.overlap<T>(); }) == Sign::negative) {
      told.known = SumParting::Known::apart;
      if (are_apart) return told;  // along two
      are_apart = true;
      least.emplace(next), up = sign_by_pairs([&]<class T>() { return next.middle<T>(); }) == Sign::positive;
      continue;
    }
    if (are_apart) continue;
    const Sign order =
        least ? sign_by_pairs([&]<class T>() { return next.overlap<T>() - least->overlap<T>(); }) : Sign::negative;
    if (order == Sign::positive) continue;
    const Sign side = sign_by_pairs([&]<class T>() { return next.middle<T>(); });
    const bool next_up = side == Sign::positive;  // of two ways the one down comes first
    is_unique = order == Sign::negative && side != Sign::zero;
    if (order == Sign::negative || rank(next.axis(), next_up) < rank(least->axis(), *up)) {
      least.emplace(next), up = next_up;
    }
  }
  const int axis = least->axis();
  const Sign out = *up ? Sign::negative : Sign::positive;  // of the difference, where the way leads through
  const Sign of_group = up_of_group(sum, least->group()) * out;
  told.level = furthest_of(sum, [&](std::size_t g) { return g == least->group() ? of_group : Sign::zero; });
  const Way way = Way::along_axis(axis, *up, {told.level[0].first, told.level[1].first});
  told.parting = Parting{way, are_apart, is_unique};
  if (are_apart) return told;
  told.known = SumParting::Known::parting;
  told.is_plain = {sum.has_its_own(0), sum.has_its_own(1)};
  told.overlap = least->overlap<Ball>() * Ball(0.5);
  return told;
}

}  // namespace plumb::query::parting
