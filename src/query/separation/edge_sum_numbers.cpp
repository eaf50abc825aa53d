// The statement over pairs of doubles: the face is that of the nearest points, and these are there.
#include "arith/twofold.hpp"
#include "certify/fused.hpp"
#include "query/body/vectors.hpp"
#include "query/separation/edge_sums.hpp"
#include "query/separation/quick.hpp"

namespace plumb::query {
namespace {

/// Of which the bound of the error is that of either, so that it is one constant whichever way was taken.
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
/// Times the weight.
template <class T, bool posed>
[[gnu::always_inline]] inline Vec3<T> turned(const EdgeSum& s, const Vec3<T>& v) {
  if constexpr (!posed) {
    return v;
  } else {
    const auto& c = s.columns;
    return {v.x * c[0].x + v.y * c[1].x + v.z * c[2].x, v.x * c[0].y + v.y * c[1].y + v.z * c[2].y,
            v.x * c[0].z + v.y * c[1].z + v.z * c[2].z};
  }
}

/// The middle of the face.
template <class T, bool posed>
[[gnu::always_inline]] inline Vec3<T> middle_of(const EdgeSum& s, std::uint32_t along, std::uint32_t upper) {
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
  return turned<T, posed>(s, middle);
}

/// Do all edges at an end lead strictly away from there, the body being ahead along `way` or behind?
template <bool posed>
[[gnu::always_inline]] inline bool is_least(const EdgeSum& s, std::uint32_t along, std::uint32_t upper,
                                            const Vec3<Approximate>& way, int ahead) {
  using N = Approximate;
  Vec3<N> n = way;
  if constexpr (posed) {
    const auto& c = s.columns;
    const auto back = [&](const Vector3& v) { return way.x * N(v.x) + way.y * N(v.y) + way.z * N(v.z); };
    n = {back(c[0]), back(c[1]), back(c[2])};
  }
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

struct SumNumbers {
  double distance = 0;
  Point3 on_a{}, on_b{};
};

/// One edge of the face.
struct FreeEdge {
  const EdgeSum* of;
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

template <class T, bool posed>
[[gnu::always_inline]] inline std::optional<SumNumbers> numbers_on(const EdgeSum& a, const EdgeSum& b,
                                                                   const EdgeFace& face, bool points) {
  std::array<FreeEdge, 2> free{};
  std::size_t count = 0;
  const auto take = [&](const EdgeSum& s, std::uint32_t along, bool is_of_a) {
    for (std::uint32_t k = 0; k < s.size; ++k) {
      if ((along >> k & 1) != 0) free[count++] = {&s, &s.edges[k], is_of_a};
    }
  };
  take(a, face.along[0], true), take(b, face.along[1], false);

  Vec3<T> on_a = middle_of<T, posed>(a, face.along[0], face.upper[0]);
  Vec3<T> on_b = middle_of<T, posed>(b, face.along[1], face.upper[1]);
  Vec3<T> between = difference<T>(a.at, b.at);
  const T scale = posed ? T(2 * a.weight) * b.weight : T(2.0);
  if constexpr (posed) {
    between = (times(on_a, b.weight) - times(on_b, a.weight)) + between * scale;
  } else {
    between = (on_a - on_b) + times(between, 2.0);
  }
  std::array<Vec3<T>, 2> own{between, between};  // times the weight of its body alone
  const auto whole_edge = [&](std::size_t k) __attribute__((always_inline)) {
    const FreeEdge& e = free[k];
    own[k] = turned<T, posed>(*e.of, edge_at_rest<T>(*e.edge, e.is_of_a ? 1 : -1));
    return posed ? times(own[k], e.is_of_a ? b.weight : a.weight) : own[k];
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
  const T distance = posed ? quotient(apart, scale) : apart * 0.5, left = distance - (T(a.radius) + T(b.radius));
  const int side = certain_sign(left);
  if (certain_sign(distance) <= 0 || side == 0 || (points && side < 0)) return {};
  const Vec3<Approximate> ahead{x.x.plain(), x.y.plain(), x.z.plain()};
  if (!is_least<posed>(a, face.along[0], face.upper[0], ahead, 1)) return {};
  if (!is_least<posed>(b, face.along[1], face.upper[1], ahead, -1)) return {};
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
    const EdgeSum& s = is_a ? a : b;
    Vec3<T> p = is_a ? on_a : on_b;
    p = posed ? over(p, T(2 * s.weight)) : times(p, 0.5);
    if (s.radius != 0) p = p + x * quotient(T(is_a ? -s.radius : s.radius), length);
    const auto at = rounded(Vec3<T>{s.at.x + p.x, s.at.y + p.y, s.at.z + p.z});
    if (!at) return {};
    told_at[is_a ? 0 : 1] = *at;
  }
  return SumNumbers{*d, told_at[0], told_at[1]};
}

template <class T>
[[gnu::always_inline]] inline std::optional<SumNumbers> numbers_under(const EdgeSum& a, const EdgeSum& b,
                                                                      const EdgeFace& face, bool points) {
  const bool stand = !a.is_turned && !b.is_turned;
  return stand ? numbers_on<T, false>(a, b, face, points) : numbers_on<T, true>(a, b, face, points);
}
PLUMB_WITH_FMA std::optional<SumNumbers> numbers_fused(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                       bool points) {
  return numbers_under<Twofold<true>>(a, b, face, points);
}
PLUMB_WITHOUT std::optional<SumNumbers> numbers_plain(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face,
                                                      bool points) {
  return numbers_under<Twofold<false>>(a, b, face, points);
}
std::optional<SumNumbers> numbers_of(const EdgeSum& a, const EdgeSum& b, const EdgeFace& face, bool points) {
  return has_fma ? numbers_fused(a, b, face, points) : numbers_plain(a, b, face, points);
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

std::optional<Closest> closest_of_sums(const PosedView& a, const PosedView& b) {
  EdgeSum p, q;
  if (!p.set(a) || !q.set(b)) return {};
  const auto face = guessed_face(p, q);
  if (!face) return {};
  const auto n = numbers_of(p, q, *face, true);
  if (!n) return {};
  return Closest{n->on_a, n->on_b, n->distance, feature_on(a.figure, p, face->along[0], face->upper[0]),
                 feature_on(b.figure, q, face->along[1], face->upper[1])};
}

std::optional<double> distance_of_sums(const PosedView& a, const PosedView& b) {
  EdgeSum p, q;
  if (!p.set(a) || !q.set(b)) return {};
  const auto face = guessed_face(p, q);
  if (!face) return {};
  const auto n = numbers_of(p, q, *face, false);
  if (!n) return {};
  return n->distance;
}

}  // namespace plumb::query
