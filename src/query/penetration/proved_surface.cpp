#include "query/penetration/proved_surface.hpp"

#include <algorithm>
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
    const QuickHull& hull = s.hull(body);
    const auto far = c.facet->plane.along(way_in(w, hull.given(e[0][body]), hull.given(i)));
    return (body == 0 ? w.negative(far) : w.positive(far)) && w.in_range();
  };
  auto of_a = level_corners(d.a, normal, Sign::positive, e[0][0], known.a, [&](auto i) { return is_below(0, i); });
  if (!of_a) return {};
  auto of_b = level_corners(d.b, normal, Sign::negative, e[0][1], known.b, [&](auto i) { return is_below(1, i); });
  if (!of_b) return {};
  return std::array{*of_a, *of_b};
}

/// The triangles that are nearest, or through the origin, as far as running errors tell.
class NearestTriangles {
 public:
  explicit NearestTriangles(const Difference& d) : d_(d) {}

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

/// Which triangles are farther than a length for certain?  It is a little more than the least distance is guessed to be.
class FartherThan {
 public:
  explicit FartherThan(GuessedSurface& s)
      : world_(s.world()),
        length_(s.least_square() > 0 ? std::sqrt(s.least_square()) * beyond : 0),
        limit_(world_.difference(length_, 0.0)),
        may_tell_(s.is_given() && world_.in_range()) {}

  [[nodiscard]] bool is_inside(const GuessedSurface::Facet& f) const { return world_.positive(f.plane.height); }
  [[nodiscard]] bool is_farther(const GuessedSurface::Facet& f) const {
    return may_tell_ && is_inside(f) && world_.positive(f.plane.farther_than(limit_));
  }
  [[nodiscard]] bool is_nearer(const GuessedSurface::Facet& f) const {
    return may_tell_ && is_inside(f) && world_.negative(f.plane.farther_than(limit_));
  }
  /// No more than the square of the length.
  [[nodiscard]] double square() const { return (Running(length_) * Running(length_)).lower(); }

 private:
  static constexpr double beyond = 1 + 0x1p-12;  // a guess: few are nearer than that

  GuessedSurface::World& world_;
  double length_;
  GuessedSurface::Number limit_;
  bool may_tell_;
};

/// Where all others are farther than a length for certain, and one is nearer: that one, which is inside as they are.
const GuessedSurface::Facet* only_nearest(const Difference& d, const GuessedSurface& s, const FartherThan& far) {
  const GuessedSurface::Facet* only = nullptr;
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (!f.is_there || far.is_farther(f)) continue;
    if (only == nullptr) {
      if (!far.is_nearer(f)) return nullptr;
      only = &f;
    } else {  // another part of it
      const std::array<Ends, 3> first = s.ends_of(*only);
      if (!far.is_inside(f) || !is_known_in(d, {&first, 1}, s.ends_of(f))) return nullptr;
    }
  }
  return only;
}

/// All that are nearest, or through the origin; false where one has the origin before it.
bool find_nearest(const GuessedSurface& s, const FartherThan& far, NearestTriangles& nearest) {
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (f.is_there && !far.is_farther(f) && !nearest.add(s.ends_of(f), f)) return false;
  }
  if (nearest.touches() || nearest.most() < far.square()) return true;
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (f.is_there && far.is_farther(f) && !nearest.add(s.ends_of(f), f)) return false;
  }
  return true;
}

/// Planes that are told, and of each what of both bodies lies in it.
class ToldPlanes {
 public:
  ToldPlanes(const Difference& d, GuessedSurface& s) : d_(d), surface_(s) {}

  /// Is it in a plane that is told?
  [[nodiscard]] bool has(const Candidate& c) const {
    const auto lies_in = [&](const std::array<LevelCorners, 2>& level) {
      return std::ranges::all_of(c.ends, [&](const Ends& e) {
        return std::ranges::binary_search(level[0], e[0]) && std::ranges::binary_search(level[1], e[1]);
      });
    };
    return std::ranges::any_of(levels_, lies_in);
  }
  /// False where something of the difference lies before it.
  bool add(const Candidate& c) {
    const auto level = level_in(d_, surface_, c);
    if (!level) return false;
    levels_.push_back(*level), planes_.push_back(c.ends);
    return true;
  }
  void clear() { levels_.clear(), planes_.clear(); }
  [[nodiscard]] std::optional<NearestPlanes> as(Origin origin) const {
    if (planes_.empty()) return {};
    NearestPlanes p{origin, planes_, {}};
    if (planes_.size() == 1) p.level = levels_[0];
    return p;
  }

 private:
  const Difference& d_;
  GuessedSurface& surface_;
  ShortList<std::array<LevelCorners, 2>, 2> levels_;
  ShortList<std::array<Ends, 3>, 8> planes_;
};

std::optional<NearestPlanes> proved(const Difference& d, GuessedSurface& s) {
  if (!s.is_sound() || !s.is_closed()) return {};
  const FartherThan far(s);
  ToldPlanes told(d, s);
  if (const GuessedSurface::Facet* only = only_nearest(d, s, far)) {
    if (!told.add({s.ends_of(*only), only, Running()})) return {};
    return told.as(Origin::inside);
  }
  NearestTriangles nearest(d);
  if (!find_nearest(s, far, nearest) || nearest.all().empty()) return {};
  const bool touches = nearest.touches();
  const Candidate* best = std::ranges::min_element(nearest.all(), {}, [](const auto& c) { return c.square.value; });
  if (!told.add(*best)) return {};
  for (const Candidate& c : nearest.all()) {
    if ((!touches && c.square.lower() > nearest.most()) || told.has(c)) continue;
    const Sign order = touches ? Sign::zero : compare(d, c, *best);
    if (order == Sign::positive) continue;
    if (order == Sign::negative) told.clear(), best = &c;
    if (!told.add(c)) return {};
  }
  return told.as(touches ? Origin::on_boundary : Origin::inside);
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
