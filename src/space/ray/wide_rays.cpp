#include "space/ray/wide_rays.hpp"

#include <algorithm>
#include <new>

#include "certify/batch/instruction_sets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "space/ray/wide_rays.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "space/ray/by_turns.hpp"
#include "space/ray/packet_walk.hpp"

HWY_BEFORE_NAMESPACE();
namespace plumb::space::HWY_NAMESPACE {
namespace {

template <class Mesh>
void visit_by_turns(const Mesh& mesh, std::span<const RayTask> tasks) {
  std::size_t begun = 0;
  ByTurns<Walk<Mesh>, rays_together>().run([&](std::byte* memory) {
    if (begun == tasks.size()) return false;
    new (memory) Walk<Mesh>(tasks[begun++], mesh);
    return true;
  });
}

template <class Mesh>
void visit_packets(const Mesh& mesh, std::span<const RayTask> tasks) {
  std::size_t begun = 0;
  ByTurns<PacketWalk<Mesh>, packets_together>().run([&](std::byte* memory) {
    if (begun == tasks.size()) return false;
    const auto packet = tasks.subspan(begun, std::min(packet_size, tasks.size() - begun));
    new (memory) PacketWalk<Mesh>(packet, mesh);
    begun += packet.size();
    return true;
  });
}

/// Packets where they fit, one after the other.
template <class Mesh>
void visit_each(const Mesh& mesh, std::span<const RayTask> tasks) {
  if (tasks.size() == 1) {
    Walk<Mesh>(tasks[0], mesh).walk_to_end();
    return;
  }
  const auto packet = [&](std::size_t from) { return tasks.subspan(from, std::min(packet_size, tasks.size() - from)); };
  for (std::size_t from = 0, to = 0; from < tasks.size(); from = to) {
    const bool fit = PacketSlabs::fit(packet(from));
    do {
      to += packet(to).size();
    } while (to < tasks.size() && PacketSlabs::fit(packet(to)) == fit);
    const auto part = tasks.subspan(from, to - from);
    if (fit)
      visit_packets(mesh, part);
    else
      visit_by_turns(mesh, part);
  }
}
void visit_wide(const Bvh& bvh, std::span<const RayTask> tasks) { visit_each(bvh, tasks); }
void visit_compact(const CompactBvh& bvh, std::span<const RayTask> tasks) { visit_each(bvh, tasks); }

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

HWY_EXPORT(visit_wide);
HWY_EXPORT(visit_compact);

}  // namespace

void visit_triangles(const Bvh& bvh, std::span<const RayTask> tasks) {
  if (!bvh.wide.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_wide)(bvh, tasks);
}
void visit_triangles(const CompactBvh& bvh, std::span<const RayTask> tasks) {
  if (!bvh.tree.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_compact)(bvh, tasks);
}

}  // namespace plumb::space
#endif
