#include "query/time_of_impact/moving_body.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plumb/query/body/detail/with_figure.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/convex/exact_map.hpp"

namespace plumb::query {
namespace {

template <class T>
class Maker {
 public:
  template <Figure Shape>
  requires has_boundary<Shape> &&(figure_dimension<Shape> == 3 && (figure_kind<Shape> == FigureKind::polygon ||
                                                                   !is_one_of(figure_kind<Shape>, polygon_kinds))) void
  operator()(const Shape& s) {
    tell_boundary<T>(s, *this);
    if constexpr (figure_kind<Shape> == FigureKind::polygon) {  // a convex one
      std::vector<std::uint32_t> all(made.vertices.size());
      std::iota(all.begin(), all.end(), 0u);
      face(all, 0);
    }
    if constexpr (figure_kind<Shape> == FigureKind::ball) made.vertex_features = {{FeatureKind::face, 0}};
    if constexpr (requires { s.radius; }) {
      made.reach = T(s.radius);
      made.swept = s.radius > 0;
    }
  }
  void operator()(const PosedView& v) {
    if (!v.pose.stands()) pose_ = weighted_pose<T>(v.pose);
    with_figure(v.figure, [this](const auto& s) {
      if constexpr (requires { (*this)(s); }) (*this)(s);
    });
    if (!pose_) return;
    if (made.swept && !is_rigid(v.pose)) made.reach = made.reach * T(*scale_of(v.pose));
    if (pose_->has_weight) made.reach = made.reach * pose_->weight;
    made.weight = pose_->weight, made.has_weight = pose_->has_weight;
    for (auto& face : made.faces) {
      if (!face.corners.empty()) continue;  // a plane: its normal by the cofactors, of which the determinant is made
      if (pose_->stands) continue;
      const auto& [u, v2, w] = pose_->columns;
      const Vec3<T> n = face.normal;
      face.normal = cross(v2, w) * n.x + cross(w, u) * n.y + cross(u, v2) * n.z;
      face.offset = face.offset * dot(u, cross(v2, w)) + dot(face.normal, pose_->translation);
    }
  }
  void operator()(const Plane3& p) {
    made.faces.push_back({{}, vector_of<T>(p.normal), T(p.offset), {FeatureKind::face, 0}});
  }

  MovingBody<T> made;

  void corner(const Vec3<T>& v) {
    made.vertex_features.push_back({FeatureKind::vertex, static_cast<std::uint32_t>(made.vertices.size())});
    made.vertices.push_back(pose_ ? pose_->image(v) : v);
  }
  void edge(std::uint32_t from, std::uint32_t to, std::uint32_t number) {
    made.edges.push_back({{from, to}, {FeatureKind::edge, number}});
  }
  void face(std::span<const std::uint32_t> corners, std::uint32_t number) {
    if (corners.size() < 3) return;  // an edge
    const auto& v = made.vertices;
    const Vec3<T>& first = v[corners[0]];
    Vec3<T> normal = cross(v[corners[1]] - first, v[corners[2]] - first);
    for (std::size_t i = 3; i < corners.size(); ++i)
      normal = normal + cross(v[corners[i - 1]] - first, v[corners[i]] - first);
    const T offset = dot(normal, first);
    made.faces.push_back({{corners.begin(), corners.end()}, normal, offset, {FeatureKind::face, number}});
  }

 private:
  std::optional<WeightedPose<T>> pose_;
};

}  // namespace

std::optional<double> scale_of(const AnyPoseView& pose) {
  if (is_rigid(pose)) return 1;
  const auto square = squared_scale(exact_map(pose), 3);
  if (!square) return {};
  const double root = std::sqrt(square->get_d());  // a guess
  if (root - root != 0 || mpq_class(root) * mpq_class(root) != *square) return {};
  return root;
}

template <class T>
MovingBody<T> moving_body(const PosedView& shape) {
  Maker<T> maker;
  maker(shape);
  return std::move(maker.made);
}
template MovingBody<Running> moving_body(const PosedView&);
template MovingBody<Ball> moving_body(const PosedView&);
template MovingBody<BigDyadic> moving_body(const PosedView&);

bool check_body(std::string_view function, std::string_view name, const PosedView& shape) {
  if (shape.pose.stands()) require_figure(function, name, shape.figure);
  return with_figure(shape.figure, []<class Shape>(const Shape& s) {
    if constexpr (std::is_same_v<Shape, Plane3>) {
      return s.normal != Vector3{0, 0, 0} || s.offset == 0;
    } else {
      return !is_nothing(s);
    }
  });
}

}  // namespace plumb::query
