// Which plane should divide these pieces?  A guess, by balance and splits.
//
// Law: what is chosen decides nothing but how large the tree becomes; the caller looks exactly at what a plane does.
// Source: RTCD 8.3.1, 8.3.2.
// Cost: at most 256 of the pieces are looked at for each plane.
#pragma once

#include <optional>

#include "plumb/space/bsp/build_bsp.hpp"
#include "space/bsp/piece_list.hpp"

namespace plumb::space {

struct PlaneChoice {
  std::optional<std::uint32_t> face;   // whose plane is not used yet; none where all are
  std::optional<BspAxisPlane> across;  // where it seems better
};

PlaneChoice choose_plane(const BspTree& tree, const PieceList& list, const BspOptions& options);

}  // namespace plumb::space
