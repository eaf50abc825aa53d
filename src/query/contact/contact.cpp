#include "plumb/query/contact/contact.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "query/contact/corner_numbers.hpp"
#include "query/contact/quick_match.hpp"
#include "query/contact/quick_numbers.hpp"
#include "query/contact/upright.hpp"
#include "query/penetration/kept_answer.hpp"

namespace plumb::query {
namespace {

using namespace touching;  // NOLINT: all of it is of this question

template <class T>
bool match(const Pair& pair, Matched& m) {
  CertainSigns ask;
  const Vec<T> normal = pair.normal<T>(), back = turned_back(normal);
  m.facing[0] = FacingSearch<T>(m.seen[0], normal, ask).run();
  if (!ask.certain()) return false;
  m.facing[1] = FacingSearch<T>(m.seen[1], back, ask).run();
  if (!ask.certain()) return false;
  m.corners = common_corners(View<T>(m.seen[0], m.facing[0]), View<T>(m.seen[1], m.facing[1]), normal, pair.way(), ask);
  return ask.certain();
}
Matched matched(const Pair& pair) {
  Matched m{{pair.seen(0), pair.seen(1)}, {}, {}};
  if (!match_boxes(pair, m) && !match<Approximate>(pair, m) && !match<Running>(pair, m) && !match<Ball>(pair, m)) {
    (void)match<BigDyadic>(pair, m);
  }
  std::sort(m.corners.begin(), m.corners.end(), [](const Found& p, const Found& q) { return p.id < q.id; });
  return m;
}

/// Has a corner two points that are both as far as any, so that they are nearest?
bool has_nearest(const Matched& m) {
  const LevelParts level(m);
  return std::ranges::any_of(m.corners, [&](const Found& f) { return level.has(f); });
}

/// The sign of height / whole * |normal| - limit, whole and limit not below zero.
Sign compare_with(const BigDyadic& height, const BigDyadic& whole, const BigDyadic& square, const mpq_class& limit) {
  const Sign side = height.sign() * whole.sign();
  if (side != Sign::positive) return side == Sign::zero && sgn(limit) == 0 ? Sign::zero : Sign::negative;
  const mpq_class h = gmp_number(height), w = gmp_number(whole), reach = limit * w;
  return sign_of_number(cmp(mpq_class(h * h * gmp_number(square)), mpq_class(reach * reach)));
}

/// The same by integers.
class ExactNumbers3 {
 public:
  explicit ExactNumbers3(const Pair& p)
      : pair_(p),
        normal_(p.normal<BigDyadic>()),
        square_(dot(normal_, normal_)),
        scale_(p.difference().a.scale<BigDyadic>()),
        radii_{p.radii().exact(0), p.radii().exact(1)},
        both_(radii_[0] + radii_[1]),
        limit_(both_ + mpq_class(p.margin())) {}

  [[nodiscard]] Whole whole() const {
    const BigDyadic height = pair_.height(normal_);
    const BigDyadic whole = square_ * scale_;
    if (compare_with(height, whole, square_, limit_) == Sign::positive) return {false, Relation::disjoint, {}, 0};
    const auto unit = [&](const BigDyadic& x) {
      return rounded_radical(Rounding::nearest, BigDyadic(0.0), x, square_, square_) + 0.0;
    };
    const Sign side = compare_with(height, whole, square_, both_);
    return {true,
            static_cast<Relation>(-static_cast<int>(side)),
            {unit(normal_.x), unit(normal_.y), unit(normal_.z)},
            distance(height, whole)};
  }
  [[nodiscard]] bool is_near(const CornerFractions<BigDyadic>& n) const {
    return compare_with(n.height, n.whole * scale_, square_, limit_) != Sign::positive;
  }
  [[nodiscard]] Corner corner(CornerFractions<BigDyadic> n, const ContactId& id) const {
    if (n.whole.sign() == Sign::negative) {
      const BigDyadic none(0.0);
      n.whole = none - n.whole, n.height = none - n.height;
      n.on_a.numerator = none - n.on_a.numerator, n.on_b.numerator = none - n.on_b.numerator;
    }
    if (!is_near(n)) return {false, {}};
    return {
        true,
        {at(n.on_a, n.whole, radii_[0]), at(n.on_b, n.whole, -radii_[1]), distance(n.height, n.whole * scale_), id}};
  }

