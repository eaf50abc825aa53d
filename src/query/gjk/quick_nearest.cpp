// The search is a guess in doubles; the statement proves it, and pairs of doubles tell the numbers.
#include "query/gjk/quick_nearest.hpp"

#include <algorithm>
#include <bit>

#include "arith/double_double.hpp"
#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "query/body/vectors.hpp"
#include "query/gjk/directed.hpp"
#include "query/gjk/nearest_statement.hpp"
#include "query/gjk/quick_meeting.hpp"
#include "query/separation/exact_corners.hpp"

namespace plumb::query {
namespace {

using gjk_origin::AreNearest, gjk_origin::Asked, gjk_origin::Nearness, gjk_origin::Pairs;
using gjk_search::Corner, gjk_search::Directed, gjk_search::Plain;

Pairs pairs_of(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  Pairs p;
  for (std::size_t i = 0; i < corners.size; ++i)
    p.a[i] = a.given(corners.ends[i][0]), p.b[i] = b.given(corners.ends[i][1]);
  return p;
}

Asked asked_of(const QuickHull& h, std::span<const std::uint32_t> in_plane) {
  const auto of = h.solid() != nullptr ? h.solid()->neighbors_of(in_plane[0]) : std::span<const std::uint32_t>();
  return {&h.given(0), of, h.size(), in_plane};
}

/// Corners that were asked about, and those of them that are known to lie in the planes.
struct NearestQuestion {
  QuickNearest found;
  Pairs pairs;
  Asked a, b;

  NearestQuestion(const QuickHull& p, const QuickHull& q, const DifferenceCorners& corners)
      : NearestQuestion(p, q, corners, linked(corners)) {}
  NearestQuestion(const NearestQuestion&) = delete;  // it refers to itself
  NearestQuestion& operator=(const NearestQuestion&) = delete;
  ~NearestQuestion() = default;

  /// Asks the question that is made for the number of corners that were found.
  template <template <int> class Ask>
  [[gnu::always_inline]] auto asked() const {
    const std::size_t size = found.proved.corners.size;
    return size == 1 ? Ask<1>{}(pairs, a, b) : size == 2 ? Ask<2>{}(pairs, a, b) : Ask<3>{}(pairs, a, b);
  }

 private:
  NearestQuestion(const QuickHull& p, const QuickHull& q, const DifferenceCorners& corners,
                  const DifferenceCorners& known)
      : found{{corners, false, false, {}, {}}, named(known, 0), named(known, 1), {0, 0, 0}, 1},
        pairs(pairs_of(p, q, corners)),
        a(asked_of(p, found.of_a.all())),
        b(asked_of(q, found.of_b.all())),
        all_known_(known.size == corners.size) {}

 public:
  /// As it is told: all corners by name.
  [[nodiscard]] QuickNearest told() const {
    QuickNearest r = found;
    if (!all_known_) r.of_a = named(r.proved.corners, 0), r.of_b = named(r.proved.corners, 1);
    r.proved.is_alone = !r.proved.meets && is_one_pair(r.proved, r.of_a.size, r.of_b.size);
    return r;
  }

 private:
  bool all_known_;
};

template <int count>
struct InDoubles {
  [[gnu::always_inline]] bool operator()(const Pairs& pairs, const Asked& a, const Asked& b) const {
    FloatWorld<AreNearest<count>> w;
    const bool is_so = AreNearest<count>{}(w, pairs, a, b);
    return is_so && w.certain();
  }
};
template <int count>
struct Certainly {
  Nearness operator()(const Pairs& pairs, const Asked& a, const Asked& b) const {
    using Statement = AreNearest<count, false>;  // doubles tell nothing of what touches
    return certify::one_lane::ask_worlds<PairWorld<Statement>, IntegerWorld, RationalWorld>(NoWorldRecorder{},
                                                                                            Statement{}, pairs, a, b);
  }
};

/// Are these corners nearest, as far as doubles tell, and no others in their planes?
std::optional<QuickNearest> proved(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  const NearestQuestion ask(a, b, corners);
  if (!ask.asked<InDoubles>()) return {};
  return ask.told();
}

/// The last corner that was found, and what is known so far.
class Search {
 public:
  Search(const QuickHull& a, const QuickHull& b) : a_(a), b_(b) {}

