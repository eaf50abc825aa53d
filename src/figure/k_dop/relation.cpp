#include <algorithm>

#include "figure/k_dop/halfspace_slack.hpp"
#include "figure/k_dop/inner_point.hpp"
#include "figure/k_dop/sets.hpp"

namespace plumb {
namespace {

using namespace figure;

// The largest of (later start - earlier end): positive where intervals are disjoint; NaN where a number may be none.
template <class Vector>
double gap(const KDop<Vector>& a, const KDop<Vector>& b) {
  const std::size_t n = a.directions.size();
  double all = 0, widest = -1;
  for (std::size_t i = 0; i < n; ++i) {
    all += (a.min[i] + a.max[i]) + (b.min[i] + b.max[i]);
    widest = std::max(widest, std::max(a.min[i], b.min[i]) - std::min(a.max[i], b.max[i]));
  }
  return widest + (all - all);
}

template <class Vector>
bool have_one_form(const KDop<Vector>& a, const KDop<Vector>& b) {
  const std::size_t n = a.directions.size();
  return a.directions == b.directions && a.min.size() == n && a.max.size() == n && b.min.size() == n &&
         b.max.size() == n;
}

template <class Vector>
bool overlap(std::string_view function, const KDop<Vector>& a, const KDop<Vector>& b) {
  if (!have_one_form(a, b)) check(function, a, b);
  const double g = gap(a, b);
  if (g - g == 0) return g <= 0;
  check(function, a, b);
  for (std::size_t i = 0; i < a.min.size(); ++i) {
    if (std::max(a.min[i], b.min[i]) > std::min(a.max[i], b.max[i])) return false;
  }
  return true;
}

// What lies in both, of one form.
template <class Vector>
KDop<Vector> common_part(const KDop<Vector>& a, const KDop<Vector>& b) {
  KDop<Vector> both = a;
  for (std::size_t i = 0; i < a.min.size(); ++i) {
    both.min[i] = std::max(a.min[i], b.min[i]);
    both.max[i] = std::min(a.max[i], b.max[i]);
  }
  return both;
}

// The greatest slack that a point has in all halfspaces: its sign, where that is proved.
template <class Vector>
std::optional<int> sign_of_slack(const KDop<Vector>& k_dop) {
  const auto row = [&]<class T>(std::size_t i, const T&) {
    const auto d = coordinates(k_dop.directions.all()[i / 2]);
    SlackRow<T> r{{T(0.0), T(0.0), T(0.0)}, T(i % 2 == 0 ? k_dop.max[i / 2] : -k_dop.min[i / 2])};
    for (std::size_t k = 0; k < d.size(); ++k) r.normal[k] = T(i % 2 == 0 ? d[k] : -d[k]);
    return r;
  };
  HalfspaceSlack slack([&](std::size_t i) { return row(i, BigDyadic()); });
  slack.reserve(2 * k_dop.min.size());
  for (std::size_t i = 0; i < 2 * k_dop.min.size(); ++i) {
    double size = 0;
    for (const double x : coordinates(k_dop.directions.all()[i / 2])) size += magnitude_of(x);
    slack.add(row(i, Running()), size);
  }
  return slack.sign();
}

// Which halfspaces have slack somewhere in the set, which is not empty: those that bound its relative interior.
std::vector<bool> with_slack(const arith::Constraints& halfspaces) {
  std::vector<bool> slack(halfspaces.rows.size(), true);
  // Ends, for each turn takes some away: where the greatest common slack is 0, the multipliers of those that were to
  // have slack sum up to 1, and those above 0 decide.
  for (;;) {
    const arith::Feasible found = arith::feasible(halfspaces, slack);
    if (found.slack != 0) return slack;
    for (const std::size_t i : found.deciding) slack[i] = false;
  }
}

template <class Vector>
Relation relation(std::string_view function, const KDop<Vector>& a, const KDop<Vector>& b) {
  if (!overlap(function, a, b)) return Relation::disjoint;
  if (CommonSlabs(a, b).have_inner_point()) return Relation::overlapping;
  const KDop<Vector> both = common_part(a, b);
  const auto sign = sign_of_slack(both);
  if (sign && (*sign != 0 || (sign_of_slack(a) == 1 && sign_of_slack(b) == 1))) return static_cast<Relation>(*sign);
  const arith::Constraints common = halfspaces(both);
  const int slack = arith::feasible(common, std::vector<bool>(common.rows.size(), true)).slack;
  if (slack != 0) return slack < 0 ? Relation::disjoint : Relation::overlapping;
  // A common point, but none inside both: the relative interiors may still meet where a set is flat.
  arith::Constraints all = halfspaces(a);
  std::vector<bool> strictly = with_slack(all);
  const arith::Constraints of_b = halfspaces(b);
  const std::vector<bool> strictly_b = with_slack(of_b);
  all.rows.insert(all.rows.end(), of_b.rows.begin(), of_b.rows.end());
  all.limits.insert(all.limits.end(), of_b.limits.begin(), of_b.limits.end());
  strictly.insert(strictly.end(), strictly_b.begin(), strictly_b.end());
  return arith::feasible(all, strictly).slack > 0 ? Relation::overlapping : Relation::touching;
}

template <class Vector>
bool meet(const KDop<Vector>& a, const KDop<Vector>& b) {
  if (!overlap("intersects", a, b)) return false;
  if (CommonSlabs(a, b).have_inner_point()) return true;
  const KDop<Vector> both = common_part(a, b);
  if (const auto sign = sign_of_slack(both)) return *sign >= 0;
  return !is_empty(halfspaces(both));
}

template <class Vector>
bool is_empty_set(const KDop<Vector>& k_dop) {
  require_sound("is_empty", k_dop);
  if (has_empty_interval(k_dop)) return true;
  if (CommonSlabs(k_dop, k_dop).have_inner_point()) return false;
  if (const auto sign = sign_of_slack(k_dop)) return *sign < 0;
  return is_empty(halfspaces(k_dop));
}

template <class Vector>
bool holds(const KDop<Vector>& outer, const KDop<Vector>& inner) {
  require_sound("contains", "outer", outer);
  require_sound("contains", "inner", inner);
  bool nested = outer.directions == inner.directions;
  for (std::size_t i = 0; nested && i < outer.min.size(); ++i)
    nested = outer.min[i] <= inner.min[i] && inner.max[i] <= outer.max[i];
  if (nested) return true;
  const arith::Constraints within = halfspaces(inner), needed = halfspaces(outer);
  if (is_empty(within)) return true;
  for (std::size_t i = 0; i < needed.rows.size(); ++i) {
    const arith::Optimum farthest = arith::maximize(needed.rows[i], within);
    if (farthest.kind != arith::Optimum::Kind::optimal || arith::dot(needed.rows[i], farthest.at) > needed.limits[i])
      return false;
  }
  return true;
}

}  // namespace

bool intervals_overlap(const KDop2& a, const KDop2& b) { return overlap("intervals_overlap", a, b); }
bool intervals_overlap(const KDop3& a, const KDop3& b) { return overlap("intervals_overlap", a, b); }
Relation relate(const KDop2& a, const KDop2& b) { return relation("relate", a, b); }
Relation relate(const KDop3& a, const KDop3& b) { return relation("relate", a, b); }
bool intersects(const KDop2& a, const KDop2& b) { return meet(a, b); }
bool intersects(const KDop3& a, const KDop3& b) { return meet(a, b); }
bool is_empty(const KDop2& k_dop) { return is_empty_set(k_dop); }
bool is_empty(const KDop3& k_dop) { return is_empty_set(k_dop); }
bool contains(const KDop2& outer, const KDop2& inner) { return holds(outer, inner); }
bool contains(const KDop3& outer, const KDop3& inner) { return holds(outer, inner); }

}  // namespace plumb
