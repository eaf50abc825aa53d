#include "query/convex/near_pair.hpp"

#include <algorithm>

#include "arith/nearest_of_corners.hpp"
#include "figure/support/gjk_simplex.hpp"

namespace plumb::query {
namespace {

using arith::Plain;

/// Of the difference of the hulls, by the numbers of the vertices.
using IndexSimplex = figure::gjk::Simplex<std::pair<std::size_t, std::size_t>>;

class NearPairSearch {
 public:
  NearPairSearch(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b)
      : a_(a), b_(b), reach_(Running(radius_a) + Running(radius_b)) {}

  std::optional<Sign> run(LikelyEnds* likely) const {
    IndexSimplex simplex({{0, 0}, plain(a_[0]) - plain(b_[0])});
    const std::optional<Sign> told = search(simplex);
    if (!told && likely != nullptr) {
      for (const IndexSimplex::Corner& c : simplex.corners())
        likely->ends[likely->size++] = {c.ends.first, c.ends.second};
    }
    return told;
  }

 private:
  std::optional<Sign> search(IndexSimplex& simplex) const {
    constexpr int most_rounds = 32;  // a guess of cost alone: then nothing is told, and others are asked
    constexpr double near = 1 - 0x1p-30, far = 1 + 0x1p-30;  // guesses: beyond them a proof is likely
    const double square = reach_.value * reach_.value;
    for (int round = 0; round < most_rounds; ++round) {
      const Plain x = simplex.nearest();
      const double xx = arith::dot(x, x);
      if (xx < square * near) return proved_near(simplex);
      const auto ends = extremes(x);
      const Plain w = plain(a_[ends.first]) - plain(b_[ends.second]);
      const double least = arith::dot(x, w);
      if (least > 0 && least * least > square * xx * far) return proved_far(x);
      if (!(least < xx) || std::ranges::count(simplex.corners(), ends, &IndexSimplex::Corner::ends) != 0) {
        if (xx < square) return proved_near(simplex);
        return proved_far(x);
      }
      if (simplex.is_full()) return {};  // about the origin, but for roundings
      simplex.add({ends, w});
    }
    return {};
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> extremes(const Plain& n) const {
    const auto first = [&n](std::span<const Vertex> all, double sign) {
      std::size_t best = 0;
      double least = sign * arith::dot(n, plain(all[0]));
      for (std::size_t i = 1; i < all.size(); ++i) {
        const double along = sign * arith::dot(n, plain(all[i]));
        if (along < least) best = i, least = along;
      }
      return best;
    };
    return {first(a_, 1), first(b_, -1)};
  }

  // With weights w_k >= 0 the sum of w_k (a_k - b_k) over that of w_k is the way between points of the hulls.
  [[nodiscard]] std::optional<Sign> proved_near(const IndexSimplex& simplex) const {
    Vertex way;
    Running whole;
    for (const IndexSimplex::Corner& c : simplex.corners()) {
      if (!(c.weight >= 0)) return {};
      const Running weight(c.weight);
      way = way + (a_[c.ends.first] - b_[c.ends.second]) * weight;
      whole = whole + weight;
    }
    const Running reach = reach_ * whole;
    const Unsure<Sign> s = (arith::dot(way, way) - reach * reach).sign();
    if (s.certain() && s.value() == Sign::negative) return Sign::negative;
    return {};
  }

  // Every n . (x - y) is at least the gap, and the gap's square is more than that of |n| times the radii.
  [[nodiscard]] std::optional<Sign> proved_far(const Plain& direction) const {
    const Vertex n = arith::vec<Running>(direction);
    const Vertex& from = b_[0];
    double above = 0, below = arith::dot(n, a_[0] - from).lower();
    for (const Vertex& y : b_.subspan(1)) {
      const double top = arith::dot(n, y - from).upper();
      if (!(top <= above)) above = top;
    }
    for (const Vertex& x : a_.subspan(1)) {
      const double bottom = arith::dot(n, x - from).lower();
      if (!(bottom >= below)) below = bottom;
    }
    if (!(below > above)) return {};
    const Running gap = Running(below) - Running(above);
    const Unsure<Sign> s = (gap * gap - reach_ * reach_ * arith::dot(n, n)).sign();
    if (s.certain() && s.value() == Sign::positive) return Sign::positive;
    return {};
  }

  std::span<const Vertex> a_, b_;
  Running reach_;
};

}  // namespace

std::optional<Sign> quick_gap(std::span<const Vertex> a, std::span<const Vertex> b, double radius_a, double radius_b,
                              LikelyEnds* likely) {
  return NearPairSearch(a, b, radius_a, radius_b).run(likely);
}

// What is nearest of the ends' hull is nearest of all where it is within that, and no vertex lies before the plane
// through it.
std::optional<Sign> integer_gap(std::span<const ExactVertex> a, std::span<const ExactVertex> b, double radius_a,
                                double radius_b, const LikelyEnds& likely) {
  CertainSigns ask;
  const ShortDyadic reach = ShortDyadic(radius_a) + ShortDyadic(radius_b);
  if (likely.size == 0 || ask(reach) != Sign::positive) return {};
  const ExactVertex none = arith::no_way<ShortDyadic>();
  std::array<ExactVertex, 4> at{none, none, none, none};
  for (std::size_t i = 0; i < likely.size; ++i) at[i] = a[likely.ends[i][0]] - b[likely.ends[i][1]];
  const auto n = arith::nearest_of<ShortDyadic>(at, likely.size, ask);
  if (!arith::is_within(n, likely.size, ask)) return {};
  const auto any_before = [&](std::span<const ExactVertex> all, std::size_t end, Sign before) {
    return std::ranges::any_of(all,
                               [&](const ExactVertex& v) { return ask(arith::dot(n.way, v - all[end])) == before; });
  };
  const auto& [of_a, of_b] = likely.ends[0];
  if (any_before(a, of_a, Sign::negative) || any_before(b, of_b, Sign::positive)) return {};
  const Sign gap = ask(n.square - reach * reach * n.square_whole);
  return ask.certain() ? std::optional(gap) : std::nullopt;
}

}  // namespace plumb::query
