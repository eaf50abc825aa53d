// The search is a guess in doubles; the statement proves it, and pairs of doubles tell the numbers.
#include "query/gjk/quick_nearest.hpp"

#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "query/body/vectors.hpp"
#include "query/gjk/directed.hpp"
#include "query/gjk/nearest_statement.hpp"
#include "query/gjk/quick_meeting.hpp"
#include "query/separation/exact_corners.hpp"

namespace plumb::query {
namespace {

using gjk_origin::AreNearest, gjk_origin::Asked, gjk_origin::Pairs;
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

template <int count>
bool are_nearest(const Pairs& pairs, const Asked& a, const Asked& b) {
  FloatWorld<AreNearest<count>> w;
  const bool is_so = AreNearest<count>{}(w, pairs, a, b);
  return is_so && w.certain();
}

/// Are these corners nearest, for certain, and no others in their planes?
std::optional<QuickNearest> proved(const QuickHull& a, const QuickHull& b, const DifferenceCorners& corners) {
  const DifferenceCorners known = linked(corners);
  QuickNearest r{{corners, false, false, {}, {}}, named(known, 0), named(known, 1), {0, 0, 0}, 1};
  const Pairs pairs = pairs_of(a, b, corners);
  const Asked p = asked_of(a, r.of_a.all()), q = asked_of(b, r.of_b.all());
  const bool is_so = corners.size == 1   ? are_nearest<1>(pairs, p, q)
                     : corners.size == 2 ? are_nearest<2>(pairs, p, q)
                                         : are_nearest<3>(pairs, p, q);
  if (!is_so) return {};
  if (known.size != corners.size) r.of_a = named(corners, 0), r.of_b = named(corners, 1);
  r.proved.is_alone = is_one_pair(r.proved, r.of_a.size, r.of_b.size);
  return r;
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
    if (!are_around_origin(a_, b_, corners)) return {};
    return QuickNearest{{all, true, false, {}, {}}, {}, {}, {0, 0, 0}, static_cast<std::uint32_t>(rounds)};
  }

  const QuickHull &a_, &b_;
  GjkCorner last_{};
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

template <int count, class T>
[[gnu::always_inline]] inline std::optional<double> coordinate_of(double first, double second, double third,
                                                                  const std::array<T, 3>& weight, const T& whole) {
  T more = T::difference(second, first) * weight[1];
  if constexpr (count == 3) more = more + T::difference(third, first) * weight[2];
  return (first + quotient(more, whole)).nearest();
}
template <int count, class T>
[[gnu::always_inline]] inline std::optional<Point3> place_of(const std::array<Point3, 4>& at,
                                                             const std::array<T, 3>& weight, const T& whole) {
  const auto x = coordinate_of<count, T>(at[0].x, at[1].x, at[2].x, weight, whole);
  const auto y = coordinate_of<count, T>(at[0].y, at[1].y, at[2].y, weight, whole);
  const auto z = coordinate_of<count, T>(at[0].z, at[1].z, at[2].z, weight, whole);
  if (!x || !y || !z) return {};
  return told(Point3{*x, *y, *z});
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
    const Vec<T> d = difference_at<T>(p, 0), u = between(d, difference_at<T>(p, 1));
    std::array<T, 3> weight{T(0.0), T(0.0), T(0.0)};  // of the first one not asked
    T whole(0.0);
    if constexpr (count == 2) {
      whole = dot(u, u), weight[1] = -dot(u, d);
    } else {
      const Vec<T> v = between(d, difference_at<T>(p, 2)), normal = cross(u, v);
      whole = dot(normal, normal), weight[1] = -dot(cross(d, v), normal), weight[2] = -dot(cross(u, d), normal);
    }
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

}  // namespace plumb::query
