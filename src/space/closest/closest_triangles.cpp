#include "plumb/space/closest/closest_triangles.hpp"

#include "space/closest/closest_pair_search.hpp"

namespace plumb {
namespace {

/// ask(the search), or `none` where no pair can be.
template <class Answer, class Ask>
Answer ask_pair(const char* function, const space::AskedPair& pair, const ClosestPairOptions& options,
                const Answer& none, const Ask& ask) {
  if (options.within != options.within)
    throw NonFinite(std::string(function) + ": the distance is nan, not a real number; give one, or infinity");
  if (pair.a.bvh.slots() == 0 || pair.b.bvh.slots() == 0 || options.within < 0) return none;
  const auto between = [&](auto a, auto b) {
    space::ClosestSearch search(a, b, options);
    return ask(search);
  };
  if (pair.stand() || pair.are_moved_as_one())
    return between(space::StandingSource(pair.a.bvh), space::StandingSource(pair.b.bvh));
  return between(space::PosedSource(pair.a), space::PosedSource(pair.b));
}

struct NearSlots {
  std::uint32_t a, b, slot_a, slot_b;
};

}  // namespace

std::optional<ClosestTriangles> closest_triangles(const BvhView& a, const BvhView& b,
                                                  const ClosestPairOptions& options) {
  const space::AskedPair pair("closest_triangles", a, b);
  const auto found = ask_pair("closest_triangles", pair, options, std::optional<NearSlots>(), [](auto& search) {
    const auto best = search.run();
    return best ? std::optional(NearSlots{best->a, best->b, best->slot_a, best->slot_b}) : std::nullopt;
  });
  if (!found) return {};
  const auto [number_a, number_b, i, k] = *found;
  if (pair.stand()) {
    return ClosestTriangles{number_a, number_b,
                            space::StandingSource::closest(pair.a.bvh.triangle(i), pair.b.bvh.triangle(k))};
  }
  return ClosestTriangles{number_a, number_b, space::PosedSource::closest(pair.a.triangle(i), pair.b.triangle(k))};
}

double distance(const BvhView& a, const BvhView& b) {
  const space::AskedPair pair("distance", a, b);
  return ask_pair("distance", pair, {}, space::beyond_all, [](auto& search) { return search.run()->distance; });
}

bool within(const BvhView& a, const BvhView& b, double distance) {
  const space::AskedPair pair("within", a, b);
  return ask_pair("within", pair, {.within = distance}, false, [](auto& search) { return search.finds_any(); });
}

}  // namespace plumb
