#include "figure/obb/flush_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arith/big_rounding.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/measures/measures.hpp"

namespace plumb::figure::frame {
namespace {

using arith::cross, arith::dot, arith::Vec;
using Enclosed = Vec<Ball>;

// What is so small that its square is unknown, as zero give or take that much.
Ball squarable(const Ball& x) {
  constexpr double no_square = 0x1p-400;  // a guess: products of four such numbers are lost
  return std::fabs(x.high) < no_square ? Ball{0, 0, Ball::widened((std::fabs(x.high) + std::fabs(x.low)) + x.radius)}
                                       : x;
}

// Of a vector of magnitude one or so.
Enclosed unit_of(const Enclosed& given) {
  const Enclosed v{squarable(given.x), squarable(given.y), squarable(given.z)};
  const Ball length = root(dot(v, v));
  return {quotient(v.x, length), quotient(v.y, length), quotient(v.z, length)};
}

// Pairs of doubles for exact numbers, scaled so that the largest is one.
Enclosed near(const Vec<BigDyadic>& v) {
  BigDyadic most = magnitude(v.x);
  for (const BigDyadic& x : {magnitude(v.y), magnitude(v.z)}) {
    if ((x - most).sign() == Sign::positive) most = x;
  }
  const auto part = [&most](const BigDyadic& x) {
    const double high = rounded_quotient(Rounding::nearest, x, most);
    const double low = rounded_quotient(Rounding::nearest, x - BigDyadic(high) * most, most);
    return Ball{high, low, Interval::step(low)};
  };
  return {part(v.x), part(v.y), part(v.z)};
}

// Is each coordinate known well, and of a size that lengths can be had of?
bool is_known(const Enclosed& v) {
  constexpr double least = 0x1p-200, greatest = 0x1p200, well = 0x1p-60;  // guesses of which way to take
  const double most = std::max({std::fabs(v.x.high), std::fabs(v.y.high), std::fabs(v.z.high)});
  return most > least && most < greatest && std::max({v.x.radius, v.y.radius, v.z.radius}) < most * well;
}

// Points brought near to magnitude one by a power of two, where they are far from it, which is a guess; and whether that
// rounded nothing.
struct Scaled {
  std::vector<Point3> points;
  int exponent = 0;
  bool exact = true;

  explicit Scaled(std::span<const Point3> given) : points(given.begin(), given.end()) {
    constexpr double least = 0x1p-300, greatest = 0x1p300;  // guesses of what is near enough
    double most = 0;
    for (const Point3& p : given) most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    if (most > least && most < greatest) return;
    exponent = frame::exponent(most);
    for (Point3& p : points) {
      for (double* x : {&p.x, &p.y, &p.z}) {
        const double scaled = std::ldexp(*x, -exponent);
        exact = exact && std::ldexp(scaled, exponent) == *x;
        *x = scaled;
      }
    }
  }
};

// Exact directions of edges and normals of faces.
class Directions {
 public:
  Directions(std::span<const Point3> given, const Scaled& scaled) : given_(given), scaled_(scaled) {}

  [[nodiscard]] Enclosed edge(std::uint32_t a, std::uint32_t b) const {
    return enclosed([&]<class N>(const std::vector<Point3>* points) { return at<N>(b, points) - at<N>(a, points); });
  }
  // Corners of a face are never on a line.
  [[nodiscard]] Enclosed normal(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return enclosed([&]<class N>(const std::vector<Point3>* points) {
      return cross(at<N>(b, points) - at<N>(a, points), at<N>(c, points) - at<N>(a, points));
    });
  }

 private:
  template <class N>
  [[nodiscard]] Vec<N> at(std::uint32_t v, const std::vector<Point3>* points) const {
    return arith::vec<N>(points != nullptr ? (*points)[v] : given_[v]);
  }
  template <class Direction>
  [[nodiscard]] Enclosed enclosed(const Direction& direction) const {
    if (scaled_.exact) {
      const Enclosed quick = direction.template operator()<Ball>(&scaled_.points);
      if (is_known(quick)) return unit_of(quick);
    }
    return unit_of(near(direction.template operator()<BigDyadic>(nullptr)));
  }

  std::span<const Point3> given_;
  const Scaled& scaled_;
};

// No more than the volume of the hull, in cubes of side 2^exponent.
double volume_below(const HullModel& model, const Scaled& scaled, std::span<const Point3> given, int exponent) {
  TriangleMesh mesh{scaled.points, {}};
  for (std::size_t f = 0; f + 1 < model.first.size(); ++f) {
    for (std::uint32_t i = model.first[f] + 1; i + 1 < model.first[f + 1]; ++i)
      mesh.triangles.push_back({model.corners[model.first[f]], model.corners[i], model.corners[i + 1]});
  }
  if (scaled.exact) {
    const int grow = exponent - scaled.exponent;
    const double least = Interval::down(volume(mesh), -1), in_units = std::ldexp(least, -3 * grow);
    return std::ldexp(in_units, 3 * grow) == least ? std::max(in_units, 0.0) : 0;
  }
  BigDyadic six_volumes(0);
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](std::uint32_t v) { return arith::vec<BigDyadic>(given[v]); };
    six_volumes = six_volumes + dot(at(a), cross(at(b), at(c)));
  }
  const BigDyadic half_side(std::ldexp(1.0, exponent / 2)),
      side = half_side * BigDyadic(std::ldexp(1.0, exponent - exponent / 2));
  return rounded_quotient(Rounding::down, six_volumes, BigDyadic(6.0) * (side * side * side));
}

}  // namespace

