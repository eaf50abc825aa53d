#include "space/ray/hit_search.hpp"

#include <algorithm>
#include <cmath>

#include "query/ray/posed_barycentric.hpp"
#include "query/ray/posed_triangle.hpp"

namespace plumb::space {

bool HitSearch::is_hit(std::uint32_t slot) const {
  return pose_ != nullptr ? query::hits(*ray_, posed(slot), rule_) : hits(*ray_, triangles_.triangle(slot), rule_);
}
NumberedHit HitSearch::numbered(const SlotHit& hit) const {
  if (pose_ != nullptr) return {number(hit.slot), *query::first_hit(*ray_, posed(hit.slot), rule_)};
  const auto [triangle, how] = decided(hit);
  return {number(hit.slot), query::hit_of(*ray_, triangle, how)};
}

query::DecidedTriangle HitSearch::decided(const SlotHit& hit) const {
  const Triangle3 triangle = triangles_.triangle(hit.slot);
  if (hit.decided) return {triangle, *hit.decided};
  return {triangle, rule_ == HitRule::closed ? *query::decide_crossing(*ray_, triangle)
                                             : *query::decide_hit(*ray_, triangle, rule_)};
}

std::optional<HitSearch::SlotHit> HitSearch::between(std::uint32_t slot, bool certain, double least,
                                                     double most) const {
  const auto found = hit_between(slot, certain, least, most);
  if (found && limits_ != nullptr && is_left_out(*found)) return {};
  return found;
}

bool HitSearch::is_left_out(const SlotHit& hit) const {
  const auto& [least, most, skip] = *limits_;
  if (std::find(skip.begin(), skip.end(), number(hit.slot)) != skip.end()) return true;
  if (hit.most < least || hit.least > most) return true;
  if (hit.least >= least && hit.most <= most) return false;
  const auto t = pose_ != nullptr ? query::first_hit_parameter(*ray_, posed(hit.slot), rule_)
                                  : first_hit_parameter(*ray_, triangles_.triangle(hit.slot), rule_);
  const auto is_below = [&](double limit) { return std::isfinite(limit) && *t < RayParameter{Rational(limit)}; };
  const auto is_above = [&](double limit) { return std::isfinite(limit) && *t > RayParameter{Rational(limit)}; };
  return is_below(least) || is_above(most) || least == infinity || most == -infinity;
}

std::optional<HitSearch::SlotHit> HitSearch::hit_between(std::uint32_t slot, bool certain, double least,
                                                         double most) const {
  if (certain) return SlotHit{slot, least, most, true, query::crossed_inside};
  if (pose_ != nullptr) return posed_between(slot, least, most);
  if (least > -infinity && most < infinity) {  // or lanes know no parameters
    if (!is_hit(slot)) return {};
    return SlotHit{slot, least, most};
  }
  const Triangle3 triangle = triangles_.triangle(slot);
  const auto decided = query::decide_hit(*ray_, triangle, rule_);
  if (!decided) return {};
  const auto range = query::range_of(*ray_, triangle, *decided);
  return SlotHit{slot, range.least, range.most, false, decided};
}

std::optional<HitSearch::SlotHit> HitSearch::posed_between(std::uint32_t slot, double least, double most) const {
  if (least > -infinity && most < infinity) {
    if (is_hit(slot)) return SlotHit{slot, least, most};
    return {};
  }
  const auto exact = query::first_hit(*ray_, posed(slot), rule_);
  if (!exact) return {};
  return SlotHit{slot, std::nextafter(exact->t, -infinity), std::nextafter(exact->t, infinity)};
}

bool HitSearch::is_before(const SlotHit& a, const SlotHit& b) const {
  if (a.most < b.least) return true;
  if (b.most < a.least) return false;
  const auto compared = [&] {
    if (pose_ != nullptr) return query::compare_hits(*ray_, posed(a.slot), posed(b.slot), rule_);
    if (a.is_crossed && b.is_crossed) {
      const Triangle3 first = triangles_.triangle(a.slot), second = triangles_.triangle(b.slot);
      if (const auto order = query::compare_crossings(*ray_, first, second)) return *order;
    }
    return query::compare_hits(*ray_, decided(a), decided(b));
  };
  const Sign order = compared();
  return order == Sign::negative || (order == Sign::zero && number(a.slot) < number(b.slot));
}

double FirstHit::visit(std::uint32_t slot, bool certain, double least, double most) {
  if (found_ && least > best_.most) return limit_;
  auto hit = between(slot, certain, least, most);
  if (!hit || (found_ && hit->least > best_.most)) return limit_;
  if (!found_ || hit->most < best_.most) {
    std::swap(*hit, best_);
    limit_ = std::min(limit_, keys_.limit_at(best_.most));
  }
  if (found_ && !(hit->least > best_.most)) others_.push_back(*hit);
  found_ = true;
  return limit_;
}

std::optional<HitSearch::SlotHit> FirstHit::earliest() const {
  if (!found_) return {};
  SlotHit first = best_;
  for (const SlotHit& other : others_) {
    if (!(other.least > best_.most) && is_before(other, first)) first = other;
  }
  return first;
}
std::optional<std::uint32_t> FirstHit::first_number() const {
  const auto first = earliest();
  if (!first) return {};
  return number(first->slot);
}
std::optional<NumberedHit> FirstHit::first() const {
  const auto first = earliest();
  if (!first) return {};
  return numbered(*first);
}

double AnyHit::visit(std::uint32_t slot, bool certain, double least, double most) {
  found_ = counts(slot, certain, least, most);
  slot_ = slot;
  return found_ ? -infinity : limit_;
}

double CountedHits::visit(std::uint32_t slot, bool certain, double least, double most) {
  if (counts(slot, certain, least, most)) numbers_.push_back(number(slot));
  return limit_;
}
std::size_t CountedHits::count() {
  std::sort(numbers_.begin(), numbers_.end());
  return static_cast<std::size_t>(std::unique(numbers_.begin(), numbers_.end()) - numbers_.begin());
}

double OrderedHits::visit(std::uint32_t slot, bool certain, double least, double most) {
  if (const auto hit = between(slot, certain, least, most)) all_.push_back(*hit);
  return limit_;
}
std::vector<NumberedHit> OrderedHits::in_order(std::vector<NumberedHit> hits) {
  hits.clear();
  std::sort(all_.begin(), all_.end(), [&](const SlotHit& a, const SlotHit& b) { return is_before(a, b); });
  for (const SlotHit& hit : all_) {  // an item may be in several slots
    if (hits.empty() || hits.back().index != number(hit.slot)) hits.push_back(numbered(hit));
  }
  return hits;
}

double PassedTriangles::visit(std::uint32_t slot, bool /*certain*/, double /*least*/, double /*most*/) {
  slots_.push_back(slot);
  return limit_;
}
std::optional<std::uint32_t> PassedTriangles::slot_of(std::uint32_t triangle) const {
  const auto at = std::ranges::find(slots_, triangle, [&](std::uint32_t slot) { return number(slot); });
  return at == slots_.end() ? std::nullopt : std::optional(*at);
}
std::optional<HitBarycentric> PassedTriangles::barycentric(std::uint32_t triangle) const {
  const auto slot = slot_of(triangle);
  if (!slot) return {};
  return pose_ != nullptr ? query::hit_barycentric(*ray_, posed(*slot))
                          : hit_barycentric(*ray_, triangles_.triangle(*slot));
}
std::optional<ExactHitBarycentric> PassedTriangles::exact_barycentric(std::uint32_t triangle) const {
  const auto slot = slot_of(triangle);
  if (!slot) return {};
  return pose_ != nullptr ? query::exact_hit_barycentric(*ray_, posed(*slot))
                          : exact_hit_barycentric(*ray_, triangles_.triangle(*slot));
}

}  // namespace plumb::space
