// A walk from feature to feature, each nearer to p than the last: from a vertex along an edge toward p, from an edge
// onto the face toward which p lies, from a face to what of it is nearest.  It can end in a face that has p behind it;
// then p is inside, or all features are asked.  The walk ends, for no feature that it left, all signs being exact, is
// as near as those that follow; around a vertex and a face it goes by permutations of corners, which come back.
#include <algorithm>
#include <string>

#include "figure/basic/finite_parts.hpp"
#include "figure/basic/mesh_corners.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

class RegionWalk : MeshCorners {
 public:
  RegionWalk(const ConvexPolyhedron3& polyhedron, const Point3& p)
      : MeshCorners(polyhedron), mesh_(polyhedron.mesh), p_(p) {}

  Feature from(FeatureKind kind, std::uint32_t corner) {
    for (;;) {
      std::optional<Place> next;
      if (kind == FeatureKind::vertex) {
        if (!(next = off_vertex(corner)))
          return is_behind_vertex(corner) ? among_all() : Feature{FeatureKind::vertex, mesh_.corners[corner]};
      } else if (kind == FeatureKind::edge) {
        if (!(next = off_edge(corner)))
          return is_behind_edge(corner) ? among_all() : Feature{FeatureKind::edge, std::min(corner, twin(corner))};
      } else if (!(next = off_face(corner))) {
        const std::uint32_t face = face_of(corner);
        return is_behind(face) ? among_all() : Feature{FeatureKind::face, face};
      }
      kind = next->kind;
      corner = next->corner;
    }
  }

 private:
  /// A vertex by a corner at it, an edge by the corner that it leaves, a face by one of its corners.
  struct Place {
    FeatureKind kind;
    std::uint32_t corner;
  };

  /// Does the way from one to the other lead toward p?
  [[nodiscard]] bool toward(const Point3& a, const Point3& b) const { return angle_sign(p_, a, b) == Sign::positive; }

  /// The side of the edge, in the plane of the face, on which p projects: positive on the face's own.
  [[nodiscard]] Sign side(std::uint32_t corner, std::uint32_t face) const {
    return coplanar_orientation(at(corner), at(next(corner, face)), off_line(corner, face), p_);
  }
  [[nodiscard]] bool is_behind(std::uint32_t face) const {
    const std::uint32_t a = mesh_.first[face];
    return orient3d(at(a), at(next(a, face)), off_line(a, face), p_) == Sign::positive;  // below
  }

  /// Of what lies in one plane with all its faces the region has two sides: is p on the solid's?
  [[nodiscard]] bool is_behind_edge(std::uint32_t corner) const {
    return is_behind(face_of(corner)) && is_behind(face_of(twin(corner)));
  }
  [[nodiscard]] bool is_behind_vertex(std::uint32_t corner) const {
    std::uint32_t c = corner;
    do {
      if (!is_behind(face_of(c))) return false;
      c = next(twin(c));
    } while (c != corner);
    return true;
  }

