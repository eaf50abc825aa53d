#include "plumb/query/contact/contact.hpp"

#include <algorithm>
#include <string>

#include "arith/exact_number.hpp"
#include "arith/rounded_radical.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/compare_distance.hpp"
#include "query/contact/corner_numbers.hpp"
#include "query/convex/core.hpp"
#include "query/convex/exact_gap.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query {
namespace {

using namespace touching;  // NOLINT: all of it is of this question

/// As doubles where all of them are, and without rounding.
class Radii {
 public:
  Radii(std::string_view function, const BodyView& a, const BodyView& b) {
    given_ = {radius_of(a), radius_of(b)};
    if ((given_[0] == 0 || a.pose.stands()) && (given_[1] == 0 || b.pose.stands())) return;
    const std::array<Body, 2> bodies = bodies_of(function, a, b);
    posed_ = {bodies[0].radius, bodies[1].radius};
    for (std::size_t i = 0; i < 2; ++i) {
      given_[i] = (*posed_)[i].get_d();
      are_doubles_ = are_doubles_ && given_[i] == (*posed_)[i];
    }
  }
  [[nodiscard]] bool are_doubles() const { return are_doubles_; }
  [[nodiscard]] double given(std::size_t i) const { return given_[i]; }
  [[nodiscard]] mpq_class exact(std::size_t i) const { return posed_ ? (*posed_)[i] : mpq_class(given_[i]); }
  [[nodiscard]] bool are_none() const { return given_[0] == 0 && given_[1] == 0; }

 private:
  std::array<double, 2> given_{};
  std::optional<std::array<mpq_class, 2>> posed_;
  bool are_doubles_ = true;
};

template <class T>
Vec<T> turned_back(const Vec<T>& v) {
  return Vec<T>{T(0.0), T(0.0), T(0.0)} - v;
}

/// What is asked about.
class Pair {
 public:
  Pair(std::string_view function, const BodyView& a, const BodyView& b, double margin, ContactCache* cache)
      : views_{a, b}, corners_(corners_of(function, a, b)), radii_(function, a, b), margin_(margin) {
    aim(true, cache);
  }
  Pair(const Pair&) = delete;  // what is seen refers to it
  Pair& operator=(const Pair&) = delete;
  ~Pair() = default;

  void aim(bool may_guess, ContactCache* cache) {
    aim_.emplace(aim_at(difference(), may_guess, cache));
    known_.emplace(aim_->way.known(difference()));
  }
  [[nodiscard]] bool is_proved() const { return aim_->is_proved; }

  [[nodiscard]] Difference difference() const { return {corners_[0], corners_[1]}; }
  [[nodiscard]] const Radii& radii() const { return radii_; }
  [[nodiscard]] double margin() const { return margin_; }

  /// From a to b.
  template <class T>
  [[nodiscard]] Vec<T> normal() const {
    return turned_back(aim_->way.along<T>(difference()));
  }
  /// How far the cores are apart along the normal, times its length.
  template <class T>
  [[nodiscard]] T height(const Vec<T>& normal) const {
    return T(0.0) - sparse_dot(normal, difference().at<T>(aim_->at));
  }
  [[nodiscard]] Seen seen(std::size_t i) const {
    return {views_[i],
            corners_[i],
            aim_->at[i],
            i == 0 ? known_->a : known_->b,
            aim_->level ? &(*aim_->level)[i] : nullptr,
            aim_->all ? &(*aim_->all)[i] : nullptr};
  }

