// The fifteen axes of oriented boxes (figure/obb/fifteen_axes.hpp) over doubles, an axis a lane.
#include "figure/obb/quick.hpp"

#include "certify/exact_axes.hpp"
#include "certify/fused_lanes.hpp"
#include "plumb/arith/stack_dyadic.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/obb/quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "figure/obb/fifteen_axes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::obb_quick::HWY_NAMESPACE {
namespace {

namespace lanes = certify::three_lanes::HWY_NAMESPACE;

template <class Statement, Precision precision, class... Boxes>
HWY_INLINE std::optional<Relation> by(const Boxes&... boxes) {
  using World = lanes::Floats<lanes::Three, Statement::highest, Statement::scales, NoBoundListener, precision>;
  return lanes::told_by_worlds<World>(NoWorldRecorder{}, Statement{}, boxes...);
}
/// A guess: are the axes' numbers so short that all that is computed of them may fit in doubles?
HWY_INLINE bool is_short(const Obb3& box) {
  const lanes::Three addend = lanes::of_all(0x1.8p48);  // leaves multiples of 1/16
  const auto is_short = [&](const Vector3& v) HWY_ATTR {
    const lanes::Three x = lanes::loaded(v);
    return lanes::is_zero(((x + addend) - addend) - x);
  };
  return lanes::all(is_short(box.axes[0]) & is_short(box.axes[1]) & is_short(box.axes[2]));
}
template <class Statement, class A>
HWY_INLINE std::optional<Relation> by_doubles(const A& a, const Obb3& b) {
  return by<Statement, Precision::doubles>(a, b);
}
template <class Statement, class A>
HWY_INLINE std::optional<Relation> by_pairs(const A& a, const Obb3& b) {
  if (is_short(b)) {
    if (const auto told = by<Statement, Precision::lattice>(a, b)) return told;
  }
  return by<Statement, Precision::pairs>(a, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Obb3& a, const Obb3& b) {
  return by_doubles<fifteen_axes::HWY_NAMESPACE::ObbPair>(a, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Aabb3& a, const Obb3& b) {
  return by_doubles<fifteen_axes::HWY_NAMESPACE::BoxAndObb>(a, b);
}
[[maybe_unused]] std::optional<Relation> near_relation(const Obb3& a, const Obb3& b) {
  return by_pairs<fifteen_axes::HWY_NAMESPACE::ObbPair>(a, b);
}
[[maybe_unused]] std::optional<Relation> near_relation(const Aabb3& a, const Obb3& b) {
  return by_pairs<fifteen_axes::HWY_NAMESPACE::BoxAndObb>(a, b);
}

}  // namespace
}  // namespace plumb::figure::obb_quick::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace plumb {

std::optional<Relation> quick_relation(const Obb3& a, const Obb3& b) {
  return PLUMB_BY_LANES(figure::obb_quick, relation(a, b));
}
std::optional<Relation> quick_relation(const Aabb3& a, const Obb3& b) {
  return PLUMB_BY_LANES(figure::obb_quick, relation(a, b));
}
namespace {

using Integers = certify::exact_axes::ExactAxes<StackDyadic, WorldKind::integers>;
namespace stated = figure::fifteen_axes::HWY_NAMESPACE;
template <class Statement, class A>
[[gnu::noinline]] std::optional<Relation> by_integers(const A& a, const Obb3& b) {
  return certify::one_lane::told_by_worlds<Integers>(NoWorldRecorder{}, Statement{}, a, b);
}

}  // namespace

std::optional<Relation> near_relation(const Obb3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(figure::obb_quick, near_relation(a, b))) return told;
  return by_integers<stated::ObbPair>(a, b);
}
std::optional<Relation> near_relation(const Aabb3& a, const Obb3& b) {
  if (const auto told = PLUMB_BY_LANES(figure::obb_quick, near_relation(a, b))) return told;
  return by_integers<stated::BoxAndObb>(a, b);
}

}  // namespace plumb
#endif
