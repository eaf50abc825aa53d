#include "query/penetration/quick_axis.hpp"

#include "arith/sparse_vec.hpp"
#include "certify/fused.hpp"

namespace plumb::query::parting {
namespace {

using arith::sparse_cross, arith::sparse_dot, arith::sparse_product;

/// Of length 1 where it is along an axis of space by zeros: what is along such a one has no error of its own.
template <class T>
Vec<T> shortened(const Vec<T>& v) {
  const auto is = [](const T& x) { return certainly_zero(x); };
  const auto unit = [&](const T& x) { return is(x) ? T(0.0) : T(static_cast<double>(certain_sign(x))); };
  const int zeros = static_cast<int>(is(v.x)) + static_cast<int>(is(v.y)) + static_cast<int>(is(v.z));
  const bool is_along = zeros == 2 && certain_sign(v.x) + certain_sign(v.y) + certain_sign(v.z) != 0;
  return is_along ? Vec<T>{unit(v.x), unit(v.y), unit(v.z)} : v;
}

/// Along the normal of two groups.
template <class T>
struct Axis {
  Vec<T> normal;
  T square, middle, overlap;

  Axis(const SumParts<T>& parts, std::size_t groups, std::uint32_t p, std::uint32_t q)
      : normal(shortened(sparse_cross(parts.group[p], parts.group[q]))),
        square(sparse_dot(normal, normal)),
        middle(sparse_dot(normal, parts.middle)),
        overlap(T(0.0) - magnitude(middle)) {
    for (std::uint32_t g = 0; g < groups; ++g) {
      if (g != p && g != q) overlap = overlap + magnitude(sparse_dot(normal, parts.group[g]));
    }
  }
};

enum class Asked : unsigned char { overlap, middle, along, order };
/// What is asked of the normals of two groups each; `other`: the second one's number, or a group's.
struct AxisQuestion {
  Asked asked;
  std::uint32_t i;
  std::array<std::uint32_t, 2> of;
  std::uint32_t other = 0;
  std::array<std::uint32_t, 2> of_other{};
};

/// How far sums overlap along such normals, in pairs of doubles that carry a magnitude, each when it is first asked for.
struct PairAxes {
  using T = FusedPair;
  struct Of {
    Vec<T> normal;
    T square, middle, overlap;
  };

  const EdgeSum& sum;
  std::optional<SumParts<T>> parts{};
  std::array<std::optional<Of>, 15> axis{};
};

/// A sign that is not zero, or 0.
PLUMB_WITH_FMA int sign_by_pairs(PairAxes& axes, const AxisQuestion& q) {
  using T = PairAxes::T;
  const auto size = [](const T& x) { return x.high + x.low < 0 ? -x : x; };
  if (!axes.parts) axes.parts.emplace(axes.sum.parts<T>());
  const SumParts<T>& parts = *axes.parts;
  for (const std::uint32_t i : {q.i, q.asked == Asked::order ? q.other : q.i}) {
    if (axes.axis[i]) continue;
    const auto& of = i == q.i ? q.of : q.of_other;
    const Vec<T> n = arith::cross(parts.group[of[0]], parts.group[of[1]]);
    const T middle = arith::dot(n, parts.middle);
    T overlap = -size(middle);
    for (std::uint32_t g = 0; g < axes.sum.groups(); ++g) {
      if (g != of[0] && g != of[1]) overlap = overlap + size(arith::dot(n, parts.group[g]));
    }
    axes.axis[i].emplace(PairAxes::Of{n, arith::dot(n, n), middle, overlap});
  }
  const PairAxes::Of& p = *axes.axis[q.i];
  if (q.asked == Asked::overlap) return p.overlap.certain_sign();
  if (q.asked == Asked::middle) return p.middle.certain_sign();
  if (q.asked == Asked::along) return arith::dot(p.normal, parts.group[q.other]).certain_sign();
  const PairAxes::Of& r = *axes.axis[q.other];  // the order of two overlaps over the lengths of their normals
  const int of_p = p.overlap.certain_sign(), of_r = r.overlap.certain_sign();
  if (of_p == 0 || of_r == 0 || of_p != of_r) return of_p == 0 || of_r == 0 ? 0 : of_p;
  return of_p * (p.overlap.squared() * r.square - r.overlap.squared() * p.square).certain_sign();
}

/// The axes of a sum by pairs of doubles, each when it is first asked for.
class Axes {
 public:
  explicit Axes(const EdgeSum& sum) : sum_(sum) {}

