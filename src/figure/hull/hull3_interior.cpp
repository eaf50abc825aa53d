// The hull of a sample is cut into columns along x.  A column's rectangle in y and z has four corners; the line in x
// through each is in the sample's hull between the two faces that it meets, a little inside of which an interval is
// taken.  Where the four intervals overlap, the column is inside, as a box is that has its corners inside; and as the
// intervals are open, none of its points is a corner of the hull.
//
// Exact are: over which faces a line runs (three signs of orient2d each), and that the ends of its interval are
// strictly below both of them.  A point finds its column by a product, which rounds; but rounding is monotone, so the
// numbers of a column are an interval of doubles, whose first one is searched for.
#include "figure/hull/hull3_interior.hpp"

#include <cmath>
#include <limits>

#include "figure/hull/hull3_methods.hpp"
#include "figure/hull/hull3_start.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb::figure::hull3 {
namespace {

constexpr std::size_t least_points = 1 << 15, sample_size = 1 << 12;

std::vector<Node> all_nodes(std::span<const Point3> points) {
  std::vector<Node> nodes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) nodes[i] = {points[i], none, static_cast<Id>(i)};
  return nodes;
}

/// Steps of one coordinate, numbered from 0.
class Steps {
 public:
  Steps(double min, double max, std::size_t count)
      : count_(count), low_(min), scale_(static_cast<double>(count) / (max - min)) {
    sound_ = scale_ > 0 && scale_ <= std::numeric_limits<double>::max();
    if (!sound_) return;
    first_.push_back(min);
    for (std::size_t k = 1; k < count && sound_; ++k) {
      double low = first_.back(), high = max;
      sound_ = of(low) < k && of(high) >= k;
      // Ends, for `middle` is strictly between while there is a double between, and the last steps are by one.
      while (sound_ && std::nextafter(low, high) < high) {
        double middle = low / 2 + high / 2;
        if (!(low < middle && middle < high)) middle = std::nextafter(low, high);
        (of(middle) < k ? low : high) = middle;
      }
      first_.push_back(high);
    }
    first_.push_back(max);
  }

  /// Of a number from min to max; never falls as x grows.
  [[nodiscard]] std::size_t of(double x) const {
    const auto k = static_cast<std::size_t>((x - low_) * scale_);
    return k < count_ ? k : count_ - 1;
  }
  /// The least number of step k; for k = count the largest of all.
  [[nodiscard]] double first(std::size_t k) const { return first_[k]; }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Were the least numbers found?
  [[nodiscard]] bool sound() const { return sound_; }

 private:
  std::size_t count_;
  double low_, scale_;
  std::vector<double> first_;
  bool sound_;
};

/// Open, and empty unless min < max.
struct Between {
  double min, max;
};
constexpr double infinity = std::numeric_limits<double>::infinity();

class DirectionColumns {
 public:
  DirectionColumns(const Extents& extents, std::size_t count)
      : x_{extents.min.x, extents.max.x},
        y_(extents.min.y, extents.max.y, count),
        z_(extents.min.z, extents.max.z, count) {}

  [[nodiscard]] bool sound() const { return y_.sound() && z_.sound(); }

  /// strictly: of what is held nothing is on the hull's boundary; otherwise no corner of the hull is held.
  void fill(const Surface& hull, bool strictly) {
    strictly_ = strictly;
    const std::size_t lines = y_.count() + 1;
    std::vector<Between> inside(lines * lines, {infinity, -infinity});
    for (Id f = 0; f < hull.faces().size(); ++f) {
      if (hull.faces()[f].alive()) run_over(hull, f, inside);
    }
    // Both ends are known by their faces; each is taken a little inside, by a guess of what roundings move.
    constexpr double little = 4096;
    for (Between& i : inside) {
      const double margin = (i.max - i.min) / little;
      i = {i.min + margin, i.max - margin};
    }
    check(hull, inside);
    column_.resize(y_.count() * z_.count());
    for (std::size_t j = 0; j < y_.count(); ++j) {
      for (std::size_t k = 0; k < z_.count(); ++k) {
        Between all{-infinity, infinity};
        for (const std::size_t corner :
             {j * lines + k, j * lines + k + 1, (j + 1) * lines + k, (j + 1) * lines + k + 1}) {
          all = {std::max(all.min, inside[corner].min), std::min(all.max, inside[corner].max)};
        }
        column_[j * z_.count() + k] = all;
      }
    }
  }

  [[nodiscard]] bool hold(const Point3& p) const {
    const Between& i = column_[y_.of(p.y) * z_.count() + z_.of(p.z)];
    return p.x > i.min && p.x < i.max;
  }

