// A mesh whose vertices move linearly from one frame to the next, laid out for questions about its motion.
//
//   MovingMesh cloth = build_moving_mesh(places_now, places_next, triangles);
//   contacts_in_motion(cloth)                  // plumb/space/moving/motion_contacts.hpp
//   next_frame(cloth, places_after_next);         // from `to` on: refits, and builds nothing
//
// At time t in [0, 1] vertex i is at (1 - t) from[i] + t to[i].
// Laws: (1) edges holds each two vertices that follow one another in a triangle once, the lower number first,
// ascending; corners holds the vertices that triangles name, ascending.  (2) The trees' items are the numbers in
// corners, edges and triangles; their boxes contain what they stand for at every time of [0, 1].  (3) The trees depend
// on the numbers and the options, not on the number of threads.
// A triangle that names a vertex that there is not throws InvalidShape, NaN and infinity NonFinite, numbers of places
// that differ UnequalLengths, by name; nothing is changed then.
// Source: RTCD 5.5, 6.2.3.
// Cost: three trees, in all of three times as many items as triangles; next_frame a tenth of that.  Bounded by n^2
// operations, as build_bvh is (space/bvh/build.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/query/time_of_impact/motion.hpp"
#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

struct MovingMesh {
  using Edge = std::array<std::uint32_t, 2>;
  std::vector<Point3> from, to;
  std::vector<Bvh::Corners> triangles;
  std::vector<Edge> edges;
  std::vector<std::uint32_t> corners;
  BoxTree corner_tree, edge_tree, triangle_tree;

  [[nodiscard]] Moving<Point3> vertex(std::uint32_t i) const { return {from[i], to[i]}; }
  [[nodiscard]] Moving<Segment3> edge(std::uint32_t i) const {
    const auto& [a, b] = edges[i];
    return {{from[a], from[b]}, {to[a], to[b]}};
  }
  [[nodiscard]] Moving<Triangle3> triangle(std::uint32_t i) const {
    const auto& [a, b, c] = triangles[i];
    return {{from[a], from[b], from[c]}, {to[a], to[b], to[c]}};
  }
};

MovingMesh build_moving_mesh(std::span<const Point3> from, std::span<const Point3> to,
                             std::span<const Bvh::Corners> triangles, const BvhOptions& options = {});

/// The next frame: what was `to` is `from`.
void next_frame(MovingMesh& mesh, std::span<const Point3> to, Execution execution = Execution::parallel);

}  // namespace plumb