  [[nodiscard]] const EdgeSum& sum() const { return sum_; }
  [[nodiscard]] bool stand() const { return sum_.difference().a.stands() && sum_.difference().b.stands(); }

  /// Nothing where such pairs leave it open, as they leave zero.
  std::optional<Sign> quick_sign(const AxisQuestion& q) {
    const int s = has_fma ? sign_by_pairs(pairs_, q) : 0;  // without it balls are no slower
    return s == 0 ? std::nullopt : std::optional(static_cast<Sign>(s));
  }

  const SumParts<Ball>& parts() {
    if (!parts_) parts_ = sum_.parts<Ball>();
    return *parts_;
  }
  const Axis<Ball>& operator()(std::uint32_t normal, std::uint32_t p, std::uint32_t q) {
    auto& axis = axis_[normal];
    if (!axis) axis.emplace(parts(), sum_.groups(), p, q);
    return *axis;
  }

 private:
  const EdgeSum& sum_;
  PairAxes pairs_{sum_};
  std::optional<SumParts<Ball>> parts_;
  std::array<std::optional<Axis<Ball>>, 15> axis_;
};

/// The axis of space that a normal is along by zeros.
std::optional<int> axis_of(const Vec<Running>& n) {
  const std::array is_zero{certainly_zero(n.x), certainly_zero(n.y), certainly_zero(n.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool is_along = is_zero[(k + 1) % 3] && is_zero[(k + 2) % 3] && !is_zero[k];
    const auto axis = static_cast<int>(k);
    if (is_along && certain_sign(along_axis(n, axis)) != 0) return axis;
  }
  return {};
}

/// Of sums as they stand, whose groups lead one way each: what they overlap by along an axis of space, times two.
Ball overlap_along(const EdgeSum& sum, int axis) {
  const Difference& d = sum.difference();
  const auto middle = [&](const CoreCorners& c) { return along_axis(c.twice_middle<Ball>(), axis); };
  Ball overlap = Ball(0.0) - magnitude(middle(d.a) - middle(d.b));
  for (const SumEdge& e : sum.edges()) {
    const CoreCorners& c = e.body == 0 ? d.a : d.b;
    if (c.is_aligned() && e.bit != static_cast<std::uint32_t>(axis)) continue;  // it leads along another axis of space
    const Ball length = c.length_of_edge<Ball>(e.bit, axis);
    if (!certainly_zero(length)) overlap = overlap + length;
  }
  return overlap;
}

std::optional<Sign> certain(const Unsure<Sign>& s) {
  if (!s.certain()) return {};
  return s.value();
}

/// What is along a normal of two groups.
struct Signs {
  std::array<std::uint32_t, 2> of;
  Sign overlap, middle;
  std::array<Sign, 6> along{};  // of each group
};
/// From running errors (`along`: of a group), and pairs of doubles where these leave a sign open; nothing where both do,
/// or where nothing leads along the normal.
template <class Along>
std::optional<Signs> signs_of(std::size_t groups, std::uint32_t normal, const std::array<std::uint32_t, 2>& of,
                              const Vec<Running>& n, const Running& overlap, const Running& middle, const Along& along,
                              Axes& axes) {
  const auto fine = [&]() -> const Axis<Ball>& { return axes(normal, of[0], of[1]); };
  const auto sign = [&](const Running& rough, Asked asked, std::uint32_t k, const auto& by_balls) {
    auto s = certain(rough.sign());
    if (!s) s = axes.quick_sign({asked, normal, of, k});
    return s ? s : certain(by_balls().sign());
  };
  auto of_overlap = certain(overlap.sign());
  if (const auto axis = axis_of(n); !of_overlap && axis && axes.stand()) {
    of_overlap = certain(overlap_along(axes.sum(), *axis).sign());
  }
  if (!of_overlap) of_overlap = sign(overlap, Asked::overlap, 0, [&]() -> const Ball& { return fine().overlap; });
  const auto of_middle = sign(middle, Asked::middle, 0, [&]() -> const Ball& { return fine().middle; });
  if (!of_overlap || !of_middle || *of_middle == Sign::zero) return {};
  Signs told{of, *of_overlap, *of_middle};
  bool has_reach = false;
  for (std::uint32_t k = 0; k < groups; ++k) {
    if (k == of[0] || k == of[1]) continue;
    const auto s = sign(along(k), Asked::along, k, [&] { return sparse_dot(fine().normal, axes.parts().group[k]); });
    if (!s) return {};
    told.along[k] = *s, has_reach = has_reach || *s != Sign::zero;
  }
  if (!has_reach) return {};
  return told;
}

/// The order of two overlaps over the lengths of their normals; nothing where it is not certain.
std::optional<Sign> order_of(const Axis<Ball>& p, const Axis<Ball>& q) {
  const Ball square_p = sparse_product(p.overlap, magnitude(p.overlap)),
             square_q = sparse_product(q.overlap, magnitude(q.overlap));
  return certain((sparse_product(square_p, q.square) - sparse_product(square_q, p.square)).sign());
}

/// The axis of the least overlap; of what is apart that of the widest gap as far as doubles tell, or a likely one.
struct Least {
  Signs signs;
  bool is_widest = true;
};
std::optional<Least> least_of(const Zonotope& z, Gap gap) {
  std::array<std::uint32_t, 15> near;  // as far as running errors tell
  std::size_t size = 0;
  std::uint32_t best = 0;
  double most = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < z.normals(); ++i) {
    if (const double upper = z.square(i).upper(); upper < most) most = upper, best = i;
  }
  for (std::uint32_t i = 0; i < z.normals(); ++i) {
    if (!(z.square(i).lower() > most)) near[size++] = i;
  }
  const std::size_t groups = z.sum().groups();
  Axes axes(z.sum());
  bool is_widest = true;
  if (gap == Gap::likely && z.rough(best).overlap.sign() == Unsure{Sign::negative}) {
    // A guess: of faces that are nearly in one plane the largest is the one that the other body is before.
    const auto is_of_one = [&](std::uint32_t i) {
      return z.sum().first_of(z.pair(i)[0]).body == z.sum().first_of(z.pair(i)[1]).body;
    };
    std::optional<std::uint32_t> face;
    for (std::size_t k = 0; k < size; ++k) {
      const auto area = [&](std::uint32_t i) {
        const Vec<Running>& n = z.rough(i).normal;
        return n.x.value * n.x.value + n.y.value * n.y.value + n.z.value * n.z.value;
      };
      if (z.rough(near[k]).overlap.sign() != Unsure{Sign::negative}) continue;
      if (is_of_one(near[k]) && (!face || area(near[k]) > area(*face))) face = near[k];
    }
    is_widest = size == 1;
    best = face.value_or(best), size = 0;
  }
  const auto fine = [&](std::uint32_t i) -> const Axis<Ball>& { return axes(i, z.pair(i)[0], z.pair(i)[1]); };
  const auto order = [&](std::uint32_t i, std::uint32_t j) {
    const auto s = axes.quick_sign({Asked::order, i, z.pair(i), j, z.pair(j)});
    return s ? s : order_of(fine(i), fine(j));
  };
  for (;;) {  // ends, for each is nearer than the one before
    const Zonotope::OfNormal& rough = z.rough(best);
    const auto signs = signs_of(
        groups, best, rough.of, rough.normal, rough.overlap, rough.middle,
        [&](std::uint32_t k) { return z.rough_along(best, k); }, axes);
    if (!signs) return {};
    std::optional<std::uint32_t> nearer;
    for (std::size_t k = 0; k < size && !nearer; ++k) {
      const auto [p, q] = z.pair(near[k]);
      if (signs->along[p] == Sign::zero && signs->along[q] == Sign::zero)
        continue;  // parallel to it, or to one another
      const auto is = order(near[k], best);
      if (is == Sign::negative) {
        nearer = near[k];
      } else if (is != Sign::positive && signs->overlap != Sign::negative) {
        return {};
      }
    }
    if (!nearer) return Least{*signs, is_widest};
    best = *nearer;
  }
}

/// Along an axis of space for certain, where it is along one by zeros.
Way across(const Vector3& u, const Vector3& v, const Ends& p) {
  const Vec<Running> n = sparse_cross(arith::vec<Running>(u), arith::vec<Running>(v));
  const std::array of{n.x.sign(), n.y.sign(), n.z.sign()};
  const auto is_zero = [&](std::size_t k) { return of[k] == Unsure{Sign::zero}; };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_zero((k + 1) % 3) || !is_zero((k + 2) % 3) || !of[k].certain() || is_zero(k)) continue;
    return Way::along_axis(static_cast<int>(k), of[k].value() == Sign::positive, p);
  }
  return Way::across(u, v, p);
}

