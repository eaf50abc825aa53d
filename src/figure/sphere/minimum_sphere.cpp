#include "plumb/figure/sphere/minimum_sphere.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "figure/sphere/point_scan.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace figure::sphere {
namespace {

template <class Point>
bool before(const Point& a, const Point& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  if constexpr (requires { a.z; }) return a.z < b.z;
  return false;
}

template <class Ball>
std::size_t size(const Ball& ball) {
  return static_cast<std::size_t>(ball.count);
}

/// The ball is the smallest that contains its points, none of which could be left out: its center lies within their
/// simplex.  So it is where each point is strictly outside the ball of the others: the center is then on the point's
/// side of them.  Points that span no ball fail, for zero is not outside.
template <class Ball>
bool rests_on_all(const Ball& ball) {
  if (ball.count <= 2) return true;
  for (std::size_t out = 0; out < size(ball); ++out) {
    Ball rest{{}, ball.count - 1};
    for (std::size_t i = 0, to = 0; i < size(ball); ++i) {
      if (i != out) rest.points[to++] = ball.points[i];
    }
    if (side(rest, ball.points[out]) != Sign::negative) return false;
  }
  return true;
}

/// The smallest ball of the points of this one and of p, which is outside it: p lies on it, and what else does is found
/// by looking at all choices, the smaller first.
template <class Ball>
Ball with(const Ball& old, const PointOf<Ball>& p) {
  const unsigned all = (1u << size(old)) - 1;
  for (int count = 2; count <= dimension<Ball> + 1; ++count) {
    for (unsigned chosen = 1; chosen <= all; ++chosen) {
      Ball ball{{p}, 1};
      for (std::size_t i = 0; i < size(old); ++i) {
        if ((chosen >> i & 1) != 0 && ball.count < count) ball.points[size(ball)] = old.points[i], ++ball.count;
      }
      if (std::popcount(chosen) + 1 != count) continue;
      bool holds = true;
      for (std::size_t i = 0; i < size(old) && holds; ++i) {
        holds = (chosen >> i & 1) != 0 || side(ball, old.points[i]) != Sign::negative;
      }
      if (holds && rests_on_all(ball)) return ball;
    }
  }
  std::abort();  // finitely many points always have a smallest ball
}

template <class Ball>
class SphereSearch {
 public:
  using Point = PointOf<Ball>;

  /// From the point that is farthest from the middle.
  SphereSearch(std::span<const Point> points, PointScan<Point>& scan, RestScan<Ball>& rests, const Point& middle,
               std::vector<Ball>* history)
      : points_(points), scan_(scan), rests_(rests), history_(history), center_(middle) {
    scan_.pass(center_);
    gather(-1);
    become({{points[candidates_[0]]}, 1});
    climb();
  }
  /// From the smallest ball of some of the points, and whether that was crowded.
  SphereSearch(std::span<const Point> points, PointScan<Point>& scan, RestScan<Ball>& rests, const Ball& of_some,
               bool crowded, std::vector<Ball>* history)
      : points_(points), scan_(scan), rests_(rests), history_(history), crowded_(crowded) {
    settle(of_some);
  }

  /// Indices of the points on the boundary of the smallest ball, which is then ball().
  std::vector<std::uint32_t> run() {
    std::vector<std::uint32_t> boundary;
    // Ends, for each turn but the last finds a point outside, and the exact ball that takes it in is larger: of the
    // finitely many that rest on some of the points none comes twice.
    while (pass_finds_some_outside() || !holds_all(boundary)) climb();
    return boundary;
  }

  [[nodiscard]] const Ball& ball() const { return ball_; }
  [[nodiscard]] bool is_crowded() const { return crowded_; }

 private:
  static constexpr std::size_t most_candidates = 64;

  /// Then they are in candidates_.  Where many points are off the boundary by ulps, a pass over all tells nothing.
  bool pass_finds_some_outside() {
    if (crowded_) return false;
    scan_.pass(center_);
    gather(limit_);
    return !candidates_.empty() && outside(candidates_[0]);
  }

