#include "space/kd_tree/point_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certify/batch/instruction_sets.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/query/closest/closest.hpp"
#include "space/kd_tree/query_order.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/kd_tree/point_search.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "arith/twofold.hpp"
#include "space/kd_tree/nearest_lanes.hpp"
#include "space/kd_tree/number_lanes.hpp"
#include "space/kd_tree/point_lanes.hpp"
#include "space/kd_tree/point_leaves.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::kd::HWY_NAMESPACE {
namespace {

/// The nearest double to the distance.
template <class Point>
HWY_INLINE double distance_between(const Point& p, const Point& q) {
  if (p == q) return 0;
  constexpr bool fma = HWY_NATIVE_FMA != 0;
  using Two = Twofold<fma>;
  const auto a = coordinates(p), b = coordinates(q);
  const auto square = [&](std::size_t k) HWY_ATTR { return Two::difference(a[k], b[k]).squared(); };
  double told = 0;
  Two sum = square(0) + square(1);
  if constexpr (sizeof(Point) == sizeof(Point3)) sum = sum + square(2);
  return root_at_once(sum).told(told) ? told : distance(p, q);
}

template <class Point>
HWY_INLINE NearestPoint nearest_from(const KdTree<Point>& tree, const Point& p, std::size_t leaf) {
  Candidate<Point> best;
  NearestSoFar<Point> found(p, &best, 1);
  find_nearest(tree, p, leaf, found);
  return {best.number, distance_between(p, best.at)};
}

template <class Point>
NearestPoint one(const KdTree<Point>& tree, const Point& p) {
  return nearest_from(tree, p, find_leaf(tree, coordinates(p)));
}
template <class Point>
void of_each(const KdTree<Point>& tree, const Point* queries, const std::uint64_t* keys, std::size_t n,
             NearestPoint* out) {
  for (std::size_t i = 0; i < n; ++i) {
    const auto number = static_cast<std::uint32_t>(keys[i]);
    __builtin_prefetch(&queries[static_cast<std::uint32_t>(keys[std::min(i + asked_ahead, n - 1)])]);
    out[number] = nearest_from(tree, queries[number], keys[i] >> 32);
  }
}
template <class Point>
void leaves(const KdTree<Point>& tree, const Point* queries, std::size_t n, std::uint64_t* keys) {
  for (std::size_t i = 0; i < n; ++i) keys[i] = std::uint64_t{find_leaf(tree, coordinates(queries[i]))} << 32 | i;
}
template <class Point>
void several(const KdTree<Point>& tree, const Point& p, std::size_t leaf, Candidate<Point>* room, std::size_t k,
             NearestPoint* out) {
  if (!NearestFew<Point>::find(tree, p, leaf, room, k)) {
    NearestSoFar<Point> found(p, room, k);
    find_nearest(tree, p, leaf, found);
  }
  for (std::size_t i = 0; i < k; ++i) out[i] = {room[i].number, distance_between(p, room[i].at)};
}

/// What is told of points that are found: their numbers, or how many have a greater one than this.
struct Collected {
  std::vector<std::uint32_t>& numbers;
  HWY_INLINE void add(std::uint32_t number) { numbers.push_back(number); }
  HWY_INLINE void add(std::span<const std::uint32_t> ascending) {
    numbers.insert(numbers.end(), ascending.begin(), ascending.end());
  }
};
struct CountedAbove {
  std::uint32_t number;
  std::size_t count = 0;
  HWY_INLINE void add(std::uint32_t other) { count += other > number ? 1 : 0; }
  HWY_INLINE void add(std::span<const std::uint32_t> ascending) {
    count += static_cast<std::size_t>(ascending.end() - std::upper_bound(ascending.begin(), ascending.end(), number));
  }
};

/// Those of whose values it is certain, or is_in says so.
template <class Point, class IsIn, class Told>
HWY_INLINE void add_within_values(const Query<Point>& query, std::size_t leaf, double inside, double outside,
                                  const IsIn& is_in, Told& told) {
  search_from(
      query, leaf, [&]() HWY_ATTR { return outside; },
      [&](LeafRun at) HWY_ATTR {
        if (at.leaves > 1) {
          const Candidate<Point> c = query.one_of(at);
          if (c.value <= inside || (c.value <= outside && is_in(c))) told.add(query.numbers_of(at));
          return;
        }
        query.each_value(at.leaf, [&](const Many& value, std::size_t first, std::size_t i, std::size_t count) HWY_ATTR {
          unsigned in = bits_of(at_most(value, of_all(outside))) & first_lanes(count - i);
          const unsigned sure = bits_of(at_most(value, of_all(inside)));
          for (; in != 0; in &= in - 1) {
            const auto k = static_cast<std::size_t>(__builtin_ctz(in));
            if ((sure >> k & 1) != 0 || is_in(query.candidate(first, i + k, count, 0)))
              told.add(query.tree.numbers[first + i + k]);
          }
        });
      });
}

/// A value up to `inside` is certainly of a ball's point, beyond `outside` certainly of none.
template <class Point>
struct BallLimits {
  double inside, outside;

