#include "plumb/query/penetration/penetration.hpp"

#include "arith/exact_number.hpp"
#include "arith/leading_digits.hpp"
#include "arith/rounded_radical.hpp"
#include "arith/sparse_vec.hpp"
#include "plumb/arith/ball.hpp"
#include "query/penetration/cached_guess.hpp"
#include "query/penetration/facet_lengths.hpp"
#include "query/penetration/flush_feature.hpp"
#include "query/penetration/kept_answer.hpp"
#include "query/penetration/separating_axes.hpp"

namespace plumb::query {
namespace {

using namespace parting;  // NOLINT: all of it is of this question

/// What is told of a parting: numbers are of a way v, the squared length w of it, and how far along it the cores'
/// planes overlap, times its length: h, below zero where they are apart.
template <class T>
struct Lengths {
  Vec<T> way;
  T square, overlap;

  Lengths(const Vec<T>& v, const T& w, const T& h) : way(v), square(w), overlap(h) {}
  Lengths(const Difference& d, const Way& along, const Ends& in_plane)
      : way(along.along<T>(d)), square(dot(way, way)), overlap(T(0.0) - dot(way, d.at<T>(in_plane))) {}
};

struct Told {
  std::array<CoreCorners, 2> corners;
  std::optional<mpq_class> radii;  // both together, where a body has one
  Parting parting;
  FlushPair flush;
  std::optional<Ball> overlap;  // of the cores, where it is known

