// Vectors of space and pairs of doubles, four at once: what the texts of two boxes' axes and of their corners are made of.
//
// Included once for each target by files that Highway compiles for several; there are lanes for AVX2 alone.
// Laws: those of arith/twofold.hpp, lane by lane.
// Source: RTCD 13.7.
// Cost: some 60 operations a dot product, 110 a cross product, of four.
#if defined(PLUMB_MANY_VECTORS) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_MANY_VECTORS
#undef PLUMB_MANY_VECTORS
#else
#define PLUMB_MANY_VECTORS
#endif

#include <hwy/highway.h>

#include <array>

#include "certify/many_lanes.hpp"
#include "certify/many_twofolds.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::query::parting::many_vectors::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

namespace hn = hwy::HWY_NAMESPACE;
using certify::many_lanes::HWY_NAMESPACE::Lanes, certify::many_lanes::HWY_NAMESPACE::Many,
    certify::many_lanes::HWY_NAMESPACE::of_all, certify::many_lanes::HWY_NAMESPACE::Truth,
    certify::many_lanes::HWY_NAMESPACE::Twofolds;
using Four = std::array<double, 4>;
using One = Twofold<true>;

HWY_INLINE Many loaded_four(const Four& x) { return {hn::LoadU(Lanes(), x.data())}; }
HWY_INLINE void store(const Many& x, Four& to) { hn::StoreU(x.v, Lanes(), to.data()); }

HWY_INLINE Twofolds of_all(const One& x) {
  return {of_all(x.high), of_all(x.low), of_all(x.magnitude), x.error, x.width};
}
HWY_INLINE One first_of(const Twofolds& x) {
  return {hn::GetLane(x.high.v), hn::GetLane(x.low.v), hn::GetLane(x.magnitude.v), x.error, x.width};
}
HWY_INLINE Twofolds product_of(const Many& a, const Many& b) { return Twofolds::exact(a) * b; }

template <class T>
struct Space {
  T x, y, z;
};
HWY_INLINE Space<Many> all_of(const Vector3& v) { return {of_all(v.x), of_all(v.y), of_all(v.z)}; }
template <class S, class T>
HWY_INLINE Twofolds dot_of(const Space<S>& a, const Space<T>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
HWY_INLINE Space<Twofolds> cross_of(const Space<Many>& a, const Space<Many>& b) {
  return {product_of(a.y, b.z) - product_of(a.z, b.y), product_of(a.z, b.x) - product_of(a.x, b.z),
          product_of(a.x, b.y) - product_of(a.y, b.x)};
}
HWY_INLINE Space<Twofolds> cross_of(const Space<Twofolds>& a, const Space<Many>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#endif

}  // namespace plumb::query::parting::many_vectors::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