  HWY_INLINE BallLimits(double radius, Powers powers) {
    const Interval scaled(radius * powers.before * powers.after), square = scaled * scaled;
    inside = Square<Point>::certainly_within(square.lower), outside = Square<Point>::certainly_beyond(square.upper);
  }
};
/// No point of the ball is outside.
HWY_INLINE Side side_of_ball(double at, double radius) {
  return {(Interval(at) - Interval(radius)).lower, (Interval(at) + Interval(radius)).upper};
}

/// Those of a leaf.
template <class Point>
HWY_INLINE void add_of_leaf(const Query<Point>& query, double radius, const BallLimits<Point>& limits, std::size_t leaf,
                            NumberList& found) {
  query.each_value(leaf, [&](const Many& value, std::size_t first, std::size_t i, std::size_t count) HWY_ATTR {
    unsigned in = bits_of(at_most(value, of_all(limits.outside))) & first_lanes(count - i);
    for (unsigned rest = in & ~bits_of(at_most(value, of_all(limits.inside))); rest != 0; rest &= rest - 1) {
      const Candidate<Point> c = query.candidate(first, i + static_cast<std::size_t>(__builtin_ctz(rest)), count, 0);
      if (compare_distance(query.p, c.at, radius) == Sign::positive) in &= ~(rest & -rest);
    }
    found.add(query.tree.numbers, first + i, in);
  });
}

template <class Point>
void add_ball(const KdTree<Point>& tree, const Point& p, double radius, NumberList& found) {
  const Query<Point> query(tree, p, powers_for(tree, p, radius));
  const BallLimits<Point> limits(radius, query.powers);
  std::array<Side, Query<Point>::d> sides;
  for (std::size_t a = 0; a < sides.size(); ++a) sides[a] = side_of_ball(query.at[a], radius);
  const std::size_t start = found.end();
  visit_leaves(
      tree, sides, [&](std::size_t leaf) HWY_ATTR { add_of_leaf(query, radius, limits, leaf, found); },
      [&](LeafRun run) HWY_ATTR {
        const Candidate<Point> c = query.one_of(run);
        if (c.value <= limits.inside ||
            (c.value <= limits.outside && compare_distance(p, c.at, radius) != Sign::positive))
          found.add(query.numbers_of(run));
      });
  found.sort(start, found.end());
}
template <class Point>
void ball(const KdTree<Point>& tree, const Point& p, double radius, std::vector<std::uint32_t>& numbers) {
  NumberList found(numbers);
  add_ball(tree, p, radius, found);
  found.close();
}

/// So many balls at a time that the processor waits for none of them.
constexpr std::size_t balls_at_once = 16;

/// Of a radius that asks for no powers, as long as no node of equal points is met.
template <class Point>
HWY_INLINE bool add_balls(const KdTree<Point>& tree, const Point* queries, std::span<const std::uint64_t> keys,
                          double radius, const BallLimits<Point>& limits, NumberList& found, std::size_t* ends) {
  constexpr std::size_t d = KdTree<Point>::dimension;
  std::array<NodeOfBox, balls_at_once> roots;
  std::array<Side, d * balls_at_once> sides;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    roots[i] = NodeOfBox{i} << 32;
    const auto at = coordinates(queries[static_cast<std::uint32_t>(keys[i])]);
    for (std::size_t a = 0; a < d; ++a) sides[d * i + a] = side_of_ball(at[a], radius);
  }
  bool is_each_visited = true;
  visit_leaves_below(
      tree, 0, std::span(roots.data(), keys.size()), sides.data(),
      [&](std::size_t i, std::size_t leaf) HWY_ATTR {
        const Query<Point> query(tree, queries[static_cast<std::uint32_t>(keys[i])], {});
        add_of_leaf(query, radius, limits, leaf, found);
        ends[i] = found.end();
      },
      [&](std::size_t, LeafRun) HWY_ATTR { is_each_visited = false; });
  return is_each_visited;
}
template <class Point>
void balls(const KdTree<Point>& tree, const Point* queries, const std::uint64_t* keys, std::size_t n, double radius,
           ListBlock& block) {
  NumberList found(block.numbers);
  const BallLimits<Point> limits(radius, {});
  for (std::size_t from = 0; from < n; from += balls_at_once) {
    const std::span<const std::uint64_t> some(keys + from, std::min(balls_at_once, n - from));
    std::size_t start = found.end();
    std::array<std::size_t, balls_at_once> ends;
    const bool are_found = is_moderate(radius) && add_balls(tree, queries, some, radius, limits, found, ends.data());
    if (!are_found) found.cut(start);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const auto number = static_cast<std::uint32_t>(some[i]);
      if (are_found) {
        found.sort(start, ends[i]);
      } else {
        add_ball(tree, queries[number], radius, found);
        ends[i] = found.end();
      }
      block.start[number] = start, block.size[number] = ends[i] - start;
      start = ends[i];
    }
  }
  found.close();
}
template <class Point, class Told>
HWY_INLINE void find_tied(const KdTree<Point>& tree, const Point& p, const Point& limit, Powers powers, Told& told) {
  const Query<Point> query(tree, p, powers);
  std::array<double, Query<Point>::d> square;
  const auto b = coordinates(limit);
  for (std::size_t k = 0; k < b.size(); ++k) {
    const double x = (b[k] * powers.before - query.scaled[k]) * powers.after;
    square[k] = x * x;
  }
  const double outside = Square<Point>{Query<Point>::sum_of(square)}.beyond();
  add_within_values(
      query, find_leaf(tree, query.at), -1, outside,
      [&](const Candidate<Point>& c) { return c.at == limit || compare_distance(p, c.at, limit) == Sign::zero; }, told);
}
template <class Point>
void ties(const KdTree<Point>& tree, const Point& p, const Point& limit, Powers powers,
          std::vector<std::uint32_t>& numbers) {
  Collected told{numbers};
  find_tied(tree, p, limit, powers, told);
}
template <class Point>
std::size_t ties_above(const KdTree<Point>& tree, const Point& p, const Point& limit, Powers powers,
                       std::uint32_t number) {
  CountedAbove told{number};
  find_tied(tree, p, limit, powers, told);
  return told.count;
}

