#include "query/contact/quick_match.hpp"

#include "query/contact/facing_sides.hpp"
#include "query/penetration/two_boxes.hpp"

namespace plumb::query::touching {
namespace {

/// A guess, or what is level where it is a side.
template <class Numbers>
std::uint32_t guessed_side(const parting::SumLevel& level, const Numbers& along, const Numbers& square) {
  std::uint32_t best = 3;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if ((level.free >> k & 1) != 0) continue;
    const auto part = [&](std::uint32_t i) { return along[i].value * along[i].value; };
    if (best == 3 || part(k) * square[best].value > part(best) * square[k].value) best = k;
  }
  return best == 3 ? 0 : best;
}

Facing facing_of(const Seen& seen, const FacingSide& side) {
  const Index base = side.upper ? Index{1} << side.axis : 0;
  const Index i = Index{1} << (side.axis + 1) % 3, j = Index{1} << (side.axis + 2) % 3;
  const std::array<Index, 4> corners{base, base | i, base | i | j, base | j};
  Facing f;
  for (std::size_t k = 0; k < 4; ++k) f.corners.push_back(corners[side.forth ? k : 3 - k]);
  for (std::size_t k = 0; k < 4; ++k) f.edges.push_back(edge_between(seen, f.corners[k], f.corners[(k + 1) % 4]));
  f.face = surface_feature(seen, FeatureKind::face, 2 * side.axis + (side.upper ? 1 : 0));
  return f;
}

/// Are they told?
template <class Box>
bool match_such(const Pair& pair, Matched& m) {
  const Difference d = pair.difference();
  const auto spanned = pair.way().spanned_by();
  if (!spanned) return false;
  const auto a = parting::box_of<Box>(d.a);
  if (!a) return false;
  const auto b = parting::box_of<Box>(d.b);
  if (!b) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!d.a.has_length(k) || !d.b.has_length(k)) return false;
  }
  using Sides = FacingSidesOf<Box>;
  const auto level = [&](std::size_t i) {
    return typename Sides::Level{m.seen[i].level->first, m.seen[i].level->free};
  };
  const auto guess = [&](std::size_t i, const auto& along, const auto& square) {
    return guessed_side(*m.seen[i].level, along, square);
  };
  FloatWorld<Sides> world;
  // The way leads from b to a.
  const auto told = Sides{}(world, {*a, *b}, {level(0), level(1)}, (*spanned)[1], (*spanned)[0], guess);
  if (!told.is_told || !world.certain()) return false;
  for (std::size_t i = 0; i < 2; ++i) m.facing[i] = facing_of(m.seen[i], told.side[i]);
  m.corners = found_corners({m.seen[0], m.facing[0]}, {m.seen[1], m.facing[1]}, touching::Sides(told.sign[0]),
                            touching::Sides(told.sign[1]));
  return true;
}

}  // namespace

bool match_boxes(const Pair& pair, Matched& m) {
  if (m.seen[0].level == nullptr || m.seen[1].level == nullptr) return false;
  const Difference d = pair.difference();
  return d.a.stands() && d.b.stands() ? match_such<GivenBox>(pair, m) : match_such<PosedBox>(pair, m);
}

}  // namespace plumb::query::touching
