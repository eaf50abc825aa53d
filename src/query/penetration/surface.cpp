#include "query/penetration/surface.hpp"

#include <algorithm>

namespace plumb::query::parting {

Sign Surface::height_sign(Facet& f) {
  return sign_of([&]<class T>() -> T {
    if constexpr (std::is_same_v<T, Running>) {
      return f.height;
    } else {
      return plane<T>(f).height();
    }
  });
}

std::uint32_t Surface::make(std::uint32_t p, std::uint32_t q, std::uint32_t r) {
  const PlaneOf<Running> plane(points_[p].at, points_[q].at, points_[r].at);
  const Facet facet{{p, q, r}, {}, plane.normal, plane.height(), Running()};
  if (free_.empty()) {
    facets_.push_back(facet);
    return static_cast<std::uint32_t>(facets_.size() - 1);
  }
  const std::uint32_t f = free_.back();
  free_.pop_back();
  facets_[f] = facet;
  return f;
}

void Surface::start(const std::array<Ends, 4>& corners) {
  for (const Ends& e : corners) points_.push_back({e, of_.at<Running>(e)});
  const Sign turn = sign_of([&]<class T>() -> T { return PlaneOf<T>(at<T>(0), at<T>(1), at<T>(2)).beyond(at<T>(3)); });
  // Seen from outside, which is from where the fourth is not.
  if (turn == Sign::positive) std::swap(points_[0], points_[1]);
  make(0, 1, 2), make(0, 3, 1), make(1, 3, 2), make(2, 3, 0);
  facets_[0].across = {1, 2, 3};
  facets_[1].across = {3, 2, 0};
  facets_[2].across = {1, 3, 0};
  facets_[3].across = {2, 1, 0};
}

void Surface::grow(const Ends& ends, std::uint32_t beyond) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back({ends, of_.at<Running>(ends)});
  seen_.assign(1, beyond), horizon_.clear(), made_.clear();
  facets_[beyond].is_there = false;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const std::uint32_t f = seen_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = facets_[f].across[k];
      if (!facets_[g].is_there) continue;  // seen already
      if (is_beyond(ends, points_[point].at, facets_[g], [&]<class T>() { return at<T>(point); })) {
        facets_[g].is_there = false;
        seen_.push_back(g);
      }
    }
  }
  for (const std::uint32_t f : seen_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t g = facets_[f].across[k];
      if (facets_[g].is_there) horizon_.push_back({facets_[f].corner[k], facets_[f].corner[(k + 1) % 3], g});
    }
  }
  free_.insert(free_.end(), seen_.begin(), seen_.end());
  for (const Edge& e : horizon_) {
    const std::uint32_t f = make(e.from, e.to, point);
    made_.push_back(f);
    points_[e.from].starts = f;
    facets_[f].across[0] = e.outer;
    Facet& outer = facets_[e.outer];
    for (std::size_t k = 0; k < 3; ++k) {
      if (outer.corner[k] == e.to && outer.corner[(k + 1) % 3] == e.from) outer.across[k] = f;
    }
  }
  for (std::size_t i = 0; i < made_.size(); ++i) {  // around the new point
    const std::uint32_t f = made_[i], next = points_[horizon_[i].to].starts;
    facets_[f].across[1] = next;
    facets_[next].across[2] = f;
  }
}

}  // namespace plumb::query::parting
