// Bullet's tree of a mesh, asked for the first triangle of a ray, which has an end there.
#include <BulletCollision/CollisionShapes/btBvhTriangleMeshShape.h>
#include <BulletCollision/CollisionShapes/btTriangleIndexVertexArray.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include <cmath>

#include "bench/rivals/chart_rival.hpp"
#include "lab/trial/mesh_questions.hpp"

namespace plumb::bench {
namespace {

using namespace lab::trial;

class FirstHit final : public btTriangleRaycastCallback {
 public:
  using btTriangleRaycastCallback::btTriangleRaycastCallback;
  btScalar reportHit(const btVector3&, btScalar fraction, int, int index) override {
    number = index;
    return fraction;
  }
  double number = no_item;
};

struct BulletMesh {
  explicit BulletMesh(const TriangleMesh& mesh) {
    for (const Point3& p : mesh.vertices) {
      vertices.insert(vertices.end(), {p.x, p.y, p.z});
      reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t i : t) corners.push_back(static_cast<int>(i));
    }
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(mesh.triangles.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(corners.data());
    part.m_triangleIndexStride = 3 * sizeof(int);
    part.m_numVertices = static_cast<int>(mesh.vertices.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(vertices.data());
    part.m_vertexStride = 3 * sizeof(double);
    part.m_vertexType = PHY_DOUBLE;
    array.addIndexedMesh(part, PHY_INTEGER);
    shape = std::make_unique<btBvhTriangleMeshShape>(&array, true);
  }
  BulletMesh(const BulletMesh&) = delete;
  BulletMesh& operator=(const BulletMesh&) = delete;

  std::vector<double> vertices;
  std::vector<int> corners;
  double reach = 0;
  btTriangleIndexVertexArray array;
  std::unique_ptr<btBvhTriangleMeshShape> shape;
};

struct Cast {
  btVector3 from, along;
};

double first_of(const BulletMesh& mesh, const Cast& q) {
  // Beyond the mesh, and no farther than needed.
  const btScalar far = 2 * (mesh.reach + q.from.absolute().length()) / q.along.length();
  FirstHit callback(q.from, q.from + q.along * far);
  mesh.shape->performRaycast(&callback, callback.m_from, callback.m_to);
  return callback.number;
}

}  // namespace

void add_bullet_meshes(Rivals& all) {
  all.push_back({"closest-hit", of_one_mesh<ray_numbers>(
                                    "bullet", "Bullet's btBvhTriangleMeshShape::performRaycast",
                                    [](const TriangleMesh& m) { return BulletMesh(m); },
                                    [](std::span<const double> q) {
                                      return Cast{btVector3(q[4], q[5], q[6]), btVector3(q[7], q[8], q[9])};
                                    },
                                    first_of)});
}

}  // namespace plumb::bench
