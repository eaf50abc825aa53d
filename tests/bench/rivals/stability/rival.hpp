// Who else tells which bodies of a world meet?  The collision worlds of Bullet and FCL, in doubles, with no margins.
//
// Laws: none; they are on trial.  Bodies touch, to Bullet, where a contact's distance is 0 at most; FCL tells whether.
// Source: the headers of Bullet 3.24 and FCL 0.7.
// Cost: theirs.
#pragma once

#include "lab/stability/experiment.hpp"

namespace plumb::bench {

lab::stability::BodyPairs told_by_bullet(std::span<const lab::stability::WorldBody> bodies);
lab::stability::BodyPairs told_by_fcl(std::span<const lab::stability::WorldBody> bodies);

inline std::vector<lab::stability::WorldRival> world_rivals() {
  return {{"bullet", told_by_bullet}, {"fcl", told_by_fcl}};
}

}  // namespace plumb::bench
