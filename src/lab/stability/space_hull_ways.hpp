// How is a hull in space commonly computed?  Three algorithms of textbooks, over signs that somebody else takes.
//
// An answer is faces, the indices of their corners counterclockwise seen from outside; no faces for points in a plane;
// none at all where the algorithm did not end within its bound.
// Laws: (1) with exact signs the faces bound the hull, for whatever points there are: every extreme point is a corner,
// no point lies on the outer side of a face, every edge has two faces; gift wrapping gives the hull's own faces, the
// others triangles, of which some may lie side by side in one plane; (2) every loop that wrong signs may keep running
// is bounded by what it needs at most with right ones; a surface of n^2 faces is given up.
// Source: RTCD 3.9.2; Barber, Dobkin and Huhdanpaa 1996 (quickhull); Chand and Kapur 1970 (gift wrapping); Kallay 1981
// (beneath and beyond).
// Cost: n^2 signs as a rule, n^3 for gift wrapping.
#pragma once

#include <optional>

#include "lab/stability/hull_signs.hpp"

namespace plumb::lab::stability {

using Faces = std::vector<std::vector<std::uint32_t>>;

struct SpaceHullWay {
  std::string name, about;
  std::optional<Faces> (*run)(const HullSigns<3>& signs);
};
const std::vector<SpaceHullWay>& space_hull_ways();

}  // namespace plumb::lab::stability
