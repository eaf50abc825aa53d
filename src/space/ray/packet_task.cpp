#include "space/ray/packet_task.hpp"

#include <algorithm>
#include <cmath>

namespace plumb::space {
namespace {

/// Of rates that are all infinite no bound is 0 times infinity: places differ from `from` then (RaySlabs).
bool go_alike(const RaySlabs::Planes& a, const RaySlabs::Planes& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if ((a.low_rate[k] < 0) != (b.low_rate[k] < 0) || std::isinf(a.low_rate[k]) != std::isinf(b.low_rate[k]) ||
        std::isinf(a.high_rate[k]) != std::isinf(b.high_rate[k]))
      return false;
  }
  return true;
}

}  // namespace

bool put_packet(std::span<const RayTask> tasks, PacketTask& packet) {
  const RaySlabs::Planes& first = tasks[0].planes;
  for (const RayTask& task : tasks) {
    if (task.planes.all_met || !go_alike(first, task.planes)) return false;
  }
  packet.size = tasks.size();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    packet.asked[i] = tasks[i].asked;
    packet.limits[i] = tasks[i].limit;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    packet.planes.down[k] = first.low_rate[k] < 0;
    for (std::size_t i = 0; i < packet_size; ++i) {
      const RaySlabs::Planes& p = tasks[std::min(i, tasks.size() - 1)].planes;
      if (packet.planes.down[k]) {
        packet.planes.put(k, i, p.high_from[k], p.high_rate[k], p.low_from[k], p.low_rate[k]);
      } else {
        packet.planes.put(k, i, p.low_from[k], p.low_rate[k], p.high_from[k], p.high_rate[k]);
      }
    }
  }
  return true;
}

}  // namespace plumb::space
