// GJK as others do it: do two hulls of points meet?  libccd, FCL and Bullet, where the build has found them.
//
// Laws: none; they are on trial.
// Source: libccd 2.1, FCL 0.7, Bullet 3.24.
// Cost: theirs.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace plumb::bench {

struct GjkRival {
  std::string name;
  std::shared_ptr<void> (*make)(const std::vector<double>& numbers);
  bool (*meet)(const void* a, const void* b);
};

/// Those that are linked: all of this folder whose library was found.
std::vector<GjkRival> gjk_rivals();

/// One of each library, or none where it was not found.
std::vector<GjkRival> gjk_ccd_rival();
std::vector<GjkRival> gjk_fcl_rival();
std::vector<GjkRival> gjk_bullet_rival();

}  // namespace plumb::bench
