// Finds the fewest convex pieces of a polygon by dynamic programming over its chains.
//
// Of the chain from vertex i to vertex k, closed by the diagonal between them, two things are kept: the least number of
// diagonals that make its parts convex, and of the ways to do so with that number the pairs of diagonals at i and k
// that leave the narrowest angles in the piece at the diagonal, for the narrower, the sooner may the diagonal itself be
// left out.  A diagonal of a smallest set has a reflex corner at an end, or it could be left out.
// Source: RTCD 12.5.2; Keil and Snoeyink 2002.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "plumb/predicates.hpp"
#include "plumb/surface/planar/convex_pieces.hpp"
#include "surface/planar/checked_points.hpp"
#include "surface/planar/cut_ring.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

// The corners next to i and next to k in the piece at the diagonal from i to k.
struct Narrow {
  std::uint32_t at_i, at_k;
};

constexpr std::uint32_t not_known = std::numeric_limits<std::uint32_t>::max();

struct Chain {
  bool seen = false;  // do its ends see each other through the polygon?
  std::uint32_t diagonals = not_known;
  std::vector<Narrow> narrow;  // both corners ascend, for none is narrower at both ends
};

class FewestPieces {
 public:
  /// Of a simple polygon that turns counterclockwise.
  explicit FewestPieces(std::span<const Point2> points)
      : points_(points), n_(static_cast<std::uint32_t>(points.size())), chains_(points.size() * points.size()) {
    for (std::uint32_t i = 0; i < n_; ++i)
      reflex_.push_back(turn(i == 0 ? n_ - 1 : i - 1, i, i + 1 == n_ ? 0 : i + 1) == Sign::negative);
    for (std::uint32_t i = 0; i < n_; ++i)
      for (std::uint32_t k = i + 1; k < n_; ++k) chain(i, k).seen = k == i + 1 || (i == 0 && k == n_ - 1) || sees(i, k);
  }

  std::vector<Numbers> run() {
    for (std::uint32_t i = 0; i + 1 < n_; ++i) chain(i, i + 1).diagonals = 0;
    for (std::uint32_t i = 0; i + 2 < n_; ++i)
      if (chain(i, i + 2).seen) chain(i, i + 2) = {true, 0, {{i + 1, i + 1}}};
    reflex_[0] = true;  // so that the whole is asked for
    for (std::uint32_t gap = 3; gap < n_; ++gap) {
      for (std::uint32_t i = 0; i + gap < n_; ++i)
        if (reflex_[i] && chain(i, i + gap).seen) from_reflex(i, i + gap);
      for (std::uint32_t k = gap; k < n_; ++k)
        if (reflex_[k] && !reflex_[k - gap] && chain(k - gap, k).seen) to_reflex(k - gap, k);
    }
    mark_narrow();
    return collect();
  }

