// Two solids.  A vertex of the common set is a vertex of one of them, or lies on an edge of one and a face of the other, so that
// edges alone are clipped, as in meet.hpp.  A face lies on a bound of one of them; on which bounds a corner lies is
// known from what it is made of, and of corners at one place by what all of them are made of.  What has no volume lies
// on one bound whole: solids that touch are parted by the plane of a face.
#include <algorithm>

#include "plumb/query/section/solid.hpp"
#include "query/body/figure_input.hpp"
#include "query/convex/set.hpp"
#include "query/section/corner_name.hpp"
#include "query/section/meet.hpp"
#include "query/section/meet_halfspaces.hpp"
#include "query/section/solid_faces.hpp"

namespace plumb::query::meeting {
namespace {

FaceLook look_of(const Bound<3>& b) {
  const Sign side = static_cast<Sign>(b.side == 0 ? 1 : b.side);
  if (b.kind == Bound<3>::Kind::face) {
    for (const std::size_t axis : {2u, 0u, 1u}) {
      const Sign turn = orient2d(seen<3>(b.a, looks[axis]), seen<3>(b.b, looks[axis]), seen<3>(b.c, looks[axis]));
      if (turn != Sign::zero) return {axis, -(side * turn)};
    }
  }
  return face_look([&](std::size_t axis) {
    if (b.kind == Bound<3>::Kind::given) return side * b.given->gradient[axis].sign();
    const double x = b.kind == Bound<3>::Kind::axis ? static_cast<double>(b.axis == axis) : part(b.direction, axis);
    return side * sign_of_number(static_cast<int>(x > 0) - static_cast<int>(x < 0));
  });
}

/// Of two solids: which of their own bounds hold a vertex, found when it is asked.
class OwnBounds {
 public:
  explicit OwnBounds(const ConvexSet<3>& set)
      : set_(set), of_vertex_(std::max(set.vertices.size(), set.exact_vertices.size())) {}

  const Ids& of_vertex(int vertex) {
    auto& ids = of_vertex_[static_cast<std::size_t>(vertex)];
    if (!ids) {
      ids.emplace();
      for (std::uint32_t i = 0; i < set_.bounds.size(); ++i) {
        if (vertex_sign(set_, static_cast<std::size_t>(vertex), set_.bounds[i]) == Sign::zero) ids->push_back(i);
      }
    }
    return *ids;
  }
  Ids of_edge(const Edge<3>& e) {
    Ids both;
    std::ranges::set_intersection(of_vertex(e.from), of_vertex(e.to), std::back_inserter(both));
    return both;
  }

 private:
  const ConvexSet<3>& set_;
  std::vector<std::optional<Ids>> of_vertex_;
};

/// One computation in the numbers T; nothing where they cannot tell.
template <class T>
class SolidMeeting {
 public:
  SolidMeeting(const ConvexSet<3>& a, const ConvexSet<3>& b, const SignTable& of_a, const SignTable& of_b,
               OwnBounds& own_a, OwnBounds& own_b)
      : a_(a), b_(b), of_a_(of_a), of_b_(of_b), own_a_(own_a), own_b_(own_b) {}

  std::optional<SolidIntersection3> operator()() {
    if (!add_pieces(false) || !add_pieces(true)) return {};
    const auto look = [&](std::size_t i) {
      return look_of(i < a_.bounds.size() ? a_.bounds[i] : b_.bounds[i - a_.bounds.size()]);
    };
    const auto name = [&](const Corner<T, 3>& c) { return corner_name(c, a_, b_); };
    return solid_of(std::move(found_), a_.bounds.size() + b_.bounds.size(), look, name, ask_);
  }

 private:
  bool add_pieces(bool of_b) {
    const ConvexSet<3>&set = of_b ? b_ : a_, &other = of_b ? a_ : b_;
    for (std::size_t e = 0; e < set.edges.size(); ++e) {
      const auto piece = Clip<T, 3>(set, set.edges[e], other, of_b ? of_b_ : of_a_, ask_)();
      if (!ask_.certain()) return false;
      if (!piece) continue;
      if (!add(e, piece->from, of_b)) return false;
      if (!piece->is_point && !add(e, piece->to, of_b)) return false;
    }
    return true;
  }

