#include "plumb/world/any_body.hpp"

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/build.hpp"
#include "world/proxy_around.hpp"
#include "world/rigid_links.hpp"

namespace plumb {

struct SharedMesh::Kept {
  Kept(Bvh tree, std::vector<std::uint32_t> slots, const Aabb3& around)
      : bvh(std::move(tree)), slot_of(std::move(slots)), box(around) {}

  Bvh bvh;
  std::vector<std::uint32_t> slot_of;  // of each number; one of its slots
  Aabb3 box;
  struct Proxy {
    std::once_flag asked;
    std::optional<AnyFigure> figure;
  };
  std::array<Proxy, proxy_kinds> proxies{};
};

SharedMesh::SharedMesh(const TriangleMesh& mesh) : SharedMesh(build_bvh(mesh)) {}

SharedMesh::SharedMesh(Bvh bvh) {
  if (bvh.slots() == 0) throw InvalidShape("SharedMesh: the mesh has no triangles; a body has one at least");
  std::vector<std::uint32_t> slot_of;
  Aabb3 box{bvh.triangle(0).a, bvh.triangle(0).a};
  for (std::size_t slot = 0; slot < bvh.slots(); ++slot) {
    const std::uint32_t number = bvh.number(slot);
    if (slot_of.size() <= number) slot_of.resize(std::size_t{number} + 1);
    slot_of[number] = static_cast<std::uint32_t>(slot);
    const Triangle3 t = bvh.triangle(slot);
    for (const Point3& p : {t.a, t.b, t.c}) {
      box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
      box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
    }
  }
  kept_ = std::make_shared<Kept>(std::move(bvh), std::move(slot_of), box);
}

const Bvh& SharedMesh::bvh() const { return kept_->bvh; }
Triangle3 SharedMesh::triangle(std::uint32_t number) const { return kept_->bvh.triangle(kept_->slot_of.at(number)); }
const Aabb3& SharedMesh::box() const { return kept_->box; }

const std::optional<AnyFigure>& SharedMesh::proxy(ProxyKind kind) const {
  Kept::Proxy& proxy = kept_->proxies[static_cast<std::size_t>(kind)];
  std::call_once(proxy.asked, [&] { proxy.figure = world::proxy_around(world::points_around({*this, {}}), kind); });
  return proxy.figure;
}

AnyBody::AnyBody(const AnyFigure& figure) : parts_{{figure.under({}), {}}}, pose_(figure.pose()) {}
AnyBody::AnyBody(const SharedMesh& mesh) : parts_{{mesh, {}}} {}
AnyBody::AnyBody(const SharedMesh& mesh, const AnyPose& pose) : parts_{{mesh, {}}}, pose_(pose) {
  static_cast<void>(world::links_of("AnyBody", pose));
}

AnyBody AnyBody::compound(const std::vector<AnyBody>& parts) {
  AnyBody all;
  for (const AnyBody& body : parts) {
    for (const Part& part : body.parts_) all.parts_.push_back(world::part_under("AnyBody::compound", part, body.pose_));
  }
  if (all.parts_.empty()) throw InvalidShape("AnyBody::compound: no parts; a body has one at least");
  return all;
}

AnyBody AnyBody::of(std::vector<Part> parts, const AnyPose& pose) {
  AnyBody body;
  body.parts_ = std::move(parts), body.pose_ = pose;
  return body;
}

AnyBody AnyBody::under(const AnyPose& pose) const {
  AnyBody body = *this;
  body.pose_ = pose;
  return body;
}

}  // namespace plumb
