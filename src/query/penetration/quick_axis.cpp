#include "query/penetration/quick_axis.hpp"

#include <cmath>

#include "arith/sparse_vec.hpp"

namespace plumb::query::parting {
namespace {

using arith::sparse_cross, arith::sparse_dot, arith::sparse_product;

template <class T>
T size_of(const T& x) {
  if constexpr (std::is_same_v<T, double>) {
    return std::fabs(x);
  } else {
    return magnitude(x);
  }
}

/// Along the normal of two groups.
template <class T>
struct Axis {
  Vec<T> normal;
  T square, middle, overlap;

  Axis(const SumParts<T>& parts, std::size_t groups, std::uint32_t p, std::uint32_t q)
      : normal(sparse_cross(parts.group[p], parts.group[q])),
        square(sparse_dot(normal, normal)),
        middle(sparse_dot(normal, parts.middle)),
        overlap(T(0.0) - size_of(middle)) {
    for (std::uint32_t g = 0; g < groups; ++g) {
      if (g != p && g != q) overlap = overlap + size_of(sparse_dot(normal, parts.group[g]));
    }
  }
};

struct Guess {
  std::uint32_t i = 0, j = 1;
};

/// In doubles: the axis of the least overlap, or of the largest gap; of some that are nearly equal the first.
Guess guessed(const EdgeSum& sum, const SumParts<double>& parts) {
  constexpr double nearly = 1e-9;
  std::optional<Guess> best;
  double least = 0;
  const auto size = static_cast<std::uint32_t>(sum.groups());
  const auto is_of_one = [&](std::uint32_t i, std::uint32_t j) { return sum.first_of(i).body == sum.first_of(j).body; };
  for (const bool faces : {true, false}) {
    for (std::uint32_t i = 0; i < size; ++i) {
      for (std::uint32_t j = i + 1; j < size; ++j) {
        if (is_of_one(i, j) != faces) continue;
        const Axis<double> a(parts, size, i, j);
        const double lengths = sparse_dot(parts.group[i], parts.group[i]) * sparse_dot(parts.group[j], parts.group[j]);
        if (!(a.square > nearly * lengths)) continue;
        const double overlap = a.overlap / std::sqrt(a.square);
        if (!best || overlap < least - nearly * std::fabs(least)) least = overlap, best = Guess{i, j};
      }
    }
  }
  return best.value_or(Guess{});
}

/// The groups over the number types that doubles make, pairs of them when they are first asked for.
class Prover {
 public:
  explicit Prover(const EdgeSum& sum) : sum_(sum), rough_(sum.parts<Running>()) {}

  const SumParts<Running>& rough() const { return rough_; }
  const SumParts<Ball>& fine() {
    if (!fine_) fine_ = sum_.parts<Ball>();
    return *fine_;
  }