template <class Point>
void box(const KdTree<Point>& tree, const Point& least, const Point& most, std::vector<std::uint32_t>& numbers) {
  constexpr std::size_t d = KdTree<Point>::dimension;
  const auto low = coordinates(least), high = coordinates(most);
  std::array<Side, d> sides;
  for (std::size_t a = 0; a < d; ++a) sides[a] = {low[a], high[a]};
  NumberList found(numbers);
  const std::size_t start = found.end();
  visit_leaves(
      tree, sides,
      [&](std::size_t leaf) HWY_ATTR {
        const std::size_t first = tree.first(leaf), count = tree.first(leaf + 1) - first;
        const double* const from = tree.coordinates.data() + d * first;
        for (std::size_t i = 0; i < count; i += count_of_lanes) {
          const auto inside = [&](std::size_t a) HWY_ATTR {
            const Many x = load(from + a * count + i);
            return at_most(of_all(low[a]), x) & at_most(x, of_all(high[a]));
          };
          Truth in = inside(0) & inside(1);
          if constexpr (d == 3) in = in & inside(2);
          found.add(tree.numbers, first + i, bits_of(in) & first_lanes(count - i));
        }
      },
      [&](LeafRun run) HWY_ATTR {
        const Query<Point> query(tree, least, {});
        const auto x = coordinates(query.one_of(run).at);
        bool in = true;
        for (std::size_t a = 0; a < d; ++a) in = in && low[a] <= x[a] && x[a] <= high[a];
        if (in) found.add(query.numbers_of(run));
      });
  found.sort(start, found.end());
  found.close();
}

