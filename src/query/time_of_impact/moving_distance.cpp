#include "plumb/query/time_of_impact/moving_distance.hpp"

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

}  // namespace plumb::query
