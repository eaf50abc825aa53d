#include "query/penetration/cached_guess.hpp"

namespace plumb::query::parting {

DifferenceCorners guess_of(const Difference& d, const ContactCache* cache) {
  DifferenceCorners guess;
  for (std::uint32_t i = 0; cache != nullptr && i < cache->size && i < cache->corners.size(); ++i) {
    const Ends& e = cache->corners[i];
    if (e[0] < d.a.size() && e[1] < d.b.size()) guess.add(e);
  }
  return guess;
}

void keep(ContactCache* cache, const DifferenceCorners& corners) {
  if (cache == nullptr) return;
  cache->size = static_cast<std::uint32_t>(corners.size);
  cache->corners = corners.ends;
}

void keep(ContactCache* cache, const Difference& d, const Parting& p) {
  if (cache == nullptr || p.cores_are_apart || !p.way.is_through_plane()) return;
  DifferenceCorners corners;
  for (const Ends& e : p.way.facet()) corners.add(e);
  const arith::Plain in = p.way.along<double>(d);  // turned round from the plane's normal
  const Ends& from = p.way.from();
  corners.add({guessed_furthest(d.a, in, from[0]), guessed_furthest(d.b, in * -1, from[1])});
  keep(cache, corners);
}

std::optional<Parting> parted_as_before(const Difference& d, const DifferenceCorners& guess) {
  if (guess.size != 4) return {};
  const auto& e = guess.ends;
  const Sign turn = sign_of([&]<class T>() -> T {
    return dot(cross(d.between<T>(e[0], e[1]), d.between<T>(e[0], e[2])), d.between<T>(e[0], e[3]));
  });
  if (turn == Sign::zero) return {};
  const auto planes = proved_planes(d, e);
  if (!planes) return {};
  return first_of(d, *planes);
}

}  // namespace plumb::query::parting
