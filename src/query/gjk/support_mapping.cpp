#include "plumb/query/gjk/support_mapping.hpp"

#include <array>
#include <charconv>
#include <string>
#include <string_view>

#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error.hpp"
#include "query/body/figure_input.hpp"
#include "query/gjk/body_pair.hpp"

namespace plumb::query {
namespace {

using BigVec = arith::Vec<BigDyadic>;

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}
/// With the fewest digits that tell it from its neighbors.
std::string text_of(double x) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr};
}
std::string text_of(std::string_view what, double x, double y, double z) {
  return joined({what, " (", text_of(x), ", ", text_of(y), ", ", text_of(z), ")"});
}
std::string text_of(const Point3& p) { return text_of("point", p.x, p.y, p.z); }
std::string text_of(const Vector3& v) { return text_of("direction", v.x, v.y, v.z); }

BigDyadic square_of(const Vector3& v) {
  const BigVec n = arith::vec<BigDyadic>(v);
  return dot(n, n);
}

/// What a mapping has told so far, and is held to.
class MappingHull {
 public:
  MappingHull(const SupportCall& mapping, std::string_view name, double rounding)
      : mapping_(mapping), name_(name), rounding_(rounding) {}

  const Point3& ask(const Vector3& direction) {
    const Point3 p = mapping_(direction);
    if (!is_real(sum_of(p))) {
      throw NonFinite(joined({"gjk_bounds: ", name_, " tells ", text_of(p), " for ", text_of(direction),
                              "; a support mapping tells a point of finite numbers"}));
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      require_no_farther(direction, points_[i], p, "which is less far along it than", points_[i]);
      require_no_farther(directions_[i], p, points_[i], "but earlier, along " + text_of(directions_[i]) + ",",
                         points_[i]);
    }
    points_.push_back(p), directions_.push_back(direction);
    return points_.back();
  }
  [[nodiscard]] const std::vector<Point3>& points() const { return points_; }

 private:
  /// Both are off by as much as the rounding.
  void require_no_farther(const Vector3& along, const Point3& one, const Point3& than, const std::string& how,
                          const Point3& other) const {
    const BigVec way = arith::vec<BigDyadic>(one) - arith::vec<BigDyadic>(than);
    const BigDyadic ahead = dot(arith::vec<BigDyadic>(along), way), slack = BigDyadic(rounding_) + BigDyadic(rounding_);
    if (ahead.sign() != Sign::positive || (ahead * ahead - slack * slack * square_of(along)).sign() != Sign::positive)
      return;
    throw InvalidShape(
        joined({"gjk_bounds: ", name_, " contradicts itself: it tells ", text_of(&other == &one ? than : one), ", ",
                how, " ", text_of(other), "; state its rounding, if it is no more than that"}));
  }

  SupportCall mapping_;
  std::string name_;
  double rounding_;
  std::vector<Point3> points_;
  std::vector<Vector3> directions_;
};

/// The way's numbers, of a size that doubles hold.
Vector3 told_direction(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const auto n = nearest_of<BigDyadic>(a, b, corners, ask);
  const BigDyadic square = dot(n.way, n.way);
  const auto part = [&](const BigDyadic& x) {  // of a vector of length one
    return rounded_radical(Rounding::nearest, BigDyadic(0.0), x, square, square);
  };
  return {part(n.way.x), part(n.way.y), part(n.way.z)};
}

/// root(square / whole) + extra.
double rounded_bound(Rounding rounding, const BigDyadic& square, const BigDyadic& whole, const BigDyadic& extra) {
  return rounded_radical(rounding, extra * whole, BigDyadic(1.0), square * whole, whole);
}

}  // namespace

GjkBounds bounds_of(const SupportCall& a, const SupportCall& b, const GjkBoundsOptions& options) {
  const auto require_length = [](const char* name, double x) {
    if (!is_real(x))
      throw NonFinite(joined({"gjk_bounds: options.", name, " is ", text_of(x), "; give a finite double"}));
    if (x < 0) throw InvalidShape(joined({"gjk_bounds: options.", name, " is negative; give one that is not"}));
  };
  require_length("rounding", options.rounding), require_length("within", options.within);
  const BigDyadic both_off = BigDyadic(options.rounding) + BigDyadic(options.rounding), none(0.0);
  MappingHull of_a(a, "a", options.rounding), of_b(b, "b", options.rounding);
  GjkBounds r;
  r.upper = Ball::infinity;
  Vector3 n{1, 0, 0};
  std::optional<mpq_class> last;
  DifferenceCorners guess;
  for (;;) {  // ends, for the square falls each time, and mappings tell finitely many points of doubles
    ++r.steps;
    const Point3 p = of_a.ask({-n.x, -n.y, -n.z}), q = of_b.ask(n);
    const BigVec way = arith::vec<BigDyadic>(p) - arith::vec<BigDyadic>(q);
    const BigDyadic gap = dot(arith::vec<BigDyadic>(n), way), whole = square_of(n);
    if (gap.sign() == Sign::positive) {
      const double lower = rounded_bound(Rounding::down, gap * gap, whole, none - both_off);
      if (lower > r.lower) r.lower = lower, r.direction = n;
      if ((gap * gap - both_off * both_off * whole).sign() == Sign::positive) r.told = GjkTold::disjoint;
    }
    const auto corners_a = CoreCorners::of(BodyView{.vertices = of_a.points()}),
               corners_b = CoreCorners::of(BodyView{.vertices = of_b.points()});
    if (guess.size == 4) guess.size = 3;
    guess.add({r.steps - 1, r.steps - 1});
    const ProvedCorners proved = certainly_nearest(*corners_a, *corners_b, guess);
    guess = proved.corners;
    const mpq_class square = QuickPair(*corners_a, *corners_b, 0, 0, proved).square();
    const double upper = rounded_bound(Rounding::up, BigDyadic(mpz_class(square.get_num())),
                                       BigDyadic(mpz_class(square.get_den())), both_off);
    r.upper = upper < r.upper ? upper : r.upper;
    if (proved.meets) {
      if (options.rounding == 0) r.told = GjkTold::meeting;
      return r;
    }
    if (last && square >= *last) return r;
    if (r.upper - r.lower <= options.within) return r;
    last = square;
    n = told_direction(*corners_a, *corners_b, proved.corners);
  }
}

}  // namespace plumb::query
