// A predicate of one's own: of two weighted sites, which one does a point belong to?
//
// A site's power distance from p is |p - site|^2 - weight; cells of power diagrams are cut by its signs.  The formula
// is stated once, in + - *; its filter and its exact stages are derived.
#include <cstdio>
#include <plumb/predicates.hpp>

namespace {

struct Site {
  plumb::Point2 at;
  double weight;
};

/// Negative where p belongs to a, positive where it belongs to b, zero on the line between the cells.
plumb::Sign nearer_site(const Site& a, const Site& b, const plumb::Point2& p) {
  return plumb::sign_of(
      [](auto ax, auto ay, auto aw, auto bx, auto by, auto bw, auto px, auto py) {
        const auto dx = px - ax, dy = py - ay, ex = px - bx, ey = py - by;
        return (dx * dx + dy * dy - aw) - (ex * ex + ey * ey - bw);
      },
      a.at, a.weight, b.at, b.weight, p);
}

/// The same in plain floating point.
int nearer_site_float(const Site& a, const Site& b, const plumb::Point2& p) {
  const double dx = p.x - a.at.x, dy = p.y - a.at.y, ex = p.x - b.at.x, ey = p.y - b.at.y;
  const double x = (dx * dx + dy * dy - a.weight) - (ex * ex + ey * ey - b.weight);
  return (x > 0) - (x < 0);
}

}  // namespace

int main() {
  const Site a{{0.1, 0.2}, 0.05}, b{{0.7, 0.4}, 0.15};
  int belongs[3] = {}, wrong = 0, asked = 0;
  // Points within some ulps of the line between the cells: 0.6 x + 0.2 y = 0.25, the numbers rounded.
  for (int i = 0; i < 1000; ++i) {
    const double y = 0.001 * i, x = (0.25 - 0.2 * y) / 0.6;
    for (int ulps = -3; ulps <= 3; ++ulps) {
      const plumb::Point2 p{x + ulps * 0x1p-54, y};
      const plumb::Sign exact = nearer_site(a, b, p);
      ++belongs[static_cast<int>(exact) + 1];
      wrong += nearer_site_float(a, b, p) != static_cast<int>(exact);
      ++asked;
    }
  }
  std::printf("%d points: %d belong to a, %d to b, %d to both\n", asked, belongs[0], belongs[2], belongs[1]);
  std::printf("plain floating point is wrong about %d of them\n", wrong);
}