  /// Is no point outside?  Then `boundary` has those on the boundary; else candidates_ has those first found outside.
  bool holds_all(std::vector<std::uint32_t>& boundary) {
    const FineBall<Ball> fine = fine_ball(ball_);
    rests_.aim(fine);
    boundary.clear();
    candidates_.clear();
    std::vector<std::size_t> open;
    std::size_t blocks = 0;
    scan_.blocks_from(crowded_ ? -1 : limit_, [&](std::size_t first, std::span<const Point>) {
      ++blocks;
      open.clear();
      rests_.not_certainly_inside(first, open);
      for (const std::size_t i : open) {
        const Sign s = exact_side(fine, i);
        if (s == Sign::zero) boundary.push_back(static_cast<std::uint32_t>(i));
        if (s == Sign::negative) candidates_.push_back(i);
      }
      return candidates_.size() < most_candidates;
    });
    crowded_ = crowded_ || blocks > scan_.blocks() / 2;
    return candidates_.empty();
  }

  [[nodiscard]] Sign exact_side(const FineBall<Ball>& fine, std::size_t i) const {
    const Unsure<Sign> s = fine.rest(points_[i]).sign();
    return s.certain() ? s.value() : side(ball_, points_[i]);
  }
  [[nodiscard]] bool outside(std::size_t i) const { return side(ball_, points_[i]) == Sign::negative; }

  void gather(double limit) {
    candidates_.clear();
    scan_.farthest(center_, limit, most_candidates, candidates_);
  }

  /// Takes a candidate in, about the farthest, as long as one is outside; ends as run() does.
  void climb() {
    while (const auto farthest = crowded_ ? farthest_outside() : farthest_of_pass())
      become(with(ball_, points_[*farthest]));
  }

  std::optional<std::size_t> farthest_of_pass() {
    std::size_t farthest = 0;
    double most = limit_;
    for (const std::size_t i : candidates_) {
      const double s = scan_.distance(center_, i);
      if (s > most) most = s, farthest = i;
    }
    if (most > limit_ && outside(farthest)) return farthest;
    // Doubles may place another one behind it that is outside by less than they see.
    const auto other = std::ranges::find_if(
        candidates_, [&](std::size_t i) { return scan_.distance(center_, i) > limit_ && outside(i); });
    return other == candidates_.end() ? std::nullopt : std::optional(*other);
  }

  /// Of candidates that doubles cannot tell apart.
  std::optional<std::size_t> farthest_outside() {
    const FineBall<Ball> fine = fine_ball(ball_);
    std::optional<std::size_t> farthest;
    double least = 0;
    for (const std::size_t i : candidates_) {
      if (exact_side(fine, i) != Sign::negative) continue;
      const double rest = fine.rest(points_[i]).high;
      if (!farthest || rest < least) least = rest, farthest = i;
    }
    return farthest;
  }

  void become(const Ball& ball) {
    if (history_ != nullptr) history_->push_back(ball);
    settle(ball);
  }

  void settle(const Ball& ball) {
    ball_ = ball;
    center_ = center_of(ball_);
    // The rounded center off the exact one: a point of the boundary is nearer to it by no more, and whoever is nearer by
    // twice that is in the exact ball.
    Interval off(0);
    for (const double x : coordinates(center_)) off = off + Interval(Interval::step(x));
    const double reach = rounded_root(Rounding::down, SquaredDistance<Point>{}, center_, ball_.points[0]);
    limit_ = scan_.within((Interval(reach) - off - off).lower);
  }

