#include "query/penetration/quick_axis.hpp"

#include <cmath>

namespace plumb::query::parting {
namespace {

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
      : normal(cross(parts.group[p], parts.group[q])),
        square(dot(normal, normal)),
        middle(dot(normal, parts.middle)),
        overlap(T(0.0) - size_of(middle)) {
    for (std::uint32_t g = 0; g < groups; ++g) {
      if (g != p && g != q) overlap = overlap + size_of(dot(normal, parts.group[g]));
    }
  }
};

struct Guess {
  std::uint32_t i = 0, j = 1;
};

/// In doubles: the axis of the least overlap, or of the largest gap; of some that are nearly equal the first.
Guess guessed(const EdgeSum& sum, const SumParts<double>& parts) {
  constexpr double nearly = 1e-9;
  Guess best;
  double least = std::numeric_limits<double>::infinity();
  const auto size = static_cast<std::uint32_t>(sum.groups());
  const auto is_of_one = [&](std::uint32_t i, std::uint32_t j) { return sum.first_of(i).body == sum.first_of(j).body; };
  for (const bool faces : {true, false}) {
    for (std::uint32_t i = 0; i < size; ++i) {
      for (std::uint32_t j = i + 1; j < size; ++j) {
        if (is_of_one(i, j) != faces) continue;
        const Axis<double> a(parts, size, i, j);
        const double lengths = dot(parts.group[i], parts.group[i]) * dot(parts.group[j], parts.group[j]);
        if (!(a.square > nearly * lengths)) continue;
        const double overlap = a.overlap / std::sqrt(a.square);
        if (overlap < least - nearly * std::fabs(least)) least = overlap, best = {i, j};
      }
    }
  }
  return best;
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

/// Is another axis farther out, for certain?
template <class T>
bool is_farther(const Axis<T>& other, const Axis<T>& least) {
  return certain_sign(other.overlap) > 0 &&
         certain_sign(other.overlap * other.overlap * least.square - least.overlap * least.overlap * other.square) > 0;
}

}  // namespace

std::optional<SumParting> quick_axis(const EdgeSum& sum) {
  const auto size = static_cast<std::uint32_t>(sum.groups());
  if (size < 3) return {};
  const Difference& d = sum.difference();
  const Guess g = guessed(sum, sum.parts<double>());
  Prover prover(sum);
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
    const auto s = sign([&](const auto& a, const auto& parts) { return dot(a.normal, parts.group[k]); });
    if (!s) return {};
    along[k] = *s, has_reach = has_reach || *s != Sign::zero;
  }
  if (!has_reach) return {};
  const bool are_apart = *overlap == Sign::negative;
  for (std::uint32_t p = 0; p < size && !are_apart; ++p) {
    for (std::uint32_t q = p + 1; q < size; ++q) {
      if (along[p] == Sign::zero && along[q] == Sign::zero) continue;  // parallel to the guess, or to one another
      if (is_farther(Axis<Running>(prover.rough(), size, p, q), rough)) continue;
      if (!is_farther(Axis<Ball>(prover.fine(), size, p, q), of_fine())) return {};
    }
  }
  const auto is_plain = [&](const CoreCorners& c) {
    if (c.edges() != 3) return false;
    const Vec<Running> u = c.edge<Running>(0), v = c.edge<Running>(1), w = c.edge<Running>(2);
    return certain_sign(dot(cross(u, v), w)) != 0;
  };
  SumParting told{
      are_apart ? SumParting::Known::apart : SumParting::Known::parting, {}, {}, {is_plain(d.a), is_plain(d.b)}, {}};
  const auto facet = facet_of(sum, g.i, g.j, -*middle, [&](std::uint32_t k) { return along[k]; });
  told.level = facet.level;
  const auto axis = [&](std::uint32_t k) -> std::optional<Vector3> {
    const SumEdge& e = sum.first_of(k);
    const CoreCorners& c = e.body == 0 ? d.a : d.b;
    return c.pose() != nullptr ? std::nullopt : c.axis_of_edge(e.bit);
  };
  const auto u = axis(g.i), v = axis(g.j);
  const bool up = *middle == Sign::positive;
  told.parting = Parting{u && v ? Way::across(up ? *u : *v, up ? *v : *u, facet.points[0]) : Way::through(facet.points),
                         are_apart, true};
  return told;
}

std::optional<SumParting> plane_between(const Difference& d) {
  const auto quick = quick_axis(EdgeSum(d));
  return quick && quick->known == SumParting::Known::apart ? quick : std::nullopt;
}

}  // namespace plumb::query::parting
