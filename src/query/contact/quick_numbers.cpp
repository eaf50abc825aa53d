#include "query/contact/quick_numbers.hpp"

#include "arith/leading_digits.hpp"
#include "query/contact/corner_numbers.hpp"

namespace plumb::query::touching {
namespace {

/// A list of numbers, each rounded once.
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

std::optional<Sign> sign_where_certain(const Ball& x) {
  const Unsure<Sign> s = x.sign();
  if (!s.certain()) return {};
  return s.value();
}

bool is_one(const Ball& x) { return x.high == 1 && x.low == 0 && x.radius == 0; }
Ball times(const Ball& x, const Ball& by) { return is_one(by) ? x : x * by; }
Ball over(const Ball& x, const Ball& by) { return is_one(by) ? x : quotient(x, by); }

template <class V>
auto& part(V& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// What pairs of doubles tell too little of, by integers of just the width; nothing where these do not hold it.
template <class Of>
std::optional<Ball> by_integers(const Of& of) {
  StackDyadic::clear_range();
  const Ball leading = arith::leading_digits(of());
  if (StackDyadic::left_range()) return {};
  return leading;
}
bool is_rough(const Ball& x) { return !(x.radius <= Ball::size(x.high) * 0x1p-70); }  // a guess

}  // namespace

QuickNumbers::QuickNumbers(const Pair& p)
    : pair_(p),
      normal_(p.normal<Ball>()),
      square_(sparse_dot(normal_, normal_)),
      length_(is_one(square_) ? square_ : root(square_)),
      share_(over(Ball(1), length_)),
      radii_(Ball(p.radii().given(0)) + Ball(p.radii().given(1))),
      limit_(radii_ + Ball(p.margin())) {}

std::optional<Whole> QuickNumbers::whole() const {
  if (!pair_.radii().are_doubles()) return {};
  Ball height = pair_.height(normal_);
  if (is_rough(height) && !pair_.difference().a.has_scale()) {  // times the weights of poses it is another number
    height = by_integers([&] { return pair_.height(pair_.normal<StackDyadic>()); }).value_or(height);
  }
  const Ball along = times(height, share_);
  const auto beyond = beyond_limit(height, Ball(1), along);
  if (!beyond) return {};
  if (*beyond) return Whole{false, Relation::disjoint, {}, 0};
  const auto side = sign_where_certain(pair_.radii().are_none() ? height : along - radii_);
  if (!side) return {};
  Told told;
  const Vec<Ball> unit = sparse_scaled(normal_, share_);
  const Whole w{true,
                static_cast<Relation>(-static_cast<int>(*side)),
                {told(unit.x), told(unit.y), told(unit.z)},
                *side == Sign::zero ? 0 : told(along - radii_)};
  if (!told.all()) return {};
  return w;
}

std::optional<Corner> QuickNumbers::corner(const CornerPlaces<Ball>& places, const Found& f,
                                           const std::optional<Gap>& gap) const {
  const CornerFractions<Ball> n = places.of(f);
  const auto [height, whole] = gap.value_or(Gap{n.height, n.whole});
  const Ball share = over(Ball(1), n.whole);
  const Ball along = times(gap ? over(height, whole) : times(height, share), length_);
  const auto beyond = beyond_limit(height, whole, along);
  if (!beyond) return {};
  if (*beyond) return Corner{false, {}};
  Told told;
  const auto at = [&](const PlaceOn<Ball>& p, double radius) {
    Vec<Ball> x = p.base;
    const bool is_level = p.level_axis >= 0, is_upright = is_level && p.level_axis == axis_along(p.along);
    if (!is_upright && !certainly_zero(p.numerator)) {
      x = sparse_sum(x, sparse_scaled(p.along, times(p.numerator, share)));
    }
    if (is_level) part(x, p.level_axis) = part(*p.level, p.level_axis);
    if (radius != 0) x = sparse_sum(x, sparse_scaled(normal_, share_ * Ball(radius)));
    return Point3{told(x.x), told(x.y), told(x.z)};
  };
  const Corner c{true,
                 {at(n.on_a, pair_.radii().given(0)), at(n.on_b, -pair_.radii().given(1)),
                  pair_.radii().are_none() && certainly_zero(height) ? 0 : told(along - radii_), f.id}};
  if (!told.all()) return {};
  return c;
}

std::optional<bool> QuickNumbers::beyond_limit(const Ball& height, const Ball& whole, const Ball& along) const {
  const auto h = sign_where_certain(height), w = sign_where_certain(whole);
  if (!h || !w) return {};
  if (*h * *w != Sign::positive) return false;
  const auto s = sign_where_certain(along - limit_);
  if (!s) return {};
  return *s == Sign::positive;
}

/// Of those that are not told yet heights are what pairs of doubles tell too little of.
void QuickNumbers::tell_by_integers(const Matched& m, const CornerPlaces<Ball>& places, QuickCorners& corners) const {
  StackDyadic::clear_range();
  const View<StackDyadic> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<StackDyadic> in_integers(a, b, pair_.normal<StackDyadic>());
  if (StackDyadic::left_range()) return;
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    if (corners[i]) continue;
    const auto height = by_integers([&] { return in_integers.of(m.corners[i]).height; });
    const auto whole = by_integers([&] { return in_integers.of(m.corners[i]).whole; });
    if (!height || !whole) return;
    corners.begin()[i] = corner(places, m.corners[i], Gap{*height, *whole});
  }
}

QuickCorners QuickNumbers::corners(const Matched& m) const {
  QuickCorners corners;
  for (std::size_t i = 0; i < m.corners.size(); ++i) corners.push_back({});
  if (!pair_.radii().are_doubles()) return corners;
  const View<Ball> a(m.seen[0], m.facing[0]), b(m.seen[1], m.facing[1]);
  const CornerPlaces<Ball> places(a, b, normal_);
  bool are_told = true;
  for (std::size_t i = 0; i < m.corners.size(); ++i) {
    corners.begin()[i] = corner(places, m.corners[i]);
    are_told = are_told && corners[i];
  }
  if (!are_told && !pair_.difference().a.has_scale()) tell_by_integers(m, places, corners);
  return corners;
}

}  // namespace plumb::query::touching