  /// Edges lead away from p; a face in whose straight edge the vertex lies may yet lead toward it.
  [[nodiscard]] std::optional<Place> off_vertex(std::uint32_t corner) const {
    std::uint32_t c = corner;
    do {
      if (toward(at(c), at(next(c)))) return Place{FeatureKind::edge, c};
      c = next(twin(c));
    } while (c != corner);
    do {
      const std::uint32_t face = face_of(c);
      if (collinear(at(before(c, face)), at(c), at(next(c, face))) && toward(at(c), off_line(c, face)))
        return Place{FeatureKind::face, c};
      c = next(twin(c));
    } while (c != corner);
    return {};
  }
  [[nodiscard]] std::optional<Place> off_edge(std::uint32_t corner) const {
    const std::uint32_t face = face_of(corner), head = next(corner, face);
    if (!toward(at(corner), at(head))) return Place{FeatureKind::vertex, corner};
    if (!toward(at(head), at(corner))) return Place{FeatureKind::vertex, head};
    if (side(corner, face) == Sign::positive) return Place{FeatureKind::face, corner};
    const std::uint32_t other = twin(corner);
    if (side(other, face_of(other)) == Sign::positive) return Place{FeatureKind::face, other};
    return {};
  }
  /// The edge or vertex of the face that is nearest; nothing where p projects to the inside of the face.
  [[nodiscard]] std::optional<Place> off_face(std::uint32_t corner) const {
    const std::uint32_t face = face_of(corner), first = mesh_.first[face], last = mesh_.first[face + 1];
    bool inside = true;
    for (std::uint32_t c = first; c < last; ++c) {
      if (side(c, face) == Sign::positive) continue;
      inside = false;
      const Point3 &a = at(c), &b = at(next(c, face));
      if (toward(a, b) && toward(b, a)) return Place{FeatureKind::edge, c};
    }
    if (inside) return {};
    // One of the edges at the nearest vertex has p beyond it; at one in a straight edge both have, or none.
    for (std::uint32_t c = first; c < last; ++c) {
      const std::uint32_t last_edge = before(c, face);
      if (!toward(at(c), at(last_edge)) && !toward(at(c), at(next(c, face))) &&
          (side(c, face) != Sign::positive || side(last_edge, face) != Sign::positive))
        return Place{FeatureKind::vertex, c};
    }
    return {};  // not reached: a convex polygon has a nearest point
  }

  /// By asking all of them in turn.
  [[nodiscard]] Feature among_all() const {
    const auto faces = static_cast<std::uint32_t>(mesh_.first.size() - 1);
    std::uint32_t face = 0;
    while (face < faces && is_behind(face)) ++face;
    if (face == faces) return {FeatureKind::interior, 0};
    const auto corners = static_cast<std::uint32_t>(mesh_.corners.size());
    for (std::uint32_t c = 0; c < corners; ++c) {
      if (!off_vertex(c) && !is_behind_vertex(c)) return {FeatureKind::vertex, mesh_.corners[c]};
    }
    for (std::uint32_t c = 0; c < corners; ++c) {
      if (!off_edge(c) && !is_behind_edge(c)) return {FeatureKind::edge, std::min(c, twin(c))};
    }
    for (face = 0; face < faces; ++face) {
      if (!is_behind(face) && !off_face(mesh_.first[face])) return {FeatureKind::face, face};
    }
    throw InvalidShape("voronoi_region: the polyhedron is not convex; make it by convex_polyhedron");
  }

  const PolygonMesh& mesh_;
  const Point3& p_;
};

[[noreturn]] void throw_no_such_start(const char* kind, std::uint32_t index) {
  throw InvalidShape(std::string("voronoi_region: the polyhedron has no ")
                         .append(kind)
                         .append(" ")
                         .append(std::to_string(index))
                         .append(" to start from"));
}

/// A corner of the feature.
std::uint32_t corner_of(const PolygonMesh& mesh, const Feature& start) {
  if (start.kind == FeatureKind::vertex) {
    const auto found = std::ranges::find(mesh.corners, start.index);
    if (found == mesh.corners.end()) throw_no_such_start("vertex", start.index);
    return static_cast<std::uint32_t>(found - mesh.corners.begin());
  }
  if (start.kind == FeatureKind::edge) {
    if (start.index >= mesh.corners.size()) throw_no_such_start("edge", start.index);
    return start.index;
  }
  if (start.kind == FeatureKind::face) {
    if (start.index + std::size_t{1} >= mesh.first.size()) throw_no_such_start("face", start.index);
    return mesh.first[start.index];
  }
  return 0;  // from inside any place is as good
}

}  // namespace

Feature voronoi_region(const ConvexPolyhedron3& polyhedron, const Point3& p, std::optional<Feature> start) {
  require_finite_parts("voronoi_region", std::array<std::string_view, 1>{"p"}, p);
  if (polyhedron.mesh.corners.empty())
    throw InvalidShape("voronoi_region: the polyhedron has no faces; give one made by convex_polyhedron");
  const Feature from = start.value_or(Feature{FeatureKind::interior, 0});
  const FeatureKind kind = from.kind == FeatureKind::interior ? FeatureKind::face : from.kind;
  return RegionWalk(polyhedron, p).from(kind, corner_of(polyhedron.mesh, from));
}

}  // namespace plumb
