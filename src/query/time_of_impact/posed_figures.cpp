// Figures under poses as bodies, whose vertices are the posed ones.
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/posed.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/convex/exact_map.hpp"
#include "query/convex/flat_view.hpp"
#include "query/time_of_impact/body_meeting.hpp"
#include "query/time_of_impact/lifted_motion.hpp"
#include "query/time_of_impact/polygon_contact.hpp"

namespace plumb::query {
namespace {

Relation posed_figures_at_start(const PosedView& a, const PosedView& b) { return relate_posed("first_contact", a, b); }

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
      : a{of_a.figure, of_a.by},
        b{of_b.figure, of_b.by},
        some_polygon(is_polygon(of_a.figure.figure) || is_polygon(of_b.figure.figure)) {
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

}  // namespace

std::optional<Contact> posed_contact(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("first_contact", a, b);
    const auto c = posed_contact(lifted.a.motion(), lifted.b.motion());
    if (!c) return {};
    return Contact{c->time, lifted.a.in_plane(c->feature_a), lifted.b.in_plane(c->feature_b)};
  }
  const PosedBodies bodies("first_contact", a, b);
  if (!bodies.some_polygon) return body_contact("first_contact", bodies.a, bodies.b, posed_figures_at_start);
  const auto m = polygon_meeting("first_contact", a, b);
  if (!m) return {};
  return Contact{m->time.rounded(Rounding::down) + 0.0, m->of_a, m->of_b};
}
std::optional<Root> posed_contact_time(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("first_contact_time", a, b);
    return posed_contact_time(lifted.a.motion(), lifted.b.motion());
  }
  const PosedBodies bodies("first_contact_time", a, b);
  if (!bodies.some_polygon) return body_contact_time("first_contact_time", bodies.a, bodies.b, posed_figures_at_start);
  return polygon_meeting_time("first_contact_time", a, b);
}
bool posed_bodies_meet(const PosedMotion& a, const PosedMotion& b) {
  if (is_in_plane(a)) {
    const LiftedPair lifted("intersects", a, b);
    return posed_bodies_meet(lifted.a.motion(), lifted.b.motion());
  }
  const PosedBodies bodies("intersects", a, b);
  if (!bodies.some_polygon) return bodies_meet("intersects", bodies.a, bodies.b, posed_figures_at_start);
  return polygon_meeting_time("intersects", a, b).has_value();
}

}  // namespace plumb::query
