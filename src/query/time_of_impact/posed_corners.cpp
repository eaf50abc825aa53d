#include "plumb/query/time_of_impact/posed_corners.hpp"

#include <memory>

#include "query/body/posed_input.hpp"
#include "query/time_of_impact/posed_motion.hpp"
#include "query/time_of_impact/separation_filter.hpp"

namespace plumb::query {
namespace {

using moving::MovingKind, moving::PosedQuestion;

/// Writes the corners, and returns where the next ones go.
std::size_t write_corners(const FigureView& v, std::array<Point3, 4>& to, std::size_t at) {
  const auto write = [&](std::initializer_list<Point3> corners) {
    for (const Point3& p : corners) to[at++] = p;
  };
  if (v.kind == FigureKind::point) {
    write({*static_cast<const Point3*>(v.shape)});
  } else if (v.kind == FigureKind::segment) {
    const auto& [a, b] = *static_cast<const Segment3*>(v.shape);
    write({a, b});
  } else {
    const auto& [a, b, c] = *static_cast<const Triangle3*>(v.shape);
    write({a, b, c});
  }
  return at;
}

/// The first of both is not the triangle.
std::optional<moving::TimedContact> timed_contact(const CornersInMotion& a, const CornersInMotion& b,
                                                  double separation) {
  PosedQuestion question{{}, {a.from.pose, a.to.pose}, {b.from.pose, b.to.pose}};
  const bool are_edges = a.from.figure.kind == FigureKind::segment;
  question.given.kind = are_edges ? MovingKind::edge_edge : MovingKind::vertex_triangle;
  write_corners(b.from.figure, question.given.at_0, write_corners(a.from.figure, question.given.at_0, 0));
  write_corners(b.to.figure, question.given.at_1, write_corners(a.to.figure, question.given.at_1, 0));
  return moving::posed_first_contact(question, separation);
}

std::optional<moving::TimedContact> asked(std::string_view function, const CornersInMotion& a, const CornersInMotion& b,
                                          const ContactOptions& options) {
  require_posed(function, "a.from", a.from), require_posed(function, "a.to", a.to);
  require_posed(function, "b.from", b.from), require_posed(function, "b.to", b.to);
  moving::require_separation(function, options.separation);
  if (a.from.figure.kind != FigureKind::triangle) return timed_contact(a, b, options.separation);
  auto found = timed_contact(b, a, options.separation);
  if (found) std::swap(found->a, found->b);
  return found;
}

}  // namespace

bool corners_meet(const CornersInMotion& a, const CornersInMotion& b, const ContactOptions& options) {
  return asked("intersects", a, b, options).has_value();
}
std::optional<Contact> corner_contact(const CornersInMotion& a, const CornersInMotion& b,
                                      const ContactOptions& options) {
  const auto found = asked("first_contact", a, b, options);
  if (!found) return {};
  return Contact{arith::rounded(Rounding::down, found->time), found->a, found->b};
}
std::optional<Root> corner_contact_time(const CornersInMotion& a, const CornersInMotion& b,
                                        const ContactOptions& options) {
  auto found = asked("first_contact_time", a, b, options);
  if (!found) return {};
  return Root(std::make_shared<const arith::IsolatedRoot>(std::move(found->time)));
}

}  // namespace plumb::query
