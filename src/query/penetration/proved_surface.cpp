#include "query/penetration/proved_surface.hpp"

#include <cmath>

#include "query/penetration/guessed_surface.hpp"

namespace plumb::query::parting {
namespace {

struct Candidate {
  std::array<Ends, 3> ends;
  const GuessedSurface::Facet* facet;
  Running square;
};

template <class T>
PlaneOf<T> plane_of(const Difference& d, const std::array<Ends, 3>& e) {
  const Vec<T> p = d.at<T>(e[0]);
  return {cross(d.between<T>(e[0], e[1]), d.between<T>(e[0], e[2])), p};
}

bool is_triangle(const Difference& d, const std::array<Ends, 3>& e) {
  const auto is_not_zero = [&](auto part) {
    return sign_of([&]<class T>() -> T { return part(plane_of<T>(d, e).normal); }) != Sign::zero;
  };
  return is_not_zero([](const auto& v) { return v.x; }) || is_not_zero([](const auto& v) { return v.y; }) ||
         is_not_zero([](const auto& v) { return v.z; });
}

/// The order of two planes by their distance.
Sign compare(const Difference& d, const Candidate& p, const Candidate& q) {
  if (p.square.lower() > q.square.upper()) return Sign::positive;
  if (p.square.upper() < q.square.lower()) return Sign::negative;
  return sign_of([&]<class T>() -> T {
    const Fraction<T> x = EveryWay().measure(plane_of<T>(d, p.ends), 1),
                      y = EveryWay().measure(plane_of<T>(d, q.ends), 1);
    return x.above * y.below - y.above * x.below;
  });
}

/// What of both bodies lies in the plane; nothing where something of the difference lies before it.
std::optional<std::array<LevelCorners, 2>> level_in(const Difference& d, GuessedSurface& s, const Candidate& c) {
  const auto& e = c.ends;
  Normal normal([&]<class T>() -> Vec<T> { return plane_of<T>(d, e).normal; });
  const KnownPlane known(d, e);
  auto& w = s.world();
  const auto is_below = [&](std::size_t body, std::uint32_t i) {
    if (!s.is_given()) return false;
    const Point3 &p = s.hull(body).given(i), &from = s.hull(body).given(e[0][body]);
    const auto far =
        c.facet->plane.along(w.difference(p.x, from.x), w.difference(p.y, from.y), w.difference(p.z, from.z));
    return (body == 0 ? w.negative(far) : w.positive(far)) && w.in_range();
  };
  auto of_a = level_corners(d.a, normal, Sign::positive, e[0][0], known.a, [&](auto i) { return is_below(0, i); });
  if (!of_a) return {};
  auto of_b = level_corners(d.b, normal, Sign::negative, e[0][1], known.b, [&](auto i) { return is_below(1, i); });
  if (!of_b) return {};
  return std::array{*of_a, *of_b};
}

/// The triangles that are nearest, or through the origin, as far as running errors tell.
class Nearest {
 public:
  explicit Nearest(const Difference& d) : d_(d) {}

  [[nodiscard]] bool touches() const { return touches_; }
  [[nodiscard]] const ShortList<Candidate, 8>& all() const { return all_; }
  /// No less than the least square of a distance.
  [[nodiscard]] double most() const { return most_; }

  /// Is the origin on the inner side?
  bool add(const std::array<Ends, 3>& ends, const GuessedSurface::Facet& f) {
    const PlaneOf<Running> plane(d_.at<Running>(ends[0]), d_.at<Running>(ends[1]), d_.at<Running>(ends[2]));
    const Running height = plane.height();
    const Sign side = sign_of([&]<class T>() -> T {
      if constexpr (std::is_same_v<T, Running>) {
        return height;
      } else {
        return plane_of<T>(d_, ends).height();
      }
    });
    if (side == Sign::negative) return false;
    if (side == Sign::zero && !is_triangle(d_, ends)) return true;
    if (side == Sign::zero && !touches_) touches_ = true, all_.clear();
    if (touches_ != (side == Sign::zero)) return true;
    const Running square = touches_ ? Running() : quotient(height * height, dot(plane.normal, plane.normal));
    if (square.lower() > most_) return true;
    if (!touches_) most_ = std::min(most_, square.upper());
    all_.push_back({ends, &f, square});
    return true;
  }

 private:
  const Difference& d_;
  ShortList<Candidate, 8> all_;
  double most_ = std::numeric_limits<double>::infinity();
  bool touches_ = false;
};

/// Those of the surface; triangles that are farther than a length for certain are not looked at again, where another one
/// is no farther than that.
bool find_nearest(GuessedSurface& s, Nearest& nearest) {
  constexpr double beyond = 1 + 0x1p-30;  // a guess: what is nearer than that may be a tie
  const double length = s.least_square() > 0 ? std::sqrt(s.least_square()) * beyond : 0;
  auto& w = s.world();
  const auto limit = w.difference(length, 0.0);
  const bool may_skip = s.is_given() && w.in_range();
  const auto is_farther = [&](const GuessedSurface::Facet& f) {
    return w.positive(f.plane.height) && w.positive(f.plane.farther_than(limit));
  };
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (!f.is_there || (may_skip && is_farther(f))) continue;
    if (!nearest.add(s.ends_of(f), f)) return false;
  }
  const Running square = Running(length) * Running(length);
  if (!may_skip || nearest.touches() || nearest.most() < square.lower()) return true;
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (f.is_there && is_farther(f) && !nearest.add(s.ends_of(f), f)) return false;
  }
  return true;
}

std::optional<NearestPlanes> proved(const Difference& d, GuessedSurface& s) {
  if (!s.is_sound() || !s.is_closed()) return {};
  Nearest nearest(d);
  if (!find_nearest(s, nearest)) return {};
  NearestPlanes told{nearest.touches() ? Origin::on_boundary : Origin::inside, {}, {}};
  ShortList<Candidate, 4> best;
  for (const Candidate& c : nearest.all()) {
    if (!nearest.touches() && c.square.lower() > nearest.most()) continue;
    if (is_known_in(d, {told.facets.begin(), told.facets.size()}, c.ends)) continue;
    const Sign order = nearest.touches() || best.empty() ? Sign::zero : compare(d, c, best[0]);
    if (order == Sign::positive) continue;
    if (order == Sign::negative) told.facets.clear(), best.clear();
    best.push_back(c);
    told.facets.push_back(c.ends);
  }
  for (const Candidate& c : best) {
    const auto level = level_in(d, s, c);
    if (!level) return {};
    if (best.size() == 1) told.level = level;
  }
  if (best.empty()) return {};
  return told;
}

}  // namespace

std::optional<NearestPlanes> proved_planes(const Difference& d) {
  GuessedSurface s(d);
  s.grow_from_far();
  return proved(d, s);
}

std::optional<NearestPlanes> proved_planes(const Difference& d, const std::array<Ends, 4>& start) {
  GuessedSurface s(d);
  s.grow_from(start);
  return proved(d, s);
}

}  // namespace plumb::query::parting
