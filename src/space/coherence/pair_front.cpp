// The front in parts, each on one thread; what they become is the front of this frame.
#include "plumb/space/coherence/pair_front.hpp"

#include <algorithm>

#include "space/bvh/parts.hpp"
#include "space/coherence/front_scenes.hpp"
#include "space/coherence/front_walk.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_sources.hpp"

namespace plumb {
namespace space {
namespace {

/// What is worth a part of its own, and how many parts are wanted: they do not depend on threads.
constexpr std::size_t least_front_part = 32, front_parts_wanted = 512;

/// A front so many times as large as that of a descent holds much that a descent would not come to: a guess.
constexpr std::size_t most_growth = 3;

bool are_still_divided(const DividedNodes& divided, std::span<const BoxNode> nodes) {
  return divided.links.size() == nodes.size() && std::ranges::all_of(divided.nodes, [&](std::uint32_t i) {
           return !nodes[i].is_leaf() && nodes[i].link == divided.links[i];
         });
}
void add_divided(DividedNodes& divided, std::span<const BoxNode> nodes, const std::vector<std::uint32_t>& more) {
  for (const std::uint32_t i : more) {
    if (divided.links[i] != 0) continue;
    divided.links[i] = nodes[i].link;
    divided.nodes.push_back(i);
  }
}
/// Of a mesh with itself all is in a.
template <class Scene>
void add_divided(Front& front, const Scene& scene, const FrontPart& part) {
  add_divided(front.divided_a, scene.nodes_a(), part.divided_a);
  add_divided(scene.is_own() ? front.divided_a : front.divided_b, scene.nodes_b(), part.divided_b);
}

template <class Scene>
void begin_at_roots(Front& front, const Scene& scene) {
  front.pairs.assign(1, {0, 0});
  front.divided_a = {{}, std::vector<std::uint32_t>(scene.nodes_a().size())};
  front.divided_b = {{}, std::vector<std::uint32_t>(scene.nodes_b().size())};
  front.is_own = scene.is_own();
}

/// Levels of a descent, until there are enough pairs for parts.
template <class Scene>
void spread(Front& front, const Scene& scene, FrontWork& work) {
  for (bool any = true; any && front.pairs.size() < front_parts_wanted;) {
    FrontWalk<Scene> walk(scene, front.frame, true);
    any = false;
    for (const NodePair pair : front.pairs) any |= walk.one_level(pair);
    add_divided(front, scene, walk.result());
    work.comparisons += walk.result().comparisons;
    front.pairs.swap(walk.result().pairs);
  }
}

template <class Scene>
std::vector<TrianglePair> follow(const char* function, Front& front, FrontWork& work, Scene scene,
                                 const PairOptions& options) {
  work = {};
  if (scene.nodes_a().empty() || scene.nodes_b().empty()) return {};
  if (front.is_stale || front.pairs.size() == 1 || front.is_own != scene.is_own() ||
      !are_still_divided(front.divided_a, scene.nodes_a()) ||
      !(scene.is_own() || are_still_divided(front.divided_b, scene.nodes_b()))) {
    begin_at_roots(front, scene);
    work.from_roots = true;
    front.is_stale = true;  // until there is an answer
  }
  scene.prepare(front, options.execution);
  if (work.from_roots) spread(front, scene, work);
  const std::size_t part_size = std::max(least_front_part, blocks_of(front.pairs.size(), front_parts_wanted));
  std::vector<FrontPart> parts(blocks_of(front.pairs.size(), part_size));
  for_parts(function, options.execution, options.progress, parts.size(), [&](std::size_t part) {
    FrontWalk<Scene> walk(scene, front.frame, options.touching);
    const std::size_t to = std::min(front.pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) walk.from(front.pairs[i]);
    parts[part] = std::move(walk.result());
  });

  std::vector<TrianglePair> found;
  std::size_t tried = 0, parted = 0;
  front.pairs.clear();
  for (const FrontPart& part : parts) {
    front.pairs.insert(front.pairs.end(), part.pairs.begin(), part.pairs.end());
    found.insert(found.end(), part.found.begin(), part.found.end());
    add_divided(front, scene, part);
    work.comparisons += part.comparisons;
    tried += part.tried;
    parted += part.parted;
  }
  if (work.from_roots) front.size_at_first = front.pairs.size();
  front.is_stale = (!work.from_roots && 2 * parted > tried && parted >= front_parts_wanted / 8) ||
                   front.pairs.size() > most_growth * front.size_at_first + front_parts_wanted;
  ++front.frame;
  return found;
}

StandingScene scene_of(const Bvh& a, const Bvh& b, bool is_own) { return {a, b, is_own}; }
MovedScene scene_of(const PosedMesh& a, const PosedMesh& b, bool is_own) { return {a, b, is_own}; }

std::vector<TrianglePair> ordered(std::vector<TrianglePair> pairs, const Bvh& a, std::vector<TrianglePair> rows) {
  std::vector<std::vector<TrianglePair>> parts;
  parts.push_back(std::move(pairs));
  return in_order(std::move(parts), a.triangles.size(), std::move(rows));
}

std::size_t bytes_of(const DividedNodes& divided) {
  return (divided.nodes.capacity() + divided.links.capacity()) * sizeof(std::uint32_t);
}
std::size_t bytes_of(const NeededBoxes& needed) {
  return needed.boxes.capacity() * sizeof(Aabb3) + needed.posed.size();
}

}  // namespace
}  // namespace space

std::vector<TrianglePair> PairFront::intersecting_pairs(const BvhView& a, const BvhView& b, const PairOptions& options,
                                                        std::vector<TrianglePair> rows) {
  constexpr const char* function = "intersecting_pairs";
  return space::with_sources(function, a, b, [&](const auto& s, const auto& t) {
    return space::ordered(space::follow(function, front_, work_, space::scene_of(s, t, false), options),
                          space::mesh_of(s), std::move(rows));
  });
}
std::vector<TrianglePair> PairFront::intersecting_pairs(const BvhView& mesh, const PairOptions& options,
                                                        std::vector<TrianglePair> rows) {
  constexpr const char* function = "intersecting_pairs";
  return space::with_own_source(function, mesh, [&](const auto& s) {
    return space::ordered(space::follow(function, front_, work_, space::scene_of(s, s, true), options),
                          space::mesh_of(s), std::move(rows));
  });
}

std::size_t PairFront::memory() const {
  using space::bytes_of;
  return front_.pairs.capacity() * sizeof(space::NodePair) + bytes_of(front_.divided_a) + bytes_of(front_.divided_b) +
         bytes_of(front_.boxes_a) + bytes_of(front_.boxes_b);
}

}  // namespace plumb
