// Model no more than the scene needs: for which bodies of a world does a proxy pay, and which one?
//
//   const WorldPlan scene = plan(world);
//   adopt(world, scene);                   // every answer stays what it was
//   for (const BodyPlan& b : scene.bodies) use(b.user_id, name_of(b.proxy), b.saved);
//
// What is counted are questions about two figures, or triangles: those that commit() would ask of the pairs whose boxes
// overlap now, and that no filter leaves out, if none was known.  Of two meshes these are the pairs of triangles near the
// other mesh whose boxes overlap.  A pair of which a body has a proxy costs one question more, and saves all others where
// the proxies are apart.  Pairs that meet count as if no question told so before the last.
// Laws: (1) questions_with is at most questions_without, and the counts depend on the world alone.  (2) A proxy is taken only
// where its body saves questions by it, with what the others take: saved is then how many more there would be without it,
// one at least.  (3) Taking or leaving any proxy alone saves no more.  (4) The answers of a world that adopts a plan, of
// this world or of one as it was before, are those that it gave without.
// The index says what each broad phase is expected to take (space/broad_phase/choose_index.hpp); a world has that which is
// kept from frame to frame.  It is nothing of an empty world.
// Source: RTCD 2.2.2, 2.4.1.
// Cost: that of proxies of each kind for each body that may need one, some times a commit's questions for boxes and proxies.
// Nothing is searched but by overlapping_pairs and trees; a round that gains is linear in the pairs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/space/broad_phase/choose_index.hpp"
#include "plumb/world/world.hpp"

namespace plumb {

struct WorldPlanOptions {
  double moving_share = 1;  // of the bodies, from one frame to the next; for the index alone
};

/// A body that is no single figure, and is in a pair of several questions.
struct BodyPlan {
  BodyHandle body;
  std::uint64_t user_id = 0;
  ProxyKind proxy = ProxyKind::none;
  std::size_t pairs = 0, told_apart = 0;  // it is in, and of these by the proxies
  std::size_t saved = 0;                  // questions
  friend bool operator==(const BodyPlan&, const BodyPlan&) = default;
};

struct WorldPlan {
  std::vector<BodyPlan> bodies;  // by user ids, then handles
  std::size_t questions_without = 0, questions_with = 0;
  std::optional<IndexChoice> index;
};

WorldPlan plan(const CollisionWorld& world, const WorldPlanOptions& options);
inline WorldPlan plan(const CollisionWorld& world) { return plan(world, {}); }

/// Gives each body the proxy of the plan.  A body that is no longer there throws StaleHandle.
void adopt(CollisionWorld& world, const WorldPlan& taken);

}  // namespace plumb
