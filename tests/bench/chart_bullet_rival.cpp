#include "bench/bullet_calls.hpp"
#include "bench/chart_rival.hpp"

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
  using Segments = std::pair<Cloud, Cloud>;
  join<12>(
      all, "segment-segment-distance", "bullet", "Bullet's btGjkPairDetector, clouds of two points, no margin",
      [](const std::array<double, 12>& q) {
        return Segments{Cloud(&q[0], 2), Cloud(&q[6], 2)};
      },
      [](const Segments& q) { return gap(q.first.shape(), q.second.shape()); });
}

}  // namespace plumb::bench