  /// From the least corners along n, of which these are likely near to some.
  std::optional<QuickNearest> run(Plain n, const GjkCorner& from) {
    constexpr int most_rounds = 64;            // a guess: whoever has not ended by then goes round
    constexpr double nearer_by = 1 - 0x1p-40;  // a guess: what is level but for roundings is no corner more
    last_ = from;
    Directed simplex(least(n));
    int rounds = 1;
    for (;; ++rounds) {
      n = simplex.direction();
      const Corner c = least(n);
      if (rounds == most_rounds || simplex.has(c.ends)) break;
      if (!(dot(c.at, n) < dot(simplex[0].at, n) * nearer_by)) break;
      if (simplex.add(c)) return around(simplex, rounds);
    }
    DifferenceCorners corners;
    for (std::uint32_t i = 0; i < simplex.size(); ++i) corners.add(simplex[i].ends);
    std::optional<QuickNearest> found = proved(a_, b_, corners);
    if (!found && (found = certainly_proved(a_, b_, corners), !found)) found = finely_nearest(a_, b_, corners);
    if (found) found->way = n, found->steps = static_cast<std::uint32_t>(rounds);
    return found;
  }

 private:
  Corner least(const Plain& n) {
    last_ = {a_.farthest(n * -1, last_[0]), b_.farthest(n, last_[1])};
    return {last_, a_.at(last_[0]) - b_.at(last_[1])};
  }
  [[nodiscard]] std::optional<QuickNearest> around(const Directed& simplex, int rounds) const {
    std::array<GjkCorner, 4> corners;
    DifferenceCorners all;
    for (std::uint32_t i = 0; i < 4; ++i) all.add(corners[i] = simplex[i].ends);
    if (are_around_origin(a_, b_, corners))
      return QuickNearest{{all, true, false, {}, {}}, {}, {}, {0, 0, 0}, static_cast<std::uint32_t>(rounds)};
    auto found = certainly_proved(a_, b_, all);
    if (!found) found = finely_nearest(a_, b_, all);
    if (found) found->steps = static_cast<std::uint32_t>(rounds);
    return found;
  }

  const QuickHull &a_, &b_;
  GjkCorner last_{};
};

QuickNearest answered(NearestQuestion& ask, const Nearness& n) {
  ProvedCorners& p = ask.found.proved;
  p.a.level = n.is_level[0] ? 1 : 0, p.b.level = n.is_level[1] ? 1 : 0;
  return ask.told();
}

QuickNearest held_by(const DifferenceCorners& corners) {
  return {{corners, true, false, {}, {}}, {}, {}, {0, 0, 0}, 1};
}

/// Keeps those bits of a mask whose places among its bits `which` names.
unsigned part_of(unsigned mask, unsigned which) {
  unsigned part = 0;
  for (unsigned place = 0; mask != 0; mask &= mask - 1, ++place) {
    if ((which >> place & 1) != 0) part |= mask & (~mask + 1);
  }
  return part;
}

/// The same search in double-doubles: where bodies all but touch, doubles do not tell the direction of the nearest point.
class FineSearch {
 public:
  FineSearch(const QuickHull& a, const QuickHull& b) : a_(a), b_(b) {}

  std::optional<QuickNearest> run(const DifferenceCorners& from) {
    constexpr int most_rounds = 16;  // a guess: whoever has not ended by then goes round
    std::array<FineCorner, 4> known;
    for (std::size_t i = 0; i < from.size; ++i) known[i] = corner(from.ends[i]);
    FineDirected simplex(known[0]);
    bool is_around = false;
    for (int round = 0; round < most_rounds && !is_around; ++round) {
      const FineVec n = simplex.direction();
      const auto is_before = [&](const FineCorner& p, const FineCorner& q) { return dot(p.at, n) < dot(q.at, n); };
      FineCorner next =
          *std::min_element(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(from.size), is_before);
      if (simplex.has(next.ends) || !(dot(next.at, n) < dot(simplex[0].at, n))) {
        const GjkCorner& last = simplex[0].ends;
        next = corner({least(a_, n, last[0], 1), least(b_, n, last[1], -1)});
        if (simplex.has(next.ends) || !(dot(next.at, n) < dot(simplex[0].at, n))) break;
      }
      is_around = simplex.add(next);
    }
    DifferenceCorners corners;
    for (std::uint32_t i = 0; i < simplex.size(); ++i) corners.add(simplex[i].ends);
    auto found = certainly_proved(a_, b_, corners);
    const FineVec n = simplex.direction();
    if (found) found->way = {n.x.high, n.y.high, n.z.high};
    return found;
  }