SumParting told_of(const EdgeSum& sum, const Signs& signs) {
  const Difference& d = sum.difference();
  const bool are_apart = signs.overlap == Sign::negative, up = signs.middle == Sign::positive;
  const auto facet =
      facet_of(sum, signs.of[0], signs.of[1], -signs.middle, [&](std::uint32_t k) { return signs.along[k]; });
  const SumEdge &p = sum.first_of(signs.of[0]), &q = sum.first_of(signs.of[1]);
  const auto axis = [&](const SumEdge& e) -> std::optional<Vector3> {
    const CoreCorners& c = e.body == 0 ? d.a : d.b;
    return c.stands() ? c.axis_of_edge(e.bit) : std::nullopt;
  };
  const auto u = axis(p), v = axis(q);
  const Way way = u && v ? across(up ? *u : *v, up ? *v : *u, facet.points[0]) : Way::through(facet.points);
  return {.known = are_apart ? SumParting::Known::apart : SumParting::Known::parting,
          .parting = Parting{way, are_apart, true},
          .level = facet.level,
          .edges = SumFacetEdges{{{p.body, p.bit}, {q.body, q.bit}}}};
}

}  // namespace

std::optional<SumParting> quick_axis(const Zonotope& z, Gap gap) {
  const auto least = least_of(z, gap);
  if (!least) return {};
  SumParting told = told_of(z.sum(), least->signs);
  told.is_widest = least->is_widest;
  if (told.known == SumParting::Known::parting) told.is_plain = {z.is_independent(0), z.is_independent(1)};
  return told;
}

std::optional<SumParting> plane_across(const Difference& d, const SumFacetEdges& edges) {
  const EdgeSum sum(d);
  const auto p = sum.group_of(edges[0]), q = sum.group_of(edges[1]);
  if (!p || !q || *p == *q || sum.groups() < 3) return {};
  const std::array of{std::min(*p, *q), std::max(*p, *q)};
  const SumParts<Approximate> parts = settled(sum.parts<Approximate>());
  const Axis<Approximate> rough(parts, sum.groups(), of[0], of[1]);
  Axes axes(sum);
  const auto signs = signs_of(
      sum.groups(), 0, of, running(rough.normal), running(rough.overlap), running(rough.middle),
      [&](std::uint32_t k) { return running(sparse_dot(rough.normal, parts.group[k])); }, axes);
  if (!signs || signs->overlap != Sign::negative) return {};
  return told_of(sum, *signs);
}

}  // namespace plumb::query::parting
