// Branch and bound over the points of a k-d tree: what lanes of doubles find, by the instruction set at hand.
//
// A point's value is the square of its distance from p in doubles (arith/square_sum.hpp), of differences times a
// power of two; so is a cell's, of the planes between it and p.  Both are compared with what is certainly beyond the
// limit.
// Laws: those of plumb/space/kd_tree/nearest_point.hpp and point_range.hpp.
// Source: Arya and Mount 1993 (incremental distances).
// Cost: a step down for each level, the cells beyond planes that are nearer than what is found.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/arith/square_sum.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/space/kd_tree/nearest_point.hpp"
#include "plumb/space/kd_tree/point_range.hpp"

namespace plumb::space::kd {

namespace squares = arith::squares;

inline auto sum_of_squares(squares::Difference x, squares::Difference y) {
  return squares::squared(x) + squares::squared(y);
}
inline auto sum_of_squares(squares::Difference x, squares::Difference y, squares::Difference z) {
  return squares::squared(x) + squares::squared(y) + squares::squared(z);
}
template <std::size_t d>
struct SquareOf;
template <>
struct SquareOf<2> {
  using type = decltype(sum_of_squares(squares::Difference(), squares::Difference()));
};
template <>
struct SquareOf<3> {
  using type = decltype(sum_of_squares(squares::Difference(), squares::Difference(), squares::Difference()));
};
/// The square of a distance, which knows how far it is off.
template <class Point>
using Square = typename SquareOf<KdTree<Point>::dimension>::type;

/// A point of the tree, as it was met.
template <class Point>
struct Candidate {
  Point at;
  std::uint32_t number;
  double value;
};

/// By distance from p, then by number.
template <class Point>
bool comes_first(const Point& p, const Candidate<Point>& a, const Candidate<Point>& b) {
  const auto c = squares::compare(Square<Point>{a.value}, Square<Point>{b.value});
  if (c.sure) [[likely]]
    return c.value < 0;
  if (a.at == b.at) return a.number < b.number;  // many points may be equal, and nothing is to be decided of them
  const Sign order = compare_distance(p, a.at, b.at);
  return order == Sign::zero ? a.number < b.number : order == Sign::negative;
}

/// Is half of it a double?
constexpr bool has_half(double x) { return 2 * (x / 2) == x; }

/// Half of the longest way along an axis between different points: a guess at their distance.
template <class Point>
double half_of_widest(const Point& p, const Point& q) {
  const auto a = coordinates(p), b = coordinates(q);
  double most = std::numeric_limits<double>::denorm_min();
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::fabs(a[k] / 2 - b[k] / 2));
  return most;
}

/// What coordinates are multiplied by, which stay exact, and what their differences are.
struct Powers {
  double before = 1, after = 1;
};
/// Are squares of such differences far from the largest and the least doubles?  A guess, as powers_for is.
constexpr bool is_moderate(double distance) { return distance > 0x1p-400 && distance < 0x1p400; }
/// A guess, where squares of differences may overflow or get lost: powers that make distances of about this many
/// numbers near 1.  Halves where doubles are so large that their differences overflow.
template <class Point>
Powers powers_for(const KdTree<Point>& tree, const Point& p, double distance);

/// Of a tree of at least one, and at least room.size(), points.
template <class Point>
NearestPoint nearest_one(const KdTree<Point>& tree, const Point& p);
/// Keys: the leaf whose cell holds a query, in the upper half, and the query's number.
template <class Point>
void find_leaves(const KdTree<Point>& tree, std::span<const Point> queries, std::uint64_t* keys);
template <class Point>
void nearest_of_each(const KdTree<Point>& tree, const Point* queries, std::span<const std::uint64_t> keys,
                     NearestPoint* out);
template <class Point>
void k_nearest(const KdTree<Point>& tree, const Point& p, std::size_t leaf, std::span<Candidate<Point>> room,
               NearestPoint* out);
/// Those that are exactly as near as the limit, in the order of the leaves.
template <class Point>
void add_ties(const KdTree<Point>& tree, const Point& p, const Point& limit, std::vector<std::uint32_t>& numbers);
/// How many of them have a number above this one.  Of equal points, of which a node has all, one is looked at.
template <class Point>
std::size_t count_ties_above(const KdTree<Point>& tree, const Point& p, const Point& limit, std::uint32_t number);

struct ListBlock;

/// Ascending, as are those in a box.
template <class Point>
void add_within(const KdTree<Point>& tree, const Point& p, double radius, std::vector<std::uint32_t>& numbers);
/// A list for each of the queries that keys name.
template <class Point>
void add_within_each(const KdTree<Point>& tree, const Point* queries, std::span<const std::uint64_t> keys,
                     double radius, ListBlock& block);
template <class Point>
void add_in_box(const KdTree<Point>& tree, const BoxOf<Point>& box, std::vector<std::uint32_t>& numbers);

}  // namespace plumb::space::kd