// One for each dimension, which are exported by name.
#define PLUMB_POINT_SEARCHES(d)                                                                                        \
  NearestPoint one##d(const KdTree##d& t, const Point##d& p) { return one(t, p); }                                     \
  void of_each##d(const KdTree##d& t, const Point##d* q, const std::uint64_t* keys, std::size_t n, NearestPoint* o) {  \
    of_each(t, q, keys, n, o);                                                                                         \
  }                                                                                                                    \
  void leaves##d(const KdTree##d& t, const Point##d* q, std::size_t n, std::uint64_t* keys) { leaves(t, q, n, keys); } \
  void several##d(const KdTree##d& t, const Point##d& p, std::size_t leaf, Candidate<Point##d>* room, std::size_t k,   \
                  NearestPoint* o) {                                                                                   \
    several(t, p, leaf, room, k, o);                                                                                   \
  }                                                                                                                    \
  void ball##d(const KdTree##d& t, const Point##d& p, double radius, std::vector<std::uint32_t>& to) {                 \
    ball(t, p, radius, to);                                                                                            \
  }                                                                                                                    \
  void balls##d(const KdTree##d& t, const Point##d* q, const std::uint64_t* keys, std::size_t n, double radius,        \
                ListBlock& to) {                                                                                       \
    balls(t, q, keys, n, radius, to);                                                                                  \
  }                                                                                                                    \
  void ties##d(const KdTree##d& t, const Point##d& p, const Point##d& limit, Powers powers,                            \
               std::vector<std::uint32_t>& to) {                                                                       \
    ties(t, p, limit, powers, to);                                                                                     \
  }                                                                                                                    \
  std::size_t ties_above##d(const KdTree##d& t, const Point##d& p, const Point##d& limit, Powers powers,               \
                            std::uint32_t number) {                                                                    \
    return ties_above(t, p, limit, powers, number);                                                                    \
  }                                                                                                                    \
  void box##d(const KdTree##d& t, const Point##d& low, const Point##d& high, std::vector<std::uint32_t>& to) {         \
    box(t, low, high, to);                                                                                             \
  }
