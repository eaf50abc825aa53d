// Boolean operations, CSG: what is the union, intersection or difference of solids, exactly?  And which solid does a mesh
// mean that crosses itself?
//
//   const ExactMesh both = unite(a, b);
//   const RoundedMesh rounded = round(both);       // surface/solid/round.hpp: doubles, certified
//   subtract(a, b); intersect(a, b); symmetric_difference(a, b);
//   unite(meshes);                                 // of many at once
//   unite(a, b, WindingRule::positive, Pieces::of_polygons);   // merged, and faster where much lies in one plane
//   subtract(both, exact_mesh(c, pose));           // of exact meshes: a chain is rounded at its end, if at all
//   solid_where(meshes, [](auto winding) { return winding[0] > 0 && winding[1] <= 0 && winding[2] <= 0; });
//
// Input: as arrange takes it, each mesh standing for the points around which it winds as the rule says: by `positive` a
// mesh that is inside out bounds nothing.
// Laws: (1) the result bounds exactly what the operation makes of the solids, seen as open sets whose closure is taken:
// no wall of no thickness is left, solids that only touch have no intersection.  (2) It is closed, wound outward, and
// its triangles have nothing in common but vertices and edges that both have; at an edge or vertex where solids touch
// there are more triangles than at others.  (3) volume(a) + volume(b) = volume(unite) + volume(intersect), volume(a) =
// volume(intersect) + volume(subtract), exactly.  (4) A triangle that nothing cuts stays as given, bit for bit.  (5)
// Equal whatever the order of vertices, triangles and, where the operation allows, meshes.  No mesh, or only empty ones,
// make an empty one.
// `Pieces::of_polygons` is that of arrange, and what comes of it is merged (merge_pieces.hpp): the same solid, of as few
// triangles as its polygons can have.  Law 4 is not kept by it, and a triangle's source is the least of its polygon's.
// Refused is what arrange refuses.
// Source: RTCD 2.2.1; Requicha 1980 (regularized operations); Zhou et al. 2016 (winding vectors).
// Cost: that of arrange.  Bounded by n^4 signs.
#pragma once

#include <span>

#include "plumb/surface/planar/triangulate_polygon.hpp"  // WindingRule
#include "plumb/surface/solid/arrangement.hpp"
#include "plumb/surface/solid/merge_pieces.hpp"

namespace plumb {

/// Which side of facets is solid, one number for each region: 0 for those that are not.
ExactMesh solid_of(const Arrangement& arrangement, std::span<const std::uint8_t> is_solid);

/// inside(windings), of a std::span<const std::int32_t>, says whether points are in the solid around which the meshes wind
/// so; it must be false where all are 0.
template <class Inside>
ExactMesh solid_where(const Arrangement& arrangement, const Inside& inside) {
  std::vector<std::uint8_t> is_solid(arrangement.regions());
  for (std::size_t r = 0; r < is_solid.size(); ++r) is_solid[r] = inside(arrangement.windings_of(r)) ? 1 : 0;
  return solid_of(arrangement, is_solid);
}
template <class Inside>
ExactMesh solid_where(std::span<const TriangleMesh> meshes, const Inside& inside,
                      Pieces pieces = Pieces::of_triangles) {
  ExactMesh made = solid_where(arrange(meshes, pieces), inside);
  if (pieces == Pieces::of_polygons) return merge_pieces(made);
  return made;
}
template <class Inside>
ExactMesh solid_where(std::span<const ExactMesh> meshes, const Inside& inside, Pieces pieces = Pieces::of_triangles) {
  ExactMesh made = solid_where(arrange(meshes, pieces), inside);
  if (pieces == Pieces::of_polygons) return merge_pieces(made);
  return made;
}

ExactMesh resolve(const TriangleMesh& mesh, WindingRule rule = WindingRule::positive,
                  Pieces pieces = Pieces::of_triangles);

/// Keeps what is in any of them.
ExactMesh unite(std::span<const TriangleMesh> meshes, WindingRule rule = WindingRule::positive,
                Pieces pieces = Pieces::of_triangles);
/// Keeps what is in all of them.
ExactMesh intersect(std::span<const TriangleMesh> meshes, WindingRule rule = WindingRule::positive,
                    Pieces pieces = Pieces::of_triangles);
/// Keeps what is in the first, and in none of the others.
ExactMesh subtract(std::span<const TriangleMesh> meshes, WindingRule rule = WindingRule::positive,
                   Pieces pieces = Pieces::of_triangles);
/// Keeps what is in an odd number of them.
ExactMesh symmetric_difference(std::span<const TriangleMesh> meshes, WindingRule rule = WindingRule::positive,
                               Pieces pieces = Pieces::of_triangles);

ExactMesh unite(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule = WindingRule::positive,
                Pieces pieces = Pieces::of_triangles);
ExactMesh intersect(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule = WindingRule::positive,
                    Pieces pieces = Pieces::of_triangles);
ExactMesh subtract(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule = WindingRule::positive,
                   Pieces pieces = Pieces::of_triangles);
ExactMesh symmetric_difference(const TriangleMesh& a, const TriangleMesh& b, WindingRule rule = WindingRule::positive,
                               Pieces pieces = Pieces::of_triangles);

/// The same take what operations made: a chain stays exact, and is rounded at its end.  Sources name triangles of these
/// meshes.
ExactMesh resolve(const ExactMesh& mesh, WindingRule rule = WindingRule::positive,
                  Pieces pieces = Pieces::of_triangles);
ExactMesh unite(std::span<const ExactMesh> meshes, WindingRule rule = WindingRule::positive,
                Pieces pieces = Pieces::of_triangles);
ExactMesh intersect(std::span<const ExactMesh> meshes, WindingRule rule = WindingRule::positive,
                    Pieces pieces = Pieces::of_triangles);
ExactMesh subtract(std::span<const ExactMesh> meshes, WindingRule rule = WindingRule::positive,
                   Pieces pieces = Pieces::of_triangles);
ExactMesh symmetric_difference(std::span<const ExactMesh> meshes, WindingRule rule = WindingRule::positive,
                               Pieces pieces = Pieces::of_triangles);
ExactMesh unite(const ExactMesh& a, const ExactMesh& b, WindingRule rule = WindingRule::positive,
                Pieces pieces = Pieces::of_triangles);
ExactMesh intersect(const ExactMesh& a, const ExactMesh& b, WindingRule rule = WindingRule::positive,
                    Pieces pieces = Pieces::of_triangles);
ExactMesh subtract(const ExactMesh& a, const ExactMesh& b, WindingRule rule = WindingRule::positive,
                   Pieces pieces = Pieces::of_triangles);
ExactMesh symmetric_difference(const ExactMesh& a, const ExactMesh& b, WindingRule rule = WindingRule::positive,
                               Pieces pieces = Pieces::of_triangles);

}  // namespace plumb
