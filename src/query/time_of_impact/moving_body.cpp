#include "query/time_of_impact/moving_body.hpp"

#include <algorithm>
#include <cmath>

#include "query/body/figure_input.hpp"
#include "query/body/figure_view.hpp"
#include "query/convex/exact_map.hpp"

namespace plumb::query {
namespace {

template <class T>
class Maker {
 public:
  void operator()(const Point3* p) { vertices({*p}); }
  void operator()(const Segment3* s) {
    vertices({s->a, s->b});
    edge(0, 1, 0);
  }
  void operator()(const Triangle3* t) {
    vertices({t->a, t->b, t->c});
    for (std::uint32_t i = 0; i < 3; ++i) edge(i, (i + 1) % 3, i);
    face({0, 1, 2}, 0);
  }
  void operator()(const PosedTriangle3* t) {
    for (const Vec3<T>& v : posed_corners<T>(*t)) vertex(v);
    for (std::uint32_t i = 0; i < 3; ++i) edge(i, (i + 1) % 3, i);
    face({0, 1, 2}, 0);
  }
  void operator()(const PosedView* v) {
    pose_ = v->in_space;
    with_figure(v->figure, [this](const auto& s) {
      if constexpr (requires { (*this)(&s); }) (*this)(&s);
    });
    if (pose_ == nullptr) return;
    if (made.swept) made.reach = made.reach * T(*scale_of(*pose_));
    for (auto& face : made.faces) {
      if (!face.corners.empty()) continue;  // a plane: its normal by the cofactors, of which the determinant is made
      const auto& [c, t] = *pose_;
      const Vec3<T> u = vector_of<T>(c[0]), v2 = vector_of<T>(c[1]), w = vector_of<T>(c[2]), n = face.normal;
      face.normal = cross(v2, w) * n.x + cross(w, u) * n.y + cross(u, v2) * n.z;
      face.offset = face.offset * dot(u, cross(v2, w)) + dot(face.normal, vector_of<T>(t));
    }
  }
  void operator()(const Aabb3* box) {
    const auto& [low, high] = *box;
    for (std::uint32_t i = 0; i < 8; ++i)
      vertex({T((i & 1) != 0 ? high.x : low.x), T((i & 2) != 0 ? high.y : low.y), T((i & 4) != 0 ? high.z : low.z)});
    box_features();
  }
  void operator()(const Obb3* box) {
    // Upper ends are those of the magnitudes, here and in rectangles.
    const std::array<double, 3> half{std::fabs(box->half.x), std::fabs(box->half.y), std::fabs(box->half.z)};
    for (std::uint32_t i = 0; i < 8; ++i) {
      Vec3<T> v = vector_of<T>(box->center);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3<T> step = vector_of<T>(box->axes[k]) * T(half[k]);
        v = (i >> k & 1) != 0 ? v + step : v - step;
      }
      vertex(v);
    }
    box_features();
  }
  void operator()(const Tetrahedron3* t) {
    vertices({t->a, t->b, t->c, t->d});
    std::uint32_t number = 0;
    for (std::uint32_t i = 0; i < 4; ++i) {
      for (std::uint32_t j = i + 1; j < 4; ++j) edge(i, j, number++);
    }
    for (std::uint32_t i = 0; i < 4; ++i) face({(i + 1) % 4, (i + 2) % 4, (i + 3) % 4}, i);
  }
  void operator()(const Rectangle3* r) {
    const double x = std::fabs(r->half.x), y = std::fabs(r->half.y);
    const Vec3<T> u = vector_of<T>(r->axes[0]) * T(x), v = vector_of<T>(r->axes[1]) * T(y);
    parallelogram(vector_of<T>(r->center) - u - v, u + u, v + v);
  }
  void operator()(const Lozenge3* l) {
    parallelogram(vector_of<T>(l->corner), vector_of<T>(l->edges[0]), vector_of<T>(l->edges[1]));
    made.reach = T(l->radius);
    made.swept = l->radius > 0;
  }
  void operator()(const ConvexPolyhedron3* polyhedron) {
    const PolygonMesh& mesh = polyhedron->mesh;
    for (const Point3& p : mesh.vertices) vertex(vector_of<T>(p));
    for (std::uint32_t f = 0; f + 1 < mesh.first.size(); ++f) {
      const auto corners = std::span(mesh.corners).subspan(mesh.first[f], mesh.first[f + 1] - mesh.first[f]);
      for (std::uint32_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t from = corners[c], to = corners[(c + 1) % corners.size()];
        // Each edge has two corners that leave it; the faces come in order, so the first one seen is the lower.
        if (f < polyhedron->across[mesh.first[f] + c]) edge(from, to, mesh.first[f] + c);
      }
      face({corners.begin(), corners.end()}, f);
    }
  }
  void operator()(const Sphere3* s) {
    vertices({s->center});
    made.vertex_features = {{FeatureKind::face, 0}};
    made.reach = T(s->radius);
    made.swept = s->radius > 0;
  }
  void operator()(const Capsule3* c) {
    vertices({c->a, c->b});
    edge(0, 1, 0);
    made.reach = T(c->radius);
    made.swept = c->radius > 0;
  }
  void operator()(const Plane3* p) {
    made.faces.push_back({{}, vector_of<T>(p->normal), T(p->offset), {FeatureKind::face, 0}});
  }