 private:
  /// The lines that meet the face, by its shadow in y and z.
  template <class Visit>
  void each_line(const Surface& hull, Id face, Visit visit) const {
    const auto& v = hull.faces()[face].vertex;
    std::array<Point2, 3> shadow;
    for (std::size_t i = 0; i < 3; ++i) shadow[i] = {hull.point(v[i]).y, hull.point(v[i]).z};
    const Sign turn = sign_of(predicates::Orient2d{}, shadow[0], shadow[1], shadow[2]);
    if (turn == Sign::zero) return;
    const auto [y0, y1] = std::minmax({shadow[0].x, shadow[1].x, shadow[2].x});
    const auto [z0, z1] = std::minmax({shadow[0].y, shadow[1].y, shadow[2].y});
    for (std::size_t j = y_.of(y0); j <= y_.of(y1) + 1; ++j) {
      for (std::size_t k = z_.of(z0); k <= z_.of(z1) + 1; ++k) {
        const Point2 p{y_.first(j), z_.first(k)};
        bool meets = true;
        for (std::size_t i = 0; i < 3 && meets; ++i) {
          const Sign s = sign_of(predicates::Orient2d{}, shadow[i], shadow[(i + 1) % 3], p);
          meets = s == turn || (s == Sign::zero && !strictly_);
        }
        if (meets) visit(j * (y_.count() + 1) + k, p, turn == Sign::positive);
      }
    }
  }

  /// Where the lines meet the face, rounded.
  void run_over(const Surface& hull, Id face, std::vector<Between>& inside) const {
    const FacePlane& plane = hull.plane(face);
    each_line(hull, face, [&](std::size_t line, const Point2& p, bool right) {
      const double x = plane.pivot[0] -
                       ((p.x - plane.pivot[1]) * plane.coefficient[1] + (p.y - plane.pivot[2]) * plane.coefficient[2]) /
                           plane.coefficient[0];
      (right ? inside[line].max : inside[line].min) = std::min(std::max(x, x_.min), x_.max);
    });
  }

  /// Empties the intervals of which an end is not certainly strictly below the face that the line meets there.
  void check(const Surface& hull, std::vector<Between>& inside) const {
    std::vector<unsigned char> left(inside.size(), 0), right(inside.size(), 0);
    for (Id f = 0; f < hull.faces().size(); ++f) {
      if (!hull.faces()[f].alive()) continue;
      each_line(hull, f, [&](std::size_t line, const Point2& p, bool is_right) {
        const Between& i = inside[line];
        if (!(i.min < i.max)) return;
        if (hull.side(f, {is_right ? i.max : i.min, p.x, p.y}) > 0) (is_right ? right : left)[line] = 1;
      });
    }
    for (std::size_t line = 0; line < inside.size(); ++line) {
      if (left[line] == 0 || right[line] == 0) inside[line] = {infinity, -infinity};
    }
  }

  Between x_;
  bool strictly_ = true;
  Steps y_, z_;
  std::vector<Between> column_;
};

/// A spread-out sample, always the same.
std::vector<Node> sample_of(std::span<const Point3> points) {
  std::vector<Node> nodes;
  const std::size_t stride = points.size() / sample_size;
  std::uint64_t state = 0;
  for (std::size_t i = 0; i + stride <= points.size(); i += stride) {
    state = state * 6364136223846793005 + 1442695040888963407;
    const std::size_t at = i + static_cast<std::size_t>(state >> 33) % stride;
    nodes.push_back({points[at], none, static_cast<Id>(at)});
  }
  return nodes;
}

}  // namespace

std::vector<Node> outer_nodes(std::span<const Point3> points, const Extents& extents, bool all_boundary_points) {
  if (points.size() < least_points) return all_nodes(points);
  std::vector<Node> sample = sample_of(points);
  const Start start = find_start(sample);
  if (start.dimension < 3) return all_nodes(points);
  constexpr std::size_t many_points = 16 * least_points, fewer = 32, more = 64;  // guesses, of lines either way
  DirectionColumns columns(extents, points.size() < many_points ? fewer : more);
  if (!columns.sound()) return all_nodes(points);
  Surface hull(std::move(sample), extents);
  grow_quickhull(hull, start.simplex, false);
  columns.fill(hull, all_boundary_points);

  std::vector<Node> nodes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!columns.hold(points[i])) nodes.push_back({points[i], none, static_cast<Id>(i)});
  }
  return nodes;
}

}  // namespace plumb::figure::hull3