PLUMB_POINT_SEARCHES(2)
PLUMB_POINT_SEARCHES(3)
#undef PLUMB_POINT_SEARCHES

}  // namespace
}  // namespace plumb::space::kd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space::kd {
namespace {

#define PLUMB_EXPORT_BOTH(name) \
  PLUMB_EXPORT(name##2);        \
  PLUMB_EXPORT(name##3)
PLUMB_EXPORT_BOTH(one);
PLUMB_EXPORT_BOTH(of_each);
PLUMB_EXPORT_BOTH(leaves);
PLUMB_EXPORT_BOTH(several);
PLUMB_EXPORT_BOTH(ball);
PLUMB_EXPORT_BOTH(balls);
PLUMB_EXPORT_BOTH(ties);
PLUMB_EXPORT_BOTH(ties_above);
PLUMB_EXPORT_BOTH(box);
#undef PLUMB_EXPORT_BOTH

}  // namespace

template <class Point>
Powers powers_for(const KdTree<Point>& tree, const Point& p, double distance) {
  if (is_moderate(distance)) return {};
  if (distance == 0) return {1, 0x1p1000};
  const double power = std::ldexp(1.0, std::clamp(-std::ilogb(distance), -1000, 1000));
  bool halves = distance > 1 && tree.halves;
  for (const double x : coordinates(p)) halves = halves && has_half(x);
  return halves ? Powers{0.5, 2 * power} : Powers{1, power};
}

#define PLUMB_BY_DIMENSION(name, ...)            \
  if constexpr (std::is_same_v<Point, Point2>) { \
    return PLUMB_DISPATCH(name##2)(__VA_ARGS__); \
  } else {                                       \
    return PLUMB_DISPATCH(name##3)(__VA_ARGS__); \
  }

template <class Point>
NearestPoint nearest_one(const KdTree<Point>& tree, const Point& p) {
  PLUMB_BY_DIMENSION(one, tree, p)
}
template <class Point>
void find_leaves(const KdTree<Point>& tree, std::span<const Point> queries, std::uint64_t* keys) {
  PLUMB_BY_DIMENSION(leaves, tree, queries.data(), queries.size(), keys)
}
template <class Point>
void nearest_of_each(const KdTree<Point>& tree, const Point* queries, std::span<const std::uint64_t> keys,
                     NearestPoint* out) {
  PLUMB_BY_DIMENSION(of_each, tree, queries, keys.data(), keys.size(), out)
}
template <class Point>
void k_nearest(const KdTree<Point>& tree, const Point& p, std::size_t leaf, std::span<Candidate<Point>> room,
               NearestPoint* out) {
  PLUMB_BY_DIMENSION(several, tree, p, leaf, room.data(), room.size(), out)
}
template <class Point>
void add_ties(const KdTree<Point>& tree, const Point& p, const Point& limit, std::vector<std::uint32_t>& numbers) {
  const Powers powers = powers_for(tree, p, p == limit ? 0 : half_of_widest(p, limit));
  PLUMB_BY_DIMENSION(ties, tree, p, limit, powers, numbers)
}
template <class Point>
std::size_t count_ties_above(const KdTree<Point>& tree, const Point& p, const Point& limit, std::uint32_t number) {
  const Powers powers = powers_for(tree, p, p == limit ? 0 : half_of_widest(p, limit));
  PLUMB_BY_DIMENSION(ties_above, tree, p, limit, powers, number)
}
template <class Point>
void add_within(const KdTree<Point>& tree, const Point& p, double radius, std::vector<std::uint32_t>& numbers) {
  PLUMB_BY_DIMENSION(ball, tree, p, radius, numbers)
}
template <class Point>
void add_within_each(const KdTree<Point>& tree, const Point* queries, std::span<const std::uint64_t> keys,
                     double radius, ListBlock& block) {
  PLUMB_BY_DIMENSION(balls, tree, queries, keys.data(), keys.size(), radius, block)
}
template <class Point>
void add_in_box(const KdTree<Point>& tree, const BoxOf<Point>& box,
                std::vector<std::uint32_t>& numbers){PLUMB_BY_DIMENSION(box, tree, box.min, box.max, numbers)}
#undef PLUMB_BY_DIMENSION

#define PLUMB_INSTANTIATE(P)                                                                                     \
  template Powers powers_for(const KdTree<P>&, const P&, double);                                                \
  template NearestPoint nearest_one(const KdTree<P>&, const P&);                                                 \
  template void find_leaves(const KdTree<P>&, std::span<const P>, std::uint64_t*);                               \
  template void nearest_of_each(const KdTree<P>&, const P*, std::span<const std::uint64_t>, NearestPoint*);      \
  template void k_nearest(const KdTree<P>&, const P&, std::size_t, std::span<Candidate<P>>, NearestPoint*);      \
  template void add_ties(const KdTree<P>&, const P&, const P&, std::vector<std::uint32_t>&);                     \
  template std::size_t count_ties_above(const KdTree<P>&, const P&, const P&, std::uint32_t);                    \
  template void add_within(const KdTree<P>&, const P&, double, std::vector<std::uint32_t>&);                     \
  template void add_within_each(const KdTree<P>&, const P*, std::span<const std::uint64_t>, double, ListBlock&); \
  template void add_in_box<P>(const KdTree<P>&, const BoxOf<P>&, std::vector<std::uint32_t>&);
PLUMB_INSTANTIATE(Point2) PLUMB_INSTANTIATE(Point3)
#undef PLUMB_INSTANTIATE

}  // namespace plumb::space::kd
#endif
