// Along which normal are two bodies in contact?  The direction from the nearest points of cores that are apart, or that
// of the least translation that parts them.
//
// Laws: exact; of bodies that overlap the direction is penetration's.  `at`: a corner of each core that is no less far
// along the normal than any.  `level`: of a sum of edges what lies as far, `all`: of other bodies; where it is known.
// Source: query/separation/proved_corners.hpp, query/penetration/parted.hpp.
// Cost: that of both.
#pragma once

#include "plumb/query/contact/contact.hpp"
#include "query/penetration/parted.hpp"
#include "query/penetration/separating_axes.hpp"

namespace plumb::query::touching {

using parting::Difference, parting::Ends, parting::Way;

struct Aim {
  Way way;  // from b to a
  Ends at;
  bool are_apart;  // the cores
  std::optional<std::array<parting::SumLevel, 2>> level{};
  std::optional<std::array<parting::LevelCorners, 2>> all{};
  bool is_proved = true, is_widest = true;  // no other plane has a wider gap
  bool do_touch = false;                    // the cores, for certain
};

/// May the answer be a plane between sums of edges that are apart, and which one?
enum class Guess : unsigned char { likely, widest, none };

/// Of sums of edges that are apart: the plane between them that was found before, where it still is one.  It is proved
/// where the points that are farthest have two that are straight ahead of one another; proved or not, the bodies are apart
/// by no less.
std::optional<Aim> cached_aim(const Difference& d, const ContactCache& cache);

Aim aim_at(const Difference& d, Guess guess, ContactCache* cache);

}  // namespace plumb::query::touching
