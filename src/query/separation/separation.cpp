// Nearest points of cores by the search of convex pairs; what that leaves is told of rationals, of figures as they stand
// and of their images under poses alike.
#include "plumb/query/separation/separation.hpp"

#include "arith/exact_number.hpp"
#include "figure/basic/plane_of_points.hpp"
#include "plumb/query/separation/posed.hpp"
#include "query/body/boundary.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/body/vectors.hpp"
#include "query/closest/flat_box.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/convex/core.hpp"
#include "query/convex/posed_radius.hpp"
#include "query/convex/search.hpp"
#include "query/separation/aligned_boxes.hpp"
#include "query/separation/cores.hpp"
#include "query/separation/edge_sums.hpp"
#include "query/separation/quick.hpp"
#include "query/separation/told_pair.hpp"

namespace plumb::query {
namespace {

std::string_view name_in_pair(const FigureView& figure, const FigureView& other, std::string_view name) {
  return figure.kind == other.kind ? name : spoken(figure);
}

/// A figure that is one, and where it is.
class ExactImage {
 public:
  ExactImage(std::string_view function, std::string_view name, const PosedView& v) : figure_(v.figure) {
    require_posed(function, name, v);
    with_figure(v.figure, [&]<class Shape>(const Shape& s) {
      if constexpr (is_one_of(figure_kind<Shape>, polygon_kinds) && figure_dimension<Shape> == 3) {
        std::vector<Point3> all;
        for_each_corner<double>(s, [&](const arith::Vec<double>& p) { all.push_back({p.x, p.y, p.z}); });
        require_planar(function, name, plane_of_points(all));
      }
    });
    if (!v.pose.stands()) posed_ = posed_set(v);
    radius_ = posed_ ? radius_of_image(function, v, *posed_) : mpq_class(radius_of(v.figure));
  }

  [[nodiscard]] FigureAt at() const { return posed_ ? FigureAt(figure_, posed_->map) : FigureAt(figure_); }
  [[nodiscard]] SeenFigure seen() const { return {figure_, radius_, posed_ ? &posed_->map : nullptr}; }
  [[nodiscard]] const mpq_class& radius() const { return radius_; }

 private:
  FigureView figure_;
  mpq_class radius_;
  std::optional<PosedSet> posed_;
};

NearestPair some_pair(std::string_view function, const FigureAt& at_a, const FigureAt& at_b, WhichPair which) {
  if (auto pair = nearest_of_cores(at_a, at_b, which)) return std::move(*pair);
  const FigureView &a = at_a.figure, &b = at_b.figure;
  const bool is_a_some = is_polygon(a) || !core_of(a).points.empty();
  throw InvalidShape(std::string(function)
                         .append(": ")
                         .append(is_a_some ? name_in_pair(b, a, "b") : name_in_pair(a, b, "a"))
                         .append(" is empty, and nothing is nearest; give one that has a point"));
}

/// What is nearest, of figures that are some.
struct ExactPair {
  ExactPair(std::string_view function, const PosedView& p, const PosedView& q, WhichPair which)
      : a(function, name_in_pair(p.figure, q.figure, "a"), p),
        b(function, name_in_pair(q.figure, p.figure, "b"), q),
        nearest(some_pair(function, a.at(), b.at(), which)) {}
  [[nodiscard]] mpq_class both_radii() const { return a.radius() + b.radius(); }

  ExactImage a, b;
  NearestPair nearest;
};

double distance_at(const FigureAt& a, const FigureAt& b, std::string_view function) {
  const auto radii = [&] { return mpq_class(mpq_class(radius_of(a.figure)) + radius_of(b.figure)); };
  if (const auto quick = QuickPair::of(a, b)) {
    const auto d = quick->distance();
    return d ? *d : rounded_distance(quick->square(), radii());
  }
  return rounded_distance(some_pair(function, a, b, WhichPair::any).square, radii());
}

}  // namespace

Closest posed_closest_points(const PosedView& a, const PosedView& b, WhichPair common) {
  if (const auto c = closest_of_sums(a, b)) return *c;
  if (const auto c = closest_by_search(a, b, common)) return *c;
  const ExactPair pair("closest_points", a, b, WhichPair::first);  // a radius is a number after this
  return told_pair(pair.nearest, pair.a.seen(), pair.b.seen());
}

double posed_distance(const PosedView& a, const PosedView& b, Question question) {
  if (const auto d = distance_of_sums(a, b)) return *d;
  if (const auto d = distance_by_search(a, b)) return *d;
  const ExactPair pair(name_of(question), a, b, WhichPair::any);
  return rounded_distance(pair.nearest.square, pair.both_radii());
}

ExactDistance posed_exact_distance(const PosedView& a, const PosedView& b, Question question) {
  const ExactPair pair(name_of(question), a, b, WhichPair::any);
  const mpq_class radii = pair.both_radii();
  if (pair.nearest.square <= radii * radii) return {Rational(0.0), Rational(0.0)};
  return {exact_number(pair.nearest.square), exact_number(radii)};
}

Closest posed_closest_points(const Posed<Triangle3>& a, const Posed<Triangle3>& b) {
  require_posed("closest_points", posed_view(a), posed_view(b));
  return closest_points(PosedTriangle3(a), PosedTriangle3(b));
}
Closest posed_closest_points(const Point3& p, const Posed<Triangle3>& triangle) {
  require_posed("closest_points", posed_view(p), posed_view(triangle));
  const ClosestOnPosed near = closest_on(triangle, p);
  return {p, near.point, near.distance, {FeatureKind::vertex, 0}, near.feature};
}

Closest closest_points_of(const FigureView& a, const FigureView& b, WhichPair common) {
  const auto f = facing_points(a, b);
  if (!f) return posed_closest_points({a}, {b}, common);
  const auto feature = [&](const Aabb3& box, const Point3& p) {
    return a.dimension == 2 ? of_flat_box(voronoi_region(box, p)) : voronoi_region(box, p);
  };
  return {told(f->on_a), told(f->on_b), distance(f->on_a, f->on_b), feature(f->a, f->on_a), feature(f->b, f->on_b)};
}

double distance_of(const FigureView& a, const FigureView& b, Question question) {
  if (const auto f = facing_points(a, b)) return distance(f->on_a, f->on_b);
  return posed_distance({a}, {b}, question);
}

double distance_of_moved(const FigureView& a, const Vector3& by_a, const FigureView& b, const Vector3& by_b,
                         double time, std::string_view function) {
  return distance_at({a, by_a, time}, {b, by_b, time}, function);
}

ExactDistance exact_distance_of(const FigureView& a, const FigureView& b, Question question) {
  if (const auto f = facing_points(a, b)) return exact_distance(f->on_a, f->on_b);
  if (const auto quick = QuickPair::of(a, b))
    return {exact_number(quick->square()), exact_number(mpq_class(mpq_class(radius_of(a)) + radius_of(b)))};
  const ExactPair pair(name_of(question), {a}, {b}, WhichPair::any);
  return {exact_number(pair.nearest.square), exact_number(pair.both_radii())};
}

}  // namespace plumb::query
