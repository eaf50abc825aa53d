#include "query/contact/upright.hpp"

#include <algorithm>
#include <array>

#include "arith/certain.hpp"
#include "arith/exact_sum.hpp"
#include "arith/running_error.hpp"
#include "query/body/upright_box.hpp"

namespace plumb::query::touching {
namespace {

/// The axis along which they face each other, and whether a is below.
struct FacingAxis {
  std::size_t axis;
  bool is_a_below;
  Relation relation;
};

class UprightPair {
 public:
  UprightPair(const UprightBox& a, const UprightBox& b) : a_(a), b_(b) {}

  [[nodiscard]] bool are_apart() const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (gap(k, true) > 0 || gap(k, false) > 0) return true;
    }
    return false;
  }
  /// Nothing where there are several.
  [[nodiscard]] std::optional<FacingAxis> facing() const {
    std::optional<FacingAxis> found;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const bool below : {true, false}) {
        const auto order = gap(k, below);
        if (order < 0) continue;
        if (found) return {};
        found = FacingAxis{k, below, order > 0 ? Relation::disjoint : Relation::touching};
      }
    }
    return found ? found : least_overlap();
  }
  /// The upper face of the lower one, or the lower face of the upper one.
  [[nodiscard]] const FacePlace& face(std::size_t body, const FacingAxis& f) const {
    const UprightBox& box = body == 0 ? a_ : b_;
    return (body == 0) == f.is_a_below ? box.high[f.axis] : box.low[f.axis];
  }
  /// From a to b, below zero where they overlap.
  [[nodiscard]] auto distance(const FacingAxis& f) const {
    return [this, f](auto maker) {
      const auto of_a = face(0, f).number(maker), of_b = face(1, f).number(maker);
      return f.is_a_below ? of_b - of_a : of_a - of_b;
    };
  }
  [[nodiscard]] const UprightBox& a() const { return a_; }
  [[nodiscard]] const UprightBox& b() const { return b_; }

 private:
  /// Above zero: there is one, with a below or above.
  [[nodiscard]] std::strong_ordering gap(std::size_t k, bool is_a_below) const {
    return is_a_below ? b_.low[k].against(a_.high[k]) : a_.low[k].against(b_.high[k]);
  }
  /// Six ways lead out; it is the one that is shorter than any other, for certain.
  [[nodiscard]] std::optional<FacingAxis> least_overlap() const {
    const auto running = [](double x) { return Running(x); };
    std::array<Running, 6> overlap;
    std::size_t least = 0;  // a guess, which is held against all others
    for (std::size_t i = 0; i < 6; ++i) {
      overlap[i] = Running(0.0) - distance({i / 2, i % 2 == 0, Relation::overlapping})(running);
      if (overlap[i].value < overlap[least].value) least = i;
    }
    for (std::size_t i = 0; i < 6; ++i) {
      if (i != least && certain_sign(overlap[i] - overlap[least]) <= 0) return {};
    }
    return FacingAxis{least / 2, least % 2 == 0, Relation::overlapping};
  }

  const UprightBox &a_, &b_;
};

/// An end of what two intervals have in common, and of which bodies it is one.
struct CommonEnd {
  const FacePlace* at;
  std::array<bool, 2> of;
  bool is_high;
};
CommonEnd common_end(const FacePlace& a, const FacePlace& b, bool is_high) {
  const auto order = a.against(b);
  const bool is_of_a = order == 0 || (order < 0) == is_high;
  return {is_of_a ? &a : &b, {is_of_a, order == 0 || !is_of_a}, is_high};
}

/// The axes along which it is at an end tell it, and at which one; query/penetration/penetration.hpp says the numbers.
Feature feature_at(const std::array<bool, 3>& is_at_end, const std::array<bool, 3>& is_high) {
  std::uint32_t free = 0, ends = 0, upper = 0, vertex = 0, face = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (!is_at_end[k]) {
      free = k;
      continue;
    }
    const std::uint32_t bit = is_high[k] ? 1 : 0;
    vertex |= bit << k, upper |= bit << ends, face = 2 * k + bit, ++ends;
  }
  if (ends == 3) return {FeatureKind::vertex, vertex};
  if (ends == 2) return {FeatureKind::edge, 4 * free + upper};
  return {FeatureKind::face, face};
}

double& coordinate(Point3& p, std::size_t k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// The four corners of what both faces have in common.
std::array<ContactCorner, 4> common_corners(const UprightPair& pair, const FacingAxis& f, double distance) {
  const std::size_t u = f.axis == 0 ? 1 : 0, v = f.axis == 2 ? 1 : 2;
  const auto end = [&](std::size_t k, bool is_high) {
    return is_high ? common_end(pair.a().high[k], pair.b().high[k], true)
                   : common_end(pair.a().low[k], pair.b().low[k], false);
  };
  std::array<ContactCorner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const CommonEnd along_u = end(u, i % 2 != 0), along_v = end(v, i / 2 != 0);
    ContactCorner& c = corners[i];
    c.distance = distance;
    for (std::size_t body = 0; body < 2; ++body) {
      std::array<bool, 3> is_at_end{}, is_high{};
      is_at_end[f.axis] = true, is_high[f.axis] = (body == 0) == f.is_a_below;
      is_at_end[u] = along_u.of[body], is_high[u] = along_u.is_high;
      is_at_end[v] = along_v.of[body], is_high[v] = along_v.is_high;
      (body == 0 ? c.id.a : c.id.b) = feature_at(is_at_end, is_high);
      Point3& on = body == 0 ? c.on_a : c.on_b;
      coordinate(on, f.axis) = pair.face(body, f).nearest + 0.0;
      coordinate(on, u) = along_u.at->nearest + 0.0, coordinate(on, v) = along_v.at->nearest + 0.0;
    }
  }
  std::ranges::sort(corners, {}, &ContactCorner::id);
  return corners;
}

}  // namespace

UprightContact upright_contact(const BodyView& a, const BodyView& b, double margin) {
  const auto boxed = [](const BodyView& v) {
    return v.is_hull() || v.radius != 0 ? std::nullopt : upright_box({v.figure, v.pose});
  };
  const auto first = boxed(a);
  if (!first) return {};
  const auto second = boxed(b);
  if (!second) return {};
  const UprightPair pair(*first, *second);
  if (margin == 0 && pair.are_apart()) return {true, {}};
  const auto f = pair.facing();
  if (!f) return {};
  const auto gap = pair.distance(*f);
  using namespace arith::exact_sum;  // NOLINT: sums alone
  if (f->relation == Relation::disjoint &&
      sign([&](auto maker) { return gap(maker) - maker(margin); }) == Sign::positive) {
    return {true, {}};
  }
  const double distance = f->relation == Relation::touching ? 0 : nearest(gap) + 0.0;
  const double towards = f->is_a_below ? 1 : -1;
  UprightContact told{true, ContactManifold{f->relation, {0, 0, 0}, distance, {}}};
  (f->axis == 0 ? told.manifold->normal.x : f->axis == 1 ? told.manifold->normal.y : told.manifold->normal.z) = towards;
  for (const ContactCorner& c : common_corners(pair, *f, distance)) told.manifold->corners.push_back(c);
  return told;
}

}  // namespace plumb::query::touching