 private:
  const EdgeSum& sum_;
  SumParts<Running> rough_;
  std::optional<SumParts<Ball>> fine_;
};

/// How far out is another axis than this one?  Positive: farther; nothing where it is not certain.
template <class T>
std::optional<Sign> order_of(const Axis<T>& other, const Axis<T>& least) {
  const Unsure<Sign> overlap = other.overlap.sign();
  if (!overlap.certain()) return {};
  if (overlap.value() == Sign::negative) return Sign::negative;
  const Unsure<Sign> order = (sparse_product(sparse_product(other.overlap, other.overlap), least.square) -
                              sparse_product(sparse_product(least.overlap, least.overlap), other.square))
                                 .sign();
  if (!order.certain()) return {};
  return order.value();
}

/// The facet that the axis of the guess leads to, or a guess that is nearer for certain; nothing where doubles do not
/// tell.
struct Tried {
  std::optional<SumParting> told;
  std::optional<Guess> nearer;
};
Tried tried(const EdgeSum& sum, Prover& prover, const Guess& g);

}  // namespace

std::optional<SumParting> quick_axis(const EdgeSum& sum) {
  if (sum.groups() < 3) return {};
  Prover prover(sum);
  std::optional<Guess> guess = guessed(sum, sum.parts<double>());
  while (guess) {  // ends, for each is nearer than the one before
    const Tried t = tried(sum, prover, *guess);
    if (t.told) return t.told;
    guess = t.nearer;
  }
  return {};
}

namespace {

Tried tried(const EdgeSum& sum, Prover& prover, const Guess& g) {
  const auto size = static_cast<std::uint32_t>(sum.groups());
  const Difference& d = sum.difference();
  const Axis<Running> rough(prover.rough(), size, g.i, g.j);
  std::optional<Axis<Ball>> fine;
  const auto of_fine = [&]() -> const Axis<Ball>& {
    if (!fine) fine.emplace(prover.fine(), size, g.i, g.j);
    return *fine;
  };
  const auto sign = [&](const auto& of) -> std::optional<Sign> {
    if (const Unsure<Sign> s = of(rough, prover.rough()).sign(); s.certain()) return s.value();
    if (const Unsure<Sign> s = of(of_fine(), prover.fine()).sign(); s.certain()) return s.value();
    return {};
  };
  const auto overlap = sign([](const auto& a, const auto&) { return a.overlap; });
  const auto middle = sign([](const auto& a, const auto&) { return a.middle; });
  if (!overlap || !middle || *middle == Sign::zero) return {};
  std::array<Sign, 6> along{};
  bool has_reach = false;
  for (std::uint32_t k = 0; k < size; ++k) {
    if (k == g.i || k == g.j) continue;
    const auto s = sign([&](const auto& a, const auto& parts) { return sparse_dot(a.normal, parts.group[k]); });
    if (!s) return {};
    along[k] = *s, has_reach = has_reach || *s != Sign::zero;
  }
  if (!has_reach) return {};
  const bool are_apart = *overlap == Sign::negative;
  for (std::uint32_t p = 0; p < size && !are_apart; ++p) {
    for (std::uint32_t q = p + 1; q < size; ++q) {
      if (along[p] == Sign::zero && along[q] == Sign::zero) continue;  // parallel to the guess, or to one another
      auto order = order_of(Axis<Running>(prover.rough(), size, p, q), rough);
      if (!order) order = order_of(Axis<Ball>(prover.fine(), size, p, q), of_fine());
      if (order == Sign::negative) return {{}, Guess{p, q}};
      if (order != Sign::positive) return {};
    }
  }
  const auto is_plain = [&](const CoreCorners& c) {
    if (c.edges() != 3) return false;
    const Vec<Running> u = c.edge<Running>(0), v = c.edge<Running>(1), w = c.edge<Running>(2);
    return certain_sign(sparse_dot(sparse_cross(u, v), w)) != 0;
  };
  SumParting told{
      are_apart ? SumParting::Known::apart : SumParting::Known::parting, {}, {}, {is_plain(d.a), is_plain(d.b)}, {}};
  const auto facet = facet_of(sum, g.i, g.j, -*middle, [&](std::uint32_t k) { return along[k]; });
  told.level = facet.level;
  const auto axis = [&](std::uint32_t k) -> std::optional<Vector3> {
    const SumEdge& e = sum.first_of(k);
    const CoreCorners& c = e.body == 0 ? d.a : d.b;
    return c.stands() ? c.axis_of_edge(e.bit) : std::nullopt;
  };
  const auto u = axis(g.i), v = axis(g.j);
  const bool up = *middle == Sign::positive;
  told.parting = Parting{u && v ? Way::across(up ? *u : *v, up ? *v : *u, facet.points[0]) : Way::through(facet.points),
                         are_apart, true};
  return {told, {}};
}

}  // namespace

std::optional<SumParting> plane_between(const Difference& d) {
  const auto quick = quick_axis(EdgeSum(d));
  return quick && quick->known == SumParting::Known::apart ? quick : std::nullopt;
}

}  // namespace plumb::query::parting