 private:
  std::array<BodyView, 2> views_;
  std::array<CoreCorners, 2> corners_;
  Radii radii_;
  double margin_;
  std::optional<Aim> aim_;
  std::optional<parting::KnownPlane> known_;
};

/// The features that face each other, and the corners of what they have in common.
struct Matched {
  std::array<Seen, 2> seen;
  std::array<Facing, 2> facing;
  FoundCorners corners;
};

template <class T>
bool match(const Pair& pair, Matched& m) {
  CertainSigns ask;
  const Vec<T> normal = pair.normal<T>(), back = turned_back(normal);
  m.facing[0] = FacingSearch<T>(m.seen[0], normal, ask).run();
  if (!ask.certain()) return false;
  m.facing[1] = FacingSearch<T>(m.seen[1], back, ask).run();
  if (!ask.certain()) return false;
  m.corners = common_corners(View<T>(m.seen[0], m.facing[0]), View<T>(m.seen[1], m.facing[1]), normal, ask);
  return ask.certain();
}
Matched matched(const Pair& pair) {
  Matched m{{pair.seen(0), pair.seen(1)}, {}, {}};
  if (!match<Running>(pair, m) && !match<Ball>(pair, m)) (void)match<BigDyadic>(pair, m);
  std::sort(m.corners.begin(), m.corners.end(), [](const Found& p, const Found& q) { return p.id < q.id; });
  return m;
}

/// Has a corner two points that are both as far as any, so that they are nearest?
bool has_nearest(const Matched& m) {
  const auto is_level = [&](std::size_t body, std::size_t i) {
    const Seen& s = m.seen[body];
    return (m.facing[body].corners[i] & ~s.level->free) == s.level->first;
  };
  const auto is_all_level = [&](std::size_t body) {
    bool all = true;
    for (std::size_t i = 0; i < m.facing[body].corners.size(); ++i) all = all && is_level(body, i);
    return all;
  };
  const auto is_edge_level = [&](std::size_t body, std::size_t i) {
    return is_level(body, i) && is_level(body, i + 1 == m.facing[body].corners.size() ? 0 : i + 1);
  };
  for (const Found& f : m.corners) {
    const bool of_a = f.kind == CornerKind::vertex_of_b ? is_all_level(0)
                      : f.kind == CornerKind::edges     ? is_edge_level(0, f.i)
                                                        : is_level(0, f.i);
    const bool of_b = f.kind == CornerKind::vertex_of_a ? is_all_level(1)
                      : f.kind == CornerKind::edges     ? is_edge_level(1, f.j)
                                                        : is_level(1, f.j);
    if (of_a && of_b) return true;
  }
  return false;
}

/// The sign of height / whole * |normal| - limit, whole and limit not below zero.
Sign compare_with(const BigDyadic& height, const BigDyadic& whole, const BigDyadic& square, const mpq_class& limit) {
  const Sign side = height.sign() * whole.sign();
  if (side != Sign::positive) return side == Sign::zero && sgn(limit) == 0 ? Sign::zero : Sign::negative;
  const mpq_class h = gmp_number(height), w = gmp_number(whole), reach = limit * w;
  return sign_of_number(cmp(mpq_class(h * h * gmp_number(square)), mpq_class(reach * reach)));
}

/// A list of numbers that pairs of doubles tell, each rounded once.
class Told {
 public:
  double operator()(const Ball& x) {
    const auto nearest = x.nearest();
    all_ = all_ && nearest;
    return nearest.value_or(0);
  }
  [[nodiscard]] bool all() const { return all_; }

 private:
  bool all_ = true;
};

/// Numbers of one pair by pairs of doubles; what these leave open is nothing.
class QuickNumbers {
 public:
  explicit QuickNumbers(const Pair& p)
      : pair_(p),
        normal_(p.normal<Ball>()),
        length_(root(sparse_dot(normal_, normal_))),
        share_(quotient(Ball(1), length_)),
        radii_(Ball(p.radii().given(0)) + Ball(p.radii().given(1))),
        limit_(radii_ + Ball(p.margin())) {}

  /// Is there a contact?
  struct Whole {
    bool is_near;
    Relation relation;
    Vector3 normal;
    double distance;
  };
  [[nodiscard]] std::optional<Whole> whole() const {
    if (!pair_.radii().are_doubles()) return {};
    const Ball height = pair_.height(normal_), along = height * share_;
    const auto beyond = beyond_limit(height, Ball(1), along);
    if (!beyond) return {};
    if (*beyond) return Whole{false, Relation::disjoint, {}, 0};
    const Unsure<Sign> side = pair_.radii().are_none() ? height.sign() : (along - radii_).sign();
    if (!side.certain()) return {};
    Told told;
    const Vec<Ball> unit = normal_ * share_;
    const Whole w{true,
                  static_cast<Relation>(-static_cast<int>(side.value())),
                  {told(unit.x), told(unit.y), told(unit.z)},
                  side.value() == Sign::zero ? 0 : told(along - radii_)};
    if (!told.all()) return {};
    return w;
  }

