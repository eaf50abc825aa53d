#include "query/overlap/neighbor_triangles.hpp"

#include "query/overlap/filters.hpp"
#include "query/overlap/flat_areas.hpp"
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
std::optional<Relation> of_same(const Triangle3& a, std::size_t likely) {
  for (const std::size_t axis : {likely, (likely + 1) % 3, (likely + 2) % 3}) {
    if (turn(a.a, a.b, a.c, axis) != Sign::zero) return Relation::overlapping;
  }
  return {};
}

/// The edge v w is shared, the third corner of b is not surely off a's plane.
std::optional<Relation> at_edge(const Triangle3& a, const Point3& v, const Point3& w, const Point3& of_a,
                                const Point3& of_b, std::size_t axis) {
  const Sign turned_a = turn(v, w, of_a, axis);
  if (turned_a == Sign::zero) return {};
  if (orient3d(a.a, a.b, a.c, of_b) != Sign::zero) return Relation::touching;
  const Sign turned_b = turn(v, w, of_b, axis);
  if (turned_b == Sign::zero) return {};
  return turned_a == turned_b ? Relation::overlapping : Relation::touching;
}

/// Of a cone from v between p and q, and one between r and s, as seen in a plane.
class Cones {
 public:
  Cones(const Point2& v, const Point2& p, const Point2& q, const Point2& r, const Point2& s)
      : v_(v), ends_{p, q, r, s}, from_v_{from_to(v, p), from_to(v, q), from_to(v, r), from_to(v, s)} {
    error_ = area_error_of(from_v_[0], from_v_[1], from_v_[2], from_v_[3]);
  }

  /// Is v all that they have in common?  Then a line through an edge of one has the other on its outer side, and may hold
  /// an edge of it that leads away.  The first cone is wide.
  [[nodiscard]] bool only_meet_at_tip() const {
    const Sign wide = turn(0, 1);
    if (wide == Sign::zero) return false;
    const Sign pr = turn(0, 2), ps = turn(0, 3);
    if (is_beyond(wide, pr, 0, 2) && is_beyond(wide, ps, 0, 3)) return true;
    const Sign qr = turn(1, 2), qs = turn(1, 3);
    if (is_beyond(-wide, qr, 1, 2) && is_beyond(-wide, qs, 1, 3)) return true;
    const Sign other = turn(2, 3);
    if (other == Sign::zero) return false;
    return (is_beyond(other, -pr, 0, 2) && is_beyond(other, -qr, 1, 2)) ||
           (is_beyond(-other, -ps, 0, 3) && is_beyond(-other, -qs, 1, 3));
  }

 private:
  /// Seen from the edge to end i: is the other end, turned so, not on the inner side, nor on the edge?
  [[nodiscard]] bool is_beyond(Sign inner, Sign turned, std::size_t i, std::size_t k) const {
    if (turned != Sign::zero) return turned != inner;
    const auto away = [](double a, double b) { return (a < 0 && b > 0) || (a > 0 && b < 0); };  // differences' signs
    return away(from_v_[i].x, from_v_[k].x) || away(from_v_[i].y, from_v_[k].y);
  }
  [[nodiscard]] Sign turn(std::size_t i, std::size_t k) const {
    const double x = area(from_v_[i], from_v_[k]);
    if (magnitude_of(x) > error_) return x > 0 ? Sign::positive : Sign::negative;
    return orient2d(v_, ends_[i], ends_[k]);
  }
  Point2 v_;
  std::array<Point2, 4> ends_;
  std::array<Seen2<double>, 4> from_v_;
  double error_;
};

/// v is shared; p and q are a's other corners, r and s b's, with such heights over a's plane.
std::optional<Relation> at_corner(const Point3& v, const Point3& p, const Point3& q, const Point3& r, const Point3& s,
                                  std::size_t axis, double over_r, double over_s, double error) {
  using predicates::cross, predicates::dot;
  const int of_r = sign_beyond(over_r, error), of_s = sign_beyond(over_s, error);
  if (of_r * of_s > 0) return Relation::touching;
  // The plane of a is not seen edge on, so that what is in common is seen to be.
  const auto only_meet_at_tip = [&] {
    return Cones(seen(v, axis), seen(p, axis), seen(q, axis), seen(r, axis), seen(s, axis)).only_meet_at_tip();
  };
  const bool in_plane = of_r == 0 && of_s == 0;
  if (in_plane && only_meet_at_tip()) return Relation::touching;
  const Difference normal = cross(difference(v, r), difference(v, s));
  const double over_p = dot(difference(v, p), normal), over_q = dot(difference(v, q), normal);
  const double sum = over_p + over_q;
  const double eightfold = error * from_any_corner + (sum - sum);
  const int of_p = sign_beyond(over_p, eightfold), of_q = sign_beyond(over_q, eightfold);
  if (of_p * of_q > 0) return Relation::touching;
  // Along the cross product of the planes' normals, p x q and r x s, a leaves v forward where p is above b's plane, and
  // b where r is below a's.  In doubt the other corner is on the other side: else it is no crossing, and they touch.
  if (in_plane) return {};
  if (of_p == 0 && of_q == 0) return only_meet_at_tip() ? std::optional(Relation::touching) : std::nullopt;
  const int a_forward = of_p != 0 ? of_p : -of_q, b_forward = of_r != 0 ? -of_r : of_s;
  if (a_forward != b_forward) return Relation::touching;
  if (of_p * of_q < 0 && of_r * of_s < 0) return Relation::overlapping;
  return {};
}

}  // namespace

std::optional<Relation> relate_neighbors(const Triangle3& a, const Triangle3& b, std::size_t axis,
                                         const std::array<double, 3>& over_a, double error) {
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
    return at_corner(*p[first], *p[(first + 1) % 3], *p[(first + 2) % 3], *q[r], *q[s], axis, over_a[r], over_a[s],
                     error);
  }
  if (of_a[1] == first) return {};
  if (shared == 2) {
    if (magnitude_of(over_a[own]) > error) return Relation::touching;
    return at_edge(a, *p[first], *p[of_a[1]], *p[3 - first - of_a[1]], *q[own], axis);
  }
  if (of_a[2] == first || of_a[2] == of_a[1]) return {};
  return of_same(a, axis);
}

}  // namespace plumb::query
