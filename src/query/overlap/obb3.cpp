// An oriented box against what is straight, triangles and axis-aligned boxes.
//
// The matrix of the box's cofactors (rows N_i, its face normals) maps it to an axis-aligned box, |t_i| <= H_i, and the
// other shape to one of its kind; a linear map that is one to one keeps the relation.  There the axes that can separate
// are those of the box, the normal of a triangle, and cross products of an edge with an axis, of two terms each.
// Over doubles with bounds of their errors first (query/overlap/box_quick.hpp, figure/obb/quick.hpp), then with the errors of
// each carried along, then over pairs of doubles, then over integers (docs/overlap.md).
// Source: RTCD 5.2.1, 5.2.9, 5.3.3, 4.4.1.
#include <optional>

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "figure/minkowski/zonotope.hpp"
#include "figure/obb/quick.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/query/overlap/box.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/vectors.hpp"
#include "query/convex/flat_set.hpp"
#include "query/overlap/box_quick.hpp"
#include "query/overlap/shapes3.hpp"
#include "query/overlap/signs.hpp"

namespace plumb {
namespace query {
namespace {

std::optional<Sign> sign(const Approximate& x) {
  CertainSigns ask;
  const Sign s = ask(x);
  return ask.certain() ? std::optional(s) : std::nullopt;
}
std::optional<Sign> sign(const Ball& x) {
  CertainSigns ask;
  const Sign s = ask(x);
  return ask.certain() ? std::optional(s) : std::nullopt;
}
std::optional<Sign> sign(const BigDyadic& x) { return x.sign(); }

// The errors stay.
Approximate larger(const Approximate& a, const Approximate& b) {
  return {std::max(a.value, b.value), a.magnitude + b.magnitude, std::max(a.error, b.error)};  // a sum keeps a NaN
}
Ball larger(const Ball& a, const Ball& b) {
  const bool first = a.high > b.high || (a.high == b.high && a.low > b.low);
  return {first ? a.high : b.high, first ? a.low : b.low, a.radius + b.radius};
}
BigDyadic larger(const BigDyadic& a, const BigDyadic& b) { return (a - b).sign() == Sign::negative ? b : a; }

template <class T>
T negated(const T& x) {
  return T(0.0) - x;
}

// The gaps along all axes: the least answer, unless one that matters is not certain.
template <class T>
class Gaps {
 public:
  /// Where positive, the shapes are apart; where zero they touch, unless the axis is the zero vector.
  template <class... Parts>
  void add(const T& gap, const Parts&... axis) {
    const std::optional<Sign> s = sign(gap);
    if (!s) {
      certain_ = false;
    } else if (*s == Sign::positive) {
      apart_ = true;
    } else if (*s == Sign::zero && !is_zero_vector(axis...)) {
      level_ = true;
    }
  }
  /// A gap of which it is not known whether it is one: it must be below zero.
  void add_doubtful(const T& gap) { certain_ = certain_ && sign(gap) == Sign::negative; }

  [[nodiscard]] bool apart() const { return apart_; }
  [[nodiscard]] std::optional<Relation> relation() const {
    if (apart_) return Relation::disjoint;
    if (!certain_) return {};
    return level_ ? Relation::touching : Relation::overlapping;
  }

 private:
  template <class... Parts>
  bool is_zero_vector(const Parts&... axis) {
    [[maybe_unused]] const auto is_zero = [&](const T& x) {
      const std::optional<Sign> s = sign(x);
      if (!s) certain_ = false;
      return s == Sign::zero;
    };
    return sizeof...(Parts) > 0 && (is_zero(axis) && ...);
  }

  bool apart_ = false, level_ = false, certain_ = true;
};

// The box |x| <= half in a frame of its own, and what reaches along a normal of two or three numbers.
template <class T>
struct Frame {
  Vec3<T> half;

  [[nodiscard]] const T& half_of(std::size_t k) const { return k == 0 ? half.x : k == 1 ? half.y : half.z; }
};
template <class T>
const T& part(const Vec3<T>& v, std::size_t k) {
  return k == 0 ? v.x : k == 1 ? v.y : v.z;
}

// Along the cross product of axis k and the edge e, of a point on that edge's line: the offset there, and the reach.
template <class T>
struct Across {
  const T &j, &k;  // the two numbers of the edge
  std::size_t at_j, at_k;

