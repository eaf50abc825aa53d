#include "query/penetration/proved_surface.hpp"

namespace plumb::query::parting {
namespace {

/// Has each triangle another one on each of its edges, the other way round?
bool is_closed(const GuessedSurface& s) {
  const auto all = s.facets();
  for (std::uint32_t f = 0; f < all.size(); ++f) {
    for (std::size_t k = 0; k < 3 && all[f].is_there; ++k) {
      const GuessedSurface::Facet& g = all[all[f].across[k]];
      const std::uint32_t from = all[f].corner[k], to = all[f].corner[(k + 1) % 3];
      bool is_back = false;
      for (std::size_t m = 0; m < 3; ++m) {
        is_back = is_back || (g.across[m] == f && g.corner[m] == to && g.corner[(m + 1) % 3] == from);
      }
      if (!g.is_there || !is_back) return false;
    }
  }
  return true;
}

struct Candidate {
  std::array<Ends, 3> ends;
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
  return sign_of([&]<class T>() -> T {
    const Fraction<T> x = EveryWay().measure(plane_of<T>(d, p.ends), 1),
                      y = EveryWay().measure(plane_of<T>(d, q.ends), 1);
    return x.above * y.below - y.above * x.below;
  });
}

bool has_nothing_before(const Difference& d, const std::array<Ends, 3>& e) {
  Normal normal([&]<class T>() -> Vec<T> { return plane_of<T>(d, e).normal; });
  const KnownPlane known(d, e);
  return !any_further(d.a, normal, Sign::positive, e[0][0], known.a) &&
         !any_further(d.b, normal, Sign::negative, e[0][1], known.b);
}

}  // namespace

std::optional<NearestPlanes> proved_planes(const Difference& d, const std::array<Ends, 4>& start) {
  const GuessedSurface s(d, start);
  if (!s.is_sound() || !is_closed(s)) return {};
  ShortList<Vec<Running>, 48> at;
  for (const GuessedSurface::Point& p : s.points()) at.push_back(d.at<Running>(p.ends));
  ShortList<Candidate, 16> nearest;
  double most = std::numeric_limits<double>::infinity();
  bool touches = false;
  for (const GuessedSurface::Facet& f : s.facets()) {
    if (!f.is_there) continue;
    const std::array<Ends, 3> ends = s.ends_of(f);
    const PlaneOf<Running> plane(at[f.corner[0]], at[f.corner[1]], at[f.corner[2]]);
    const Running height = plane.height();
    const Sign side = sign_of([&]<class T>() -> T {
      if constexpr (std::is_same_v<T, Running>) {
        return height;
      } else {
        return plane_of<T>(d, ends).height();
      }
    });
    if (side == Sign::negative) return {};
    if (side == Sign::zero && !is_triangle(d, ends)) continue;
    if (side == Sign::zero && !touches) touches = true, nearest.clear();
    if (touches != (side == Sign::zero)) continue;
    const Running square = touches ? Running() : quotient(height * height, dot(plane.normal, plane.normal));
    if (square.lower() > most) continue;
    if (!touches) most = std::min(most, square.upper());
    nearest.push_back({ends, square});
  }
  NearestPlanes told{touches ? Origin::on_boundary : Origin::inside, {}};
  std::optional<Candidate> best;
  for (const Candidate& c : nearest) {
    if (!touches && c.square.lower() > most) continue;
    if (is_known_in(d, told.facets, c.ends)) continue;
    const Sign order = touches || !best ? Sign::zero : compare(d, c, *best);
    if (order == Sign::positive) continue;
    if (order == Sign::negative) told.facets.clear();
    if (!best || order == Sign::negative) best = c;
    told.facets.push_back(c.ends);
  }
  for (const std::array<Ends, 3>& ends : told.facets) {
    if (!has_nothing_before(d, ends)) return {};
  }
  if (told.facets.empty()) return {};
  return told;
}

}  // namespace plumb::query::parting
