#include <LinearMath/btConvexHullComputer.h>

#include <cmath>

#include "bench/rivals/bullet_calls.hpp"
#include "bench/rivals/chart_rival.hpp"

namespace plumb::bench {

using namespace bullet;

void add_bullet(Rivals& all) {
  struct Cast {
    btVector3 from, to;
    std::array<btVector3, 3> corners;
  };
  join<15>(
      all, "segment-triangle", "bullet", "Bullet's btTriangleRaycastCallback",
      [](const std::array<double, 15>& q) {
        return Cast{point(&q[0]), point(&q[3]), {point(&q[6]), point(&q[9]), point(&q[12])}};
      },
      [](const Cast& q) { return hits(q.from, q.to, q.corners); });
  using Triangles = std::pair<btPrimitiveTriangle, btPrimitiveTriangle>;
  join<18>(
      all, "triangle-triangle", "bullet",
      "Bullet's btPrimitiveTriangle, as btGImpactCollisionAlgorithm asks, no margin",
      [](const std::array<double, 18>& q) {
        return Triangles{triangle(&q[0]), triangle(&q[9])};
      },
      [](const Triangles& q) { return meet(q.first, q.second); });
  using Corners = std::array<btVector3, 4>;
  join<12>(
      all, "box-box", "bullet", "Bullet's TestAabbAgainstAabb2",
      [](const std::array<double, 12>& q) {
        return Corners{point(&q[0]), point(&q[3]), point(&q[6]), point(&q[9])};
      },
      [](const Corners& q) { return TestAabbAgainstAabb2(q[0], q[1], q[2], q[3]); });
  using Boxes = std::pair<Box, Box>;
  join<30>(
      all, "obb-obb", "bullet", "Bullet's btBoxBoxDetector",
      [](const std::array<double, 30>& q) {
        return Boxes{box(&q[0]), box(&q[15])};
      },
      [](const Boxes& q) { return meet(q.first, q.second); });
  join<12>(
      all, "point-triangle-distance", "bullet", "Bullet's btGjkPairDetector, a cloud of one point, no margin",
      [](const std::array<double, 12>& q) {
        std::pair<Cloud, btTriangleShape> made{Cloud(&q[0], 1),
                                               btTriangleShape(point(&q[3]), point(&q[6]), point(&q[9]))};
        made.second.setMargin(0);
        return made;
      },
      [](const std::pair<Cloud, btTriangleShape>& q) { return gap(q.first.shape(), q.second); });
  using Clouds = std::pair<Cloud, Cloud>;
  join<12>(
      all, "segment-segment-distance", "bullet", "Bullet's btGjkPairDetector, clouds of two points, no margin",
      [](const std::array<double, 12>& q) {
        return Clouds{Cloud(&q[0], 2), Cloud(&q[6], 2)};
      },
      [](const Clouds& q) { return gap(q.first.shape(), q.second.shape()); });
  join<24>(
      all, "convex-distance", "bullet", "Bullet's btGjkPairDetector, clouds of four points, no margin",
      [](const std::array<double, 24>& q) {
        return Clouds{Cloud(&q[0], 4), Cloud(&q[12], 4)};
      },
      [](const Clouds& q) { return gap(q.first.shape(), q.second.shape()); });
  join<48>(
      all, "convex-convex", "bullet", "Bullet's btGjkPairDetector, clouds of eight points, no margin",
      [](const std::array<double, 48>& q) {
        return Clouds{Cloud(&q[0], 8), Cloud(&q[24], 8)};
      },
      [](const Clouds& q) {
        const double apart = gap(q.first.shape(), q.second.shape());
        return std::isnan(apart) ? lab::trial::unsure : lab::trial::as_answer(apart <= 0);
      });
  join<36>(all, "hull-3d", "bullet", "Bullet's btConvexHullComputer", [](const std::array<double, 36>& q) {
    btConvexHullComputer hull;
    hull.compute(q.data(), 3 * sizeof(double), 12, 0, 0);
    std::uint32_t found = 0;
    for (int i = 0; i < hull.original_vertex_index.size(); ++i)
      found |= bit_of<3>(q, &q[3 * static_cast<std::size_t>(hull.original_vertex_index[i])]);
    return static_cast<double>(found);
  });
}

}  // namespace plumb::bench