  Across(const Vec3<T>& e, std::size_t axis)
      : j(part(e, (axis + 1) % 3)), k(part(e, (axis + 2) % 3)), at_j((axis + 1) % 3), at_k((axis + 2) % 3) {}
  [[nodiscard]] T of(const Vec3<T>& p) const { return j * part(p, at_k) - k * part(p, at_j); }
  [[nodiscard]] T reach(const Frame<T>& box) const {
    return magnitude(j) * box.half_of(at_k) + magnitude(k) * box.half_of(at_j);
  }
};

template <class T>
struct Straight {
  LinearKind reach;
  Vec3<T> p, d;  // of a segment the end is p + d
  bool is_point;
};

template <class T>
void along_axes(Gaps<T>& gaps, const Frame<T>& box, const Straight<T>& s) {
  if (s.reach == LinearKind::line && !s.is_point) return;
  for (std::size_t k = 0; k < 3; ++k) {
    const T &p = part(s.p, k), &d = part(s.d, k), &h = box.half_of(k);
    if (s.is_point) {
      gaps.add(magnitude(p) - h);
    } else if (s.reach == LinearKind::segment) {
      const T q = p + d;
      gaps.add(negated(larger(p, q)) - h);
      gaps.add(negated(larger(negated(p), negated(q))) - h);
    } else {
      const std::optional<Sign> ahead = sign(d);
      const auto add = [&](const T& gap, Sign leaves) {
        if (!ahead) {
          gaps.add_doubtful(gap);
        } else if (*ahead * leaves != Sign::negative) {
          gaps.add(gap);
        }
      };
      add(p - h, Sign::positive);
      add(negated(p) - h, Sign::negative);
    }
  }
}

template <class T>
std::optional<Relation> relate_in_frame(const Frame<T>& box, const Straight<T>& s) {
  Gaps<T> gaps;
  along_axes(gaps, box, s);
  for (std::size_t k = 0; k < 3 && !s.is_point && !gaps.apart(); ++k) {
    const Across<T> axis(s.d, k);
    gaps.add(magnitude(axis.of(s.p)) - axis.reach(box), axis.j, axis.k);
  }
  return gaps.relation();
}

// Of a triangle: its corners, and the edges from each to the next.
template <class T>
using AxesOf = std::array<Vec3<T>, 3>;

template <class T>
std::optional<Relation> relate_in_frame(const Frame<T>& box, const AxesOf<T>& p, const AxesOf<T>& edges) {
  Gaps<T> gaps;
  for (std::size_t k = 0; k < 3; ++k) {
    const T &a = part(p[0], k), &b = part(p[1], k), &c = part(p[2], k), &h = box.half_of(k);
    gaps.add(negated(larger(larger(a, b), c)) - h);
    gaps.add(negated(larger(larger(negated(a), negated(b)), negated(c))) - h);
  }
  if (gaps.apart()) return Relation::disjoint;
  const Vec3<T> n = cross(edges[0], edges[1]);
  gaps.add(magnitude(dot(n, p[0])) -
               (magnitude(n.x) * box.half.x + magnitude(n.y) * box.half.y + magnitude(n.z) * box.half.z),
           n.x, n.y, n.z);
  for (std::size_t i = 0; i < 3 && !gaps.apart(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Across<T> axis(edges[i], k);
      const T at_edge = axis.of(p[i]), across = axis.of(p[(i + 2) % 3]), reach = axis.reach(box);
      gaps.add(negated(larger(at_edge, across)) - reach, axis.j, axis.k);
      gaps.add(negated(larger(negated(at_edge), negated(across))) - reach, axis.j, axis.k);
    }
  }
  return gaps.relation();
}

// Of an oriented box with independent axes.
template <class T>
class ToFrame {
 public:
  explicit ToFrame(const Obb3& box) : center_(box.center) {
    const auto a0 = vector_of<T>(box.axes[0]), a1 = vector_of<T>(box.axes[1]), a2 = vector_of<T>(box.axes[2]);
    normals_ = {cross(a1, a2), cross(a2, a0), cross(a0, a1)};
    volume_ = magnitude(dot(a0, normals_[0]));
    const auto half = [&](double h) { return volume_ * T(magnitude_of(h)); };
    frame_ = {{half(box.half.x), half(box.half.y), half(box.half.z)}};
  }

  [[nodiscard]] const Frame<T>& box() const { return frame_; }
  [[nodiscard]] std::optional<Sign> volume() const { return sign(volume_); }
  [[nodiscard]] Vec3<T> vector(const Vec3<T>& v) const {
    return {dot(normals_[0], v), dot(normals_[1], v), dot(normals_[2], v)};
  }
  [[nodiscard]] Vec3<T> point(const Point3& p) const { return vector(between<T>(center_, p)); }

