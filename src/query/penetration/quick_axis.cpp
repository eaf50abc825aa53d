#include "query/penetration/quick_axis.hpp"

#include <cmath>

#include "arith/sparse_vec.hpp"
#include "certify/fused.hpp"
#include "query/penetration/box_axes.hpp"
#include "query/penetration/two_boxes.hpp"
#include "query/penetration/zonotope.hpp"

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
  /// Is it known of all edges which way they lead in space?
  [[nodiscard]] bool are_given() const {
    return std::ranges::all_of(sum_.edges(), [&](const SumEdge& e) {
      return (e.body == 0 ? sum_.difference().a : sum_.difference().b).axis_in_space(e.bit).has_value();
    });
  }

  /// Nothing where such pairs leave it open, as they leave zero.
  std::optional<Sign> quick_sign(const AxisQuestion& q) {
    const int s = has_fma ? sign_by_pairs(numbers().pairs, q) : 0;  // without it balls are no slower
    return s == 0 ? std::nullopt : std::optional(static_cast<Sign>(s));
  }

  const SumParts<Ball>& parts() {
    if (!numbers().parts) numbers().parts = sum_.parts<Ball>();
    return *numbers().parts;
  }
  const Axis<Ball>& operator()(std::uint32_t normal, std::uint32_t p, std::uint32_t q) {
    auto& axis = numbers().axis[normal];
    if (!axis) axis.emplace(parts(), sum_.groups(), p, q);
    return *axis;
  }

 private:
  struct Numbers {
    explicit Numbers(const EdgeSum& sum) : pairs{sum} {}
    PairAxes pairs;
    std::optional<SumParts<Ball>> parts;
    std::array<std::optional<Axis<Ball>>, 15> axis;
  };
  Numbers& numbers() {
    if (!numbers_) numbers_.emplace(sum_);
    return *numbers_;
  }

  const EdgeSum& sum_;
  std::optional<Numbers> numbers_;  // as a rule doubles tell all
};

