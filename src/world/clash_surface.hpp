// What of a part is found out when it is first asked?  Whether it is simple, and its hull.
//
// Source: none.
// Cost: that of what is asked for, once.
#pragma once

#include <mutex>

#include "plumb/world/clash.hpp"

namespace plumb {

struct ClashPart::Surface {
  bool plainly_closed = false;
  std::once_flag simple_asked, hull_asked;
  bool simple = false;
  std::vector<std::array<std::uint32_t, 3>> neighbors;
  Hull hull;
};

}  // namespace plumb
