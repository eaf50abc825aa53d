// What lies between few slabs?  Discrete orientation polytopes: k-DOPs of the usual directions and of your own.
//
// Laws: (1) a k-DOP is the closed set that its numbers say: all x with min[i] <= directions[i] . x <= max[i]; it may be
// empty or flat, and unbounded where the directions do not span.  (2) What is made of points, k-DOPs or images contains
// them; each interval is the least that does, rounded outward once.  (3) intervals_overlap never misses: where it is
// false the k-DOPs are disjoint.  Where it is true they may still be: relate and intersects say exactly.  (4) relate is
// symmetric; a k-DOP that contains a point has a location for it, that of all halfspaces.
// Interval ends of the wrong number, and two k-DOPs of different directions, throw InvalidShape, as do no points and a
// direction that is zero; NaN and infinities throw NonFinite; an interval that no double ends throws BeyondDoubles.
// Source: RTCD 4.6, 4.6.2, 4.6.3, 4.6.4, 6.5.4.
// Cost: intervals_overlap that of the plain test; relate the same where some interval is disjoint, 4 to 10 ns a slab
// where a point inside both is guessed, else some microseconds for a linear program in doubles of which the outcome is
// proved, ten where sets touch, up to a millisecond in rationals where one is flat; moves, measures: milliseconds.
// Bounded by n operations for a fit; of relate and tighten by a linear program of k rows, whatever the exponents are.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/arith/rounding.hpp"
#include "plumb/figure/basic/body.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// Normals of slabs, shared by all k-DOPs that have them; none is zero.
template <class Vector>
class Directions {
 public:
  explicit Directions(std::vector<Vector> directions);

  [[nodiscard]] std::span<const Vector> all() const { return *all_; }
  [[nodiscard]] std::size_t size() const { return all_->size(); }
  friend bool operator==(const Directions& a, const Directions& b) { return a.all_ == b.all_ || *a.all_ == *b.all_; }

 private:
  std::shared_ptr<const std::vector<Vector>> all_;
};
using Directions2 = Directions<Vector2>;
using Directions3 = Directions<Vector3>;

/// Of space: k = 6 (axes), 8 (corners of a cube), 14 (both), 18 (axes and edges), 26 (all).  Another k: InvalidShape.
Directions3 k_dop_directions(int k);
/// Of the plane: k = 4 (axes), 8 (and diagonals).
Directions2 k_dop_directions2(int k);

/// All x with min[i] <= directions[i] . x <= max[i].
template <class Vector>
struct KDop {
  Directions<Vector> directions;
  std::vector<double> min, max;
  friend bool operator==(const KDop&, const KDop&) = default;
};
using KDop2 = KDop<Vector2>;
using KDop3 = KDop<Vector3>;

template <class Vector, class Take>
constexpr auto body(const KDop<Vector>& s, Take take) {
  return take("k_dop", part::slabs(s));
}

KDop2 fit_k_dop(std::span<const Point2> points, const Directions2& directions);
KDop3 fit_k_dop(std::span<const Point3> points, const Directions3& directions);
KDop3 fit_k_dop(std::span<const Point3> points, int k);
/// Of the points under the pose: the tight refit of what has moved (RTCD 4.6.4).
KDop3 fit_k_dop(std::span<const Point3> points, const Directions3& directions, PoseView pose);

/// The least k-DOP of both k-DOPs' intervals; one with an empty interval adds nothing.
KDop2 merge(const KDop2& a, const KDop2& b);
KDop3 merge(const KDop3& a, const KDop3& b);

/// Of the same directions around the exact image.  An empty k-DOP stays as it is; InvalidShape where the image is
/// unbounded along a direction.
KDop2 transform(const KDop2& k_dop, PoseView2 pose);
KDop3 transform(const KDop3& k_dop, PoseView pose);

/// With every slack plane moved up to the set, which stays the same but for the rounding.  An empty set becomes that of
/// all intervals [1, -1].
KDop2 tighten(const KDop2& k_dop);
KDop3 tighten(const KDop3& k_dop);

/// The box of the set; of an empty set that of all intervals [1, -1].
Aabb2 fit_aabb(const KDop2& k_dop);
Aabb3 fit_aabb(const KDop3& k_dop);

/// The greatest direction . x of the set, rounded once as asked; up gives a halfspace that certainly contains it.  Of an
/// empty set, and along a direction in which it is unbounded, InvalidShape.
double support_value(const KDop2& k_dop, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(const KDop3& k_dop, const Vector3& direction, Rounding rounding = Rounding::up);

/// Do the intervals of every direction overlap?  The usual test: conservative.
bool intervals_overlap(const KDop2& a, const KDop2& b);
bool intervals_overlap(const KDop3& a, const KDop3& b);

/// Of the sets themselves.
Relation relate(const KDop2& a, const KDop2& b);
Relation relate(const KDop3& a, const KDop3& b);
bool intersects(const KDop2& a, const KDop2& b);
bool intersects(const KDop3& a, const KDop3& b);

/// Is there no point in it?
bool is_empty(const KDop2& k_dop);
bool is_empty(const KDop3& k_dop);

Location locate(const KDop2& k_dop, const Point2& p);
Location locate(const KDop3& k_dop, const Point3& p);
bool contains(const KDop2& k_dop, const Point2& p);
bool contains(const KDop3& k_dop, const Point3& p);

/// Does the outer set hold every point of the inner one?
bool contains(const KDop2& outer, const KDop2& inner);
bool contains(const KDop3& outer, const KDop3& inner);

/// The exact value rounded to nearest; of an unbounded set InvalidShape.  Some milliseconds.
double area(const KDop2& k_dop);
double volume(const KDop3& k_dop);
/// Within 1 ulp, and nearest but for rare doubt; a flat k-DOP has both its sides.
double surface_area(const KDop3& k_dop);

}  // namespace plumb
