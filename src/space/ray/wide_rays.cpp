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
  ByTurns<Walk<Mesh>, rays_together> turns;  // not {}, which would fill its memory
  turns.run([&](std::byte* memory) {
    if (begun == tasks.size()) return false;
    new (memory) Walk<Mesh>(tasks[begun++], mesh);
    return true;
  });
}

template <class Mesh>
void visit_together(const Mesh& mesh, std::span<const PacketTask> packets) {
  std::size_t begun = 0;
  ByTurns<PacketWalk<Mesh>, packets_together> turns;
  turns.run([&](std::byte* memory) {
    if (begun == packets.size()) return false;
    new (memory) PacketWalk<Mesh>(packets[begun++], mesh);
    return true;
  });
}

/// Together where they are near and fit, else by turns.
template <class Mesh>
void visit_each(const Mesh& mesh, std::span<const RayTask> tasks, bool are_near) {
  if (tasks.size() == 1) {
    Walk<Mesh>(tasks[0], mesh).walk_to_end();
    return;
  }
  if (!are_near) return visit_by_turns(mesh, tasks);
  std::array<PacketTask, packets_together> packets;
  std::size_t others = 0, taken = 0, fit = 0;  // others from, and up to; packets since then
  const auto visit_packets = [&] {
    visit_together(mesh, std::span<const PacketTask>(packets).first(fit));
    fit = 0;
  };
  while (taken < tasks.size()) {
    const auto next = tasks.subspan(taken, std::min(packet_size, tasks.size() - taken));
    taken += next.size();
    if (!put_packet(next, packets[fit])) continue;
    visit_by_turns(mesh, tasks.subspan(others, taken - next.size() - others));
    others = taken;
    if (++fit == packets.size()) visit_packets();
  }
  visit_packets();
  visit_by_turns(mesh, tasks.subspan(others));
}
void visit_wide(const Bvh& bvh, std::span<const RayTask> tasks, bool are_near) { visit_each(bvh, tasks, are_near); }
void visit_compact(const CompactBvh& bvh, std::span<const RayTask> tasks, bool are_near) {
  visit_each(bvh, tasks, are_near);
}
void visit_wide_packets(const Bvh& bvh, std::span<const PacketTask> packets) { visit_together(bvh, packets); }
void visit_compact_packets(const CompactBvh& bvh, std::span<const PacketTask> packets) { visit_together(bvh, packets); }

}  // namespace
}  // namespace plumb::space::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "certify/batch/chosen_target.hpp"

namespace plumb::space {
namespace {

PLUMB_EXPORT(visit_wide);
PLUMB_EXPORT(visit_compact);
PLUMB_EXPORT(visit_wide_packets);
PLUMB_EXPORT(visit_compact_packets);

}  // namespace

void visit_triangles(const Bvh& bvh, std::span<const RayTask> tasks, bool are_near) {
  if (!bvh.wide.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_wide)(bvh, tasks, are_near);
}
void visit_triangles(const CompactBvh& bvh, std::span<const RayTask> tasks, bool are_near) {
  if (!bvh.tree.nodes.empty() && !tasks.empty()) PLUMB_DISPATCH(visit_compact)(bvh, tasks, are_near);
}
void visit_triangles(const Bvh& bvh, std::span<const PacketTask> packets) {
  if (!bvh.wide.nodes.empty()) PLUMB_DISPATCH(visit_wide_packets)(bvh, packets);
}
void visit_triangles(const CompactBvh& bvh, std::span<const PacketTask> packets) {
  if (!bvh.tree.nodes.empty()) PLUMB_DISPATCH(visit_compact_packets)(bvh, packets);
}

}  // namespace plumb::space
#endif
