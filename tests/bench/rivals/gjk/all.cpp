#include "bench/rivals/gjk/rival.hpp"

namespace plumb::bench {

std::vector<GjkRival> gjk_rivals() {
  std::vector<GjkRival> all;
  for (auto* some : {gjk_ccd_rival, gjk_fcl_rival, gjk_bullet_rival}) {
    for (GjkRival& r : some()) all.push_back(std::move(r));
  }
  return all;
}

}  // namespace plumb::bench
