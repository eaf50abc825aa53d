#include "plumb/world/world.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "plumb/query/variant/questions.hpp"

namespace plumb {
namespace {

auto order_of(const WorldPair& p) { return std::tie(p.id_a, p.id_b, p.a, p.b); }
bool comes_before(const WorldPair& p, const WorldPair& q) { return order_of(p) < order_of(q); }

HandlePair by_handles(const BodyHandle& a, const BodyHandle& b) { return a < b ? HandlePair{a, b} : HandlePair{b, a}; }

bool masks_admit(const BodyOptions& a, const BodyOptions& b) {
  return (a.group & b.mask) != 0 && (b.group & a.mask) != 0;
}

/// Says of an error which body it is about.
template <class Call>
auto about_body(const char* function, std::uint64_t user_id, const Call& call) {
  const auto text = [&](const Error& e) {
    return std::string(function) + ": body " + std::to_string(user_id) + ": " + e.what();
  };
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

Aabb3 box_of_body(const char* function, const AnyFigure& figure, std::uint64_t user_id) {
  return about_body(function, user_id, [&] {
    if (figure.dimension() != 3) throw Unsupported("a figure of the plane; a world is of figures of space");
    if (std::holds_alternative<Pose>(figure.pose())) {
      throw UnevenPose("a figure under a matrix; a world takes a RigidPose or a RigidChain");
    }
    return query::any_fit_aabb(figure);
  });
}

}  // namespace

struct CollisionWorld::State {
  struct Body {
    AnyFigure figure;
    BodyOptions options;
    bool is_changed = true;  // since the last commit
  };

  /// What relate has said of a pair of boxes that overlap, for the next commit.
  struct AskedPair {
    HandlePair pair;
    Relation relation;
  };

  MovingBoxes boxes;
  std::vector<std::optional<Body>> bodies;  // by slot
  std::set<HandlePair> allowed;
  std::shared_ptr<void> filter;
  AskFilter ask_filter = nullptr;
  std::vector<AskedPair> asked;  // ascending
  std::vector<WorldPair> pairs;
  WorldEvents events;

  [[nodiscard]] const Body& body(const char* function, const BodyHandle& handle) const {
    if (!boxes.contains(handle)) {
      throw StaleHandle(std::string(function) + ": no body has slot " + std::to_string(handle.slot) +
                        " and generation " + std::to_string(handle.generation) + "; was it removed?");
    }
    return *bodies[handle.slot];
  }
  [[nodiscard]] Body& body(const char* function, const BodyHandle& handle) {
    static_cast<void>(std::as_const(*this).body(function, handle));
    return *bodies[handle.slot];
  }

  void put(const char* function, const BodyHandle& handle, Body& at, const AnyFigure& figure) {
    const Aabb3 box = box_of_body(function, figure, at.options.user_id);
    AnyFigure copy = figure;
    boxes.move(handle, box);
    at.figure = std::move(copy);
    at.is_changed = true;
  }

  /// What relate said at the last commit, where both bodies are as they were.
  [[nodiscard]] std::optional<Relation> known(const HandlePair& pair, const Body& a, const Body& b) const {
    if (a.is_changed || b.is_changed) return {};
    const auto at = std::lower_bound(asked.begin(), asked.end(), pair,
                                     [](const AskedPair& x, const HandlePair& p) { return x.pair < p; });
    if (at == asked.end() || at->pair != pair) return {};
    return at->relation;
  }