  bool add(std::size_t edge, const End<T>& end, bool of_b) {
    const ConvexSet<3>&set = of_b ? b_ : a_, &other = of_b ? a_ : b_;
    auto& seen = of_b ? seen_b_ : seen_a_;
    if (end.own) {  // once, of whichever edge
      if (std::ranges::find(seen, end.index) != seen.end()) return true;
      seen.push_back(end.index);
    }
    Corner<T, 3> c =
        end.own ? vertex_corner<T, 3>(set, end.index, of_b) : crossing_corner<T, 3>(set, edge, other, end, of_b);
    const Place place = place_of(c, found_.corners, ask_);
    if (!ask_.certain()) return false;
    const auto at = static_cast<std::ptrdiff_t>(place.index);
    if (!place.taken) {
      found_.corners.insert(found_.corners.begin() + at, std::move(c));
      found_.on.insert(found_.on.begin() + at, Ids());
    }
    Ids &on = found_.on[place.index], all;
    std::ranges::set_union(on, bounds_at(set.edges[edge], end, of_b), std::back_inserter(all));
    on = std::move(all);
    return true;
  }

  // Ascending: the bounds of a, then those of b.
  Ids bounds_at(const Edge<3>& e, const End<T>& end, bool of_b) {
    const ConvexSet<3>& other = of_b ? a_ : b_;
    const SignTable& signs = of_b ? of_b_ : of_a_;
    OwnBounds& own_bounds = of_b ? own_b_ : own_a_;
    const auto beyond = static_cast<std::uint32_t>(a_.bounds.size());
    Ids own = end.own ? own_bounds.of_vertex(end.index) : own_bounds.of_edge(e), others;
    for (std::uint32_t i = 0; i < other.bounds.size(); ++i) {
      const bool on = end.own
                          ? signs.at(i, end.index) == 0
                          : end.index == static_cast<int>(i) || (signs.at(i, e.from) == 0 && signs.at(i, e.to) == 0);
      if (on) others.push_back(i);
    }
    for (std::uint32_t& i : of_b ? own : others) i += beyond;
    Ids& all = of_b ? others : own;
    const Ids& last = of_b ? own : others;
    all.insert(all.end(), last.begin(), last.end());
    return all;
  }

  const ConvexSet<3>&a_, &b_;
  const SignTable &of_a_, &of_b_;
  OwnBounds &own_a_, &own_b_;
  CertainSigns ask_;
  SolidCorners<T> found_;
  std::vector<int> seen_a_, seen_b_;  // vertices that have been added
};

SolidIntersection3 meet_solids(const ConvexSet<3>& a, const ConvexSet<3>& b) {
  if (a.dimension != 3 || b.dimension != 3) {
    Intersection3 common = meet(a, b);
    SolidIntersection3 told;
    told.kind = common.kind;
    told.vertices = std::move(common.vertices);
    return told;
  }
  SignTable of_a, of_b;
  if (!of_a.fill(b, a) || !of_b.fill(a, b)) return {};
  OwnBounds own_a(a), own_b(b);
  if (!a.is_exact() && !b.is_exact()) {
    if (auto common = SolidMeeting<Approximate>(a, b, of_a, of_b, own_a, own_b)()) return std::move(*common);
    if (auto common = SolidMeeting<Ball>(a, b, of_a, of_b, own_a, own_b)()) return std::move(*common);
  }
  return std::move(*SolidMeeting<BigDyadic>(a, b, of_a, of_b, own_a, own_b)());
}

}  // namespace
}  // namespace plumb::query::meeting

namespace plumb::query {

using namespace meeting;

SolidIntersection3 common_solid(const FigureView& a, const FigureView& b) {
  require_figures("intersection", a, b);
  const auto of_a = convex_set3(a), of_b = convex_set3(b);
  const auto goes_on = [](const FigureView& v) { return v.kind == FigureKind::halfspace; };
  if (of_a && of_b && !(goes_on(a) && goes_on(b))) return meet_solids(*of_a, *of_b);
  std::vector<ExactHalfspace> all = halfspaces_of(a);
  for (ExactHalfspace& h : halfspaces_of(b)) all.push_back(std::move(h));
  return meet_halfspaces(all);
}

}  // namespace plumb::query