/// Of sums as they stand, whose groups lead one way each: what they overlap by along an axis of space, times two.
std::optional<Ball> overlap_along(const EdgeSum& sum, int axis) {
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

/// The same of boxes under poses, where that axis is one of each body's: their weights have no part in it.
std::optional<Ball> posed_overlap_along(const EdgeSum& sum, int axis) {
  const auto k = static_cast<std::size_t>(axis);
  std::array middle{Ball(0.0), Ball(0.0)};
  Ball reach(0.0);
  for (std::size_t body = 0; body < 2; ++body) {
    const auto b = (body == 0 ? sum.difference().a : sum.difference().b).posed_box();
    if (!b || b->along[k] == 0) return {};
    const auto of = static_cast<std::size_t>(std::abs(b->along[k]) - 1);
    const double at = along_axis(arith::vec<double>(b->at), axis);
    const Ball local = Ball(b->local[of].to) - Ball(b->local[of].from);
    middle[body] = (Ball(at) + Ball(at)) + (b->along[k] > 0 ? local : Ball(0.0) - local);
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = along_axis(arith::vec<double>(b->axes[i]), axis);
      if (part == 0) continue;
      if (part != b->weight && part != -b->weight) return {};
      reach = reach + magnitude(Ball(b->length[i].to) - Ball(b->length[i].from));
    }
  }
  return reach - magnitude(middle[0] - middle[1]);
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
/// An axis of space that the normal is along tells its signs at once, pairs of doubles what is left open; nothing is told
/// where these leave it open, or where nothing leads along the normal.
std::optional<Signs> signs_of(std::uint32_t normal, const std::array<std::uint32_t, 2>& of, const RoughSigns& rough,
                              std::optional<AlongAxis> along_space, Axes& axes) {
  const EdgeSum& sum = axes.sum();
  if (along_space && !axes.are_given()) along_space.reset();
  const auto fine = [&]() -> const Axis<Ball>& { return axes(normal, of[0], of[1]); };
  const auto sign = [&](const std::optional<Sign>& known, Asked asked, std::uint32_t k, const auto& by_balls) {
    if (known) return known;
    const auto s = axes.quick_sign({asked, normal, of, k});
    return s ? s : certain(by_balls().sign());
  };
  auto of_overlap = rough.overlap;
  if (!of_overlap && along_space) {
    const auto overlap =
        axes.stand() ? overlap_along(sum, along_space->axis) : posed_overlap_along(sum, along_space->axis);
    if (overlap) of_overlap = certain(overlap->sign());
  }
  if (!of_overlap) of_overlap = sign({}, Asked::overlap, 0, [&]() -> const Ball& { return fine().overlap; });
  const auto of_middle = sign(rough.middle, Asked::middle, 0, [&]() -> const Ball& { return fine().middle; });
  if (!of_overlap || !of_middle || *of_middle == Sign::zero) return {};
  Signs told{of, *of_overlap, *of_middle};
  bool has_reach = false;
  for (std::uint32_t k = 0; k < sum.groups(); ++k) {
    if (k == of[0] || k == of[1]) continue;
    auto known = rough.along[k];
    if (!known && along_space) {
      if (const auto& way = sum.along(k)) {
        known = along_space->up * sign_of_number(along_axis(arith::vec<double>(*way), along_space->axis));
      }
    }
    const auto s = sign(known, Asked::along, k, [&] { return sparse_dot(fine().normal, axes.parts().group[k]); });
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

/// The normals of two groups each, and which of them may be the nearest as far as doubles tell.
struct Candidates {
  using Of = std::array<std::uint32_t, 2>;

  std::array<Of, 15> of;
  std::array<std::uint32_t, 15> near;
  std::size_t size = 0;    // of those that are near
  std::uint32_t best = 0;  // a guess
  bool is_widest = true;   // of what is apart, as far as doubles tell
};

/// A guess: the largest of faces that are nearly in one plane is the one that the other body, apart from it, is before.
/// `is_face(i)`: is there a gap along the normal of a face, which is nearly as wide as any?
template <class IsFace, class Area>
std::optional<std::uint32_t> likely_face(std::size_t size, const IsFace& is_face, const Area& area) {
  std::optional<std::uint32_t> face;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (is_face(i) && (!face || area(i) > area(*face))) face = i;
  }
  return face;
}

/// The axis of the least overlap; of what is apart that of the widest gap as far as doubles tell, or a likely one.
struct Least {
  Signs signs;
  bool is_widest = true;
};
/// `signs_at(i)`: as `signs_of` tells.  `quick_order(i, k)`: is the axis near[k] farther than axis i, as far as that is known?
template <class SignsAt, class QuickOrder>
std::optional<Least> least_of(Candidates c, Axes& axes, const SignsAt& signs_at, const QuickOrder& quick_order) {
  const auto fine = [&](std::uint32_t i) -> const Axis<Ball>& { return axes(i, c.of[i][0], c.of[i][1]); };
  const auto order = [&](std::uint32_t i, std::uint32_t j) {
    const auto s = axes.quick_sign({Asked::order, i, c.of[i], j, c.of[j]});
    return s ? s : order_of(fine(i), fine(j));
  };
  std::uint32_t farther = 0;  // by bits: than one of those that were the best so far
  for (;;) {                  // ends, for each is nearer than the one before
    const auto signs = signs_at(c.best);
    if (!signs) return {};
    std::optional<std::uint32_t> nearer;
    for (std::size_t k = 0; k < c.size && !nearer; ++k) {
      const auto [p, q] = c.of[c.near[k]];
      const bool is_along = signs->along[p] == Sign::zero && signs->along[q] == Sign::zero;  // or they are parallel
      if (is_along || (farther >> k & 1) != 0) continue;
      const Sign known = quick_order(c.best, k);
      const auto is = known != Sign::zero ? std::optional(known) : order(c.near[k], c.best);
      if (is == Sign::negative) {
        nearer = c.near[k];
      } else if (is == Sign::positive) {
        farther |= 1U << k;
      } else if (signs->overlap != Sign::negative) {
        return {};
      }
    }
    if (!nearer) return Least{*signs, c.is_widest};
    c.best = *nearer;
  }
}

/// Running errors tell them, of any sums.
RoughSigns rough_signs(const Zonotope& z, std::uint32_t i) {
  const Zonotope::OfNormal& n = z.rough(i);
  RoughSigns rough{certain(n.overlap.sign()), certain(n.middle.sign())};
  for (std::uint32_t k = 0; k < z.sum().groups(); ++k) {
    if (k != n.of[0] && k != n.of[1]) rough.along[k] = certain(z.rough_along(i, k).sign());
  }
  return rough;
}
std::optional<Least> least_of(const Zonotope& z, Gap gap) {
  Candidates c;
  double most = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < z.normals(); ++i) {
    c.of[i] = z.pair(i);
    if (const double upper = z.square(i).upper(); upper < most) most = upper, c.best = i;
  }
  for (std::uint32_t i = 0; i < z.normals(); ++i) {
    if (!(z.square(i).lower() > most)) c.near[c.size++] = i;
  }
  Axes axes(z.sum());
  const auto signs_at = [&](std::uint32_t i) {
    return signs_of(i, c.of[i], rough_signs(z, i), axis_of(z.rough(i).normal), axes);
  };
  const auto is_apart = [&](std::uint32_t i) { return z.rough(i).overlap.sign() == Unsure{Sign::negative}; };
  if (gap == Gap::likely && is_apart(c.best)) {
    const auto area = [&](std::uint32_t k) {
      const Vec<Running>& n = z.rough(c.near[k]).normal;
      return n.x.value * n.x.value + n.y.value * n.y.value + n.z.value * n.z.value;
    };
    const auto body_of = [&](std::uint32_t i, std::size_t k) { return z.sum().first_of(c.of[i][k]).body; };
    const auto is_face = [&](std::uint32_t k) {
      return is_apart(c.near[k]) && body_of(c.near[k], 0) == body_of(c.near[k], 1);
    };
    const auto face = likely_face(c.size, is_face, area);
    c.is_widest = c.size == 1;
    c.best = face ? c.near[*face] : c.best, c.size = 0;
  }
  return least_of(c, axes, signs_at, [](std::uint32_t, std::size_t) { return Sign::zero; });
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

SumParting told_of(const EdgeSum& sum, const Least& least) {
  const Signs& signs = least.signs;
  const Difference& d = sum.difference();
  const bool are_apart = signs.overlap == Sign::negative, up = signs.middle == Sign::positive;
  const auto facet =
      facet_of(sum, signs.of[0], signs.of[1], -signs.middle, [&](std::uint32_t k) { return signs.along[k]; });
  const SumEdge &p = sum.first_of(signs.of[0]), &q = sum.first_of(signs.of[1]);
  const auto axis = [&](const SumEdge& e) -> std::optional<Vector3> {
    const CoreCorners& c = e.body == 0 ? d.a : d.b;
    return c.axis_in_space(e.bit);
  };
  const auto u = axis(p), v = axis(q);
  const Way way = u && v ? across(up ? *u : *v, up ? *v : *u, facet.points[0]) : Way::through(facet.points);
  return {
      .known = are_apart ? SumParting::Known::apart : SumParting::Known::parting,
      .parting =
          Parting{
              .way = way, .cores_are_apart = are_apart, .is_unique = true, .cores_touch = signs.overlap == Sign::zero},
      .level = facet.level,
      .is_widest = least.is_widest,
      .edges = SumFacetEdges{{{p.body, p.bit}, {q.body, q.bit}}}};
}

/// A guess in doubles: along which normal boxes overlap least, which is one of edges that are not nearly parallel.  Of
/// boxes that are apart the likely one.
template <class Box, class Overlaps, class Lengths>
std::uint32_t guessed_axis(const Boxes<Box>& boxes, std::span<const NearAxes::Pair> pairs, const Overlaps& overlaps,
                           const Lengths& lengths, Gap gap) {
  const auto size = static_cast<std::uint32_t>(pairs.size());
  double largest = 0;
  for (std::uint32_t i = 0; i < size; ++i) largest = std::fmax(largest, lengths[i]->value);
  const auto is_some = [&](std::uint32_t i) { return lengths[i]->value > largest * 0x1p-60; };  // a guess
  std::uint32_t best = size;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (!is_some(i)) continue;
    if (best == size || overlaps[i]->value * lengths[best]->value < overlaps[best]->value * lengths[i]->value) best = i;
  }
  if (best == size) return 0;
  if (gap == Gap::widest || !(overlaps[best]->value < 0)) return best;
  const double widest = overlaps[best]->value * (1 - 0x1p-30);  // a guess
  const auto is_face = [&](std::uint32_t i) {
    return pairs[i][0] / 3 == pairs[i][1] / 3 && is_some(i) &&
           overlaps[i]->value * lengths[best]->value <= widest * lengths[i]->value;
  };
  const auto area = [&](std::uint32_t i) { return boxes.area(pairs[i], lengths[i]->value); };
  return likely_face(size, is_face, area).value_or(best);
}

/// Doubles whose errors are derived: as a rule they leave one axis.
template <class Box>
std::optional<SumParting> quick_boxes(const EdgeSum& sum, Gap gap) {
  const auto boxes = Boxes<Box>::of(sum);
  if (!boxes) return {};
  Candidates c;
  std::array<NearAxes::Pair, 15> all;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < sum.groups(); ++i) {
    for (std::uint32_t j = i + 1; j < sum.groups(); ++j) {
      c.of[count] = {i, j}, all[count] = boxes->pair({i, j});
      if (!are_parallel(boxes->axis(all[count][0]), boxes->axis(all[count][1]))) ++count;
    }
  }
  if (count == 0) return {};
  const std::span<const NearAxes::Pair> pairs = std::span(all).first(count);
  const auto pick = [&](const auto& overlaps, const auto& lengths) {
    return guessed_axis(*boxes, pairs, overlaps, lengths, gap);
  };
  FloatWorld<NearAxesOf<Box>> world;
  const auto told = NearAxesOf<Box>{}(world, boxes->a(), boxes->b(), pairs, pick);
  if (!world.certain()) return {};
  c.best = told.picked;
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((told.near >> i & 1) != 0) c.near[c.size++] = i;
  }
  if (gap == Gap::likely && told.overlap == Sign::negative) c.is_widest = c.size == 1, c.size = 0;
  Axes axes(sum);
  const RoughSigns of_picked = boxes->rough_signs(told);
  std::optional<NearAxisSigns> fine;
  if (!boxes->along_space(all[c.best]) && (c.size > 1 || boxes->lacks(of_picked, c.of[c.best]))) {
    std::array<NearAxes::Pair, 16> asked{all[c.best]};
    for (std::size_t k = 0; k < c.size; ++k) asked[k + 1] = all[c.near[k]];
    fine = near_axis_signs(boxes->a(), boxes->b(), std::span(asked).first(c.size + 1));
    if (fine->least > 0) c.best = c.near[fine->least - 1];
  }
  const std::uint32_t of_fine = c.best;
  const auto signs_at = [&](std::uint32_t i) {
    RoughSigns rough = i == told.picked ? of_picked : RoughSigns();
    if (fine && i == of_fine) boxes->fill(rough, *fine);
    const auto along_space = boxes->along_space(all[i]);
    if (!along_space && boxes->lacks(rough, c.of[i])) boxes->settle(rough, c.of[i]);
    return signs_of(i, c.of[i], rough, along_space, axes);
  };
  const auto quick_order = [&](std::uint32_t i, std::size_t k) {
    return fine && i == of_fine ? fine->order[k + 1] : Sign::zero;
  };
  const auto least = least_of(c, axes, signs_at, quick_order);
  if (!least) return {};
  SumParting parting = told_of(sum, *least);
  const auto is_plain = [&](std::uint32_t body) { return sum.has_its_own(body) && told.turn[body] != Sign::zero; };
  if (parting.known == SumParting::Known::parting) parting.is_plain = {is_plain(0), is_plain(1)};
  return parting;
}

}  // namespace

