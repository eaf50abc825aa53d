// What is a world made of?  Its bodies by slot, the pairs of boxes that are near, and what the last commit told.
//
// Laws: `near` is sorted as answers are, and holds each pair of boxes that overlapped at the last commit and that masks
// admit; what is known of one is known of its bodies as they were then.
// Source: RTCD 2.4.1.
// Cost: none.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "plumb/world/world.hpp"
#include "world/placed.hpp"

namespace plumb {

namespace world {

inline auto order_of(const WorldPair& p) { return std::tie(p.id_a, p.id_b, p.a, p.b); }
inline bool comes_before(const WorldPair& p, const WorldPair& q) { return order_of(p) < order_of(q); }

inline HandlePair by_handles(const BodyHandle& a, const BodyHandle& b) {
  return a < b ? HandlePair{a, b} : HandlePair{b, a};
}

/// Says of an error what it is about; whom() tells.
template <class Whom, class Call>
auto about(const Whom& whom, const Call& call) {
  const auto text = [&](const Error& e) { return whom() + ": " + e.what(); };
  try {
    return call();
  } catch (const NonFinite& e) {
    throw NonFinite(text(e));
  } catch (const InvalidShape& e) {
    throw InvalidShape(text(e));
  } catch (const UnevenPose& e) {
    throw UnevenPose(text(e));
  } catch (const BeyondDoubles& e) {
    throw BeyondDoubles(text(e));
  } catch (const Unsupported& e) {
    throw Unsupported(text(e));
  }
}

template <class Call>
auto about_body(const char* function, std::uint64_t user_id, const Call& call) {
  return about([&] { return std::string(function) + ": body " + std::to_string(user_id); }, call);
}

/// A pair of boxes that overlap.
struct NearPair {
  WorldPair pair;         // its relation is that of the last time that it was asked
  bool is_known = false;  // of the bodies as they are
};

struct WorldBody {
  std::vector<AnyBody::Part> parts;
  AnyPose pose;
  std::vector<Placed> placed;  // part by part
  Aabb3 box;                   // around all of them, without the margin
  BodyOptions options;
  std::optional<AnyFigure> proxy;  // where it stands
  BodyHandle handle{};
};

/// Do the proxies, or what is there in their place, say that the bodies have no point in common?  Bodies without a
/// proxy, of which this is not known at less cost than by asking them, are not.
bool are_apart_by_proxies(const WorldBody& a, const WorldBody& b);

inline Aabb3 joined(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

}  // namespace world

struct CollisionWorld::State {
  CollisionWorldOptions options;
  MovingBoxes boxes;
  std::vector<std::optional<world::WorldBody>> bodies;  // by slot
  std::vector<std::uint8_t> is_changed;                 // likewise, since the last commit
  std::vector<std::uint32_t> changed;                   // these slots, each once
  std::set<HandlePair> allowed;
  std::shared_ptr<void> filter;
  AskFilter ask_filter = nullptr;
  std::vector<world::NearPair> near;
  bool is_near_lost = false;  // memory ran out between the boxes' changes and what they change
  std::vector<WorldPair> pairs;
  WorldEvents events;
  std::vector<WorldContact> contacts, contacts_room;  // the room of those of the commit before is used again
  WorldContactEvents contact_events;

  [[nodiscard]] const world::WorldBody& body(const char* function, const BodyHandle& handle) const {
    if (!boxes.contains(handle)) {
      throw StaleHandle(std::string(function) + ": no body has slot " + std::to_string(handle.slot) +
                        " and generation " + std::to_string(handle.generation) + "; was it removed?");
    }
    return *bodies[handle.slot];
  }
  [[nodiscard]] world::WorldBody& body(const char* function, const BodyHandle& handle) {
    static_cast<void>(std::as_const(*this).body(function, handle));
    return *bodies[handle.slot];
  }
  void note_changed(std::uint32_t slot) {
    if (is_changed[slot] == 0) changed.push_back(slot);
    is_changed[slot] = 1;
  }

  [[nodiscard]] BodyHandle handle(std::uint32_t slot) const { return bodies[slot]->handle; }
  /// Nothing where masks leave it out.
  [[nodiscard]] std::optional<WorldPair> pair_of(const BodyHandle& a, const BodyHandle& b) const;
  /// By the matrix and the filter.
  [[nodiscard]] bool is_admitted(const WorldPair& p) const {
    if (!allowed.empty() && allowed.contains(world::by_handles(p.a, p.b))) return false;
    return ask_filter == nullptr || ask_filter(filter.get(), p.a, p.b);
  }
  /// Brings `near` to what the boxes are now.
  void update_near();
  /// Those of them that no filter leaves out now, by their places in `near`.
  [[nodiscard]] std::vector<std::size_t> admitted() const;
};

}  // namespace plumb
