#include "plumb/query/body/any_figure.hpp"

#include <algorithm>

namespace plumb {

namespace {

bool same(const PolygonMesh& a, const PolygonMesh& b) {
  return a.vertices == b.vertices && a.corners == b.corners && a.first == b.first;
}

std::string named(const query::FigureView& v) {
  return std::string(name_of(v.kind)) + (v.dimension == 2 ? " of the plane" : " of space");
}

}  // namespace

bool operator==(const AnyFigure& a, const AnyFigure& b) {
  if (a.kind_ != b.kind_ || a.dimension_ != b.dimension_ || a.pose_ != b.pose_) return false;
  return visit(
      [&b]<class Shape>(const Shape& s) {
        const Shape& other = *get_if<Shape>(b);
        if constexpr (std::is_same_v<Shape, ConvexPolyhedron3>) {
          return same(s.mesh, other.mesh);  // what else it holds follows from that
        } else {
          return s == other;
        }
      },
      a);
}

AnyFigure AnyFigure::under(const AnyPose& pose) const {
  const bool fits = std::visit(
      [this]<class By>(const By&) {
        return std::is_same_v<By, std::monostate> || (dimension_ == 2 ? PoseOfPlane<By> : PoseOfSpace<By>);
      },
      pose);
  if (!fits) {
    throw Unsupported("a pose of " + std::string(dimension_ == 2 ? "space" : "the plane") + " moves no " +
                      named(figure()) + "; give a " +
                      (dimension_ == 2 ? "Pose2, a RigidPose2 or a RigidChain2" : "Pose, a RigidPose or a RigidChain"));
  }
  AnyFigure there = *this;
  there.pose_ = pose;
  return there;
}

namespace query {

void refuse_pair(std::string_view question, const FigureView& a, const FigureView& b) {
  throw Unsupported(std::string(question) + " has no answer for a " + named(a) + " and a " + named(b) +
                    "; the pages of docs/ list the pairs of each question, and query/body/ holds their tables");
}

void refuse_figure(std::string_view question, const FigureView& figure) {
  throw Unsupported(std::string(question) + " has no answer for a " + named(figure) +
                    "; docs/figures.md lists the kinds");
}

}  // namespace query

}  // namespace plumb
