#include "plumb/query/penetration/along.hpp"

#include "arith/big_rounding.hpp"
#include "arith/exact_number.hpp"
#include "query/penetration/aims.hpp"
#include "query/penetration/directions.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/parted.hpp"

namespace plumb::query {
namespace {

using parting::CoreDistance, parting::Difference, parting::Ends, parting::PlaneOf, parting::Way;
using Exact = arith::Vec<mpq_class>;

PlaneOf<mpq_class> exact_plane(const Difference& d, const std::array<Ends, 3>& facet) {
  return {d.at<mpq_class>(facet[0]), d.at<mpq_class>(facet[1]), d.at<mpq_class>(facet[2])};
}

/// Of bodies that meet.
class Pair {
 public:
  Pair(const BodyView& a, const BodyView& b, const std::array<Body, 2>& bodies, const CoreDistance& core)
      : a_(a), b_(b), bodies_(bodies), core_(core) {}

  /// Nothing where they are parted as they stand.
  template <class Aim>
  [[nodiscard]] std::span<const std::array<Ends, 3>> facets(const Aim& aim) {
    planes_ = parting::nearest_planes(difference(), core_, aim);
    if (planes_.origin != parting::Origin::inside) return {};
    return planes_.facets;
  }
  [[nodiscard]] Way way_as_it_stands() const { return parting::parted(difference(), {})->way; }
  [[nodiscard]] Way first_way(std::span<const std::array<Ends, 3>> facets) const {
    return Way::through(facets[parting::first_way(difference(), facets).index]);
  }
  [[nodiscard]] Difference difference() const { return {bodies_[0].corners, bodies_[1].corners}; }
  [[nodiscard]] parting::FlushPair flush(const Way& way) const {
    return parting::flush_pair(a_, b_, difference(), way);
  }

 private:
  const BodyView &a_, &b_;
  const std::array<Body, 2>& bodies_;
  const CoreDistance& core_;
  parting::NearestPlanes planes_;
};

double rounded_number(const mpq_class& x) { return rounded(Rounding::nearest, x) + 0.0; }
Vector3 rounded_vector(const Exact& v) { return {rounded_number(v.x), rounded_number(v.y), rounded_number(v.z)}; }
double rounded_length(const mpq_class& square) {
  return rounded_root(Rounding::nearest, BigDyadic(mpz_class(square.get_num())),
                      BigDyadic(mpz_class(square.get_den())));
}

/// So many times the direction.
mpq_class multiple_of(const Difference& d, const std::array<Ends, 3>& facet, const Vector3& direction) {
  const PlaneOf<mpq_class> plane = exact_plane(d, facet);
  return plane.height() / parting::OneWay(direction).along(plane.normal);
}

Exact translation_in(const Difference& d, const std::array<Ends, 3>& facet, const parting::InCone& aim) {
  const PlaneOf<mpq_class> plane = exact_plane(d, facet);
  const std::uint32_t passage =
      aim.passage([&]<class T>() { return PlaneOf<T>(d.at<T>(facet[0]), d.at<T>(facet[1]), d.at<T>(facet[2])); });
  const Exact back{-plane.normal.x, -plane.normal.y, -plane.normal.z};
  const parting::InPart<mpq_class> in(aim.part(passage), aim.directions(), back);
  return in.point() * mpq_class(plane.height() / in.square());
}

bool is_before(const Exact& u, const Exact& v) { return std::tie(u.x, u.y, u.z) < std::tie(v.x, v.y, v.z); }
bool is_same(const Exact& u, const Exact& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }

}  // namespace

std::optional<PenetrationAlong> penetration_along_of(const BodyView& a, const BodyView& b,
                                                     std::span<const Vector3> directions, bool is_list) {
  const std::string function = "penetration_along";
  require_directions(function, directions, is_list);
  const std::array<Body, 2> bodies = bodies_of(function, a, b);
  const CoreDistance core = parting::core_distance({bodies[0].corners, bodies[1].corners});
  if (!core.meet) return {};
  Pair pair(a, b, bodies, core);
  std::optional<Way> way;
  std::size_t index = 0;
  mpq_class multiple = 0, square = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto facets = pair.facets(parting::OneWay(directions[i]));
    if (facets.empty()) {
      way = pair.way_as_it_stands();
      break;  // whatever the direction
    }
    const mpq_class times = multiple_of(pair.difference(), facets[0], directions[i]);
    const Exact d = arith::vec<mpq_class>(directions[i]);
    const mpq_class length = times * times * dot(d, d);
    if (way && length >= square) continue;
    way = pair.first_way(facets), index = i, multiple = times, square = length;
  }
  const parting::FlushPair flush = pair.flush(*way);
  const Exact by = arith::vec<mpq_class>(directions[index]) * multiple;
  return PenetrationAlong{index, exact_number(multiple), rounded_length(square), rounded_vector(by), flush.a, flush.b};
}

std::optional<PenetrationWithin> penetration_within_of(const BodyView& a, const BodyView& b,
                                                       const DirectionCone3& cone) {
  const std::string function = "penetration_within";
  require_directions(function, cone.directions, true);
  const std::array<Body, 2> bodies = bodies_of(function, a, b);
  const CoreDistance core = parting::core_distance({bodies[0].corners, bodies[1].corners});
  if (!core.meet) return {};
  Pair pair(a, b, bodies, core);
  const parting::InCone aim(cone.directions);
  const auto facets = pair.facets(aim);
  Exact least{0, 0, 0};
  bool is_unique = true;
  std::vector<std::array<Ends, 3>> through;  // those that it ends at
  for (const auto& f : facets) {
    const Exact by = translation_in(pair.difference(), f, aim);
    const bool is_first = through.empty(), as_before = !is_first && is_same(by, least);
    if (!is_first && !as_before) is_unique = false;
    if (is_first || is_before(by, least)) least = by, through.clear();
    if (is_same(by, least)) through.push_back(f);
  }
  const Way way = through.empty() ? pair.way_as_it_stands() : pair.first_way(through);
  const parting::FlushPair flush = pair.flush(way);
  const mpq_class square = dot(least, least);
  return PenetrationWithin{{exact_number(least.x), exact_number(least.y), exact_number(least.z)},
                           exact_number(square),
                           rounded_length(square),
                           rounded_vector(least),
                           flush.a,
                           flush.b,
                           is_unique};
}

}  // namespace plumb::query
