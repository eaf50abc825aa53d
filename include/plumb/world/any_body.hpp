// What stands in a world as one?  A figure, a mesh that several may share, or a compound of both, under one pose.
//
//   AnyBody ball = Sphere3{{0, 0, 0}, 1};
//   const SharedMesh rock(mesh);                                     // its tree is made once
//   AnyBody boulder(rock, RigidPose{turn, {5, 0, 0}});
//   AnyBody table = AnyBody::compound({top, leg, AnyBody(leg_figure, RigidPose{{}, {3, 0, 0}})});
//   proxy_of(boulder, ProxyKind::hull)                               // what misses it misses the boulder
//
// Laws: (1) a body is the union of its parts, each under its own pose and then under that of the body, exactly.  (2) A mesh
// is its triangles: a surface, of which nothing is inside.  (3) Copies share what is large.  (4) A proxy holds every point
// of the body, exactly: what misses the proxy misses the body.
// A mesh of no triangles and a compound of no parts throw InvalidShape, a pose that is neither rigid nor a chain of such
// UnevenPose, for a mesh and for the parts of a compound.
// Source: RTCD 2.2.2, 2.4.1.
// Cost: that of the tree for a mesh, once, and of each kind of proxy when it is first asked for; of other bodies each
// time.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

/// What may be asked in place of a body first: a Sphere3, an Obb3 or a ConvexPolyhedron3.
enum class ProxyKind : unsigned char { none, sphere, obb, hull };
inline constexpr std::size_t proxy_kinds = 4;
std::string_view name_of(ProxyKind kind);  // "none", "sphere", "box", "hull"

/// A mesh with its tree, which never changes.
class SharedMesh {
 public:
  explicit SharedMesh(const TriangleMesh& mesh);
  explicit SharedMesh(Bvh bvh);

  [[nodiscard]] const Bvh& bvh() const;
  /// The number is that in the mesh.
  [[nodiscard]] Triangle3 triangle(std::uint32_t number) const;
  /// Around all of it.
  [[nodiscard]] const Aabb3& box() const;
  /// That of proxy_of; it is made when it is first asked for, from any thread.
  [[nodiscard]] const std::optional<AnyFigure>& proxy(ProxyKind kind) const;
  friend bool operator==(const SharedMesh&, const SharedMesh&) = default;

 private:
  struct Kept;
  std::shared_ptr<Kept> kept_;
};

class AnyBody {
 public:
  struct Part {
    std::variant<AnyFigure, SharedMesh> shape;
    AnyPose pose{};  // of a mesh in the body; a figure has its own
  };

  template <PosedOrNot Shape>
  AnyBody(const Shape& s) : AnyBody(AnyFigure(s)) {}  // NOLINT: a figure is one
  AnyBody(const AnyFigure& figure);                   // NOLINT
  AnyBody(const SharedMesh& mesh);                    // NOLINT: and so is a mesh
  AnyBody(const SharedMesh& mesh, const AnyPose& pose);

  static AnyBody compound(const std::vector<AnyBody>& parts);

  /// What another one told of itself.
  static AnyBody of(std::vector<Part> parts, const AnyPose& pose);
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] const AnyPose& pose() const { return pose_; }
  /// The same parts elsewhere.
  [[nodiscard]] AnyBody under(const AnyPose& pose) const;

 private:
  AnyBody() = default;
  std::vector<Part> parts_;
  AnyPose pose_;
};

/// In the body's own place, without its pose.  Nothing of no kind, nor where doubles hold none: of a hull where it is flat.
std::optional<AnyFigure> proxy_of(const AnyBody& body, ProxyKind kind);

}  // namespace plumb
