#include "plumb/space/closest/closest_triangles.hpp"

#include "plumb/space/closest/posed_closest.hpp"
#include "space/closest/closest_pair_search.hpp"

namespace plumb {
namespace space {
namespace {

StandingSource source_of(const Bvh& mesh) { return StandingSource(mesh); }
PosedSource source_of(const PosedMesh& mesh) { return PosedSource(mesh); }
void require_mesh(const char*, const char*, const Bvh&) {}
void require_mesh(const char* function, const char* name, const PosedMesh& mesh) {
  require_pose(function, name, mesh.pose);
}

/// Under one rigid pose no distance changes.
bool are_moved_as_one(const Bvh&, const Bvh&) { return false; }
bool are_moved_as_one(const PosedMesh& a, const PosedMesh& b) { return a.pose.matrix() == nullptr && a.pose == b.pose; }
const Bvh& unmoved(const Bvh& mesh) { return mesh; }
const Bvh& unmoved(const PosedMesh& mesh) { return mesh.bvh; }

struct NearSlots {
  std::uint32_t a, b, slot_a, slot_b;
};

/// What search.run() or another question answers, or `none` where no pair can be.
template <class Answer, class Source, class Ask>
Answer ask_sources(Source a, Source b, const ClosestPairOptions& options, const Answer& none, const Ask& ask) {
  if (a.bvh().slots() == 0 || b.bvh().slots() == 0 || options.within < 0) return none;
  ClosestSearch<Source> search(a, b, options);
  return ask(search);
}
template <class Answer, class Mesh, class Ask>
Answer ask_pair(const char* function, const Mesh& a, const Mesh& b, const ClosestPairOptions& options,
                const Answer& none, const Ask& ask) {
  require_mesh(function, "a", a), require_mesh(function, "b", b);
  if (options.within != options.within)
    throw NonFinite(std::string(function) + ": the distance is nan, not a real number; give one, or infinity");
  if (are_moved_as_one(a, b))
    return ask_sources(StandingSource(unmoved(a)), StandingSource(unmoved(b)), options, none, ask);
  return ask_sources(source_of(a), source_of(b), options, none, ask);
}

template <class Mesh>
std::optional<ClosestTriangles> closest_pair(const Mesh& a, const Mesh& b, const ClosestPairOptions& options) {
  const auto found = ask_pair("closest_triangles", a, b, options, std::optional<NearSlots>(), [](auto& search) {
    const auto best = search.run();
    return best ? std::optional(NearSlots{best->a, best->b, best->slot_a, best->slot_b}) : std::nullopt;
  });
  if (!found) return {};
  using Source = decltype(source_of(a));
  return ClosestTriangles{found->a, found->b, Source::closest(a.triangle(found->slot_a), b.triangle(found->slot_b))};
}
template <class Mesh>
double pair_distance(const Mesh& a, const Mesh& b) {
  return ask_pair("distance", a, b, {}, beyond_all, [](auto& search) { return search.run()->distance; });
}
template <class Mesh>
bool is_pair_within(const Mesh& a, const Mesh& b, double distance) {
  return ask_pair("within", a, b, {.within = distance}, false, [](auto& search) { return search.finds_any(); });
}

}  // namespace
}  // namespace space

std::optional<ClosestTriangles> closest_triangles(const Bvh& a, const Bvh& b, const ClosestPairOptions& options) {
  return space::closest_pair(a, b, options);
}
double distance(const Bvh& a, const Bvh& b) { return space::pair_distance(a, b); }
bool within(const Bvh& a, const Bvh& b, double distance) { return space::is_pair_within(a, b, distance); }

std::optional<ClosestTriangles> closest_triangles(const PosedMesh& a, const PosedMesh& b,
                                                  const ClosestPairOptions& options) {
  return space::closest_pair(a, b, options);
}
double distance(const PosedMesh& a, const PosedMesh& b) { return space::pair_distance(a, b); }
bool within(const PosedMesh& a, const PosedMesh& b, double distance) { return space::is_pair_within(a, b, distance); }

}  // namespace plumb
