// The hull by the farthest point, again and again: what lies in the triangle that it makes is done with.
#include <algorithm>

#include "figure/hull/hull2_steps.hpp"

namespace plumb::figure::hull2 {
namespace {

/// Two vertices, b somewhere after a when counterclockwise, and the points to the right of ab (on it, if asked).
struct Part {
  Indexed a, b;
  std::vector<Indexed> points;
};

Part part(const Indexed& a, const Indexed& b, const std::vector<Indexed>& from, bool on_line_too) {
  Part to{a, b, {}};
  for (const Indexed& p : from) {
    const Sign s = turn(b, a, p);
    if (s == Sign::positive || (s == Sign::zero && on_line_too && !(p.p == a.p) && !(p.p == b.p)))
      to.points.push_back(p);
  }
  return to;
}

/// Is p farther from ab than q?  Of equally far ones the last along ab is: it is a vertex; of equal ones the first.
bool farther(const Part& in, const Indexed& p, const Indexed& q) {
  const Sign s = sign_of(predicates::SignedLineDistance{}, in.b.p, in.a.p, p.p, q.p);
  if (s != Sign::zero) return s == Sign::positive;
  if (p.p == q.p) return p.index < q.index;
  return before(q, p) == before(in.a, in.b);
}

/// The farthest point that is not on ab.
const Indexed* farthest(const Part& in) {
  const Indexed* most = nullptr;
  for (const Indexed& p : in.points) {
    if (most == nullptr || farther(in, p, *most)) most = &p;
  }
  return most != nullptr && turn(in.b, in.a, *most) == Sign::positive ? most : nullptr;
}

}  // namespace

Hull2 quickhull(std::vector<Indexed> points, bool all_boundary_points) {
  if (points.empty()) return {-1, {}};
  const Indexed first = *std::ranges::min_element(points, before);
  Indexed last = *std::ranges::max_element(points, before);
  for (const Indexed& p : points) {
    if (p.p == last.p && p.index < last.index) last = p;
  }
  if (first.p == last.p) return {0, {first.index}};
  // The part to go on with is the last one: counterclockwise from `first`.
  std::vector<Part> open;
  open.push_back(part(last, first, points, all_boundary_points));
  open.push_back(part(first, last, points, all_boundary_points));
  Hull2 hull{2, {first.index}};
  if (farthest(open[0]) == nullptr && farthest(open[1]) == nullptr) {
    hull.dimension = 1;
    open.erase(open.begin());
  }
  while (!open.empty()) {
    Part now = std::move(open.back());
    open.pop_back();
    if (const Indexed* tip = farthest(now)) {
      open.push_back(part(*tip, now.b, now.points, all_boundary_points));
      open.push_back(part(now.a, *tip, now.points, all_boundary_points));
      continue;
    }
    sort_distinct(now.points);  // all of them on ab
    if (before(now.b, now.a)) std::ranges::reverse(now.points);
    for (const Indexed& p : now.points) hull.vertices.push_back(p.index);
    if (now.b.index != first.index) hull.vertices.push_back(now.b.index);
  }
  return hull;
}

}  // namespace plumb::figure::hull2