 private:
  Chain& chain(std::uint32_t i, std::uint32_t k) { return chains_[std::size_t{i} * n_ + k]; }
  bool is_known(std::uint32_t i, std::uint32_t k) { return chain(i, k).seen && chain(i, k).diagonals != not_known; }
  Sign turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orient2d(points_[a], points_[b], points_[c]);
  }
  bool bends(std::uint32_t a, std::uint32_t b, std::uint32_t c) const { return turn(a, b, c) == Sign::negative; }

  // Is p within the angle of corner i or on its sides?
  bool in_angle(std::uint32_t i, std::uint32_t p) const {
    const std::uint32_t before = i == 0 ? n_ - 1 : i - 1, after = i + 1 == n_ ? 0 : i + 1;
    const bool left_of_out = !bends(i, after, p), left_of_in = !bends(before, i, p);
    return reflex_[i] ? left_of_out || left_of_in : left_of_out && left_of_in;
  }

  // Does the segment from i to k stay in the polygon?  It may touch corners and run along edges: a piece with a corner
  // on a straight side is a fan of triangles some of which have no area.  None of them is ever a piece for itself,
  // because its diagonal can be left out.  Answers for diagonals at a reflex corner; the others are not asked about.
  bool sees(std::uint32_t i, std::uint32_t k) const {
    if (!reflex_[i] && !reflex_[k] && k - i > 2 && i != 0) return false;
    if (!in_angle(i, k) || !in_angle(k, i)) return false;
    Sign side = turn(i, k, n_ - 1);
    for (std::uint32_t a = n_ - 1, b = 0; b < n_; a = b++) {
      const Sign last = side;
      side = turn(i, k, b);
      if (static_cast<int>(last) * static_cast<int>(side) < 0 &&
          static_cast<int>(turn(a, b, i)) * static_cast<int>(turn(a, b, k)) < 0)
        return false;
      if (b != i && b != k && side == Sign::zero &&
          compare_xy(points_[i], points_[b]) == compare_xy(points_[b], points_[k]) &&
          (!in_angle(b, i) || !in_angle(b, k)))
        return false;
    }
    return true;
  }

  void from_reflex(std::uint32_t i, std::uint32_t k) {
    for (std::uint32_t j = i + 1; j < k; ++j)
      if (reflex_[k] || reflex_[j] || j + 1 == k) join_at_i(i, j, k);
  }
  void to_reflex(std::uint32_t i, std::uint32_t k) {
    for (std::uint32_t j = i + 1; j < k; ++j)
      if (j == i + 1 || reflex_[j]) join_at_k(i, j, k);
  }

  // Joins the triangle i, j, k at the diagonal from i to k with the piece beyond i, j if that stays convex.
  void join_at_i(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    if (!is_known(i, j) || !is_known(j, k)) return;
    std::uint32_t at_i = j, diagonals = chain(i, j).diagonals;
    if (k - j > 1) diagonals += chain(j, k).diagonals + 1;
    if (j - i > 1) {
      std::optional<Narrow> last;
      for (const Narrow& pair : chain(i, j).narrow) {
        if (bends(pair.at_k, j, k)) break;
        last = pair;
      }
      if (last && !bends(k, i, last->at_i))
        at_i = last->at_i;
      else
        ++diagonals;
    }
    keep(chain(i, k), diagonals, {at_i, j});
  }
  void join_at_k(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    if (!is_known(i, j) || !is_known(j, k)) return;
    std::uint32_t at_k = j, diagonals = chain(j, k).diagonals;
    if (j - i > 1) diagonals += chain(i, j).diagonals + 1;
    if (k - j > 1) {
      std::optional<Narrow> last;
      const auto& pairs = chain(j, k).narrow;
      for (auto pair = pairs.rbegin(); pair != pairs.rend() && !bends(i, j, pair->at_i); ++pair) last = *pair;
      if (last && !bends(last->at_k, k, i))
        at_k = last->at_k;
      else
        ++diagonals;
    }
    keep(chain(i, k), diagonals, {j, at_k});
  }
  static void keep(Chain& of, std::uint32_t diagonals, const Narrow& pair) {
    if (diagonals > of.diagonals) return;
    if (diagonals < of.diagonals) {
      of.diagonals = diagonals;
      of.narrow.assign(1, pair);
      return;
    }
    if (!of.narrow.empty() && pair.at_i <= of.narrow.back().at_i) return;
    while (!of.narrow.empty() && of.narrow.back().at_k >= pair.at_k) of.narrow.pop_back();
    of.narrow.push_back(pair);
  }

  struct Step {
    std::uint32_t j;
    bool first_is_cut, second_is_cut;  // is i, j a diagonal of the answer, and j, k?
    Narrow pair;
  };
  Step step(std::uint32_t i, std::uint32_t k) {
    const auto& pairs = chain(i, k).narrow;
    if (reflex_[i]) return {pairs.front().at_k, pairs.front().at_i == pairs.front().at_k, true, pairs.front()};
    return {pairs.back().at_i, true, pairs.back().at_i == pairs.back().at_k, pairs.back()};
  }

  // Leaves for each chain of the answer the pair alone that its neighbor was joined with.
  void mark_narrow() {
    std::vector<std::array<std::uint32_t, 2>> pending{{0, n_ - 1}};
    while (!pending.empty()) {
      const auto [i, k] = pending.back();
      pending.pop_back();
      if (k - i <= 1) continue;
      const Step s = step(i, k);
      if (!s.first_is_cut) {
        auto& pairs = chain(i, s.j).narrow;
        const auto wanted = [&](const Narrow& pair) { return pair.at_i == s.pair.at_i; };
        pairs = {*std::find_if(pairs.begin(), pairs.end(), wanted)};
      }
      if (!s.second_is_cut) {
        auto& pairs = chain(s.j, k).narrow;
        const auto wanted = [&](const Narrow& pair) { return pair.at_k == s.pair.at_k; };
        pairs = {*std::find_if(pairs.begin(), pairs.end(), wanted)};
      }
      pending.push_back({i, s.j});
      pending.push_back({s.j, k});
    }
  }

  std::vector<Numbers> collect() {
    std::vector<Numbers> pieces;
    std::vector<std::array<std::uint32_t, 2>> cuts{{0, n_ - 1}};
    while (!cuts.empty()) {
      const auto cut = cuts.back();
      cuts.pop_back();
      if (cut[1] - cut[0] <= 1) continue;
      Numbers piece{cut[0], cut[1]};
      std::vector<std::array<std::uint32_t, 2>> within{cut};
      while (!within.empty()) {
        const auto [i, k] = within.back();
        within.pop_back();
        if (k - i <= 1) continue;
        const Step s = step(i, k);
        piece.push_back(s.j);
        (s.first_is_cut ? cuts : within).push_back({i, s.j});
        (s.second_is_cut ? cuts : within).push_back({s.j, k});
      }
      std::sort(piece.begin(), piece.end());
      pieces.push_back(piece);
    }
    return pieces;
  }

  std::span<const Point2> points_;
  std::uint32_t n_;
  std::vector<bool> reflex_;
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> fewest_convex_pieces(const Polygon2& polygon) {
  surface::require_points("fewest_convex_pieces", polygon.vertices);
  const std::optional<Sign> turn = surface::turn_of_simple_ring(polygon.vertices);
  if (!turn) throw InvalidShape("fewest_convex_pieces: the polygon touches or crosses itself; ask convex_pieces");
  if (*turn == Sign::positive) return FewestPieces(polygon.vertices).run();
  const std::vector<Point2> turned(polygon.vertices.rbegin(), polygon.vertices.rend());
  std::vector<std::vector<std::uint32_t>> pieces = FewestPieces(turned).run();
  for (auto& piece : pieces)
    for (std::uint32_t& corner : piece) corner = static_cast<std::uint32_t>(turned.size()) - 1 - corner;
  return pieces;
}

}  // namespace plumb