FlushArcs::FlushArcs(const HullModel& model, std::span<const Point3> given) {
  const Scaled scaled(given);

  // The frame: the middle at the origin, which differences reach without error or with one that is known.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> middle{};
  double extent = 0;
  constexpr std::array<double Point3::*, 3> of_point{&Point3::x, &Point3::y, &Point3::z};
  constexpr std::array<double Vector3::*, 3> of_vector{&Vector3::x, &Vector3::y, &Vector3::z};
  for (std::size_t k = 0; k < 3; ++k) {
    double least = infinity, most = -infinity;
    for (const Point3& p : scaled.points) {
      least = std::min(least, p.*of_point[k]);
      most = std::max(most, p.*of_point[k]);
    }
    middle[k] = (least + most) / 2;
    extent = std::max({extent, most - middle[k], middle[k] - least});
  }
  const int grow = frame::exponent(extent);
  vertices.resize(given.size());
  places.resize(given.size(), {Ball(0.0), Ball(0.0), Ball(0.0)});
  constexpr std::array<Ball Enclosed::*, 3> of_place{&Enclosed::x, &Enclosed::y, &Enclosed::z};
  double off = 0;
  bool lost = false;
  for (std::size_t i = 0; i < given.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Rounded d = two_sum(scaled.points[i].*of_point[k], -middle[k]);
      const double x = std::ldexp(d.value, -grow), rest = std::ldexp(d.error, -grow);
      vertices[i].*of_vector[k] = x;
      places[i].*of_place[k] = {x, rest, 0};
      off = std::max(off, std::fabs(d.error));
      lost = lost || std::ldexp(x, grow) != d.value || std::ldexp(rest, grow) != d.error;
    }
  }
  exponent = scaled.exponent + grow;
  constexpr double tiniest = std::numeric_limits<double>::denorm_min();
  if (!scaled.exact) off = Interval::sum_up(off, tiniest);
  if (off > 0) vertex_error = Interval::up(std::ldexp(off, -grow), 1);
  if (lost) vertex_error = Interval::sum_up(vertex_error, tiniest);
  // Widens by what scaling and moving lost of both parts.
  const double scaling = scaled.exact ? 0 : Interval::up(std::ldexp(tiniest, -grow), 1);
  const double doubt = Interval::sum_up(scaling, lost ? 2 * tiniest : 0);
  for (Enclosed& p : places) {
    for (Ball* x : {&p.x, &p.y, &p.z}) {
      x->radius = doubt;
      *x = squarable(*x);
    }
  }

  const auto known = [this](const Enclosed& v) {
    for (const Ball& x : {v.x, v.y, v.z}) {
      const double reach = Ball::widened(std::fabs(x.low) + x.radius);
      if (!(reach <= direction_error)) direction_error = reach;  // also where nothing is known, be it by NaN
    }
    return Vector3{v.x.high, v.y.high, v.z.high};
  };
  const Directions directions(given, scaled);
  std::vector<Enclosed> faces;
  faces.reserve(model.normals.size());
  for (std::size_t f = 0; f < model.normals.size(); ++f) {
    const std::uint32_t* c = model.corners.data() + model.first[f];
    faces.push_back(directions.normal(c[0], c[1], c[2]));
    normals.push_back(known(faces.back()));
  }
  const auto add = [&](const auto& again, const Enclosed& l, const Enclosed& r, const Enclosed& e,
                       std::uint32_t vertex) -> void {
    constexpr double wide = -0.5;  // the cosine of 120 degrees
    const FlushArc arc{known(l), known(r), known(e), vertex};
    const double turn = frame::dot(arc.from, arc.to);
    if (turn >= most_turn || !(direction_error < sure_enough)) {
      arcs.push_back(arc);
      enclosed.push_back({l, r, e});
      return;
    }
    // At a right angle from l on the way to r, or halfway.
    const Enclosed between = turn < wide ? cross(e, l) : unit_of(l + r);
    again(again, l, between, e, vertex);
    again(again, between, r, e, vertex);
  };
  arcs.reserve(model.edges.size());
  enclosed.reserve(model.edges.size());
  for (const HullModel::Edge& e : model.edges)
    add(add, faces[e.left], faces[e.right], directions.edge(e.from, e.to), e.from);

  are_sure = direction_error < sure_enough;
  hull_volume = volume_below(model, scaled, given, exponent);
}

}  // namespace plumb::figure::frame
