#include "query/separation/corners.hpp"

#include "figure/basic/in_space.hpp"
#include "plumb/certify/accepted.hpp"
#include "query/body/figure_input.hpp"

namespace plumb::query {

std::optional<CoreCorners> CoreCorners::of(const FigureView& figure) {
  return with_figure(figure, [](const auto& s) -> std::optional<CoreCorners> {
    constexpr FigureKind kind = figure_kind<std::remove_cvref_t<decltype(s)>>;
    CoreCorners c;
    if constexpr (kind == FigureKind::point) {
      c.take(std::array{in_space(s)});
    } else if constexpr (kind == FigureKind::ball) {
      c.take(std::array{in_space(s.center)});
    } else if constexpr (kind == FigureKind::segment || kind == FigureKind::capsule) {
      c.take(std::array{in_space(s.a), in_space(s.b)});
    } else if constexpr (kind == FigureKind::triangle) {
      c.take(std::array{in_space(s.a), in_space(s.b), in_space(s.c)});
    } else if constexpr (kind == FigureKind::tetrahedron) {
      c.take(std::array{s.a, s.b, s.c, s.d});
    } else if constexpr (kind == FigureKind::aabb) {
      if (is_empty(s)) return {};
      c.take(std::array{in_space(s.min), in_space(s.max)});
      c.aligned_ = true;
      c.ways_ = figure_dimension<std::remove_cvref_t<decltype(s)>> == 2 ? 2 : 3;
      c.size_ = std::size_t{1} << c.ways_;
    } else if constexpr (kind == FigureKind::obb || kind == FigureKind::rectangle) {
      c.take(std::array{in_space(s.center)});
      const auto half = coordinates(s.half);
      for (std::size_t i = 0; i < half.size(); ++i) c.take_way(in_space(s.axes[i]), std::fabs(half[i]));
    } else if constexpr (kind == FigureKind::lozenge) {
      c.take(std::array{s.corner});
      c.both_ = false;
      for (const Vector3& e : s.edges) c.take_way(e, 1);
    } else if constexpr (kind == FigureKind::convex_polyhedron) {
      if (s.mesh.corners.empty()) return {};
      c.polyhedron_ = &s;
    } else {
      return {};
    }
    return c;
  });
}

std::optional<CoreCorners> CoreCorners::of(const BodyView& body) {
  CoreCorners c;
  if (body.is_hull()) {
    c.list_ = body.vertices;
  } else if (body.figure.kind == FigureKind::quadrilateral) {
    const auto& q = *static_cast<const Quadrilateral3*>(body.figure.shape);
    c.take(std::array{q.a, q.b, q.c, q.d});
  } else if (body.figure.kind == FigureKind::polygon) {
    c.list_ = static_cast<const Polygon3*>(body.figure.shape)->vertices;
  } else if (const auto of_figure = of(body.figure)) {
    c = *of_figure;
  } else {
    return {};
  }
  if (c.is_listed()) c.size_ = c.list_.size();
  if (c.size() == 0) return {};
  c.take_pose(body.pose);
  return c;
}

void CoreCorners::take_pose(const AnyPoseView& pose) {
  pose_ = pose, stands_ = pose.stands();
  std::visit(
      [this]<class By>(const By& by) {
        if constexpr (std::is_same_v<By, const Pose*>) {
          columns_ = by->columns, translation_ = by->translation, is_turned_ = true;
        } else if constexpr (std::is_same_v<By, const RigidPose*>) {
          const auto m = exact_matrix(by->turn);
          is_far_ = !m;
          if (m) columns_ = m->columns, translation_ = by->translation, weight_ = m->weight, is_turned_ = true;
        } else {
          is_far_ = !std::is_same_v<By, std::monostate>;
        }
      },
      pose.by);
  has_scale_ = is_far_ || weight_ != 1;
}

void bring_to_one_weight(CoreCorners& a, CoreCorners& b) {
  if (!a.has_scale_ && !b.has_scale_) return;
  const bool is_far = a.is_far_ || b.is_far_;
  const double weight_a = a.weight_, weight_b = b.weight_;
  for (CoreCorners* c : {&a, &b}) {
    c->is_far_ = is_far, c->has_scale_ = true, c->stands_ = false;
    c->beside_ = (c == &a ? b : a).pose_, c->beside_weight_ = c == &a ? weight_b : weight_a;
  }
}

std::optional<Vector3> CoreCorners::axis_of_edge(std::size_t k) const {
  if (ways_ > 0 && !aligned_) return half_[k] == 0 ? Vector3{} : axes_[k];
  const auto [a, b] = std::pair(points_[0], points_[1]);
  const auto along = [&](std::size_t axis, double from, double to) {
    if (from == to || (aligned_ && k != axis)) return 0;
    return from < to ? 1 : -1;
  };
  const int x = along(0, a.x, b.x), y = along(1, a.y, b.y), z = along(2, a.z, b.z);
  if (x * x + y * y + z * z > 1) return {};
  return Vector3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

std::optional<Vector3> CoreCorners::axis_in_space(std::size_t k) const {
  const auto axis = axis_of_edge(k);
  if (!axis || is_far_) return {};
  if (!is_turned_ || *axis == Vector3{}) return axis;
  const auto& [x, y, z] = *axis;
  const int zeros = static_cast<int>(x == 0) + static_cast<int>(y == 0) + static_cast<int>(z == 0);
  if (zeros != 2 || std::fabs(x + y + z) != 1) return {};
  const Vector3& c = columns_[x != 0 ? 0 : y != 0 ? 1 : 2];
  return x + y + z > 0 ? c : Vector3{-c.x, -c.y, -c.z};
}

std::optional<PosedBox> CoreCorners::posed_box() const {
  if (ways_ != 3 || is_far_ || is_swept_ || time_ != 0) return {};
  const Point3 &p = points_[0], &q = points_[1];
  PosedBox b{};
  b.weight = weight_;
  b.columns = {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}, b.along = {1, 2, 3};
  if (is_turned_) b.columns = columns_, b.at = translation_, b.along = {along_of(0), along_of(1), along_of(2)};
  if (aligned_) {
    b.axes = b.columns;
    b.length = {{{p.x, q.x}, {p.y, q.y}, {p.z, q.z}}};
    b.local = {{{-p.x, q.x}, {-p.y, q.y}, {-p.z, q.z}}};
    return b;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = axis_in_space(k);
    if (!axis) return {};
    b.axes[k] = *axis, b.length[k] = {-half_[k], half_[k]};
  }
  if (is_turned_) {
    b.center = {p.x, p.y, p.z};
    b.local = {{{-p.x, p.x}, {-p.y, p.y}, {-p.z, p.z}}};
  } else {
    b.at = {p.x, p.y, p.z};
  }
  return b;
}

std::optional<GivenBox> CoreCorners::given_box() const {
  if (ways_ != 3 || !stands_ || is_swept_) return {};
  const Point3 &p = points_[0], &q = points_[1];
  if (aligned_) {
    return GivenBox{{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}},
                    {{{p.x, q.x}, {p.y, q.y}, {p.z, q.z}}},
                    {{{-p.x, q.x}, {-p.y, q.y}, {-p.z, q.z}}}};
  }
  const auto& h = half_;
  return GivenBox{axes_, {{{-h[0], h[0]}, {-h[1], h[1]}, {-h[2], h[2]}}}, {{{-p.x, p.x}, {-p.y, p.y}, {-p.z, p.z}}}};
}

bool CoreCorners::is_finite() const {
  double sum = sum_of(by_) + sum_of(less_) + time_;
  const bool has_pose = std::visit(
      []<class By>(const By& by) {
        if constexpr (std::is_same_v<By, std::monostate>) {
          return true;
        } else {
          return is_sound(*by);
        }
      },
      pose_.by);
  if (!has_pose) return false;
  if (!list_.empty()) {
    for (const Point3& p : list_) sum += sum_of(p);
    return is_real(sum);
  }
  if (polyhedron_ != nullptr) return is_real(sum) && is_sound(*polyhedron_);
  for (std::size_t i = 0; i < (aligned_ ? 2 : ways_ > 0 ? 1 : size_); ++i) sum += sum_of(points_[i]);
  for (std::size_t k = 0; k < ways_ && !aligned_; ++k) sum += sum_of(axes_[k]) + half_[k];
  return is_real(sum);
}

}  // namespace plumb::query
