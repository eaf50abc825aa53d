// Three numbers at once: a vector of space, or one number of each of three axes.
//
// One text for two machines: four lanes of 256 bits with fused multiply-adds, of which the last is never looked at, or
// three doubles.  Included once for each target by files that Highway compiles for several.
// Laws: each operation is that of doubles in every lane, except that plus_product rounds once or twice; comparisons
// with NaN are false.  No bound of an error counts on the product being rounded, or on it not being.
// Source: RTCD 13.7.
// Cost: none.
#if defined(PLUMB_THREE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef PLUMB_THREE_LANES
#undef PLUMB_THREE_LANES
#else
#define PLUMB_THREE_LANES
#endif

#include <hwy/highway.h>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/certify/certainly.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::certify::three_lanes::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2

struct Three {
  __m256d v;
};
struct Truth {  // lane by lane
  __m256d v;
};

HWY_INLINE Three three(double x, double y, double z) { return {_mm256_set_pd(0, z, y, x)}; }
HWY_INLINE Three of_all(double x) { return {_mm256_set1_pd(x)}; }
HWY_INLINE Three loaded(const double* xyz) { return {_mm256_maskload_pd(xyz, _mm256_set_epi64x(0, -1, -1, -1))}; }
HWY_INLINE Three operator+(const Three& a, const Three& b) { return {_mm256_add_pd(a.v, b.v)}; }
HWY_INLINE Three operator-(const Three& a, const Three& b) { return {_mm256_sub_pd(a.v, b.v)}; }
HWY_INLINE Three operator*(const Three& a, const Three& b) { return {_mm256_mul_pd(a.v, b.v)}; }
HWY_INLINE Three operator/(const Three& a, const Three& b) { return {_mm256_div_pd(a.v, b.v)}; }
HWY_INLINE Three plus_product(const Three& sum, const Three& a, const Three& b) {
  return {_mm256_fmadd_pd(a.v, b.v, sum.v)};
}
HWY_INLINE Three minus_product(const Three& sum, const Three& a, const Three& b) {
  return {_mm256_fnmadd_pd(a.v, b.v, sum.v)};
}
HWY_INLINE Three size(const Three& a) { return {_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)}; }
HWY_INLINE Three larger(const Three& a, const Three& b) { return {_mm256_max_pd(a.v, b.v)}; }
HWY_INLINE Three smaller(const Three& a, const Three& b) { return {_mm256_min_pd(a.v, b.v)}; }
/// (y, z, x), and (z, x, y).
HWY_INLINE Three turned(const Three& a) { return {_mm256_permute4x64_pd(a.v, 0b11001001)}; }
HWY_INLINE Three turned_back(const Three& a) { return {_mm256_permute4x64_pd(a.v, 0b11010010)}; }
template <int lane>
HWY_INLINE Three spread(const Three& a) {
  return {_mm256_permute4x64_pd(a.v, lane * 0b01010101)};
}
HWY_INLINE double x_of(const Three& a) { return _mm256_cvtsd_f64(a.v); }
HWY_INLINE double total(const Three& a) {
  const __m128d xy = _mm256_castpd256_pd128(a.v), z = _mm256_extractf128_pd(a.v, 1);
  return _mm_cvtsd_f64(_mm_add_sd(_mm_add_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
}
HWY_INLINE double largest(const Three& a) {
  const __m128d xy = _mm256_castpd256_pd128(a.v), z = _mm256_extractf128_pd(a.v, 1);
  return _mm_cvtsd_f64(_mm_max_sd(_mm_max_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
}
HWY_INLINE double least(const Three& a) {
  const __m128d xy = _mm256_castpd256_pd128(a.v), z = _mm256_extractf128_pd(a.v, 1);
  return _mm_cvtsd_f64(_mm_min_sd(_mm_min_sd(xy, _mm_unpackhi_pd(xy, xy)), z));
}
/// What a product of two, rounded, lost; exact, as two_product is.
HWY_INLINE Three product_error(const Three& a, const Three& b, const Three& p) {
  return {_mm256_fmsub_pd(a.v, b.v, p.v)};
}
/// The largest power of two of which this is a multiple; infinity for zero.
HWY_INLINE Three lowest_bit(const Three& a) {
  const __m256i x = _mm256_castpd_si256(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.v)), zero = _mm256_setzero_si256();
  const __m256i without = _mm256_and_si256(x, _mm256_add_epi64(x, _mm256_set1_epi64x(-1)));
  const __m256d size = _mm256_castsi256_pd(x), low = _mm256_sub_pd(size, _mm256_castsi256_pd(without));
  const __m256i is_power = _mm256_cmpeq_epi64(_mm256_slli_epi64(x, 12), zero), is_none = _mm256_cmpeq_epi64(x, zero);
  const __m256d bit = _mm256_blendv_pd(low, size, _mm256_castsi256_pd(is_power));
  return {_mm256_blendv_pd(bit, _mm256_set1_pd(__builtin_huge_val()), _mm256_castsi256_pd(is_none))};
}
/// Lane i of the first is x of the i-th argument; and so on.
struct Columns {
  Three x, y, z;
};
HWY_INLINE Columns transposed(const Three& a, const Three& b, const Three& c) {
  const __m256d ab_xz = _mm256_unpacklo_pd(a.v, b.v), ab_y = _mm256_unpackhi_pd(a.v, b.v);
  return {{_mm256_permute2f128_pd(ab_xz, c.v, 0x20)},
          {_mm256_permute2f128_pd(ab_y, _mm256_permute_pd(c.v, 0b0101), 0x20)},
          {_mm256_permute2f128_pd(ab_xz, c.v, 0x31)}};
}

HWY_INLINE Truth above(const Three& a, const Three& b) { return {_mm256_cmp_pd(a.v, b.v, _CMP_GT_OQ)}; }
HWY_INLINE Truth is_zero(const Three& a) { return {_mm256_cmp_pd(a.v, _mm256_setzero_pd(), _CMP_EQ_OQ)}; }
HWY_INLINE Truth operator&(const Truth& a, const Truth& b) { return {_mm256_and_pd(a.v, b.v)}; }
HWY_INLINE Truth operator|(const Truth& a, const Truth& b) { return {_mm256_or_pd(a.v, b.v)}; }
HWY_INLINE Three chosen(const Truth& t, const Three& yes, const Three& no) {
  return {_mm256_blendv_pd(no.v, yes.v, t.v)};
}
HWY_INLINE bool any(const Truth& t) { return (_mm256_movemask_pd(t.v) & 7) != 0; }
HWY_INLINE bool all(const Truth& t) { return (_mm256_movemask_pd(t.v) & 7) == 7; }
/// Bit i: lane i.
HWY_INLINE unsigned bits(const Truth& t) { return static_cast<unsigned>(_mm256_movemask_pd(t.v)) & 7U; }

#else

struct Three {
  double x, y, z;
};
struct Truth {
  bool x, y, z;
};

HWY_INLINE double larger_of(double a, double b) { return a > b ? a : b; }
HWY_INLINE double smaller_of(double a, double b) { return a < b ? a : b; }
HWY_INLINE Three three(double x, double y, double z) { return {x, y, z}; }
HWY_INLINE Three of_all(double x) { return {x, x, x}; }
HWY_INLINE Three loaded(const double* xyz) { return {xyz[0], xyz[1], xyz[2]}; }
HWY_INLINE Three operator+(const Three& a, const Three& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Three operator-(const Three& a, const Three& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Three operator*(const Three& a, const Three& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
HWY_INLINE Three operator/(const Three& a, const Three& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
HWY_INLINE Three plus_product(const Three& sum, const Three& a, const Three& b) { return sum + a * b; }
HWY_INLINE Three minus_product(const Three& sum, const Three& a, const Three& b) { return sum - a * b; }
HWY_INLINE Three size(const Three& a) { return {magnitude_of(a.x), magnitude_of(a.y), magnitude_of(a.z)}; }
HWY_INLINE Three larger(const Three& a, const Three& b) {
  return {larger_of(a.x, b.x), larger_of(a.y, b.y), larger_of(a.z, b.z)};
}
HWY_INLINE Three smaller(const Three& a, const Three& b) {
  return {smaller_of(a.x, b.x), smaller_of(a.y, b.y), smaller_of(a.z, b.z)};
}
HWY_INLINE Three turned(const Three& a) { return {a.y, a.z, a.x}; }
HWY_INLINE Three turned_back(const Three& a) { return {a.z, a.x, a.y}; }
template <int lane>
HWY_INLINE Three spread(const Three& a) {
  return of_all(lane == 0 ? a.x : lane == 1 ? a.y : a.z);
}
HWY_INLINE double x_of(const Three& a) { return a.x; }
HWY_INLINE double total(const Three& a) { return a.x + a.y + a.z; }
HWY_INLINE double largest(const Three& a) { return larger_of(larger_of(a.x, a.y), a.z); }
HWY_INLINE double least(const Three& a) { return smaller_of(smaller_of(a.x, a.y), a.z); }
HWY_INLINE Three product_error(const Three& a, const Three& b, const Three&) {
  return {two_product(a.x, b.x).error, two_product(a.y, b.y).error, two_product(a.z, b.z).error};
}
HWY_INLINE Three lowest_bit(const Three& a) {
  return {one_lane::lowest_bit(a.x), one_lane::lowest_bit(a.y), one_lane::lowest_bit(a.z)};
}
struct Columns {
  Three x, y, z;
};
HWY_INLINE Columns transposed(const Three& a, const Three& b, const Three& c) {
  return {{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}};
}

HWY_INLINE Truth above(const Three& a, const Three& b) { return {a.x > b.x, a.y > b.y, a.z > b.z}; }
HWY_INLINE Truth is_zero(const Three& a) { return {a.x == 0, a.y == 0, a.z == 0}; }
HWY_INLINE Truth operator&(const Truth& a, const Truth& b) {
  return {(a.x & b.x) != 0, (a.y & b.y) != 0, (a.z & b.z) != 0};
}
HWY_INLINE Truth operator|(const Truth& a, const Truth& b) {
  return {(a.x | b.x) != 0, (a.y | b.y) != 0, (a.z | b.z) != 0};
}
HWY_INLINE Three chosen(const Truth& t, const Three& yes, const Three& no) {
  return {t.x ? yes.x : no.x, t.y ? yes.y : no.y, t.z ? yes.z : no.z};
}
HWY_INLINE bool any(const Truth& t) { return (t.x | t.y | t.z) != 0; }
HWY_INLINE bool all(const Truth& t) { return (t.x & t.y & t.z) != 0; }
HWY_INLINE unsigned bits(const Truth& t) { return (t.x ? 1U : 0U) | (t.y ? 2U : 0U) | (t.z ? 4U : 0U); }

#endif

HWY_INLINE Truth both(const Truth& a, const Truth& b) { return a & b; }
HWY_INLINE Three loaded(const Three& a) { return a; }
HWY_INLINE Three loaded(const Point3& p) { return loaded(&p.x); }
HWY_INLINE Three loaded(const Vector3& v) { return loaded(&v.x); }
HWY_INLINE Three loaded(double x, double y, double z) { return three(x, y, z); }
/// Is none a NaN or positive infinity?
HWY_INLINE bool all_real(const Three& a) { return all(above(of_all(__builtin_huge_val()), a)); }
/// The sum of columns' parts along a vector, lane by lane: the dot products of the vectors that were transposed.
HWY_INLINE Three along(const Columns& c, const Three& x, const Three& y, const Three& z) {
  return plus_product(plus_product(c.x * x, c.y, y), c.z, z);
}
/// The cross product in the order (z, x, y), of vectors that are given with themselves turned.
HWY_INLINE Three crossed(const Three& a, const Three& a_turned, const Three& b, const Three& b_turned) {
  return minus_product(a * b_turned, a_turned, b);
}

/// Of the columns of a matrix those of its cofactors: lane i is the cross product of rows i + 1 and i + 2.
HWY_INLINE Columns cofactors(const Columns& c) {
  const Three x = turned(c.x), y = turned(c.y), z = turned(c.z);
  return {turned(crossed(c.y, y, c.z, z)), turned(crossed(c.z, z, c.x, x)), turned(crossed(c.x, x, c.y, y))};
}

}  // namespace plumb::certify::three_lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
