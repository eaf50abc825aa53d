// Random bodies of every kind, by their views, and their exact sets: what GJK is held against.
//
// Laws: those of a Material; the figures are those of query/body/pair_shapes.hpp.  A body lives as long as its AnyBody.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "figure/basic/rationals.hpp"
#include "query/body/pair_shapes.hpp"
#include "query/body/pair_types.hpp"
#include "query/body/posed_cases.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::drawn_body {

using pair_cases::Material, query::BodyView, query::Exact3, query::FlatSet;

struct AnyBody {
  std::shared_ptr<const void> shape;
  std::shared_ptr<const Pose> pose;
  BodyView view;
};

template <class Shape>
AnyBody any(Shape s) {
  auto shape = std::make_shared<const Shape>(std::move(s));
  return {shape, nullptr, query::body_view(*shape)};
}
inline AnyBody any(std::vector<Point3> points) {
  auto list = std::make_shared<const std::vector<Point3>>(std::move(points));
  return {list, nullptr, BodyView{.vertices = *list}};
}
inline AnyBody under(AnyBody body, const Pose& pose) {
  body.pose = std::make_shared<const Pose>(pose);
  body.view.pose = body.pose.get();
  return body;
}

using Make = std::function<AnyBody(Material&)>;
template <class... Shapes>
std::vector<Make> makers_of(pair_cases::Types<Shapes...>) {
  std::vector<Make> all;
  const auto add = [&all]<class Shape>(const Shape*) {
    if constexpr (ConvexBody3<Shape>) all.push_back([](Material& m) { return any(pair_cases::near_figure<Shape>(m)); });
  };
  (add(static_cast<const Shapes*>(nullptr)), ...);
  all.push_back([](Material& m) {
    std::vector<Point3> points;
    for (std::size_t n = 1 + m.below(7); n-- > 0;) points.push_back(m.below(2) == 0 ? m.point3() : m.probe3());
    return any(std::move(points));
  });
  return all;
}
/// Figures as pairs are made of, and a hull of points.
inline const std::vector<Make>& makers() {
  static const std::vector<Make> all = makers_of(pair_cases::Space{});
  return all;
}

/// The hull of its corners.
inline FlatSet core_of(const query::Body& body) {
  FlatSet s;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const auto p = body.corners.at<mpq_class>(i);
    s.points.push_back({p.x, p.y, p.z});
  }
  return s;
}

inline std::string name_of(const BodyView& v) {
  return std::string(query::spoken(v)) + (v.pose.stands() ? "" : " posed");
}

}  // namespace plumb::drawn_body
