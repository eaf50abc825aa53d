#include "query/overlap/shared_corners.hpp"

#include "query/overlap/filters.hpp"
#include "query/overlap/linear3.hpp"
#include "query/overlap/signs.hpp"

namespace plumb::query {
namespace {

using CornerPointers = std::array<const Point3*, 3>;

int sign_beyond(double x, double error) { return static_cast<int>(x > error) - static_cast<int>(x < -error); }

Sign turn(const Point3& p, const Point3& q, const Point3& r, std::size_t axis) {
  return orient2d(seen(p, axis), seen(q, axis), seen(r, axis));
}

/// All corners of b are a's, each once.
std::optional<Relation> of_same(const Triangle3& a) {
  const std::size_t likely = likely_axis(a);
  for (const std::size_t axis : {likely, (likely + 1) % 3, (likely + 2) % 3}) {
    if (turn(a.a, a.b, a.c, axis) != Sign::zero) return Relation::overlapping;
  }
  return {};
}

/// The edge v w is shared, the third corner of b is not surely off a's plane.
std::optional<Relation> at_edge(const Triangle3& a, const Point3& v, const Point3& w, const Point3& of_a,
                                const Point3& of_b) {
  const std::size_t axis = likely_axis(a);
  const Sign turned_a = turn(v, w, of_a, axis);
  if (turned_a == Sign::zero) return {};
  if (orient3d(a.a, a.b, a.c, of_b) != Sign::zero) return Relation::touching;
  const Sign turned_b = turn(v, w, of_b, axis);
  if (turned_b == Sign::zero) return {};
  return turned_a == turned_b ? Relation::overlapping : Relation::touching;
}

/// v is shared; p and q are a's other corners, r and s b's, with such heights over a's plane.
std::optional<Relation> at_corner(const Point3& v, const Point3& p, const Point3& q, const Point3& r, const Point3& s,
                                  double over_r, double over_s, double error) {
  using predicates::cross, predicates::dot;
  const int of_r = sign_beyond(over_r, error), of_s = sign_beyond(over_s, error);
  if (of_r * of_s > 0) return Relation::touching;
  const Difference normal = cross(difference(v, r), difference(v, s));
  const double over_p = dot(difference(v, p), normal), over_q = dot(difference(v, q), normal);
  const double sum = over_p + over_q;
  const double eightfold = error * (8 * (1 + 0x1p-40)) + (sum - sum);
  const int of_p = sign_beyond(over_p, eightfold), of_q = sign_beyond(over_q, eightfold);
  if (of_p * of_q > 0) return Relation::touching;
  // Along the cross product of the planes' normals, p x q and r x s, a leaves v forward where p is above b's plane, and
  // b where r is below a's.  In doubt the other corner is on the other side: else it is no crossing, and they touch.
  if ((of_p == 0 && of_q == 0) || (of_r == 0 && of_s == 0)) return {};
  const int a_forward = of_p != 0 ? of_p : -of_q, b_forward = of_r != 0 ? -of_r : of_s;
  if (a_forward != b_forward) return Relation::touching;
  if (of_p * of_q < 0 && of_r * of_s < 0) return Relation::overlapping;
  return {};
}

}  // namespace

std::optional<Relation> by_shared_corners(const Triangle3& a, const Triangle3& b, const std::array<double, 3>& over_a,
                                          double error) {
  const CornerPointers p{&a.a, &a.b, &a.c}, q{&b.a, &b.b, &b.c};
  // Which corners are the same; none is counted twice, unless a triangle repeats it.
  std::array<std::size_t, 3> of_a{}, of_b{};
  std::size_t shared = 0, own = 2;  // those of b's corners, the last of the others
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t same = 3;
    if (!(magnitude_of(over_a[k]) > error)) same = *q[k] == a.a ? 0 : *q[k] == a.b ? 1 : *q[k] == a.c ? 2 : 3;
    if (same == 3) {
      own = k;
      continue;
    }
    of_a[shared] = same, of_b[shared] = k;
    ++shared;
  }
  if (shared == 0) return {};
  const std::size_t first = of_a[0], k = of_b[0];
  if (shared == 1) {
    const std::size_t r = (k + 1) % 3, s = (k + 2) % 3;
    return at_corner(*p[first], *p[(first + 1) % 3], *p[(first + 2) % 3], *q[r], *q[s], over_a[r], over_a[s], error);
  }
  if (of_a[1] == first) return {};
  if (shared == 2) {
    if (magnitude_of(over_a[own]) > error) return Relation::touching;
    return at_edge(a, *p[first], *p[of_a[1]], *p[3 - first - of_a[1]], *q[own]);
  }
  if (of_a[2] == first || of_a[2] == of_a[1]) return {};
  return of_same(a);
}

}  // namespace plumb::query