 private:
  using Fine = arith::DoubleDouble;
  using FineVec = arith::Vec<Fine>;
  using FineCorner = gjk_search::CornerOf<Fine>;
  using FineDirected = gjk_search::DirectedOf<Fine>;

  [[nodiscard]] FineCorner corner(const GjkCorner& ends) const {
    return {ends, arith::vec<Fine>(a_.given(ends[0])) - arith::vec<Fine>(b_.given(ends[1]))};
  }
  /// The least along `side` times n, from what doubles take for it.
  static std::uint32_t least(const QuickHull& h, const FineVec& n, std::uint32_t near, double side) {
    const Plain back{-side * n.x.high, -side * n.y.high, -side * n.z.high};
    std::uint32_t best = h.farthest(back, near);
    const auto is_less = [&](std::uint32_t i) {
      const FineVec way = arith::vec<Fine>(h.given(i)) - arith::vec<Fine>(h.given(best));
      return (dot(way, n) * Fine(side)).high < 0;
    };
    if (h.solid() == nullptr) {
      for (std::uint32_t i = 0; i < h.size(); ++i) {
        if (i != best && is_less(i)) best = i;
      }
      return best;
    }
    constexpr int most_steps = 64;  // a guess: roundings may go round
    bool better = true;
    for (int step = 0; better && step < most_steps; ++step) {
      better = false;
      for (const std::uint32_t i : h.solid()->neighbors_of(best)) {
        if (is_less(i)) best = i, better = true;
      }
    }
    return best;
  }

