// The statement over pairs of doubles: the face is that of the nearest points, and these are there.
#include <algorithm>
#include <bit>

#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "query/body/vectors.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/separation/edge_sums.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query {
namespace {

/// The number is as sure as the less sure of the two, so that the bound is one constant whichever way was taken.
template <class T>
[[gnu::always_inline]] inline T as_wide_as(const T& x, const T& other) {
  return {x.high, x.low, x.magnitude, T::larger(x.error, other.error), T::larger(x.width, other.width)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> as_wide_as(const Vec3<T>& v, const Vec3<T>& other) {
  return {as_wide_as(v.x, other.x), as_wide_as(v.y, other.y), as_wide_as(v.z, other.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> times(const Vec3<T>& v, double t) {
  return {v.x * t, v.y * t, v.z * t};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> over(const Vec3<T>& v, const T& whole) {
  return {quotient(v.x, whole), quotient(v.y, whole), quotient(v.z, whole)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> opposite(const Vec3<T>& v) {
  return {-v.x, -v.y, -v.z};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> difference(const Vector3& to, const Vector3& from) {
  return {T::difference(to.x, from.x), T::difference(to.y, from.y), T::difference(to.z, from.z)};
}
/// Or the other way.
template <class T>
[[gnu::always_inline]] inline Vec3<T> edge_at_rest(const EdgeSum::Edge& e, double side) {
  const Vec3<T> way = difference<T>(e.to, e.from);
  return {way.x * (e.axis.x * side), way.y * (e.axis.y * side), way.z * (e.axis.z * side)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> renewed(const Vec3<T>& v, double error) {
  return {v.x.renewed(error), v.y.renewed(error), v.z.renewed(error)};
}

/// A pose of other numbers than doubles; the translation is times the weight.
template <class T>
struct PoseNumbersOver {
  std::array<Vec3<T>, 3> columns;
  Vec3<T> translation;
  T weight;

  [[gnu::always_inline]] explicit PoseNumbersOver(const WeightedPose<T>& p)
      : columns{renewed(p.columns[0], error), renewed(p.columns[1], error), renewed(p.columns[2], error)},
        translation(renewed(p.translation, error)),
        weight(p.weight.renewed(error)) {}

 private:
  static constexpr double error = 0x1p10;  // a guess, of a few links; whatever it is, the bound holds
};
template <class T>
[[gnu::always_inline]] inline WeightedPose<T> pose_over(const EdgeSum& s) {
  if (s.form == PoseForm::other) return weighted_pose<T>(s.pose);
  WeightedPose<T> p;
  const auto& c = s.columns;
  p.columns = {vector_of<T>(c[0]), vector_of<T>(c[1]), vector_of<T>(c[2])};
  p.weight = T(s.weight), p.translation = vector_of<T>(s.at) * p.weight;
  return p;
}

/// A body as its pose has it.
template <class T, PoseForm form>
struct PlacedSum {
  const EdgeSum& s;

  [[gnu::always_inline]] explicit PlacedSum(const EdgeSum& of) : s(of) {}
  /// Times the weight.
  [[gnu::always_inline]] Vec3<T> turned(const Vec3<T>& v) const {
    if constexpr (form == PoseForm::none) {
      return v;
    } else {
      const auto& c = s.columns;
      return {v.x * c[0].x + v.y * c[1].x + v.z * c[2].x, v.x * c[0].y + v.y * c[1].y + v.z * c[2].y,
              v.x * c[0].z + v.y * c[1].z + v.z * c[2].z};
    }
  }
  /// Twice the middle times the weight, but for the translation, which is taken from that of the other first.
  [[gnu::always_inline]] Vec3<T> middle(const Vec3<T>& v) const { return turned(v); }
  [[gnu::always_inline]] Vec3<T> by_weight(const Vec3<T>& v) const {
    return form == PoseForm::none ? v : times(v, s.weight);
  }
  [[gnu::always_inline]] Vec3<Approximate> turned_back(const Vec3<Approximate>& v) const {
    if constexpr (form == PoseForm::none) {
      return v;
    } else {
      using N = Approximate;
      const auto back = [&](const Vector3& c) { return v.x * N(c.x) + v.y * N(c.y) + v.z * N(c.z); };
      return {back(s.columns[0]), back(s.columns[1]), back(s.columns[2])};
    }
  }
  /// Of what is as `middle` is.
  [[gnu::always_inline]] Vec3<T> without_weight(const Vec3<T>& v) const {
    return form == PoseForm::none ? times(v, 0.5) : over(v, T(2 * s.weight));
  }
  [[gnu::always_inline]] Vec3<T> from_own_place(const Vec3<T>& v) const {
    return {s.at.x + v.x, s.at.y + v.y, s.at.z + v.z};
  }
  [[gnu::always_inline]] static T twice_weights(const PlacedSum& a, const PlacedSum& b) {
    return form == PoseForm::none ? T(2.0) : T(2 * a.s.weight) * b.s.weight;
  }
  /// Twice from b to a, times both weights.
  [[gnu::always_inline]] static Vec3<T> between(const PlacedSum& a, const PlacedSum& b, const Vec3<T>& on_a,
                                                const Vec3<T>& on_b) {
    return (b.by_weight(on_a) - a.by_weight(on_b)) + difference<T>(a.s.at, b.s.at) * twice_weights(a, b);
  }
};
template <class T>
struct PlacedSum<T, PoseForm::other> {
  const EdgeSum& s;
  PoseNumbersOver<T> by;

  [[gnu::always_inline]] explicit PlacedSum(const EdgeSum& of) : s(of), by(pose_over<T>(of)) {}
  [[gnu::always_inline]] Vec3<T> turned(const Vec3<T>& v) const {
    return by.columns[0] * v.x + by.columns[1] * v.y + by.columns[2] * v.z;
  }
  [[gnu::always_inline]] Vec3<T> middle(const Vec3<T>& v) const { return turned(v) + times(by.translation, 2.0); }
  [[gnu::always_inline]] Vec3<T> by_weight(const Vec3<T>& v) const { return v * by.weight; }
  [[gnu::always_inline]] Vec3<Approximate> turned_back(const Vec3<Approximate>& v) const {
    const auto back = [&](const Vec3<T>& c) { return v.x * c.x.plain() + v.y * c.y.plain() + v.z * c.z.plain(); };
    return {back(by.columns[0]), back(by.columns[1]), back(by.columns[2])};
  }
  [[gnu::always_inline]] Vec3<T> without_weight(const Vec3<T>& v) const { return over(v, by.weight * 2.0); }
  [[gnu::always_inline]] Vec3<T> from_own_place(const Vec3<T>& v) const { return v; }
  [[gnu::always_inline]] static T twice_weights(const PlacedSum& a, const PlacedSum& b) {
    return a.by.weight * b.by.weight * 2.0;
  }
  [[gnu::always_inline]] static Vec3<T> between(const PlacedSum& a, const PlacedSum& b, const Vec3<T>& on_a,
                                                const Vec3<T>& on_b) {
    constexpr double error = 0x1p30;  // a guess: how far from the origin, seen from one another
    return renewed(b.by_weight(on_a) - a.by_weight(on_b), error);
  }
};

/// The middle of the face.
template <class T, class Placed>
[[gnu::always_inline]] inline Vec3<T> middle_of(const Placed& placed, std::uint32_t along, std::uint32_t upper) {
  const EdgeSum& s = placed.s;
  Vec3<T> middle = difference<T>(s.to, s.from);
  const Vec3<T> any = times(difference<T>({0, 0, 0}, {0, 0, 0}), 0);
  const auto add = [&](std::uint32_t k) __attribute__((always_inline)) {
    if (k < s.size && (along >> k & 1) == 0) {
      middle = middle + edge_at_rest<T>(s.edges[k], (upper >> k & 1) != 0 ? 1 : -1);
    } else {
      middle = as_wide_as(middle, middle + any);
    }
  };
  add(0), add(1), add(2);
  return placed.middle(middle);
}

/// Do all edges at an end lead strictly away from there, the body being ahead along `way` or behind?
template <class Placed>
[[gnu::always_inline]] inline bool is_least(const Placed& placed, std::uint32_t along, std::uint32_t upper,
                                            const Vec3<Approximate>& way, int ahead) {
  using N = Approximate;
  const EdgeSum& s = placed.s;
  const Vec3<N> n = placed.turned_back(way);
  bool is_so = true;
  for (std::uint32_t k = 0; k < s.size; ++k) {
    if ((along >> k & 1) != 0) continue;
    const auto& [axis, from, to, number] = s.edges[k];
    const N slope = n.x * (N::difference(to.x, from.x) * N(axis.x)) + n.y * (N::difference(to.y, from.y) * N(axis.y)) +
                    n.z * (N::difference(to.z, from.z) * N(axis.z));
    is_so = is_so && slope.certain_sign() == ((upper >> k & 1) != 0 ? -ahead : ahead);
  }
  return is_so;
}

/// One edge of the face.
struct FreeEdge {
  const EdgeSum::Edge* edge;
  bool is_of_a;
};

template <class T>
[[gnu::always_inline]] inline std::optional<Point3> rounded(const Vec3<T>& v) {
  const auto x = v.x.nearest(), y = v.y.nearest(), z = v.z.nearest();
  if (!x || !y || !z) return {};
  return told(Point3{*x, *y, *z});
}

/// Where the face is nearest to the origin, in units of `scale`: twice the weights of both.
template <class T>
struct OnFace {
  T apart;                // the distance
  Vec3<T> x;              // from b to a, or a multiple
  T length;               // of x
  std::array<T, 2> part;  // of the free edges, between -1 and 1
};
template <class T>
[[gnu::always_inline]] inline OnFace<T> on_vertex(const Vec3<T>& middle) {
  const T apart = root(dot(middle, middle)), none(0.0);
  return {apart, middle, apart, {none, none}};
}
template <class T>
[[gnu::always_inline]] inline OnFace<T> on_edge(const Vec3<T>& middle, const Vec3<T>& u) {
  const T whole = dot(u, u), part = quotient(-dot(middle, u), whole);
  const Vec3<T> turn = cross(middle, u);
  const T apart = root(quotient(dot(turn, turn), whole));
  return {apart, middle + u * part, apart, {part, T(0.0)}};
}
template <class T>
[[gnu::always_inline]] inline OnFace<T> on_plane(const Vec3<T>& middle, const Vec3<T>& u, const Vec3<T>& v) {
  const Vec3<T> normal = cross(u, v);
  const T whole = dot(normal, normal), height = dot(normal, middle), length = root(whole);
  const bool is_back = certain_sign(height) < 0;
  return {quotient(is_back ? -height : height, length),
          is_back ? opposite(normal) : normal,
          length,
          {quotient(-dot(cross(middle, v), normal), whole), quotient(-dot(cross(u, middle), normal), whole)}};
}

template <class T, PoseForm form>
[[gnu::always_inline]] inline std::optional<SumNumbers> numbers_on(const EdgeSum& sum_a, const EdgeSum& sum_b,
                                                                   const EdgeFace& face, bool points) {
  std::array<FreeEdge, 2> free{};
  std::size_t count = 0;
  const auto take = [&](const EdgeSum& s, std::uint32_t along, bool is_of_a) {
    for (std::uint32_t k = 0; k < s.size; ++k) {
      if ((along >> k & 1) != 0) free[count++] = {&s.edges[k], is_of_a};
    }
  };
  if (std::popcount(face.along[0]) + std::popcount(face.along[1]) > 2) return {};
  take(sum_a, face.along[0], true), take(sum_b, face.along[1], false);

  using Placed = PlacedSum<T, form>;
  const Placed a(sum_a), b(sum_b);
  Vec3<T> on_a = middle_of<T>(a, face.along[0], face.upper[0]);
  Vec3<T> on_b = middle_of<T>(b, face.along[1], face.upper[1]);
  const Vec3<T> between = Placed::between(a, b, on_a, on_b);
  std::array<Vec3<T>, 2> own{between, between};  // times the weight of its body alone
  const auto whole_edge = [&](std::size_t k) __attribute__((always_inline)) {
    const bool is_of_a = free[k].is_of_a;
    own[k] = (is_of_a ? a : b).turned(edge_at_rest<T>(*free[k].edge, is_of_a ? 1 : -1));
    return (is_of_a ? b : a).by_weight(own[k]);
  };
  std::optional<OnFace<T>> found;
  if (count == 0) {
    found = on_vertex(between);
  } else if (count == 1) {
    found = on_edge(between, whole_edge(0));
  } else {
    const Vec3<T> u = whole_edge(0), v = whole_edge(1);
    found = on_plane(between, u, v);
  }
  const auto& [apart, x, length, part] = *found;
  for (std::size_t k = 0; k < count; ++k) {
    if (certain_sign(1.0 + part[k]) <= 0 || certain_sign(1.0 + -part[k]) <= 0) return {};
  }
  const T distance = form == PoseForm::none ? apart * 0.5 : quotient(apart, Placed::twice_weights(a, b));
  const T left = distance - (T(sum_a.radius) + T(sum_b.radius));
  const int side = certain_sign(left);
  if (certain_sign(distance) <= 0 || side == 0 || (points && side < 0)) return {};
  const Vec3<Approximate> ahead{x.x.plain(), x.y.plain(), x.z.plain()};
  if (!is_least(a, face.along[0], face.upper[0], ahead, 1)) return {};
  if (!is_least(b, face.along[1], face.upper[1], ahead, -1)) return {};
  if (side < 0) return SumNumbers{};
  const auto d = left.nearest();
  if (!d) return {};
  if (!points) return SumNumbers{*d};

  for (std::size_t k = 0; k < count; ++k) {
    const Vec3<T> off = own[k] * part[k];
    if (free[k].is_of_a) on_a = on_a + off;
    if (!free[k].is_of_a) on_b = on_b - off;
  }
  std::array<Point3, 2> told_at;
  for (const bool is_a : {true, false}) {
    const Placed& placed = is_a ? a : b;
    const double radius = placed.s.radius;
    Vec3<T> p = placed.without_weight(is_a ? on_a : on_b);
    if (radius != 0) p = p + x * quotient(T(is_a ? -radius : radius), length);
    const auto at = rounded(placed.from_own_place(p));
    if (!at) return {};
    told_at[is_a ? 0 : 1] = *at;
  }
  return SumNumbers{*d, told_at[0], told_at[1]};
}

template <class T>
[[gnu::always_inline]] inline std::optional<SumNumbers> numbers_under(const EdgeSum& a, const EdgeSum& b,
                                                                      const EdgeFace& face, bool points) {
  const PoseForm form = std::max(a.form, b.form);
  return form == PoseForm::none ? numbers_on<T, PoseForm::none>(a, b, face, points)
                                : numbers_on<T, PoseForm::doubles>(a, b, face, points);
}
PLUMB_WITH_FMA std::optional<SumNumbers> numbers_fused(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                       bool points) {
  return numbers_under<Twofold<true>>(a, b, face, points);
}
PLUMB_WITHOUT std::optional<SumNumbers> numbers_plain(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                      bool points) {
  return numbers_under<Twofold<false>>(a, b, face, points);
}
PLUMB_WITH_FMA std::optional<SumNumbers> other_numbers_fused(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                             bool points) {
  return numbers_on<Twofold<true>, PoseForm::other>(a, b, face, points);
}
PLUMB_WITHOUT std::optional<SumNumbers> other_numbers_plain(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                            bool points) {
  return numbers_on<Twofold<false>, PoseForm::other>(a, b, face, points);
}

/// The numbers that the edges have in the figure: those without a length are at no end.
Feature feature_on(const FigureView& figure, const EdgeSum& s, std::uint32_t along, std::uint32_t upper) {
  std::uint32_t corner = 0, ways = 0;
  for (std::uint32_t k = 0; k < s.size; ++k) {
    if ((along >> k & 1) != 0) ways |= 1U << s.edges[k].number;
    if ((upper >> k & 1) != 0) corner |= 1U << s.edges[k].number;
  }
  return feature_of_sum(figure, s.all, corner, ways);
}

}  // namespace

std::optional<SumNumbers> nearest_on(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face, bool points) {
  if (a.form == PoseForm::other || b.form == PoseForm::other)
    return has_fma ? other_numbers_fused(a, b, face, points) : other_numbers_plain(a, b, face, points);
  return has_fma ? numbers_fused(a, b, face, points) : numbers_plain(a, b, face, points);
}

namespace {

/// Two sums, and what is nearest of them.
struct NearSums {
  EdgeSum a, b;
  EdgeFace face;

  std::optional<SumNumbers> set(const PosedView& of_a, const PosedView& of_b, bool points) {
    if (!a.set(of_a) || !b.set(of_b)) return {};
    const auto guess = guessed_face(a, b);
    if (!guess) return {};
    face = *guess;
    return nearest_on(a, b, face, points);
  }
};

}  // namespace

std::optional<Closest> closest_of_sums(const PosedView& a, const PosedView& b) {
  NearSums sums;
  const auto n = sums.set(a, b, true);
  if (!n) return {};
  const auto& [along, upper] = sums.face;
  return Closest{n->on_a, n->on_b, n->distance, feature_on(a.figure, sums.a, along[0], upper[0]),
                 feature_on(b.figure, sums.b, along[1], upper[1])};
}

std::optional<double> distance_of_sums(const PosedView& a, const PosedView& b) {
  NearSums sums;
  const auto n = sums.set(a, b, false);
  return n ? std::optional(n->distance) : std::nullopt;
}

}  // namespace plumb::query
