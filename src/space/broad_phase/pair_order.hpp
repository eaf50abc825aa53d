// In which order are pairs told, and which are in two lists at once?
//
// Laws: by a, then by b.  What is told depends on the pairs alone.
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (distribution by a, insertion by b).
// Cost: some 5 ns a pair.
#pragma once

#include <vector>

#include "plumb/space/pairs/box_pair.hpp"

namespace plumb::space {

/// The other vector is for work.
void sort_pairs(std::vector<BoxPair>& pairs, std::vector<BoxPair>& other);

/// Of sorted pairs, each there once: leaves in each list those that are not in the other.
void strike_off_common(std::vector<BoxPair>& lost, std::vector<BoxPair>& added);

}  // namespace plumb::space