  [[nodiscard]] Difference difference() const { return {corners[0], corners[1]}; }
};

std::optional<Told> told_of(std::string_view function, const BodyView& a, const BodyView& b,
                            ContactCache* cache = nullptr) {
  std::optional<mpq_class> radii;
  if (has_radius(a) || has_radius(b)) {
    const std::array<Body, 2> bodies = bodies_of(function, a, b);
    radii = bodies[0].radius + bodies[1].radius;
  }
  const std::array<CoreCorners, 2> corners = corners_of(function, a, b);
  const Difference d{corners[0], corners[1]};
  if (corners[0].is_sum() && corners[1].is_sum()) {
    const SumParting s = parted_sums(d);
    if (s.known == SumParting::Known::apart && !radii) return {};
    if (s.known == SumParting::Known::parting) {
      const FlushPair flush{flush_feature(a, corners[0], s.level[0], s.is_plain[0]),
                            flush_feature(b, corners[1], s.level[1], s.is_plain[1]),
                            {s.level[0].first, s.level[1].first}};
      return Told{corners, radii, *s.parting, flush, s.overlap};
    }
  }
  auto parting = parted_as_before(d, guess_of(d, cache));
  if (!parting) parting = parted(d, radii);
  if (!parting) return {};
  keep(cache, d, *parting);
  const auto& level = parting->level;
  using Level = std::span<const std::uint32_t>;
  const FlushPair flush = level ? flush_pair(a, b, d, std::array{Level((*level)[0]), Level((*level)[1])})
                                : flush_pair(a, b, d, parting->way);
  return Told{corners, radii, *parting, flush, {}};
}

Lengths<Ball> quick_lengths(const Told& t) {
  const Difference d = t.difference();
  if (t.parting.way.is_through_plane()) {
    if (const auto f = facet_lengths(d, t.parting.way.facet())) return {f->way, f->square, f->overlap};
  }
  return {d, t.parting.way, t.flush.in_plane};
}

Penetration without_numbers(const Told& t) { return {0, {}, {}, t.flush.a, t.flush.b, t.parting.is_unique}; }

/// The same, where roundings leave too few digits of what almost cancels: by integers of one width, if they hold it.
std::optional<Lengths<Ball>> lengths_by_integers(const Told& t) {
  StackDyadic::clear_range();
  const Lengths<StackDyadic> n(t.difference(), t.parting.way, t.flush.in_plane);
  const auto leading = [](const StackDyadic& x) { return arith::leading_digits(x); };
  const Ball scale = leading(t.corners[0].scale<StackDyadic>()), overlap = leading(n.overlap);
  const Vec<Ball> way{leading(n.way.x), leading(n.way.y), leading(n.way.z)};
  const Lengths<Ball> told(way, leading(n.square), certainly_zero(overlap) ? overlap : quotient(overlap, scale));
  if (StackDyadic::left_range()) return {};
  return told;
}

/// Numbers by pairs of doubles; nothing where these leave one open.
std::optional<Penetration> numbers_of(const Told& t, const Lengths<Ball>& n, double radius) {
  Penetration p = without_numbers(t);
  bool is_told = true;
  const auto tell = [&](double& to, const Ball& from) {
    const auto nearest = from.nearest();
    is_told = is_told && nearest;
    to = nearest.value_or(0);
  };
  using arith::sparse_product;  // zero times what is rounded is zero
  const Ball overlap = t.parting.cores_touch ? Ball(0) : n.overlap;
  const Ball length = root(n.square), share = quotient(Ball(1), length);
  const Vec<Ball>& way = n.way;
  tell(p.direction.x, sparse_product(way.x, share)), tell(p.direction.y, sparse_product(way.y, share));
  tell(p.direction.z, sparse_product(way.z, share));
  if (!t.parting.cores_touch || radius != 0) {  // else they are parted as they stand
    const Ball depth = Ball(radius) + sparse_product(overlap, share);
    tell(p.depth, depth);
    // Without a radius no root is in it, and what is near to a number halfway is seen to be there.
    const Ball by = radius == 0 ? quotient(overlap, n.square) : sparse_product(depth, share);
    tell(p.translation.x, sparse_product(way.x, by)), tell(p.translation.y, sparse_product(way.y, by));
    tell(p.translation.z, sparse_product(way.z, by));
  }
  return is_told ? std::optional(p) : std::nullopt;
}

/// The same along an axis of space, where the overlap is a sum of few numbers.
std::optional<Penetration> numbers_along_axis(const Told& t, const Ball& overlap, double radius) {
  const auto depth = (Ball(radius) + overlap).nearest();
  if (!depth) return {};
  Penetration p = without_numbers(t);
  const auto way = t.parting.way.along<double>(t.difference());
  p.depth = *depth;
  p.direction = {way.x, way.y, way.z};
  p.translation = {way.x * p.depth + 0.0, way.y * p.depth + 0.0, way.z * p.depth + 0.0};
  return p;
}

std::optional<Penetration> quick_numbers(const Told& t) {
  double radius = 0;
  if (t.radii) {
    radius = t.radii->get_d();
    if (radius != *t.radii) return {};
  }
  if (t.overlap) return numbers_along_axis(t, *t.overlap, radius);
  if (auto told = numbers_of(t, quick_lengths(t), radius)) return told;
  const auto fine = lengths_by_integers(t);
  return fine ? numbers_of(t, *fine, radius) : std::nullopt;
}

Penetration exact_numbers(const Told& t) {
  const Lengths<BigDyadic> n(t.difference(), t.parting.way, t.flush.in_plane);
  const mpq_class radii = t.radii.value_or(0);
  // The way is as it may be, the overlap so many times that of the bodies.
  const BigDyadic scale = t.corners[0].scale<BigDyadic>(), none(0.0);
  const BigDyadic over = BigDyadic{mpz_class(radii.get_num())} * scale, under{mpz_class(radii.get_den())};
  const BigDyadic whole = under * n.square * scale;
  constexpr Rounding nearest = Rounding::nearest;
  const bool is_round = t.radii.has_value();
  Penetration p = without_numbers(t);
  // With the scale s, radii r / u and over = r s: r / u + h / (s root(w)) is (over w + u h root(w)) / (u w s).
  p.depth = is_round ? rounded_radical(nearest, over * n.square, under * n.overlap, n.square, whole)
                     : rounded_root(nearest, n.overlap * n.overlap, n.square * (scale * scale));
  const auto unit = [&](const BigDyadic& x) { return rounded_radical(nearest, none, x, n.square, n.square) + 0.0; };
  p.direction = {unit(n.way.x), unit(n.way.y), unit(n.way.z)};
  const auto move = [&](const BigDyadic& x) {
    return is_round ? rounded_radical(nearest, x * under * n.overlap, x * over, n.square, whole) + 0.0
                    : rounded_quotient(nearest, x * n.overlap, n.square * scale) + 0.0;
  };
  p.translation = {move(n.way.x), move(n.way.y), move(n.way.z)};
  return p;
}

}  // namespace

std::optional<Penetration> penetration_of(const BodyView& a, const BodyView& b, ContactCache* cache) {
  using Answer = std::optional<Penetration>;
  const AskedContact asked{KeptQuestion::penetration, a, b};
  if (cache != nullptr) {
    if (auto before = KeptBytes::answer(*cache, asked); !before.empty()) return taken<Answer>(before);
  }
  const auto told = told_of("penetration", a, b, cache);
  Answer answer;
  if (told) answer = quick_numbers(*told);
  if (told && !answer) answer = exact_numbers(*told);
  if (cache != nullptr) KeptBytes::keep(*cache, asked, [&](std::vector<unsigned char>& to) { put(to, &answer, 1); });
  return answer;
}

std::optional<ExactPenetration> exact_penetration_of(const BodyView& a, const BodyView& b) {
  const auto told = told_of("exact_penetration", a, b);
  if (!told) return {};
  const Lengths<mpq_class> n(told->difference(), told->parting.way, told->flush.in_plane);
  const mpq_class share = n.overlap / n.square, square = n.overlap * share;
  const Exact3 way = primitive({n.way.x, n.way.y, n.way.z});
  return ExactPenetration{{exact_number(way[0]), exact_number(way[1]), exact_number(way[2])},
                          {exact_number(n.way.x * share), exact_number(n.way.y * share), exact_number(n.way.z * share)},
                          exact_number(square),
                          told->parting.cores_are_apart,
                          exact_number(told->radii.value_or(0)),
                          told->flush.a,
                          told->flush.b,
                          told->parting.is_unique};
}

}  // namespace plumb::query
