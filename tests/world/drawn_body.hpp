// What bodies of worlds are drawn for tests: figures of every convex kind and more on a coarse lattice, so that they touch
// exactly and coincide, a third of them without an inside; meshes and compounds.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/world.hpp"

namespace plumb::drawn_world {

inline AnyFigure figure(Entropy& e) {
  const auto at = [&e] { return Point3{double(e.within(3)), double(e.within(3)), double(e.within(2))}; };
  const Point3 p = at(), q = at();
  switch (e.below(7)) {
    case 0:
      return Aabb3{p, {p.x + double(e.below(3)), p.y + double(e.below(3)), p.z + double(e.below(3))}};
    case 1:
      return Sphere3{p, double(e.below(3))};
    case 2:
      return Segment3{p, e.coin() ? p : q};
    case 3:
      return Triangle3{p, e.coin() ? p : q, at()};
    case 4:
      return Capsule3{p, e.coin() ? p : q, double(e.below(2))};
    case 5:
      return Obb3{p, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {double(e.below(2)), 1, double(e.below(2))}};
    default:
      return Tetrahedron3{p, q, at(), e.coin() ? p : at()};
  }
}

inline RigidPose pose(Entropy& e) {
  const std::array<Rotation, 4> turns{{{1, 0, 0, 0}, {1, 0, 0, 1}, {1, 1, 0, 0}, {2, 1, -1, 3}}};
  return {turns[e.below(4)], {double(e.within(3)), double(e.within(3)), double(e.within(1))}};
}

/// A few triangles, some of which are segments or points.
inline TriangleMesh mesh(Entropy& e) {
  TriangleMesh m;
  const auto at = [&e] { return Point3{double(e.within(2)), double(e.within(2)), double(e.within(1))}; };
  for (std::uint64_t n = 3 + e.below(4); n > 0; --n) m.vertices.push_back(at());
  const auto corner = [&] { return static_cast<std::uint32_t>(e.below(m.vertices.size())); };
  for (std::uint64_t n = 1 + e.below(6); n > 0; --n) m.triangles.push_back({corner(), corner(), corner()});
  return m;
}

/// A body, and each figure that it is the union of, in the order of parts and triangles.
struct Drawn {
  AnyBody body;
  std::vector<std::vector<AnyFigure>> figures;  // part by part

  [[nodiscard]] Drawn under(const RigidPose& pose) const {
    Drawn there{body.under(pose), figures, inner};
    for (std::size_t i = 0; i < figures.size(); ++i) {
      for (AnyFigure& f : there.figures[i]) {
        const auto* own = std::get_if<RigidPose>(&inner[i]);
        f = own == nullptr ? f.under(pose) : f.under(RigidChain{{pose, *own}});
      }
    }
    return there;
  }
  std::vector<AnyPose> inner{};  // of each part in its compound
};

inline Drawn of_figure(const AnyFigure& f) { return {AnyBody(f), {{f}}, {AnyPose{}}}; }

inline std::vector<AnyFigure> triangles_of(const TriangleMesh& m, const AnyPose& pose) {
  std::vector<AnyFigure> all;
  for (const auto& [i, j, k] : m.triangles) {
    all.push_back(AnyFigure(Triangle3{m.vertices[i], m.vertices[j], m.vertices[k]}).under(pose));
  }
  return all;
}

/// Of the kinds that a body may be made of alone.
inline Drawn simple(Entropy& e) {
  if (e.below(3) != 0) return of_figure(figure(e));
  const TriangleMesh m = mesh(e);
  return {AnyBody(SharedMesh(m)), {triangles_of(m, {})}, {AnyPose{}}};
}

inline Drawn body(Entropy& e) {
  if (e.below(4) != 0) return simple(e);
  std::vector<AnyBody> parts;
  Drawn all{AnyBody(Sphere3{{0, 0, 0}, 0}), {}, {}};
  for (std::uint64_t n = 1 + e.below(3); n > 0; --n) {
    Drawn part = simple(e);
    const bool is_moved = e.coin();
    const RigidPose by = pose(e);
    if (is_moved) part = part.under(by);
    parts.push_back(part.body);
    all.figures.push_back(part.figures[0]);
    all.inner.push_back(is_moved ? AnyPose(by) : AnyPose{});
  }
  all.body = AnyBody::compound(parts);
  return all;
}

}  // namespace plumb::drawn_world