  /// The pairs of boxes that overlap and that no filter leaves out, in the order of answers; their relations are not
  /// known yet.
  [[nodiscard]] std::vector<WorldPair> candidates() const {
    std::vector<WorldPair> found;
    for (const HandlePair& p : boxes.overlapping_pairs()) {
      const BodyOptions &a = bodies[p.a.slot]->options, &b = bodies[p.b.slot]->options;
      if (!masks_admit(a, b) || allowed.contains(p)) continue;
      const bool swaps = b.user_id < a.user_id;
      found.push_back(swaps ? WorldPair{b.user_id, a.user_id, p.b, p.a, Relation::disjoint}
                            : WorldPair{a.user_id, b.user_id, p.a, p.b, Relation::disjoint});
    }
    std::sort(found.begin(), found.end(), comes_before);
    if (ask_filter != nullptr) {
      std::erase_if(found, [&](const WorldPair& p) { return !ask_filter(filter.get(), p.a, p.b); });
    }
    return found;
  }
};

CollisionWorld::CollisionWorld() : state_(std::make_unique<State>()) {}
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;
CollisionWorld::~CollisionWorld() = default;

BodyHandle CollisionWorld::add(const AnyFigure& figure, const BodyOptions& options) {
  const Aabb3 box = box_of_body("CollisionWorld::add", figure, options.user_id);
  State::Body made{figure, options};
  const BodyHandle handle = state_->boxes.insert(box);
  try {
    if (state_->bodies.size() <= handle.slot) state_->bodies.resize(std::size_t{handle.slot} + 1);
  } catch (...) {  // memory has run out: the box has no body
    state_->boxes.remove(handle);
    throw;
  }
  state_->bodies[handle.slot] = std::move(made);
  return handle;
}

void CollisionWorld::move(const BodyHandle& body, const RigidPose& pose) {
  State::Body& at = state_->body("CollisionWorld::move", body);
  state_->put("CollisionWorld::move", body, at, at.figure.under(pose));
}

void CollisionWorld::replace(const BodyHandle& body, const AnyFigure& figure) {
  state_->put("CollisionWorld::replace", body, state_->body("CollisionWorld::replace", body), figure);
}

void CollisionWorld::remove(const BodyHandle& body) {
  static_cast<void>(state_->body("CollisionWorld::remove", body));
  state_->boxes.remove(body);
  state_->bodies[body.slot].reset();
  std::erase_if(state_->allowed, [&](const HandlePair& p) { return p.a == body || p.b == body; });
}

bool CollisionWorld::contains(const BodyHandle& body) const { return state_->boxes.contains(body); }
std::size_t CollisionWorld::size() const { return state_->boxes.size(); }
const AnyFigure& CollisionWorld::figure(const BodyHandle& body) const {
  return state_->body("CollisionWorld::figure", body).figure;
}
const BodyOptions& CollisionWorld::options(const BodyHandle& body) const {
  return state_->body("CollisionWorld::options", body).options;
}

void CollisionWorld::allow_collision(const BodyHandle& a, const BodyHandle& b, bool allowed) {
  static_cast<void>(state_->body("CollisionWorld::allow_collision", a));
  static_cast<void>(state_->body("CollisionWorld::allow_collision", b));
  if (allowed) {
    state_->allowed.insert(by_handles(a, b));
  } else {
    state_->allowed.erase(by_handles(a, b));
  }
}

void CollisionWorld::keep_filter(std::shared_ptr<void> filter, AskFilter ask) {
  state_->filter = std::move(filter);
  state_->ask_filter = ask;
}

const WorldEvents& CollisionWorld::commit() {
  State& s = *state_;
  s.boxes.changes();
  std::vector<WorldPair> now;
  std::vector<State::AskedPair> asked;
  for (WorldPair& p : s.candidates()) {
    const HandlePair pair = by_handles(p.a, p.b);
    const State::Body &a = *s.bodies[p.a.slot], &b = *s.bodies[p.b.slot];
    const std::optional<Relation> known = s.known(pair, a, b);
    p.relation = known ? *known : about_body("CollisionWorld::commit", p.id_a, [&] {
      return about_body("and", p.id_b, [&] { return relate(a.figure, b.figure); });
    });
    asked.push_back({pair, p.relation});
    if (p.relation != Relation::disjoint) now.push_back(p);
  }
  std::sort(asked.begin(), asked.end(),
            [](const State::AskedPair& x, const State::AskedPair& y) { return x.pair < y.pair; });

  WorldEvents events;
  auto before = s.pairs.begin();
  for (const WorldPair& p : now) {
    while (before != s.pairs.end() && comes_before(*before, p)) events.ended.push_back(*before++);
    const bool is_kept = before != s.pairs.end() && !comes_before(p, *before);
    (is_kept ? events.kept : events.begun).push_back(p);
    if (is_kept) ++before;
  }
  events.ended.insert(events.ended.end(), before, s.pairs.end());

  s.pairs = std::move(now);
  s.asked = std::move(asked);
  s.events = std::move(events);
  for (std::optional<State::Body>& body : s.bodies) {
    if (body) body->is_changed = false;
  }
  return s.events;
}

const std::vector<WorldPair>& CollisionWorld::pairs() const { return state_->pairs; }

std::vector<BodyHandle> CollisionWorld::overlaps(const AnyFigure& figure, std::uint32_t mask) const {
  std::vector<BodyHandle> found;
  for (const BodyHandle& handle : state_->boxes.in_box(query::any_fit_aabb(figure))) {
    const State::Body& body = *state_->bodies[handle.slot];
    if ((body.options.group & mask) != 0 && intersects(body.figure, figure)) found.push_back(handle);
  }
  std::stable_sort(found.begin(), found.end(), [&](const BodyHandle& a, const BodyHandle& b) {
    return state_->bodies[a.slot]->options.user_id < state_->bodies[b.slot]->options.user_id;
  });
  return found;
}

}  // namespace plumb
