// Figures under poses as bodies, whose vertices are the posed ones.
#include <cmath>
#include <string>
#include <variant>

#include "plumb/arith/error.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/body/detail/with_figure.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/overlap/posed_distance.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/in_space.hpp"
#include "query/body/posed_input.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"
#include "query/time_of_impact/body_meeting.hpp"
#include "query/time_of_impact/polygon_contact.hpp"

namespace plumb::query {
namespace {

template <class Shape>
auto lifted_shape(const Shape& s) {
  if constexpr (std::is_same_v<Shape, Obb2>) {
    return Obb3{in_space(s.center),
                {in_space(s.axes[0]), in_space(s.axes[1]), {0, 0, 1}},
                {std::fabs(s.half.x), std::fabs(s.half.y), 0}};
  } else {
    return in_space(s);
  }
}

Pose lifted_pose(const Pose2& flat) {
  const auto& [u, v] = flat.columns;
  Pose pose{{{{u.x, u.y, 0}, {v.x, v.y, 0}, {0, 0, 1}}}, {flat.translation.x, flat.translation.y, 0}};
  Pose scaled = pose;
  scaled.columns[2].z = std::hypot(u.x, u.y);  // a guess
  return scale_of(&scaled) ? scaled : pose;
}
RigidPose lifted_pose(const RigidPose2& flat) { return {rotation_of(flat.turn), in_space(flat.translation)}; }
RigidChain lifted_pose(const RigidChain2& flat) {
  RigidChain chain;
  for (const RigidPose2& link : flat.links) chain.links.push_back(lifted_pose(link));
  return chain;
}

AnyPose lifted_pose(const AnyPoseView& flat) {
  return std::visit(
      []<class By>(const By& by) -> AnyPose {
        if constexpr (requires { lifted_pose(*by); }) {
          return lifted_pose(*by);
        } else {
          return AnyPose();
        }
      },
      flat.by);
}

/// Which figure of space in motion is a figure of the plane under its pose, in z = 0?  A copy, exact; what is round keeps a
/// pose that is a similarity one in space, if lengths are multiplied by a double.
class LiftedMotion {
 public:
  explicit LiftedMotion(const PosedMotion& flat)
      : kind_(flat.figure.figure.kind), pose_(lifted_pose(flat.figure.pose)), by_(flat.by) {
    with_figure(flat.figure.figure, [this]<class Shape>(const Shape& s) {
      if constexpr (MovesInPlane<Shape>) shape_ = lifted_shape(s);
    });
  }
  LiftedMotion(const LiftedMotion&) = delete;
  LiftedMotion& operator=(const LiftedMotion&) = delete;

  [[nodiscard]] PosedMotion motion() const {
    PosedMotion in_space{{}, by_};
    in_space.figure = std::visit([](const auto& s) { return PosedView{view_of(s)}; }, shape_);
    in_space.figure.pose = pose_;
    return in_space;
  }
  /// Edge 4 axis + y + 2 z, or + x + 2 z, of a box in space is edge 2 axis + y, or + x.
  [[nodiscard]] Feature in_plane(const Feature& f) const {
    if (f.kind == FeatureKind::interior) return f;
    if (kind_ == FigureKind::ball) return {FeatureKind::edge, 0};
    if (kind_ != FigureKind::aabb && kind_ != FigureKind::obb) return f;
    if (f.kind == FeatureKind::edge) return {f.kind, 2 * (f.index / 4) + (f.index & 1u)};
    return {f.kind, f.kind == FeatureKind::face ? 0 : f.index & 3u};
  }

