#include "query/separation/corner_numbers.hpp"

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "plumb/arith/ball.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {
namespace {

/// The point of one body, times the whole of the weights.
template <class T>
Vec<T> summed_corners(const CoreCorners& c, const DifferenceCorners& corners, std::size_t which,
                      const NearestOfCorners<T>& n) {
  Vec<T> sum = c.at<T>(corners.ends[0][which]) * n.weight[0];
  for (std::size_t i = 1; i < corners.size; ++i) sum = sum + c.at<T>(corners.ends[i][which]) * n.weight[i];
  return sum;
}

std::optional<Point3> nearest_doubles_of(const Vec<Ball>& v, const Ball& whole) {
  const auto x = quotient(v.x, whole).nearest(), y = quotient(v.y, whole).nearest(), z = quotient(v.z, whole).nearest();
  if (!x || !y || !z) return {};
  return told(Point3{*x, *y, *z});
}

Point3 rounded_point(const Vec<BigDyadic>& v, const BigDyadic& whole) {
  const auto rounded = [&](const BigDyadic& x) { return rounded_quotient(Rounding::nearest, x, whole); };
  return told(Point3{rounded(v.x), rounded(v.y), rounded(v.z)});
}

}  // namespace

ClosestCorners numbers_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto near = nearest_of<Ball>(a, b, corners, ask);
  const auto on_a = nearest_doubles_of(summed_corners(a, corners, 0, near), near.whole),
             on_b = nearest_doubles_of(summed_corners(b, corners, 1, near), near.whole);
  const auto d = root(quotient(near.square, near.square_whole)).nearest();
  if (on_a && on_b) return {*on_a, *on_b, d ? *d : distance_of(a, b, corners)};
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  const BigDyadic whole = n.whole * a.scale<BigDyadic>();
  return {rounded_point(summed_corners(a, corners, 0, n), whole),
          rounded_point(summed_corners(b, corners, 1, n), whole), d ? *d : distance_of(a, b, corners)};
}

double distance_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto near = nearest_of<Ball, Sought::square>(a, b, corners, ask);
  if (const auto d = root(quotient(near.square, near.square_whole)).nearest()) return *d;
  const auto n = nearest_of<BigDyadic, Sought::square>(a, b, corners, ask);
  const BigDyadic scale = a.scale<BigDyadic>();
  return rounded_root(Rounding::nearest, n.square, n.square_whole * (scale * scale));
}

mpq_class square_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic, Sought::square>(a, b, corners, ask);
  const BigDyadic scale = a.scale<BigDyadic>();
  return mpq_class(gmp_number(n.square) / gmp_number(n.square_whole * (scale * scale)));
}

}  // namespace plumb::query
