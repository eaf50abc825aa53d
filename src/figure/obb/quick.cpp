// The fifteen axes of oriented boxes (figure/obb/fifteen_axes.hpp) over doubles, an axis a lane.
#include "figure/obb/quick.hpp"

#include "certify/fused_lanes.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/obb/quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "figure/obb/fifteen_axes.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::obb_quick::HWY_NAMESPACE {
namespace {

namespace lanes = certify::three_lanes::HWY_NAMESPACE;

template <class Statement, class... Boxes>
HWY_INLINE std::optional<Relation> by_doubles(const Boxes&... boxes) {
  using Doubles = lanes::Floats<lanes::Three, Statement::highest, Statement::scales>;
  return lanes::told_by_worlds<Doubles>(NoWorldRecorder{}, Statement{}, boxes...);
}
[[maybe_unused]] std::optional<Relation> relation(const Obb3& a, const Obb3& b) {
  return by_doubles<fifteen_axes::HWY_NAMESPACE::ObbPair>(a, b);
}
[[maybe_unused]] std::optional<Relation> relation(const Aabb3& a, const Obb3& b) {
  return by_doubles<fifteen_axes::HWY_NAMESPACE::BoxAndObb>(a, b);
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

}  // namespace plumb
#endif
