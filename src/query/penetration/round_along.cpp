#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "plumb/query/penetration/along.hpp"
#include "query/penetration/directions.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/parted.hpp"
#include "query/penetration/round_exit.hpp"

namespace plumb::query {
namespace {

using parting::Difference, parting::ExitTime, parting::RoundExit;
using Time = ExitTime<BigDyadic>;

/// The square of a translation's length is (plain + root sqrt(radicand)) / whole.
struct SquaredLength {
  BigDyadic plain, root, radicand, whole;

  SquaredLength(const Time& t, const Vector3& direction) : radicand(t.radicand), whole(t.whole * t.whole) {
    const arith::Vec<BigDyadic> d = arith::vec<BigDyadic>(direction);
    const BigDyadic square = dot(d, d), half = square * t.before;
    plain = square * (t.before * t.before + t.radicand), root = half + half;
  }
  [[nodiscard]] double rounded_length() const {
    return rounded_nested_root(Rounding::nearest, plain, root, radicand, whole);
  }
};
bool is_less(const SquaredLength& a, const SquaredLength& b) {
  const BigDyadic none;
  return certify::sign_of_radicals(a.plain * b.whole - b.plain * a.whole, a.root * b.whole, a.radicand,
                                   none - b.root * a.whole, b.radicand) == Sign::negative;
}

/// Of (whole t - before)^2 = radicand the greater one.
Root multiple_of(const Time& t) {
  const BigDyadic none, by = t.before * t.whole;
  const std::array<Rational, 3> polynomial{exact_number(t.before * t.before - t.radicand), exact_number(none - by - by),
                                           exact_number(t.whole * t.whole)};
  return real_roots(polynomial).back();
}

Vector3 translation_of(const Time& t, const Vector3& direction) {
  const auto part = [&](double x) {
    return rounded_radical(Rounding::nearest, t.before * BigDyadic(x), BigDyadic(x), t.radicand, t.whole) + 0.0;
  };
  return {part(direction.x), part(direction.y), part(direction.z)};
}

struct Features {
  Feature a, b;
};
Features features_at(const BodyView& a, const BodyView& b, const Difference& d, const RoundExit& exit) {
  const auto& e = exit.corners.ends;
  const std::size_t size = exit.corners.size;
  const parting::KnownPlane known(d, {e[0], size > 1 ? e[1] : e[0], size > 2 ? e[2] : e[0]});
  const auto on_a = all_furthest(d.a, exit.normal, Sign::positive, e[0][0], known.a, true),
             on_b = all_furthest(d.b, exit.normal, Sign::negative, e[0][1], known.b, true);
  return {parting::flush_feature(a, d.a, on_a), parting::flush_feature(b, d.b, on_b)};
}

}  // namespace

std::optional<RoundPenetrationAlong> round_penetration_along_of(const BodyView& a, const BodyView& b,
                                                                std::span<const Vector3> directions, bool is_list) {
  const std::string function = "penetration_along";
  require_directions(function, directions, is_list);
  const std::array<Body, 2> bodies = bodies_of(function, a, b);
  const mpq_class radius = bodies[0].radius + bodies[1].radius;
  if (radius == 0) {
    const auto p = penetration_along_of(a, b, directions, is_list);
    if (!p) return {};
    return RoundPenetrationAlong{p->index, Root(p->multiple), p->depth, p->translation, p->feature_a, p->feature_b};
  }
  const Difference d{bodies[0].corners, bodies[1].corners};
  const parting::CoreDistance core = parting::core_distance(d);
  if (!core.meet) {
    const Sign apart = parting::compare_with_radii(d, core.nearest, radius);
    if (apart == Sign::positive) return {};
    if (apart == Sign::zero) {
      const parting::FlushPair flush = parting::flush_pair(a, b, d, parting::parted(d, radius)->way);
      return RoundPenetrationAlong{0, Root(0), 0, {}, flush.a, flush.b};
    }
  }
  // Corners are so many times those of the bodies.
  const BigDyadic scale = d.a.scale<BigDyadic>();
  const mpq_class as_scaled = radius * gmp_number(scale);
  const auto time_of = [&](const RoundExit& exit) {
    return Time{exit.time->before, exit.time->radicand, exit.time->whole * scale};
  };
  std::size_t index = 0;
  std::optional<RoundExit> first;
  std::optional<SquaredLength> least;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    RoundExit exit = parting::round_exit(d, directions[i], as_scaled, core.nearest);
    SquaredLength square(time_of(exit), directions[i]);
    if (least && !is_less(square, *least)) continue;
    index = i, first.emplace(std::move(exit)), least.emplace(std::move(square));
  }
  const Features f = features_at(a, b, d, *first);
  const Time time = time_of(*first);
  return RoundPenetrationAlong{
      index, multiple_of(time), least->rounded_length(), translation_of(time, directions[index]), f.a, f.b};
}

}  // namespace plumb::query