std::optional<SumParting> quick_axis(const EdgeSum& sum, Gap gap) {
  const Difference& d = sum.difference();
  const bool stand = d.a.stands() && d.b.stands();
  if (const auto told = stand ? quick_boxes<GivenBox>(sum, gap) : quick_boxes<PosedBox>(sum, gap)) return told;
  const Zonotope z(sum);
  const auto least = least_of(z, gap);
  if (!least) return {};
  SumParting told = told_of(sum, *least);
  if (told.known == SumParting::Known::parting) told.is_plain = {z.is_independent(0), z.is_independent(1)};
  return told;
}

std::optional<SumParting> plane_across(const Difference& d, const SumFacetEdges& edges) {
  const EdgeSum sum(d);
  const auto p = sum.group_of(edges[0]), q = sum.group_of(edges[1]);
  if (!p || !q || *p == *q || sum.groups() < 3) return {};
  const std::array of{std::min(*p, *q), std::max(*p, *q)};
  Axes axes(sum);
  std::optional<Signs> signs;
  const auto by_boxes = [&]<class Box>(const Boxes<Box>& boxes) {
    const std::array<NearAxes::Pair, 1> pair{boxes.pair(of)};
    FloatWorld<NearAxesOf<Box>> world;
    const auto told = NearAxesOf<Box>{}(world, boxes.a(), boxes.b(), pair, [](const auto&, const auto&) { return 0U; });
    if (!world.certain() || told.overlap != Sign::negative) return;
    const auto along_space = boxes.along_space(pair[0]);
    RoughSigns rough = boxes.rough_signs(told);
    if (!along_space && boxes.lacks(rough, of)) boxes.fill(rough, near_axis_signs(boxes.a(), boxes.b(), pair));
    signs = signs_of(0, of, rough, along_space, axes);
  };
  if (const auto boxes = Boxes<GivenBox>::of(sum)) {
    by_boxes(*boxes);
  } else if (const auto posed = Boxes<PosedBox>::of(sum)) {
    by_boxes(*posed);
  } else {
    const SumParts<Approximate> parts = settled(sum.parts<Approximate>());
    const Axis<Approximate> rough(parts, sum.groups(), of[0], of[1]);
    RoughSigns known{certain(running(rough.overlap).sign()), certain(running(rough.middle).sign())};
    for (std::uint32_t k = 0; k < sum.groups(); ++k) {
      if (k != of[0] && k != of[1]) {
        known.along[k] = certain(running(sparse_dot(rough.normal, parts.group[k])).sign());
      }
    }
    signs = signs_of(0, of, known, axis_of(running(rough.normal)), axes);
  }
  if (!signs || signs->overlap != Sign::negative) return {};
  return told_of(sum, {*signs});
}

}  // namespace plumb::query::parting
