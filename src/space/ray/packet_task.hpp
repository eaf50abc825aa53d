// Which rays can descend together?  Up to sixteen that go the same way along each axis.
//
//   PacketTask task;
//   if (put_packet(tasks, task)) visit_triangles(bvh, {&task, 1});       // the same calls as visit_triangles(bvh, tasks)
//
// Law: of rays that fit nothing is said of how close they lie, and nothing need be.
// Source: RTCD 6.6.7.
// Cost: copies; put_plainly takes a few ns a ray where RaySlabs takes some 20.
#pragma once

#include <cstddef>
#include <span>

#include "plumb/space/ray/ray_slabs.hpp"
#include "space/ray/wide_rays.hpp"

namespace plumb::space {

/// So many go down as one, and so many of these by turns.
inline constexpr std::size_t packet_size = 16, packets_together = 4;

/// RaySlabs::Planes number by number, where a box is entered and where it is left.
struct PacketPlanes {
  struct Plane {
    alignas(64) std::array<double, packet_size> from, rate;
  };
  std::array<Plane, 3> enter, leave;
  std::array<bool, 3> down;  // entered at its max

  void put(std::size_t axis, std::size_t ray, double enter_from, double enter_rate, double leave_from,
           double leave_rate) {
    enter[axis].from[ray] = enter_from, enter[axis].rate[ray] = enter_rate;
    leave[axis].from[ray] = leave_from, leave[axis].rate[ray] = leave_rate;
  }
};

struct PacketTask {
  std::size_t size;  // beyond it the planes repeat a ray, which is asked nothing
  PacketPlanes planes;
  std::array<AskedRay, packet_size> asked;
  std::array<double, packet_size> limits;
};

/// The planes of rays, segments among them, in most trees: those of RaySlabs, whose keys are as these say.  False where
/// some do not fit, or are not so plain.
inline constexpr RaySlabs::Keys plain_ray{}, plain_segment{.limit = 1};
bool put_plainly(std::span<const AnyRay* const> rays, const BoxFrame& frame, const FloatBox3& all,
                 PacketPlanes& planes);

/// False where some do not fit.
bool put_packet(std::span<const RayTask> tasks, PacketTask& packet);

void visit_triangles(const Bvh& bvh, std::span<const PacketTask> packets);
void visit_triangles(const CompactBvh& bvh, std::span<const PacketTask> packets);

}  // namespace plumb::space