 private:
  FigureKind kind_;
  std::variant<Point3, Segment3, Triangle3, Polygon3, HoledPolygon3, Aabb3, Obb3, Sphere3, Capsule3> shape_;
  AnyPose pose_;
  Vector3 by_;
};

/// With a radius by the distance, as query/variant/own_figure.hpp says.
Relation posed_figures_at_start(const BodyMotion& a, const BodyMotion& b) {
  if (a.radius == 0 && b.radius == 0) return relate_posed("first_contact", a.shape, b.shape);
  const ExactDistance d = posed_exact_distance(a.shape, b.shape, Question::exact_distance);
  const Rational inset = d.inset + Rational(a.radius) + Rational(b.radius);
  const auto order = d.square <=> inset * inset;
  return order > 0 ? Relation::disjoint : order < 0 ? Relation::overlapping : Relation::touching;
}

/// Leaves the pose what is round round, and a plane a plane?
void require_even(std::string_view function, const PosedView& v) {
  if (is_rigid(v.pose)) return;
  const auto refuse = [&](std::string_view why) {
    throw UnevenPose(std::string(function).append(": ").append(spoken(v.figure)).append(": ").append(why));
  };
  if (v.figure.kind == FigureKind::plane && is_singular(exact_map(v.pose)))
    refuse("its pose flattens it; give one whose matrix is not singular");
  const bool is_round = is_one_of(v.figure.kind, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge});
  if (is_round && !scale_of(v.pose))
    refuse(std::string("its pose makes an ellipsoid of it; ")
               .append(rigid_instead)
               .append(", or columns at right angles and of one length that is a double"));
}

/// In the terms of bodies, looked at.
struct PosedBodies {
  PosedBodies(std::string_view function, const PosedMotion& of_a, const PosedMotion& of_b)
      : a{of_a.figure, &of_a.by, nullptr, of_a.radius},
        b{of_b.figure, &of_b.by, nullptr, of_b.radius},
        some_polygon((of_a.radius == 0 && is_polygon(of_a.figure.figure)) ||
                     (of_b.radius == 0 && is_polygon(of_b.figure.figure))) {
    if (some_polygon && (of_a.radius > 0 || of_b.radius > 0))
      throw Unsupported(std::string(function) + " of a rounded hull takes no polygon; ask its triangles");
    require_posed(function, of_a.figure, of_b.figure);
    require_even(function, of_a.figure);
    require_even(function, of_b.figure);
  }
  BodyMotion a, b;
  bool some_polygon;
};

bool is_in_plane(const PosedMotion& m) { return m.figure.figure.dimension == 2; }

/// Two of the plane, looked at, in the plane z = 0.
struct LiftedPair {
  LiftedPair(std::string_view function, const PosedMotion& of_a, const PosedMotion& of_b) : a(of_a), b(of_b) {
    require_posed(function, of_a.figure, of_b.figure);
  }
  LiftedMotion a, b;
};

/// Asks by the types where translating_contact.hpp has a method for them; else as bodies, or as a polygon and a body.
template <class ByTypes, class Answer, class OfPolygon>
Answer asked(std::string_view function, const PosedMotion& a, const PosedMotion& b, const ByTypes& by_types,
             Answer (*of_bodies)(std::string_view, const BodyMotion&, const BodyMotion&, StartRelation),
             const OfPolygon& of_polygon) {
  const auto as_bodies = [&]() -> Answer {
    const PosedBodies bodies(function, a, b);
    return bodies.some_polygon ? of_polygon(function, a, b)
                               : of_bodies(function, bodies.a, bodies.b, posed_figures_at_start);
  };
  if (!a.figure.pose.stands() || !b.figure.pose.stands() || a.radius > 0 || b.radius > 0) return as_bodies();
  return with_figure(a.figure.figure, [&]<class A>(const A& x) -> Answer {
    if constexpr (MovesStraight<A>) {
      return with_figure(b.figure.figure, [&]<class B>(const B& y) -> Answer {
        if constexpr (MovingPair<A, B>) {
          return by_types(Translating<A>{x, a.by}, Translating<B>{y, b.by});
        } else {
          return as_bodies();
        }
      });
    } else {
      return as_bodies();
    }
  });
}

}  // namespace

std::optional<Contact> posed_contact(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("first_contact", a, b);
    const auto c = posed_contact(lifted.a.motion(), lifted.b.motion());
    if (!c) return {};
    return Contact{c->time, lifted.a.in_plane(c->feature_a), lifted.b.in_plane(c->feature_b)};
  }
  return asked(
      "first_contact", a, b, [](const auto& x, const auto& y) { return first_contact(x, y); }, body_contact,
      [](std::string_view function, const PosedMotion& x, const PosedMotion& y) -> std::optional<Contact> {
        const auto m = polygon_meeting(function, x, y);
        if (!m) return {};
        return Contact{m->time.rounded(Rounding::down) + 0.0, m->of_a, m->of_b};
      });
}
std::optional<Root> posed_contact_time(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("first_contact_time", a, b);
    return posed_contact_time(lifted.a.motion(), lifted.b.motion());
  }
  return asked(
      "first_contact_time", a, b, [](const auto& x, const auto& y) { return first_contact_time(x, y); },
      body_contact_time, polygon_meeting_time);
}
bool posed_bodies_meet(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("intersects", a, b);
    return posed_bodies_meet(lifted.a.motion(), lifted.b.motion());
  }
  return asked(
      "intersects", a, b, [](const auto& x, const auto& y) { return intersects(x, y); }, bodies_meet,
      [](std::string_view function, const PosedMotion& x, const PosedMotion& y) {
        return polygon_meeting_time(function, x, y).has_value();
      });
}

}  // namespace plumb::query
