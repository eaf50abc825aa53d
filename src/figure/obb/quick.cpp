// The fifteen gaps of oriented boxes, an axis a lane; figure/obb/gaps.hpp has them as formulas.
#include "figure/obb/quick.hpp"

#include "certify/fused_lanes.hpp"
#include "figure/obb/gaps.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "figure/obb/quick.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "certify/three_lanes.hpp"

#ifndef PLUMB_OBB_QUICK_ONCE
#define PLUMB_OBB_QUICK_ONCE
namespace plumb::figure::obb_gaps {

// No power of degree nine or lower of numbers from the least to the most leaves the range of doubles, nor does its
// product with the constant of an error.
constexpr double least = 0x1p-100, most = 0x1p100;

/// Bounds of the errors along the faces of a, those of b, and of edges.
struct Errors {
  double face_of_a, face_of_b, edges;
};

}  // namespace plumb::figure::obb_gaps
#endif

HWY_BEFORE_NAMESPACE();
namespace plumb::figure::obb_quick::HWY_NAMESPACE {
namespace {

using namespace certify::three_lanes::HWY_NAMESPACE;
using namespace figure::obb_gaps;

HWY_INLINE double at_least(double x, double floor) { return x > floor ? x : floor; }

/// In the frame of a: the way between the centers, a's extents, b's axes one by one, b's half extents.
struct Pair {
  Three t, h;
  std::array<Three, 3> r;
  Three k;
};

/// Each number that is asked for is in gap_a or in the errors, so that a NaN is seen there.
HWY_INLINE std::optional<Relation> told(const Pair& p, const Errors& error) {
  const Three &t = p.t, &h = p.h, &k = p.k;
  const std::array<Three, 3>& r = p.r;  // named apart: lambdas of clang 14 take no structured bindings
  const std::array k_of{spread<0>(k), spread<1>(k), spread<2>(k)};
  const std::array size_r{size(r[0]), size(r[1]), size(r[2])};
  const Three off_a = of_all(error.face_of_a), zero = of_all(0);
  const Three beyond_a = size(t) - h;
  const Three gap_a =
      minus_product(minus_product(minus_product(beyond_a, k_of[0], size_r[0]), k_of[1], size_r[1]), k_of[2], size_r[2]);
  if (any(above(gap_a, off_a)) && all_real(gap_a)) return Relation::disjoint;
  Truth inside = above(zero - off_a, gap_a);
  if (all(inside & above(zero - off_a, beyond_a))) return Relation::overlapping;  // the center of b is inside a

  // The cofactors c of r, in the order (z, x, y), which is that of cross products.
  const std::array r_turned{turned(r[0]), turned(r[1]), turned(r[2])};
  const auto cofactors = [&](std::size_t i, std::size_t j) { return crossed(r[i], r_turned[i], r[j], r_turned[j]); };
  const std::array c{cofactors(1, 2), cofactors(2, 0), cofactors(0, 1)};
  const std::array size_c{size(c[0]), size(c[1]), size(c[2])};
  const Three t_turned = turned(t), h_turned = turned(h), t_back = turned(t_turned), h_back = turned(h_turned);
  const Three off_edges = of_all(error.edges);
  Truth apart = above(zero, zero);
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const Three of_a = plus_product(h * size(r_turned[j]), h_turned, size_r[j]);
    const Three of_b = plus_product(k_of[j1] * size_c[j2], k_of[j2], size_c[j1]);
    const Three gap = size(crossed(t, t_turned, r[j], r_turned[j])) - (of_a + of_b);
    apart = apart | above(gap, off_edges);
    inside = inside & above(zero - off_edges, gap);
  }
  const auto sums = [](const Columns& s) { return s.x + s.y + s.z; };
  const Three determinant = of_all(magnitude_of(total(turned(r_turned[0]) * c[0]))), off_b = of_all(error.face_of_b);
  const Three along_b = size(sums(transposed(t_back * c[0], t_back * c[1], t_back * c[2])));
  const Three reach = sums(transposed(h_back * size_c[0], h_back * size_c[1], h_back * size_c[2]));
  const Three gap_b = along_b - plus_product(reach, k, determinant);
  if (any(apart | above(gap_b, off_b)) && all_real(gap_a)) return Relation::disjoint;
  // If all six edges lay in a plane, two that are not parallel would have shown its normal, along which no gap is
  // negative; so they span space, and the fifteen axes are all there are.
  if (all(inside & above(zero - off_b, gap_b))) return Relation::overlapping;
  return {};
}

[[maybe_unused]] std::optional<Relation> relation(const Obb3& a, const Obb3& b) {
  const std::array of_a{loaded(a.axes[0]), loaded(a.axes[1]), loaded(a.axes[2])};
  const std::array of_b{loaded(b.axes[0]), loaded(b.axes[1]), loaded(b.axes[2])};
  const std::array size_a{size(of_a[0]), size(of_a[1]), size(of_a[2])};
  const std::array size_b{size(of_b[0]), size(of_b[1]), size(of_b[2])};
  const Three d = loaded(b.center) - loaded(a.center), half = size(loaded(a.half)), k = size(loaded(b.half));
  const double largest_d = at_least(largest(size(d)), least);
  const double largest_a = at_least(largest(larger(larger(size_a[0], size_a[1]), size_a[2])), least);
  const double largest_b = at_least(largest(larger(larger(size_b[0], size_b[1]), size_b[2])), least);
  const double all = largest_d + total(plus_product(of_all(largest_a) * half, of_all(largest_b), k));
  if (!(all < most && largest_a < most && largest_b < most)) return {};
  // Along the axes of space: what is far apart ends here.
  const auto reach = [](const std::array<Three, 3>& axes, const Three& h) {
    return plus_product(plus_product(axes[0] * spread<0>(h), axes[1], spread<1>(h)), axes[2], spread<2>(h));
  };
  const Three gap = size(d) - (reach(size_a, half) + reach(size_b, k));
  if (any(above(gap, of_all(error<AxisOfSpace> * all))) && all_real(gap)) return Relation::disjoint;

  const Columns axes = transposed(of_a[0], of_a[1], of_a[2]), normals = cofactors(axes);
  const Three volume = size(along(normals, axes.x, axes.y, axes.z));  // three times, but for roundings
  const auto seen = [&](const Three& v) { return along(normals, spread<0>(v), spread<1>(v), spread<2>(v)); };
  const double a2 = largest_a * largest_a, a4 = a2 * a2;
  static_assert(error<CenterInA> <= error<FaceOfA>);
  return told({seen(d), half * volume, {seen(of_b[0]), seen(of_b[1]), seen(of_b[2])}, k},
              {error<FaceOfA> * a2 * all, error<FaceOfB> * (a4 * a2) * (largest_b * largest_b) * all,
               error<EdgePair> * a4 * largest_b * all});
}

[[maybe_unused]] std::optional<Relation> relation(const Aabb3& a, const Obb3& b) {
  const Three min = loaded(a.min), max = loaded(a.max), center = loaded(b.center), half = size(loaded(b.half));
  const std::array of_b{loaded(b.axes[0]), loaded(b.axes[1]), loaded(b.axes[2])};
  const Three from_min = center - min, from_max = center - max, widths = max - min, k = half + half;
  const double largest_d = at_least(largest(larger(larger(size(from_min), size(from_max)), size(widths))), least);
  const double largest_b = at_least(largest(larger(larger(size(of_b[0]), size(of_b[1])), size(of_b[2]))), least);
  const double all = largest_d + total(of_all(largest_b) * k);
  if (!(all < most && largest_b < most)) return {};
  return told({from_min + from_max, widths, of_b, k},
              {error<FaceOfBox> * all, error<FaceBesideBox> * (largest_b * largest_b) * all,
               error<EdgeOfBox> * largest_b * all});
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
