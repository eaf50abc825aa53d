// Affine maps: what is a set under a pose, and what goes into a set under one?  Images and preimages in rationals, of
// any matrix.
//
// Laws: (1) exact.  (2) The image of a set's generators generates its image; relative interiors go to relative
// interiors (Rockafellar 6.6).  (3) The preimage is that of the set's part in the map's range, and lines along which
// nothing changes; its relative interior is that of the set's own where this meets the range (6.7).  (4) A similarity
// has columns at right angles and of one length, exactly: what is round stays round.
// Source: RTCD 3.2; Rockafellar, Convex Analysis, 1970, section 6.
// Cost: GMP; some microseconds a generator.
#pragma once

#include <optional>

#include "plumb/query/body/posed.hpp"
#include "query/convex/flat_set.hpp"

namespace plumb::query {

/// sum of columns[k] * x[k] + translation.
struct ExactMap {
  std::array<Exact3, 3> columns;
  Exact3 translation;
  friend bool operator==(const ExactMap&, const ExactMap&) = default;
};
/// Of the plane z = 0, and as it is along z.  A quaternion is not zero.
ExactMap exact_map(const AnyPoseView& pose);
ExactMap exact_identity();

/// The matrix alone.
Exact3 turned(const ExactMap& map, const Exact3& v);
Exact3 image(const ExactMap& map, const Exact3& p);
FlatSet image(const ExactMap& map, const FlatSet& s);
/// First the inner map, then the outer one.
ExactMap composed(const ExactMap& outer, const ExactMap& inner);

bool is_singular(const ExactMap& map);
/// Of a map that is not singular.
ExactMap inverse(const ExactMap& map);

struct Preimage {
  FlatSet set;
  bool of_inside;  // the set's relative interior meets the map's range
};
Preimage preimage(const ExactMap& map, const FlatSet& s);

/// The square of what lengths are multiplied by, in the plane or in space; of similarities alone.
std::optional<mpq_class> squared_scale(const ExactMap& map, int dimension);

}  // namespace plumb::query