 private:
  /// height sqrt(square) / whole - p / q.
  [[nodiscard]] double distance(const BigDyadic& height, const BigDyadic& whole) const {
    const BigDyadic p{mpz_class(both_.get_num())}, q{mpz_class(both_.get_den())};
    return rounded_radical(Rounding::nearest, BigDyadic(0.0) - p * whole, height * q, square_, whole * q) + 0.0;
  }
  /// x / whole + p / q normal / sqrt(square).
  [[nodiscard]] Point3 at(const PlaceOn<BigDyadic>& place, const BigDyadic& whole, const mpq_class& radius) const {
    const BigDyadic p{mpz_class(radius.get_num())}, q{mpz_class(radius.get_den())}, over = whole * scale_;
    const auto coordinate = [&](const BigDyadic& base, const BigDyadic& along, const BigDyadic& normal) {
      const BigDyadic x = base * whole + along * place.numerator;
      if (sgn(radius) == 0) return rounded_quotient(Rounding::nearest, x, over) + 0.0;
      return rounded_radical(Rounding::nearest, x * q * square_, p * normal * over, square_, over * q * square_) + 0.0;
    };
    return {coordinate(place.base.x, place.along.x, normal_.x), coordinate(place.base.y, place.along.y, normal_.y),
            coordinate(place.base.z, place.along.z, normal_.z)};
  }

  const Pair& pair_;
  Vec<BigDyadic> normal_;
  BigDyadic square_, scale_;  // corners are so many times those of the bodies
  std::array<mpq_class, 2> radii_;
  mpq_class both_, limit_;
};

/// Those that are not told yet.
[[gnu::noinline]] void tell_exactly(const Pair& pair, const Matched& m, QuickCorners& corners) {
  const View<BigDyadic> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const ExactNumbers3 numbers(pair);
  const CornerPlaces<BigDyadic> places(a, b, pair.normal<BigDyadic>());
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    const Found& f = m.corners[i];
    if (!corners[i]) corners.begin()[i] = numbers.corner(places.of(f), f.id);
  }
}

/// Those that are near, by pairs of doubles and else by integers.
void tell_corners(const Pair& pair, const QuickNumbers& quick, const Whole& whole, const Matched& m,
                  ContactCorners& to) {
  QuickCorners corners = quick.corners(m, whole);
  const auto is_told = [](const auto& corner) { return corner.has_value(); };
  if (!std::ranges::all_of(corners, is_told)) tell_exactly(pair, m, corners);
  for (const auto& corner : corners) {
    if (corner->is_near) to.push_back(corner->told);
  }
}

/// The deepest, and each time the one that is farthest from those kept.
ContactCorners widest(const ContactCorners& all, std::size_t at_most) {
  parting::ShortList<std::size_t, 8> kept;
  std::size_t first = 0;
  for (std::size_t i = 1; i < all.size(); ++i) first = all[i].distance < all[first].distance ? i : first;
  kept.push_back(first);
  std::vector<std::size_t> nearest(all.size(), first);  // of those kept
  while (kept.size() < at_most) {
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::ranges::find(kept, i) != kept.end()) continue;
      const auto is_farther = [&](std::size_t j) {
        return compare_distance(all[i].on_a, all[nearest[i]].on_a, all[j].on_a, all[nearest[j]].on_a) == Sign::positive;
      };
      if (!next || is_farther(*next)) next = i;
    }
    kept.push_back(*next);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (compare_distance(all[i].on_a, all[*next].on_a, all[i].on_a, all[nearest[i]].on_a) == Sign::negative) {
        nearest[i] = *next;
      }
    }
  }
  std::sort(kept.begin(), kept.end());
  ContactCorners some;
  for (const std::size_t i : kept) some.push_back(all[i]);
  return some;
}

std::optional<ContactManifold> thinned(std::optional<ContactManifold> m, const ContactManifoldOptions& options) {
  if (m && options.at_most > 0 && m->corners.size() > options.at_most) m->corners = widest(m->corners, options.at_most);
  return m;
}

void require_margin(std::string_view function, double margin) {
  const auto named = [&](const char* what) { return std::string(function).append(": margin ").append(what); };
  if (!(margin - margin == 0)) throw NonFinite(named("is not a real number; give a finite double"));
  if (margin < 0) throw InvalidShape(named("is negative; give one that is not"));
}