  const QuickHull &a_, &b_;
};

template <class T>
[[gnu::always_inline]] inline Vec<T> difference_at(const Pairs& p, std::size_t i) {
  return {T::difference(p.a[i].x, p.b[i].x), T::difference(p.a[i].y, p.b[i].y), T::difference(p.a[i].z, p.b[i].z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> opposite(const Vec<T>& v) {
  return {-v.x, -v.y, -v.z};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> between(const Vec<T>& from, const Vec<T>& to) {
  return to + opposite(from);
}

/// The distance of the origin from the corners' affine hull.
template <int count, class T>
[[gnu::always_inline]] inline T distance_from(const Pairs& p) {
  const Vec<T> d = difference_at<T>(p, 0);
  if constexpr (count == 1) {
    return root(dot(d, d));
  } else {
    const Vec<T> u = between(d, difference_at<T>(p, 1));
    if constexpr (count == 2) {
      const Vec<T> turn = cross(d, u);
      return root(quotient(dot(turn, turn), dot(u, u)));
    } else {
      const Vec<T> normal = cross(u, between(d, difference_at<T>(p, 2)));
      return root(quotient(dot(normal, d).squared(), dot(normal, normal)));
    }
  }
}
template <class T>
[[gnu::always_inline]] inline std::optional<double> distance_in(const Pairs& p, std::size_t size) {
  const auto nearest = [](const T& x) { return certain_sign(x) > 0 ? x.nearest() : std::nullopt; };
  return size == 1   ? nearest(distance_from<1, T>(p))
         : size == 2 ? nearest(distance_from<2, T>(p))
                     : nearest(distance_from<3, T>(p));
}
PLUMB_WITH_FMA std::optional<double> distance_fused(const Pairs& p, std::size_t size) {
  return distance_in<Twofold<true>>(p, size);
}
PLUMB_WITHOUT std::optional<double> distance_plain(const Pairs& p, std::size_t size) {
  return distance_in<Twofold<false>>(p, size);
}

/// Of the corners but the first, whose weight is not asked.
template <class T>
using Weights = std::array<T, 4>;

template <int count, class T>
[[gnu::always_inline]] inline std::optional<double> coordinate_of(const std::array<Point3, 4>& at, double Point3::*part,
                                                                  const Weights<T>& weight, const T& whole) {
  const double first = at[0].*part;
  T more = T::difference(at[1].*part, first) * weight[1];
  for (std::size_t i = 2; i < count; ++i) more = more + T::difference(at[i].*part, first) * weight[i];
  return (first + quotient(more, whole)).nearest();
}
template <int count, class T>
[[gnu::always_inline]] inline std::optional<Point3> place_of(const std::array<Point3, 4>& at, const Weights<T>& weight,
                                                             const T& whole) {
  const auto x = coordinate_of<count, T>(at, &Point3::x, weight, whole);
  const auto y = coordinate_of<count, T>(at, &Point3::y, weight, whole);
  const auto z = coordinate_of<count, T>(at, &Point3::z, weight, whole);
  if (!x || !y || !z) return {};
  return told(Point3{*x, *y, *z});
}

template <class T>
[[gnu::always_inline]] inline Weights<T> no_weights() {
  return {T(0.0), T(0.0), T(0.0), T(0.0)};
}
/// The weights of the corners' nearest point, and their whole.
template <int count, class T>
[[gnu::always_inline]] inline T weigh(const Pairs& p, Weights<T>& weight) {
  const Vec<T> d = difference_at<T>(p, 0), u = between(d, difference_at<T>(p, 1));
  if constexpr (count == 2) {
    weight[1] = -dot(u, d);
    return dot(u, u);
  } else {
    const Vec<T> v = between(d, difference_at<T>(p, 2));
    if constexpr (count == 3) {
      const Vec<T> normal = cross(u, v);
      weight[1] = -dot(cross(d, v), normal), weight[2] = -dot(cross(u, d), normal);
      return dot(normal, normal);
    } else {
      const Vec<T> w = between(d, difference_at<T>(p, 3)), vw = cross(v, w);
      weight[1] = -dot(d, vw), weight[2] = -dot(u, cross(d, w)), weight[3] = -dot(u, cross(v, d));
      return dot(u, vw);
    }
  }
}
/// The point that the corners have in common where their difference holds the origin.
template <int count, class T>
[[gnu::always_inline]] inline std::optional<Point3> common_in(const Pairs& p) {
  if constexpr (count == 1) {
    return told(p.a[0]);
  } else {
    Weights<T> weight = no_weights<T>();
    const T whole = weigh<count, T>(p, weight);
    if (certain_sign(whole) == 0) return {};
    return place_of<count>(p.a, weight, whole);
  }
}
template <class T>
[[gnu::always_inline]] inline std::optional<Point3> common_of(const Pairs& p, std::size_t size) {
  return size == 1   ? common_in<1, T>(p)
         : size == 2 ? common_in<2, T>(p)
         : size == 3 ? common_in<3, T>(p)
                     : common_in<4, T>(p);
}
PLUMB_WITH_FMA std::optional<Point3> common_fused(const Pairs& p, std::size_t size) {
  return common_of<Twofold<true>>(p, size);
}
PLUMB_WITHOUT std::optional<Point3> common_plain(const Pairs& p, std::size_t size) {
  return common_of<Twofold<false>>(p, size);
}

/// Each point by the weights of its corners over their whole.
template <int count, class T>
[[gnu::always_inline]] inline std::optional<Closest> points_from(const Pairs& p) {
  const T distance = distance_from<count, T>(p);
  if (certain_sign(distance) <= 0) return {};
  const auto apart = distance.nearest();
  if (!apart) return {};
  if constexpr (count == 1) {
    return Closest{told(p.a[0]), told(p.b[0]), *apart, {}, {}};
  } else {
    Weights<T> weight = no_weights<T>();
    const T whole = weigh<count, T>(p, weight);
    const auto on_a = place_of<count>(p.a, weight, whole), on_b = place_of<count>(p.b, weight, whole);
    if (!on_a || !on_b) return {};
    return Closest{*on_a, *on_b, *apart, {}, {}};
  }
}
template <class T>
[[gnu::always_inline]] inline std::optional<Closest> points_in(const Pairs& p, std::size_t size) {
  return size == 1 ? points_from<1, T>(p) : size == 2 ? points_from<2, T>(p) : points_from<3, T>(p);
}
PLUMB_WITH_FMA std::optional<Closest> points_fused(const Pairs& p, std::size_t size) {
  return points_in<Twofold<true>>(p, size);
}
PLUMB_WITHOUT std::optional<Closest> points_plain(const Pairs& p, std::size_t size) {
  return points_in<Twofold<false>>(p, size);
}

}  // namespace

std::optional<QuickNearest> certainly_proved(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  if (!a.is_finite() || !b.is_finite()) return {};
  if (corners.size == 4 && certainly(gjk_origin::IsAroundOrigin{}, pairs_of(a, b, corners))) return held_by(corners);
  const unsigned end = 1U << corners.size;
  unsigned known = 0;  // those that others were asked of
  for (int size = static_cast<int>(std::min<std::size_t>(corners.size, 3)); size > 0; --size) {
    for (unsigned mask = 1; mask < end; ++mask) {
      if (std::popcount(mask) != size || (known >> mask & 1) != 0) continue;
      for (unsigned needed = mask; needed != 0;) {  // ends, for they are fewer each time
        NearestQuestion ask(a, b, corners.part(needed));
        const Nearness n = ask.asked<Certainly>();
        known |= 1U << needed;
        if (n.meets) return held_by(corners.part(part_of(needed, n.positive)));
        if (n.is_so) return answered(ask, n);
        needed = std::popcount(n.positive) < std::popcount(needed) ? part_of(needed, n.positive) : 0;
      }
    }
  }
  return {};
}

bool are_parted(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  if (corners.size != 3) return false;
  const NearestQuestion ask(a, b, corners);
  return certainly(gjk_origin::AreParted{}, ask.pairs, ask.a, ask.b);
}

std::optional<QuickNearest> finely_nearest(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  if (corners.size == 0 || !a.is_finite() || !b.is_finite()) return {};
  return FineSearch(a, b).run(corners);
}

std::optional<QuickNearest> quickly_nearest(const QuickHull& a, const QuickHull& b, const GjkCache* cache) {
  DifferenceCorners known;
  Plain way{0, 0, 0};
  if (cache != nullptr && cache->simplex.size <= 3) {
    for (std::uint32_t i = 0; i < cache->simplex.size; ++i) {
      const GjkCorner& c = cache->simplex.corners[i];
      if (c[0] < a.size() && c[1] < b.size()) known.add(c);
    }
    way = arith::vec<double>(cache->direction);
  }
  if (known.size != 0) {
    if (auto found = proved(a, b, known)) {
      found->way = way;
      return found;
    }
    if (way.x == 0 && way.y == 0 && way.z == 0) way = a.at(known.ends[0][0]) - b.at(known.ends[0][1]);
  } else {
    way = a.middle() - b.middle(), known.ends[0] = {0, 0};
  }
  auto found = Search(a, b).run(way, known.ends[0]);
  if (found && known.size != 0) ++found->steps;
  return found;
}

std::optional<double> quick_distance(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  const Pairs p = pairs_of(a, b, corners);
  return has_fma ? distance_fused(p, corners.size) : distance_plain(p, corners.size);
}

std::optional<Closest> quick_points(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  const Pairs p = pairs_of(a, b, corners);
  return has_fma ? points_fused(p, corners.size) : points_plain(p, corners.size);
}

std::optional<Closest> quick_common(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  const Pairs p = pairs_of(a, b, corners);
  const auto c = has_fma ? common_fused(p, corners.size) : common_plain(p, corners.size);
  if (!c) return {};
  constexpr Feature interior{FeatureKind::interior, 0};
  return Closest{*c, *c, 0, interior, interior};
}

}  // namespace plumb::query
