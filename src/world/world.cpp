#include "plumb/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "world/grown_box.hpp"
#include "world/state.hpp"

namespace plumb {
namespace {

using world::about_body, world::Placed, world::WorldBody;

void require_options(const char* function, const BodyOptions& options) {
  const auto of = [&] { return std::string(function) + ": body " + std::to_string(options.user_id) + ": margin "; };
  if (!std::isfinite(options.margin)) throw NonFinite(of() + "is not a real number; give a finite double");
  if (options.margin < 0) throw InvalidShape(of() + "is negative; give one that is not");
}

/// The box of what is within a margin; two that are enlarged so overlap where the bodies are as near as both margins,
/// however their sum is rounded.
Aabb3 enlarged(const Aabb3& b, double margin) {
  if (margin == 0) return b;
  return world::grown(b, std::nextafter(margin, std::numeric_limits<double>::infinity()));
}

/// The parts where they stand, and the box of all.
struct Stand {
  std::vector<Placed> placed;
  Aabb3 box;
};
Stand stand(const char* function, const std::vector<AnyBody::Part>& parts, const AnyPose& pose,
            const BodyOptions& options) {
  return about_body(function, options.user_id, [&] {
    Stand made;
    made.placed.reserve(parts.size());
    for (const AnyBody::Part& part : parts) {
      made.placed.push_back(world::placed(part, pose));
      const Aabb3 box = world::box_of(made.placed.back());
      made.box = made.placed.size() == 1 ? box : world::joined(made.box, box);
    }
    return made;
  });
}

/// Nothing where none is asked for.
std::optional<AnyFigure> proxy_in_place(const char* function, const std::vector<AnyBody::Part>& parts,
                                        const AnyPose& pose, const BodyOptions& options) {
  if (options.proxy == ProxyKind::none) return {};
  return about_body(function, options.user_id, [&] {
    const std::optional<AnyFigure> proxy = proxy_of(AnyBody::of(parts, {}), options.proxy);
    if (!proxy) {
      throw InvalidShape("it has no proxy that is a " + std::string(name_of(options.proxy)) + "; give another kind");
    }
    return std::optional(std::get<AnyFigure>(world::placed({*proxy, {}}, pose)));
  });
}

/// The same proxy under another pose.
std::optional<AnyFigure> moved(const std::optional<AnyFigure>& proxy, const RigidPose& pose) {
  if (!proxy) return {};
  return proxy->under(pose);
}

/// Does it stand there already, to the last bit?
bool stands_at(const WorldBody& body, const RigidPose& pose) {
  const auto* at = std::get_if<RigidPose>(&body.pose);
  return at != nullptr && std::memcmp(at, &pose, sizeof pose) == 0;
}

}  // namespace

CollisionWorld::CollisionWorld(const CollisionWorldOptions& options) : state_(std::make_unique<State>()) {
  state_->options = options;
}
CollisionWorld::CollisionWorld(CollisionWorld&&) noexcept = default;
CollisionWorld& CollisionWorld::operator=(CollisionWorld&&) noexcept = default;
CollisionWorld::~CollisionWorld() = default;

BodyHandle CollisionWorld::add(const AnyBody& body, const BodyOptions& options) {
  State& s = *state_;
  require_options("CollisionWorld::add", options);
  Stand made = stand("CollisionWorld::add", body.parts(), body.pose(), options);
  std::optional<AnyFigure> proxy = proxy_in_place("CollisionWorld::add", body.parts(), body.pose(), options);
  WorldBody kept{body.parts(), body.pose(), std::move(made.placed), made.box, options, std::move(proxy), {}};
  const BodyHandle handle = s.boxes.insert(enlarged(made.box, options.margin));
  try {
    if (s.bodies.size() <= handle.slot) {
      s.bodies.resize(std::size_t{handle.slot} + 1);
      s.is_changed.resize(std::size_t{handle.slot} + 1);
    }
    s.note_changed(handle.slot);
  } catch (...) {  // memory has run out: the box has no body
    s.boxes.remove(handle);
    throw;
  }
  kept.handle = handle;
  s.bodies[handle.slot] = std::move(kept);
  return handle;
}

void CollisionWorld::move(const BodyHandle& body, const RigidPose& pose) {
  State& s = *state_;
  WorldBody& at = s.body("CollisionWorld::move", body);
  if (stands_at(at, pose)) return;
  if (at.parts.size() == 1) {  // without a list of its own
    Placed there =
        about_body("CollisionWorld::move", at.options.user_id, [&] { return world::placed(at.parts[0], pose); });
    const Aabb3 box = about_body("CollisionWorld::move", at.options.user_id, [&] { return world::box_of(there); });
    std::optional<AnyFigure> proxy = moved(at.proxy, pose);
    s.note_changed(body.slot);
    s.boxes.move(body, enlarged(box, at.options.margin));
    at.placed[0] = std::move(there), at.box = box, at.proxy = std::move(proxy), at.pose = pose;
    return;
  }
  Stand made = stand("CollisionWorld::move", at.parts, pose, at.options);
  std::optional<AnyFigure> proxy = moved(at.proxy, pose);
  s.note_changed(body.slot);
  s.boxes.move(body, enlarged(made.box, at.options.margin));
  at.placed = std::move(made.placed), at.box = made.box, at.proxy = std::move(proxy), at.pose = pose;
}

void CollisionWorld::replace(const BodyHandle& body, const AnyBody& by) {
  State& s = *state_;
  WorldBody& at = s.body("CollisionWorld::replace", body);
  Stand made = stand("CollisionWorld::replace", by.parts(), by.pose(), at.options);
  std::optional<AnyFigure> proxy = proxy_in_place("CollisionWorld::replace", by.parts(), by.pose(), at.options);
  WorldBody kept{by.parts(), by.pose(), std::move(made.placed), made.box, at.options, std::move(proxy), body};
  s.note_changed(body.slot);
  s.boxes.move(body, enlarged(made.box, at.options.margin));
  at = std::move(kept);
}

void CollisionWorld::remove(const BodyHandle& body) {
  State& s = *state_;
  static_cast<void>(s.body("CollisionWorld::remove", body));
  s.boxes.remove(body);
  s.bodies[body.slot].reset();
  std::erase_if(s.allowed, [&](const HandlePair& p) { return p.a == body || p.b == body; });
}

void CollisionWorld::set_proxy(const BodyHandle& body, ProxyKind proxy) {
  WorldBody& at = state_->body("CollisionWorld::set_proxy", body);
  BodyOptions options = at.options;
  options.proxy = proxy;
  at.proxy = proxy_in_place("CollisionWorld::set_proxy", at.parts, at.pose, options);
  at.options = options;
}

bool CollisionWorld::contains(const BodyHandle& body) const { return state_->boxes.contains(body); }
std::size_t CollisionWorld::size() const { return state_->boxes.size(); }
AnyBody CollisionWorld::body(const BodyHandle& body) const {
  const WorldBody& at = state_->body("CollisionWorld::body", body);
  return AnyBody::of(at.parts, at.pose);
}
const AnyFigure& CollisionWorld::figure(const BodyHandle& body) const {
  const WorldBody& at = state_->body("CollisionWorld::figure", body);
  const auto* figure = std::get_if<AnyFigure>(&at.placed[0]);
  if (figure != nullptr && at.placed.size() == 1) return *figure;
  throw Unsupported("CollisionWorld::figure: body " + std::to_string(at.options.user_id) +
                    " is a mesh or a compound; body() tells its parts");
}
const BodyOptions& CollisionWorld::options(const BodyHandle& body) const {
  return state_->body("CollisionWorld::options", body).options;
}

void CollisionWorld::allow_collision(const BodyHandle& a, const BodyHandle& b, bool allowed) {
  static_cast<void>(state_->body("CollisionWorld::allow_collision", a));
  static_cast<void>(state_->body("CollisionWorld::allow_collision", b));
  if (allowed) {
    state_->allowed.insert(world::by_handles(a, b));
  } else {
    state_->allowed.erase(world::by_handles(a, b));
  }
}

void CollisionWorld::keep_filter(std::shared_ptr<void> filter, AskFilter ask) {
  state_->filter = std::move(filter);
  state_->ask_filter = ask;
}

const std::vector<WorldPair>& CollisionWorld::pairs() const { return state_->pairs; }

std::vector<BodyHandle> CollisionWorld::overlaps(const AnyFigure& figure, std::uint32_t mask) const {
  std::vector<BodyHandle> found;
  for (const BodyHandle& handle : state_->boxes.in_box(world::box_of_figure(figure))) {
    const WorldBody& body = *state_->bodies[handle.slot];
    if ((body.options.group & mask) == 0 || (body.proxy && !intersects(*body.proxy, figure))) continue;
    if (std::ranges::any_of(body.placed, [&](const Placed& part) { return world::meet(part, figure); })) {
      found.push_back(handle);
    }
  }
  std::stable_sort(found.begin(), found.end(), [&](const BodyHandle& a, const BodyHandle& b) {
    return state_->bodies[a.slot]->options.user_id < state_->bodies[b.slot]->options.user_id;
  });
  return found;
}

}  // namespace plumb
