#include <array>
#include <cmath>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb::query::quick {
namespace {

using T = Approximate;

/// normal . x - offset, of each vertex.
template <class T>
struct Heights {
  Vec3<T> normal;
  T offset;

  [[gnu::always_inline]] T operator()(const Point3& p) const { return dot(normal, vector_of<T>(p)) - offset; }
  [[gnu::always_inline]] std::array<T, 1> of(const Point3& p) const { return {(*this)(p)}; }
  [[gnu::always_inline]] std::array<T, 2> of(const Segment3& s) const { return {(*this)(s.a), (*this)(s.b)}; }
  [[gnu::always_inline]] std::array<T, 3> of(const Triangle3& t) const {
    return {(*this)(t.a), (*this)(t.b), (*this)(t.c)};
  }
  [[gnu::always_inline]] std::array<T, 1> of(const Sphere3& s) const { return {(*this)(s.center)}; }
  [[gnu::always_inline]] std::array<T, 2> of(const Capsule3& c) const { return {(*this)(c.a), (*this)(c.b)}; }
  [[gnu::always_inline]] std::array<T, 8> of(const Aabb3& b) const {
    const T x0 = normal.x * T(b.min.x), y0 = normal.y * T(b.min.y), z0 = normal.z * T(b.min.z) - offset;
    const T x1 = normal.x * T(b.max.x), y1 = normal.y * T(b.max.y), z1 = normal.z * T(b.max.z) - offset;
    const T a = x0 + y0, d = x1 + y0, e = x0 + y1, f = x1 + y1;
    return {a + z0, d + z0, e + z0, f + z0, a + z1, d + z1, e + z1, f + z1};
  }
  [[gnu::always_inline]] std::array<T, 8> of(const Obb3& b) const {
    const T middle = (*this)(b.center), u = dot(normal, vector_of<T>(b.axes[0])) * T(std::fabs(b.half.x)),
            v = dot(normal, vector_of<T>(b.axes[1])) * T(std::fabs(b.half.y)),
            w = dot(normal, vector_of<T>(b.axes[2])) * T(std::fabs(b.half.z));
    const T low = middle - w, high = middle + w, a = low - v, c = low + v, d = high - v, e = high + v;
    return {a - u, a + u, c - u, c + u, d - u, d + u, e - u, e + u};
  }
};

}  // namespace

template <ContactWanted asked, Small Shape>
Answer contact(const Translating<Shape>& a, const Translating<Plane3>& b) {
  constexpr bool swept = Round<Shape>;
  const double reach = reach_of(a.shape);
  const Heights<T> height{vector_of<T>(b.shape.normal), T(b.shape.offset)};
  const auto heights = height.of(a.shape);
  const T speed = dot(height.normal, velocity<T>(a.by, b.by));
  const T limit = swept ? T(reach) * T(reach) * dot(height.normal, height.normal) : T(0.0);
  // 1 or -1: on that side and beyond reach; 2: within reach; 0: who knows.
  const auto side = [&](const T& x) {
    const int s = certain_sign(x);
    if constexpr (swept) {
      const int beyond = certain_sign(x * x - limit);
      return beyond < 0 ? 2 : beyond > 0 ? s : 0;
    }
    return s;
  };
  const int at_start = side(heights[0]);
  bool apart = at_start == 1 || at_start == -1, meets = false, doubt = at_start == 0, starts = at_start == 2;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const int from = side(heights[i]), to = side(heights[i] + speed);
    starts |= from == 2 || from * at_start == -1;
    doubt |= from == 0;
    apart &= from == at_start && to == at_start;
    meets |= to == 2 || to * at_start == -1;
  }
  if (starts) return overlap;
  if (apart) return no;
  if (doubt || !meets) return unsure;
  if constexpr (asked == ContactWanted::whether) return {MotionVerdict::yes};
  std::size_t first = 0;
  const double way = at_start;
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if (way * heights[i].value < way * heights[first].value) first = i;
  }
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (i != first && certain_sign(heights[i] - heights[first]) != at_start) return unsure;
  }
  const Heights<Pairs> precise{vector_of<Pairs>(b.shape.normal), Pairs(b.shape.offset)};
  Pairs gap = precise.of(a.shape)[first] * Pairs(way);
  if (swept && reach > 0) gap = gap - Pairs(reach) * root(dot(precise.normal, precise.normal));
  const Pairs closing = dot(precise.normal, velocity<Pairs>(a.by, b.by)) * Pairs(-way);
  const Feature of_a{is_ball<Shape> ? FeatureKind::face : FeatureKind::vertex, static_cast<std::uint32_t>(first)};
  return at(quotient(gap, closing), of_a, {FeatureKind::face, 0});
}
PLUMB_QUICK_PAIR(Point3, Plane3)
PLUMB_QUICK_PAIR(Segment3, Plane3)
PLUMB_QUICK_PAIR(Triangle3, Plane3)
PLUMB_QUICK_PAIR(Aabb3, Plane3)
PLUMB_QUICK_PAIR(Obb3, Plane3)
PLUMB_QUICK_PAIR(Sphere3, Plane3)
PLUMB_QUICK_PAIR(Capsule3, Plane3)

}  // namespace plumb::query::quick