std::optional<ContactManifold> contact_anew(const BodyView& a, const BodyView& b, const ContactManifoldOptions& options,
                                            ContactCache* cache) {
  if (UprightContact quick = upright_contact(a, b, options.margin); quick.is_known) {
    return thinned(std::move(quick.manifold), options);
  }
  Pair pair("contact", a, b, options.margin, cache);
  std::optional<ContactManifold> m;
  const auto answer = [&] {
    const QuickNumbers quick(pair);
    auto whole = quick.whole();
    if (!whole) whole = ExactNumbers3(pair).whole();
    if (!whole->is_near) return true;
    const Matched match = matched(pair);
    if (!pair.is_proved() && !has_nearest(match)) return false;
    m.emplace();
    m->relation = whole->relation, m->normal = whole->normal, m->distance = whole->distance;
    tell_corners(pair, quick, *whole, match, m->corners);
    return true;
  };
  while (!answer()) pair.aim_again(cache);
  return thinned(std::move(m), options);
}

/// A manifold without its corners, and how many these are.
struct KeptManifold {
  Relation relation;
  bool is_there;
  Vector3 normal;
  double distance;
  std::size_t corners;
};
void put_manifold(std::vector<unsigned char>& to, const std::optional<ContactManifold>& m) {
  KeptManifold kept{};
  if (m) kept = {m->relation, true, m->normal, m->distance, m->corners.size()};
  put(to, &kept, 1);
  if (m) put(to, m->corners.begin(), m->corners.size());
}
std::optional<ContactManifold> manifold_in(std::span<const unsigned char> bytes) {
  const auto kept = taken<KeptManifold>(bytes);
  std::optional<ContactManifold> m;
  if (!kept.is_there) return m;
  m.emplace();
  m->relation = kept.relation, m->normal = kept.normal, m->distance = kept.distance;
  for (std::size_t i = 0; i < kept.corners; ++i) m->corners.push_back(taken<ContactCorner>(bytes));
  return m;
}

}  // namespace

std::optional<ContactManifold> contact_of(const BodyView& a, const BodyView& b, const ContactManifoldOptions& options,
                                          ContactCache* cache) {
  require_margin("contact", options.margin);
  if (cache == nullptr) return contact_anew(a, b, options, nullptr);
  const AskedContact asked{KeptQuestion::contact, a, b, {options.margin, static_cast<double>(options.at_most)}};
  if (const auto before = KeptBytes::answer(*cache, asked); !before.empty()) return manifold_in(before);
  auto answer = contact_anew(a, b, options, cache);
  KeptBytes::keep(*cache, asked, [&](std::vector<unsigned char>& to) { put_manifold(to, answer); });
  return answer;
}

std::optional<ExactContact> exact_contact_of(const BodyView& a, const BodyView& b, double margin) {
  require_margin("exact_contact", margin);
  Pair pair("exact_contact", a, b, margin, nullptr);
  if (!pair.is_proved()) pair.aim(Guess::none, nullptr);
  const ExactNumbers3 numbers(pair);
  const Whole whole = numbers.whole();
  if (!whole.is_near) return {};
  const Vec<mpq_class> normal = pair.normal<mpq_class>();
  const Exact3 direction = primitive({normal.x, normal.y, normal.z});
  const std::size_t k = sgn(direction[0]) != 0 ? 0 : sgn(direction[1]) != 0 ? 1 : 2;
  const mpq_class normals = (k == 0 ? normal.x : k == 1 ? normal.y : normal.z) / direction[k];
  const auto along = [&](const mpq_class& height, const mpq_class& whole_of) {
    return exact_number(height / whole_of * normals);
  };
  ExactContact c{whole.relation,
                 {exact_number(direction[0]), exact_number(direction[1]), exact_number(direction[2])},
                 along(pair.height(normal), dot(normal, normal)),
                 exact_number(pair.radii().exact(0)),
                 exact_number(pair.radii().exact(1)),
                 {}};
  const Matched m = matched(pair);
  const View<mpq_class> on_a(m.seen[0], m.facing[0]), on_b(m.seen[1], m.facing[1]);
  const CornerPlaces<mpq_class> places(on_a, on_b, normal);
  const View<BigDyadic> whole_a(m.seen[0], m.facing[0]), whole_b(m.seen[1], m.facing[1]);
  const CornerPlaces<BigDyadic> in_integers(whole_a, whole_b, pair.normal<BigDyadic>());
  for (const Found& f : m.corners) {
    if (!numbers.is_near(in_integers.of(f))) continue;
    const CornerFractions<mpq_class> n = places.of(f);
    const auto at = [&](const PlaceOn<mpq_class>& p) {
      const mpq_class t = p.numerator / n.whole;
      return RationalPoint3{exact_number(p.base.x + p.along.x * t), exact_number(p.base.y + p.along.y * t),
                            exact_number(p.base.z + p.along.z * t)};
    };
    c.corners.push_back({at(n.on_a), at(n.on_b), along(n.height, n.whole), f.id});
  }
  return c;
}

}  // namespace plumb::query