  struct Corner {
    bool is_near;
    ContactCorner told;
  };
  [[nodiscard]] std::optional<Corner> corner(const CornerPlaces<Ball>& places, const Found& f) const {
    const CornerFractions<Ball> n = places.of(f);
    const Ball along = quotient(n.height, n.whole) * length_;
    const auto beyond = beyond_limit(n.height, n.whole, along);
    if (!beyond) return {};
    if (*beyond) return Corner{false, {}};
    Told told;
    const auto at = [&](const PlaceOn<Ball>& p, double radius) {
      Vec<Ball> x = certainly_zero(p.numerator) ? p.base : p.base + p.along * quotient(p.numerator, n.whole);
      if (radius != 0) x = x + normal_ * (share_ * Ball(radius));
      return Point3{told(x.x), told(x.y), told(x.z)};
    };
    const Corner c{true,
                   {at(n.on_a, pair_.radii().given(0)), at(n.on_b, -pair_.radii().given(1)),
                    pair_.radii().are_none() && certainly_zero(n.height) ? 0 : told(along - radii_), f.id}};
    if (!told.all()) return {};
    return c;
  }

 private:
  /// Of height / whole normals; `along` is that with their length.
  [[nodiscard]] std::optional<bool> beyond_limit(const Ball& height, const Ball& whole, const Ball& along) const {
    const Unsure<Sign> h = height.sign(), w = whole.sign();
    if (!h.certain() || !w.certain()) return {};
    if (h.value() * w.value() != Sign::positive) return false;
    const Unsure<Sign> s = (along - limit_).sign();
    if (!s.certain()) return {};
    return s.value() == Sign::positive;
  }

  const Pair& pair_;
  Vec<Ball> normal_;
  Ball length_, share_, radii_, limit_;
};

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

  [[nodiscard]] QuickNumbers::Whole whole() const {
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
  [[nodiscard]] QuickNumbers::Corner corner(CornerFractions<BigDyadic> n, const ContactId& id) const {
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

/// Those of `all` that are near, by pairs of doubles and else by integers.
void tell_corners(const Pair& pair, const QuickNumbers& quick, const Matched& m, ContactCorners& to) {
  const View<Ball> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<Ball> places(a, b, pair.normal<Ball>());
  struct Slow {
    View<BigDyadic> a, b;
    ExactNumbers3 numbers;
    CornerPlaces<BigDyadic> places;
    Slow(const Pair& p, const Matched& m)
        : a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]), numbers(p), places(a, b, p.normal<BigDyadic>()) {}
  };
  std::optional<Slow> slow;
  for (const Found& f : m.corners) {
    auto corner = pair.radii().are_doubles() ? quick.corner(places, f) : std::nullopt;
    if (!corner) {
      if (!slow) slow.emplace(pair, m);
      corner = slow->numbers.corner(slow->places.of(f), f.id);
    }
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

void require_margin(std::string_view function, double margin) {
  const auto named = [&](const char* what) { return std::string(function).append(": margin ").append(what); };
  if (!(margin - margin == 0)) throw NonFinite(named("is not a real number; give a finite double"));
  if (margin < 0) throw InvalidShape(named("is negative; give one that is not"));
}

}  // namespace

std::optional<ContactManifold> contact_of(const BodyView& a, const BodyView& b, const ContactManifoldOptions& options,
                                          ContactCache* cache) {
  require_margin("contact", options.margin);
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
    tell_corners(pair, quick, match, m->corners);
    return true;
  };
  if (!answer()) pair.aim(false, cache), (void)answer();
  if (m && options.at_most > 0 && m->corners.size() > options.at_most) m->corners = widest(m->corners, options.at_most);
  return m;
}

std::optional<ExactContact> exact_contact_of(const BodyView& a, const BodyView& b, double margin) {
  require_margin("exact_contact", margin);
  Pair pair("exact_contact", a, b, margin, nullptr);
  if (!pair.is_proved()) pair.aim(false, nullptr);
  const ExactNumbers3 numbers(pair);
  const QuickNumbers::Whole whole = numbers.whole();
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
