#include "plumb/query/overlap/posed_distance.hpp"

#include <string>

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "query/body/figure_input.hpp"
#include "query/body/posed_input.hpp"
#include "query/closest/posed_triangle.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/convex/flat_view.hpp"
#include "query/convex/posed_radius.hpp"
#include "query/convex/search.hpp"
#include "query/overlap/polygon_relation.hpp"
#include "query/separation/edge_sums.hpp"

namespace plumb::query {
namespace {

/// Convex sets whose union is the figure, or that of its core, and the radius that the image has.
struct MeasuredImage {
  std::vector<FlatSet> pieces;
  mpq_class radius = 0;
};

MeasuredImage measured_image(std::string_view function, const PosedView& v) {
  const PosedSet s = posed_set(v);
  MeasuredImage r{{}, radius_of_image(function, v, s)};
  if (is_polygon(v.figure)) {
    const ExactChains chains = image(s.map, exact_chains(function, v.figure));
    r.pieces = trapezoids(chains);
    for (FlatSet& edge : edges_of(chains)) r.pieces.push_back(std::move(edge));
  } else {
    if (s.core.points.empty()) {
      throw InvalidShape(std::string(function)
                             .append(": ")
                             .append(spoken(v.figure))
                             .append(" has no point; give a figure that is not empty"));
    }
    r.pieces.push_back(image(s));
  }
  return r;
}

/// The distance of the cores, squared, and what the radii take of it.
struct MeasuredGap {
  mpq_class square, inset;
  [[nodiscard]] bool is_open() const { return square > inset * inset; }
};

MeasuredGap measured_gap(Question question, const PosedView& a, const PosedView& b) {
  const std::string_view function = name_of(question);
  require_posed(function, a, b);
  const MeasuredImage p = measured_image(function, a), q = measured_image(function, b);
  MeasuredGap gap{-1, p.radius + q.radius};
  for (const FlatSet& s : p.pieces) {
    for (const FlatSet& t : q.pieces) {
      const mpq_class square = *squared_distance(s, t);
      if (sgn(gap.square) < 0 || square < gap.square) gap.square = square;
      if (sgn(square) == 0) return gap;
    }
  }
  return gap;
}

}  // namespace

Closest posed_closest_points(const Posed<Triangle3>& a, const Posed<Triangle3>& b) {
  require_posed("closest_points", posed_view(a), posed_view(b));
  return closest_points(PosedTriangle3(a), PosedTriangle3(b));
}
Closest posed_closest_points(const Point3& p, const Posed<Triangle3>& triangle) {
  require_posed("closest_points", posed_view(p), posed_view(triangle));
  const ClosestOnPosed near = closest_on(triangle, p);
  return {p, near.point, near.distance, {FeatureKind::vertex, 0}, near.feature};
}

// root(p / q) - n / m is (m root(p q) - n q) / (m q).
double posed_distance(const PosedView& a, const PosedView& b, Question question) {
  if (const auto d = distance_of_sums(a, b)) return *d;
  if (const auto d = distance_by_search(a, b)) return *d;
  const MeasuredGap gap = measured_gap(question, a, b);
  if (!gap.is_open()) return 0;
  const mpz_class &p = gap.square.get_num(), &q = gap.square.get_den();
  const mpz_class &n = gap.inset.get_num(), &m = gap.inset.get_den();
  return rounded_radical(Rounding::nearest, BigDyadic(mpz_class(-n * q)), BigDyadic(m), BigDyadic(mpz_class(p * q)),
                         BigDyadic(mpz_class(m * q)));
}

ExactDistance posed_exact_distance(const PosedView& a, const PosedView& b, Question question) {
  const MeasuredGap gap = measured_gap(question, a, b);
  if (!gap.is_open()) return {Rational(0.0), Rational(0.0)};
  return {exact_number(gap.square), exact_number(gap.inset)};
}

}  // namespace plumb::query
