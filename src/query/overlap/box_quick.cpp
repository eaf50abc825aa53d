// The axes of boxes (query/overlap/box_axes.hpp) over doubles, an axis a lane.
#include "query/overlap/box_quick.hpp"

#include "certify/exact_axes.hpp"
#include "certify/fused_lanes.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/stack_dyadic.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "query/overlap/box_quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "figure/aabb/axes2.hpp"
#include "query/overlap/box_axes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::box_quick::HWY_NAMESPACE {
namespace {

namespace lanes = certify::three_lanes::HWY_NAMESPACE;
using namespace box_axes::HWY_NAMESPACE;

template <class Statement, class... Input>
HWY_INLINE std::optional<Relation> by_doubles(const Input&... input) {
  using Doubles = lanes::Floats<lanes::Three, Statement::highest, Statement::scales>;
  return lanes::told_by_worlds<Doubles>(NoWorldRecorder{}, Statement{}, input...);
}
template <class Statement, class... Input>
HWY_INLINE std::optional<Relation> by_pairs(const Input&... input) {
  using Pairs = lanes::Floats<lanes::Three, Statement::highest, Statement::scales, NoBoundListener, Precision::pairs>;
  return lanes::told_by_worlds<Pairs>(NoWorldRecorder{}, Statement{}, input...);
}
[[maybe_unused]] std::optional<Relation> relation(const Segment3& s, const Aabb3& b) {
  return by_doubles<SegmentAndBox>(s, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Ray3& r, const Aabb3& b) {
  return by_doubles<UnboundedAndBox<LinearKind::ray>>(r.origin, r.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Line3& l, const Aabb3& b) {
  return by_doubles<UnboundedAndBox<LinearKind::line>>(l.point, l.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Triangle3& t, const Aabb3& b) {
  return by_doubles<TriangleAndBox>(t, b);
}

[[maybe_unused]] std::optional<Relation> relation(const Segment3& s, const Obb3& b) {
  return by_doubles<StraightAndObb<LinearKind::segment>>(s.a, s.b, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Ray3& r, const Obb3& b) {
  return by_doubles<StraightAndObb<LinearKind::ray>>(r.origin, r.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Line3& l, const Obb3& b) {
  return by_doubles<StraightAndObb<LinearKind::line>>(l.point, l.direction, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Triangle3& t, const Obb3& b) {
  return by_doubles<TriangleAndObb>(t, b);
}

/// The parts at which the box is nearest to the center, if its axes are at right angles, and the direction from there.
[[maybe_unused]] std::optional<Relation> relation(const Sphere3& s, const Obb3& b) {
  using lanes::spread, lanes::loaded;
  if (!(s.radius >= 0)) return {};
  const lanes::Three d = loaded(s.center) - loaded(b.center), half = size(loaded(b.half));
  const lanes::Three x = loaded(b.axes[0]), y = loaded(b.axes[1]), z = loaded(b.axes[2]);
  const lanes::Columns axes = transposed(x, y, z);
  const lanes::Three at = along(axes, spread<0>(d), spread<1>(d), spread<2>(d)) / along(axes, axes.x, axes.y, axes.z);
  const lanes::Three part = larger(smaller(at, half), lanes::of_all(0) - half);
  return by_doubles<BallAndObb>(s, b, part, seen_from(d, x, y, z, part));
}

[[maybe_unused]] std::optional<Relation> relation(const Segment2& s, const Aabb2& b) {
  return by_doubles<figure::box_axes2::HWY_NAMESPACE::SegmentAndBox2>(s, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Triangle2& t, const Aabb2& b) {
  return by_doubles<figure::box_axes2::HWY_NAMESPACE::TriangleAndBox2>(t, b);
}

[[maybe_unused]] std::optional<Relation> near_relation(const Segment3& s, const Obb3& b) {
  return by_pairs<StraightAndObb<LinearKind::segment>>(s.a, s.b, b);
}
[[maybe_unused]] std::optional<Relation> near_relation(const Ray3& r, const Obb3& b) {
  return by_pairs<StraightAndObb<LinearKind::ray>>(r.origin, r.direction, b);
}
[[maybe_unused]] std::optional<Relation> near_relation(const Line3& l, const Obb3& b) {
  return by_pairs<StraightAndObb<LinearKind::line>>(l.point, l.direction, b);
}
[[maybe_unused]] std::optional<Relation> near_relation(const Triangle3& t, const Obb3& b) {
  return by_pairs<TriangleAndObb>(t, b);
}

}  // namespace
}  // namespace plumb::query::box_quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb::query {

#define PLUMB_QUICK_RELATION(A, B) \
  std::optional<Relation> quick_relation(const A& a, const B& b) { return PLUMB_BY_LANES(box_quick, relation(a, b)); }
PLUMB_QUICK_RELATION(Segment3, Aabb3)
PLUMB_QUICK_RELATION(Ray3, Aabb3)
PLUMB_QUICK_RELATION(Line3, Aabb3)
PLUMB_QUICK_RELATION(Triangle3, Aabb3)
PLUMB_QUICK_RELATION(Segment3, Obb3)
PLUMB_QUICK_RELATION(Ray3, Obb3)
PLUMB_QUICK_RELATION(Line3, Obb3)
PLUMB_QUICK_RELATION(Triangle3, Obb3)
PLUMB_QUICK_RELATION(Sphere3, Obb3)
PLUMB_QUICK_RELATION(Segment2, Aabb2)
PLUMB_QUICK_RELATION(Triangle2, Aabb2)
#undef PLUMB_QUICK_RELATION

namespace {

namespace stated = box_axes::HWY_NAMESPACE;
template <class Statement, class... Input>
[[gnu::noinline]] std::optional<Relation> by_integers(const Input&... input) {
  using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
  using Numbers = certify::exact_axes::ExactAxes<BigDyadic, WorldKind::rationals>;
  return certify::one_lane::told_by_worlds<Integers, Numbers>(NoWorldRecorder{}, Statement{}, input...);
}

}  // namespace

std::optional<Relation> near_relation(const Segment3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(box_quick, near_relation(a, b))) return told;
  return by_integers<stated::StraightAndObb<LinearKind::segment>>(a.a, a.b, b);
}
std::optional<Relation> near_relation(const Ray3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(box_quick, near_relation(a, b))) return told;
  return by_integers<stated::StraightAndObb<LinearKind::ray>>(a.origin, a.direction, b);
}
std::optional<Relation> near_relation(const Line3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(box_quick, near_relation(a, b))) return told;
  return by_integers<stated::StraightAndObb<LinearKind::line>>(a.point, a.direction, b);
}
std::optional<Relation> near_relation(const Triangle3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(box_quick, near_relation(a, b))) return told;
  return by_integers<stated::TriangleAndObb>(a, b);
}

}  // namespace plumb::query
#endif