  std::span<const Point> points_;
  PointScan<Point>& scan_;
  RestScan<Ball>& rests_;
  std::vector<Ball>* history_;
  Ball ball_{};
  Point center_;
  double limit_ = -1;     // whoever is at this computed distance or nearer is in the ball
  bool crowded_ = false;  // most points lie off the boundary by less than doubles see
  std::vector<std::size_t> candidates_;
};

template <class Ball>
struct Found {
  Ball ball;
  bool crowded;
  std::vector<std::uint32_t> boundary;
};

/// The smallest ball of many points, and which of them lie on its boundary.
template <class Ball>
Found<Ball> found(std::span<const PointOf<Ball>> points, const Extent<PointOf<Ball>>& extent,
                  PointScan<PointOf<Ball>>& scan, RestScan<Ball>& rests, std::vector<Ball>* history) {
  constexpr std::size_t share = 32, least = 1024;  // outside the ball of one point in so many are some hundred of all
  const auto run = [](SphereSearch<Ball>&& search) {
    std::vector<std::uint32_t> boundary = search.run();
    return Found<Ball>{search.ball(), search.is_crowded(), std::move(boundary)};
  };
  if (points.size() < share * least) return run({points, scan, rests, middle_of(extent), history});
  std::vector<PointOf<Ball>> some;
  some.reserve(points.size() / share + 1);
  for (std::size_t i = 0; i < points.size(); i += share) some.push_back(points[i]);
  PointScan<PointOf<Ball>> scan_of_some(some, scan.scale());
  RestScan<Ball> rests_of_some(some, extent);
  const auto of_some = found<Ball>(some, extent, scan_of_some, rests_of_some, history);
  return run({points, scan, rests, of_some.ball, of_some.crowded, history});
}

/// The smallest ball of few points: one after the other is taken in, around and around until none is outside.
template <class Ball, class At>
Ball gone_around(std::size_t count, At at, std::vector<Ball>* history = nullptr) {
  const auto become = [&](Ball& to, const Ball& ball) {
    to = ball;
    if (history != nullptr) history->push_back(ball);
  };
  Ball ball;
  become(ball, {{at(0)}, 1});
  // Ends, for each ball is larger than the one before.
  for (std::size_t i = 0, in = 0; in < count; i = (i + 1) % count, ++in) {
    if (side(ball, at(i)) != Sign::negative) continue;
    become(ball, with(ball, at(i)));
    in = 0;
  }
  return ball;
}

/// One support of all that are possible, whatever the order of the input: the points in lexicographic order go around
/// until all are in the ball of the ones taken.
template <class Ball>
std::vector<std::uint32_t> support_of(std::span<const PointOf<Ball>> points, std::vector<std::uint32_t> boundary,
                                      Ball& ball) {
  std::ranges::sort(boundary, [&](std::uint32_t a, std::uint32_t b) {
    return before(points[a], points[b]) || (points[a] == points[b] && a < b);
  });
  const auto equal = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
  boundary.erase(std::unique(boundary.begin(), boundary.end(), equal), boundary.end());
  if (boundary.size() != size(ball)) {
    ball = gone_around<Ball>(boundary.size(), [&](std::size_t i) { return points[boundary[i]]; });
    std::erase_if(boundary, [&](std::uint32_t i) {
      return std::ranges::find(ball.points.begin(), ball.points.begin() + ball.count, points[i]) ==
             ball.points.begin() + ball.count;
    });
  }
  for (std::size_t i = 0; i < boundary.size(); ++i) ball.points[i] = points[boundary[i]];
  return boundary;
}

template <class Result, class Round, class Ball>
Result minimum(std::string_view function, std::span<const PointOf<Ball>> points, std::vector<Ball>* history,
               Round Result::*round) {
  if (points.empty()) throw InvalidShape(std::string(function).append(": no points; give at least one"));
  constexpr std::size_t few = 12;  // of whom no doubles need to say who is far from the center
  const auto all = extent(function, points);
  Result result{};
  double radius = 0;
  if (points.size() <= few) {
    result.exact = gone_around<Ball>(
        points.size(), [&](std::size_t i) { return points[i]; }, history);
    std::vector<std::uint32_t> boundary;
    boundary.reserve(few);
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (side(result.exact, points[i]) == Sign::zero) boundary.push_back(i);
    }
    result.support = support_of(points, std::move(boundary), result.exact);
    FarthestPoints<Ball> farthest(center_of(result.exact));
    farthest.reserve(few);
    const double scale = scale_for(half_width(all));
    std::array<double, few> square{};
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      square[i] = square_of_distance(farthest.center(), points[i], scale).value;
      most = std::max(most, square[i]);
    }
    const double least = PointScan<PointOf<Ball>>::rivals(most);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (square[i] >= least) farthest.take(points[i]);
    }
    result.*round = {farthest.center(), 0};
    radius = farthest.distance();
  } else {
    PointScan<PointOf<Ball>> scan(points, scale_for(half_width(all)));
    RestScan<Ball> rests(points, all);
    auto exact = found<Ball>(points, all, scan, rests, history);
    result.exact = exact.ball;
    result.support = support_of(points, std::move(exact.boundary), result.exact);
    result.*round = {center_of(result.exact), 0};
    radius = enclosing_radius(scan, rests, points, (result.*round).center);
  }
  (result.*round).radius = figure::within_doubles(radius, function, "radius");
  return result;
}

}  // namespace
}  // namespace figure::sphere

MinimumCircle minimum_circle(std::span<const Point2> points, const MinimumCircleOptions& options) {
  return figure::sphere::minimum<MinimumCircle>("minimum_circle", points, options.history, &MinimumCircle::circle);
}
MinimumSphere minimum_sphere(std::span<const Point3> points, const MinimumSphereOptions& options) {
  return figure::sphere::minimum<MinimumSphere>("minimum_sphere", points, options.history, &MinimumSphere::sphere);
}

}  // namespace plumb
