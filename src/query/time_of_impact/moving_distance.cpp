#include "plumb/query/time_of_impact/moving_distance.hpp"

#include <cmath>
#include <limits>

#include "query/body/figure_input.hpp"

namespace plumb::query {

Point3 NearbyPlaces::operator()(const Interval& x, const Interval& y, const Interval& z) {
  Interval off(0.0);
  const auto near = [&off](const Interval& i) {
    const Interval width = Interval(i.upper) - Interval(i.lower);
    if (!(width.upper < Interval::infinity)) {  // beyond all doubles: anywhere
      off = Interval(Interval::infinity);
      return 0.0;
    }
    off = off + width;
    return std::fmax(i.lower, std::fmin(i.lower + width.upper / 2, i.upper));
  };
  const double px = near(x), py = near(y), pz = near(z);
  off_ = std::fmax(off_, off.upper);
  return {px, py, pz};
}

double surely_apart(double d, double off, double other_off) {
  const Interval left = Interval(std::nextafter(d, 0.0)) - Interval(off) - Interval(other_off);
  return std::fmax(0.0, left.lower);
}

double length_at_most(const Interval& x, const Interval& y, const Interval& z) {
  return root(x * x + y * y + z * z).upper;
}

void require_moving(std::string_view name, const FigureView& shape) {
  require_figure("first_contact_span", name, shape);
}
void require_way(std::string_view name, const Vector3& by) {
  const Point3 p{by.x, by.y, by.z};
  require_figure("first_contact_span", name, p);
}

TranslatingPair::TranslatingPair(const FigureView& a, const Vector3& by_a, const FigureView& b, const Vector3& by_b)
    : a_(a), b_(b), by_a_(by_a), by_b_(by_b) {
  const auto way = [](double x, double y) { return Interval(x) - Interval(y); };
  speed_ = length_at_most(way(by_a.x, by_b.x), way(by_a.y, by_b.y), way(by_a.z, by_b.z));
}

double TranslatingPair::distance_at(double t) const {
  return surely_apart(distance_of_moved(a_, by_a_, b_, by_b_, t, "first_contact_span"), 0, 0);
}

}  // namespace plumb::query