  [[nodiscard]] std::optional<Relation> relation(const Triangle3& t) const {
    return relate_in_frame(
        frame_, AxesOf<T>{point(t.a), point(t.b), point(t.c)},
        AxesOf<T>{vector(between<T>(t.a, t.b)), vector(between<T>(t.b, t.c)), vector(between<T>(t.c, t.a))});
  }
  [[nodiscard]] std::optional<Relation> relation(const Linear3& s) const {
    const auto d = s.by_points ? between<T>(s.p, s.q) : vector_of<T>(s.direction());
    return relate_in_frame(frame_, Straight<T>{s.reach, point(s.p), vector(d), s.is_point()});
  }

 private:
  Point3 center_;
  AxesOf<T> normals_{zero, zero, zero};
  T volume_ = T(0.0);
  Frame<T> frame_{zero};
  static inline const Vec3<T> zero{T(0.0), T(0.0), T(0.0)};
};

template <class T, class Shape>
std::optional<Relation> by(const Shape& a, const Obb3& b) {
  const ToFrame<T> frame(b);
  return frame.volume() == Sign::positive ? frame.relation(a) : std::nullopt;
}

bool has_extents(const Obb3& box) { return box.half.x != 0 && box.half.y != 0 && box.half.z != 0; }

template <class Shape>
Relation relate_obb(const Shape& a, const Obb3& b, Asked asked) {
  assert_sound_thread();
  if (const auto r = quick_relation(a, b)) [[likely]]
    return *r;
  require_figures(asked, a, b);
  if constexpr (std::is_same_v<Shape, Triangle3>) {
    if (a.a == a.b || a.c == a.a) return relate_obb(Segment3{a.b, a.c}, b, asked);
    if (a.b == a.c) return relate_obb(Segment3{a.a, a.b}, b, asked);
  }
  const auto figure = [&] {
    if constexpr (requires { linear(a); }) {
      return linear(a);
    } else {
      return a;
    }
  }();
  if (has_extents(b)) {
    if (const auto r = by<Approximate>(figure, b)) return *r;
    if (const auto r = by<Ball>(figure, b)) return *r;
    if (const auto r = by<BigDyadic>(figure, b)) return *r;
  }
  return relate(flat_set(a), flat_set(b));
}

// Twice the distance of the centers, twice the extents.
template <class T>
struct BoxPair {
  Vec3<T> between;
  Frame<T> box;
  AxesOf<T> generators;

  BoxPair(const Aabb3& a, const Obb3& b)
      : between(query::between<T>(a.min, b.center) + query::between<T>(a.max, b.center)),
        box{query::between<T>(a.min, a.max)},
        generators{generator(b.axes[0], b.half.x), generator(b.axes[1], b.half.y), generator(b.axes[2], b.half.z)} {}

  static Vec3<T> generator(const Vector3& axis, double half) {
    const T twice = T(half) * T(2.0);
    return {T(axis.x) * twice, T(axis.y) * twice, T(axis.z) * twice};
  }
};

Relation exactly(const Aabb3& a, const Obb3& b) {
  const BoxPair<BigDyadic> pair(a, b);
  const auto numbers = [](const Vec3<BigDyadic>& v) { return BigVector{v.x, v.y, v.z}; };
  const BigDyadic zero(0);
  const auto& [x, y, z] = pair.box.half;
  return locate_origin(numbers(pair.between), std::array{BigVector{x, zero, zero}, BigVector{zero, y, zero},
                                                         BigVector{zero, zero, z}, numbers(pair.generators[0]),
                                                         numbers(pair.generators[1]), numbers(pair.generators[2])});
}

}  // namespace
}  // namespace query

using query::relate_obb;

Relation relate(const Line3& a, const Obb3& b, Asked asked) { return relate_obb(a, b, asked); }
Relation relate(const Ray3& a, const Obb3& b, Asked asked) { return relate_obb(a, b, asked); }
Relation relate(const Segment3& a, const Obb3& b, Asked asked) { return relate_obb(a, b, asked); }
Relation relate(const Triangle3& a, const Obb3& b, Asked asked) { return relate_obb(a, b, asked); }

Relation relate(const Aabb3& a, const Obb3& b, Asked asked) {
  assert_sound_thread();
  if (const auto r = quick_relation(a, b); r && !is_empty(a)) [[likely]]
    return *r;
  query::require_figures(asked, a, b);
  if (is_empty(a)) return Relation::disjoint;
  if (const auto r = near_relation(a, b)) return *r;
  return query::exactly(a, b);
}

}  // namespace plumb