  MovingBody<T> made;

 private:
  void vertex(const Vec3<T>& v) {
    made.vertex_features.push_back({FeatureKind::vertex, static_cast<std::uint32_t>(made.vertices.size())});
    made.vertices.push_back(pose_ != nullptr ? image(v) : v);
  }
  [[nodiscard]] Vec3<T> image(const Vec3<T>& v) const {
    const auto& [c, t] = *pose_;
    return vector_of<T>(c[0]) * v.x + vector_of<T>(c[1]) * v.y + vector_of<T>(c[2]) * v.z + vector_of<T>(t);
  }
  void vertices(std::initializer_list<Point3> points) {
    for (const Point3& p : points) vertex(vector_of<T>(p));
  }
  void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
    made.edges.push_back({{from, to}, {FeatureKind::edge, number}});
  }
  void face(std::vector<std::uint32_t> corners, std::uint32_t number) {
    if (corners.size() < 3) return;  // an edge
    const auto& v = made.vertices;
    const Vec3<T>& first = v[corners[0]];
    Vec3<T> normal = cross(v[corners[1]] - first, v[corners[2]] - first);
    for (std::size_t i = 3; i < corners.size(); ++i)
      normal = normal + cross(v[corners[i - 1]] - first, v[corners[i]] - first);
    const T offset = dot(normal, first);
    made.faces.push_back({std::move(corners), normal, offset, {FeatureKind::face, number}});
  }
  /// Bit k of a vertex's number: at the end of way k.
  void parallelogram(const Vec3<T>& at, const Vec3<T>& u, const Vec3<T>& v) {
    for (const Vec3<T>& p : {at, at + u, at + v, at + u + v}) vertex(p);
    edge(0, 1, 0), edge(2, 3, 1), edge(0, 2, 2), edge(1, 3, 3);
    face({0, 1, 3, 2}, 0);
  }
  const Pose* pose_ = nullptr;
  /// Bit k of a vertex's number: at the upper end of axis k.
  void box_features() {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t u = 1u << (axis == 0 ? 1 : 0), v = 1u << (axis == 2 ? 1 : 2), along = 1u << axis;
      for (std::uint32_t n = 0; n < 4; ++n) {
        const std::uint32_t from = ((n & 1) != 0 ? u : 0) | ((n & 2) != 0 ? v : 0);
        edge(from, from | along, 4 * axis + n);
      }
      for (const std::uint32_t at : {0u, along}) face({at, at | u, at | u | v, at | v}, 2 * axis + (at != 0));
    }
  }
};

}  // namespace

std::optional<double> scale_of(const Pose& pose) {
  const auto square = squared_scale(exact_map(pose), 3);
  if (!square) return {};
  const double root = std::sqrt(square->get_d());  // a guess
  if (root - root != 0 || mpq_class(root) * mpq_class(root) != *square) return {};
  return root;
}

template <class T>
MovingBody<T> moving_body(const BodyShape& shape) {
  Maker<T> maker;
  std::visit(maker, shape);
  return std::move(maker.made);
}
template MovingBody<Running> moving_body(const BodyShape&);
template MovingBody<Ball> moving_body(const BodyShape&);
template MovingBody<BigDyadic> moving_body(const BodyShape&);

bool check_body(std::string_view function, std::string_view name, const BodyShape& shape) {
  return std::visit(
      [&](const auto* s) {
        if constexpr (
            !requires { s->pose; } && !requires { s->figure; })
          require_figure(function, name, *s);
        if constexpr (requires { s->figure; }) {
          return with_figure(s->figure, [](const auto& given) {
            if constexpr (requires { given.normal.z, given.offset; }) {
              return given.normal != Vector3{0, 0, 0} || given.offset == 0;
            } else {
              return !is_nothing(given);
            }
          });
        } else if constexpr (requires { s->normal; }) {
          return s->normal != Vector3{0, 0, 0} || s->offset == 0;
        } else {
          return !is_nothing(*s);
        }
      },
      shape);
}

}  // namespace plumb::query
