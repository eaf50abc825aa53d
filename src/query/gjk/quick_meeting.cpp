// A search in doubles, which is a guess, and its proof.
#include "query/gjk/quick_meeting.hpp"

#include <algorithm>
#include <cmath>

#include "arith/running_error.hpp"
#include "figure/support/gjk_simplex.hpp"
#include "query/body/weighted_pose.hpp"
#include "query/gjk/directed.hpp"
#include "query/gjk/origin.hpp"
#include "query/separation/convex_body.hpp"

namespace plumb::query {
namespace {

using arith::Plain, arith::cross, arith::dot;
using gjk_origin::Ahead, gjk_origin::AllOnSide, gjk_origin::AreAhead, gjk_origin::IsAroundOrigin;
using gjk_search::Corner, gjk_search::Directed;
using RunningVec = arith::Vec<Running>;

[[gnu::always_inline]] inline Sign ahead(const Plain& n, const Point3& v, const Point3& p) {
  FloatWorld<Ahead> w;
  const Sign s = Ahead{}(w, n, v, p);
  return w.certain() ? s : Sign::zero;
}
Sign certain(const Running& x) {
  const Unsure<Sign> s = x.sign();
  return s.certain() ? s.value() : Sign::zero;
}

/// Is all of the polyhedron strictly beyond the plane, by a corner and its neighbors?  From any vertex a way leads to the
/// least one that never ascends: it cannot leave the vertices seen, whose other neighbors are all above the first, but by
/// one that is.
template <class IsAbove, class IsBeyond>
bool is_polyhedron_beyond(const ConvexPolyhedron3& solid, std::uint32_t from, const IsAbove& is_above,
                          const IsBeyond& is_beyond) {
  constexpr std::size_t most_level = 16;
  std::array<std::uint32_t, most_level> level{from};
  std::size_t count = 1;
  for (std::size_t k = 0; k < count; ++k) {
    for (const std::uint32_t i : solid.neighbors_of(level[k])) {
      if (is_above(i)) continue;
      const auto end = level.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::find(level.begin(), end, i) != end) continue;
      if (count == most_level || !is_beyond(i)) return false;
      level[count++] = i;
    }
  }
  return true;
}

/// Is every corner strictly on this side of a plane through m, from which corner `from` is likely the least far?
bool is_beyond_plane(const QuickHull& h, std::uint32_t from, const Plain& n, const Point3& m, Sign side) {
  const Point3& first = h.given(from);
  if (ahead(n, first, m) != side) return false;
  const auto is_beyond = [&](std::uint32_t i) { return ahead(n, h.given(i), m) == side; };
  if (h.solid() != nullptr) {
    return is_polyhedron_beyond(
        *h.solid(), from, [&](std::uint32_t i) { return ahead(n, h.given(i), first) == side; }, is_beyond);
  }
  for (std::uint32_t i = 0; i < h.size(); ++i) {
    if (!is_beyond(i)) return false;
  }
  return true;
}

/// The same of corners that are no doubles as given, by running bounds.
template <class At>
bool is_beyond_plane(const QuickHull& h, const At& at, std::uint32_t from, const Plain& along, const RunningVec& m,
                     Sign side) {
  const RunningVec n = arith::vec<Running>(along), first = at(from);
  if (certain(dot(n, first - m)) != side) return false;
  const auto is_beyond = [&](std::uint32_t i) { return certain(dot(n, at(i) - m)) == side; };
  if (h.solid() != nullptr) {
    return is_polyhedron_beyond(
        *h.solid(), from, [&](std::uint32_t i) { return certain(dot(n, at(i) - first)) == side; }, is_beyond);
  }
  for (std::uint32_t i = 0; i < h.size(); ++i) {
    if (!is_beyond(i)) return false;
  }
  return true;
}

/// Are all neighbors of a vertex ahead of it?  Then so is the whole polyhedron.
bool is_least(const QuickHull& h, std::uint32_t i, const Plain& n) {
  FloatWorld<AreAhead> w;
  const bool is_so = AreAhead{}(w, n, &h.given(0), h.solid()->neighbors_of(i), h.given(i));
  return is_so && w.certain();
}

/// Are all corners on this side of the plane through m?
template <int side>
bool are_all_on_side(const QuickHull& h, const Plain& n, const Point3& m) {
  FloatWorld<AllOnSide<side>> w;
  const bool is_so = AllOnSide<side>{}(w, n, {&h.given(0), h.size()}, m);
  return is_so && w.certain();
}

/// Of so few corners all are asked: as quick as those about one of them, and corners that are level do no harm.
constexpr std::uint32_t most_asked = 12;

bool are_few(const QuickHull& a, const QuickHull& b) {
  return a.is_given() && b.is_given() && a.size() <= most_asked && b.size() <= most_asked;
}

/// Is all of a strictly beyond the plane through p, and all of b strictly before that through q, along n?
bool are_beside(const QuickBody& a, const QuickBody& b, const Plain& n, const GjkCorner& ends, const Point3& p,
                const Point3& q) {
  if (are_few(a.hull, b.hull)) return are_all_on_side<1>(a.hull, n, p) && are_all_on_side<-1>(b.hull, n, q);
  const auto beyond = [&](const QuickBody& body, std::uint32_t from, const Point3& m, Sign side) {
    const QuickHull& h = body.hull;
    if (h.is_given()) return is_beyond_plane(h, from, n, m, side);
    const RunningVec at = arith::vec<Running>(m);
    if (h.is_running())
      return is_beyond_plane(
          h, [&h](std::uint32_t i) { return h.running(i); }, from, n, at, side);
    const CoreCorners c = body.corners();
    return is_beyond_plane(
        h, [&c](std::uint32_t i) { return c.at<Running>(i); }, from, n, at * c.scale<Running>(), side);
  };
  return beyond(a, ends[0], p, Sign::positive) && beyond(b, ends[1], q, Sign::negative);
}

Point3 place(const Plain& p) { return {p.x, p.y, p.z}; }

/// Is all of a strictly farther along than all of b, which these corners are likely nearest to?
bool is_apart(const QuickBody& a, const QuickBody& b, const Plain& n, const GjkCorner& ends, const Plain& gap) {
  if (a.hull.solid() != nullptr && b.hull.solid() != nullptr && a.hull.is_given() && b.hull.is_given() &&
      !are_few(a.hull, b.hull)) {
    if (ahead(n, a.hull.given(ends[0]), b.hull.given(ends[1])) != Sign::positive) return false;
    if (is_least(a.hull, ends[0], n) && is_least(b.hull, ends[1], n * -1)) return true;
  }
  const Point3 m = place(b.hull.at(ends[1]) + gap * 0.5);
  return are_beside(a, b, n, ends, m, m);
}

/// Is all of a farther along than all of b by more than both radii?
bool is_out_of_reach(const QuickBody& a, const QuickBody& b, const Plain& n, const GjkCorner& ends, const Plain& gap) {
  constexpr double part = 0.25;  // a guess: how much of what is between the bodies the planes leave to either
  const double square = dot(n, n), beyond = dot(gap, n) - (a.radius + b.radius) * std::sqrt(square);
  if (!(beyond > 0)) return false;
  const Plain off = n * (part * beyond / square);
  const Point3 p = place(a.hull.at(ends[0]) - off), q = place(b.hull.at(ends[1]) + off);
  const RunningVec way = arith::vec<Running>(n);
  const Running between = dot(way, arith::vec<Running>(p) - arith::vec<Running>(q)),
                reach = Running(a.radius) + Running(b.radius);
  return certain(between) == Sign::positive &&
         certain(between * between - reach * reach * dot(way, way)) == Sign::positive &&
         are_beside(a, b, n, ends, p, q);
}

/// Corners of the difference, as large as the scale makes them.
struct RunningCorners {
  std::array<RunningVec, 4> at;
  Running scale{1.0};
};
RunningCorners running_corners(const QuickBody& a, const QuickBody& b, const GjkSimplex& s) {
  RunningCorners r;
  if (a.hull.is_running() && b.hull.is_running()) {
    for (std::size_t i = 0; i < s.size; ++i)
      r.at[i] = a.hull.running(s.corners[i][0]) - b.hull.running(s.corners[i][1]);
    return r;
  }
  const auto c = corners_of(a, b);
  for (std::size_t i = 0; i < s.size; ++i)
    r.at[i] = c[0].at<Running>(s.corners[i][0]) - c[1].at<Running>(s.corners[i][1]);
  r.scale = c[0].scale<Running>();
  return r;
}

bool is_around(const QuickBody& a, const QuickBody& b, const std::array<GjkCorner, 4>& corners) {
  if (a.hull.is_given() && b.hull.is_given()) return are_around_origin(a.hull, b.hull, corners);
  const auto at = running_corners(a, b, {corners, 4}).at;
  return figure::gjk::is_around_origin(
      [&](std::size_t i, std::size_t j, std::size_t k) { return certain(dot(at[i], cross(at[j], at[k]))); });
}

/// The simplex of a search that has lengths.
using LongSimplex = figure::gjk::Simplex<GjkCorner>;

GjkSimplex named_corners(const LongSimplex& simplex) {
  GjkSimplex s;
  for (const LongSimplex::Corner& c : simplex.corners()) s.corners[s.size++] = c.ends;
  return s;
}

/// Is the point of these weights, which are not below zero, nearer to the origin than both radii reach?
bool is_within_reach(const QuickBody& a, const QuickBody& b, const LongSimplex& simplex) {
  const RunningCorners corners = running_corners(a, b, named_corners(simplex));
  RunningVec way;
  Running whole;
  std::size_t i = 0;
  for (const LongSimplex::Corner& c : simplex.corners()) {
    if (!(c.weight >= 0)) return false;
    const Running weight(c.weight);
    way = way + corners.at[i++] * weight, whole = whole + weight;
  }
  const Running reach = (Running(a.radius) + Running(b.radius)) * whole * corners.scale;
  return certain(reach * reach - dot(way, way)) == Sign::positive;
}

void keep(GjkCache& found, const Directed& simplex) {
  found.simplex.size = simplex.size();
  for (std::uint32_t i = 0; i < simplex.size(); ++i) found.simplex.corners[i] = simplex[i].ends;
}

bool are_corners(const QuickHull& a, const QuickHull& b, const GjkSimplex& s) {
  if (s.size == 0 || s.size > 4) return false;
  for (std::uint32_t i = 0; i < s.size; ++i) {
    if (s.corners[i][0] >= a.size() || s.corners[i][1] >= b.size()) return false;
  }
  return true;
}

}  // namespace

bool QuickBody::set() {
  radius = query::radius_of(view);
  return radius >= 0 && (radius == 0 || is_rigid(view.pose)) && hull.set(view);
}

std::array<CoreCorners, 2> corners_of(const QuickBody& a, const QuickBody& b) {
  std::array<CoreCorners, 2> c{a.corners(), b.corners()};
  bring_to_one_weight(c[0], c[1]);
  return c;
}

bool are_around_origin(const QuickHull& a, const QuickHull& b, const std::array<GjkCorner, 4>& corners) {
  gjk_origin::Pairs pairs;
  for (std::size_t i = 0; i < 4; ++i) pairs.a[i] = a.given(corners[i][0]), pairs.b[i] = b.given(corners[i][1]);
  FloatWorld<IsAroundOrigin> w;
  const bool is_so = IsAroundOrigin{}(w, pairs);
  return is_so && w.certain();
}

Told quickly_told(const QuickBody& a, const QuickBody& b, GjkCache& found, std::uint32_t& steps) {
  constexpr int most_rounds = 64;  // a guess: whoever has not ended by then goes round
  const QuickHull &p = a.hull, &q = b.hull;
  const bool is_known = are_corners(p, q, found.simplex);
  if (is_known && found.simplex.size == 4) {
    ++steps;
    if (is_around(a, b, found.simplex.corners)) return Told::meet;
  }
  const auto& [x, y, z] = found.direction;
  const bool has_way = x != 0 || y != 0 || z != 0;
  Plain n = has_way ? arith::vec<double>(found.direction) : p.middle() - q.middle();
  GjkCorner last = is_known ? found.simplex.corners[0] : GjkCorner{0, 0};
  const auto next = [&] {
    last = {p.farthest(n * -1, last[0]), q.farthest(n, last[1])};
    return Corner{last, p.at(last[0]) - q.at(last[1])};
  };
  const auto tell_apart = [&] {
    found.simplex.corners[0] = last, found.simplex.size = 1, found.direction = {n.x, n.y, n.z};
    return Told::apart;
  };
  if (is_known && has_way && are_few(p, q)) {  // what proved the last answer likely proves this one
    const Plain gap = p.at(last[0]) - q.at(last[1]);
    if (dot(gap, n) > 0 && is_apart(a, b, n, last, gap)) {
      ++steps;
      return tell_apart();
    }
  }
  if (is_known) last = {p.farthest_from(n * -1, last[0]), q.farthest_from(n, last[1])};
  Corner c = is_known ? Corner{last, p.at(last[0]) - q.at(last[1])} : next();
  Directed simplex(c);
  for (int round = 0; round < most_rounds; ++round) {
    ++steps;
    if (dot(c.at, n) > 0 && is_apart(a, b, n, last, c.at)) return tell_apart();
    if (round > 0) {
      if (simplex.has(c.ends)) break;
      if (simplex.add(c)) {
        keep(found, simplex);
        found.direction = {0, 0, 0};
        return is_around(a, b, found.simplex.corners) ? Told::meet : Told::unsure;
      }
    }
    if (c.at.x == 0 && c.at.y == 0 && c.at.z == 0 && p.is_given() && q.is_given()) {  // one point of both
      found.simplex.corners[0] = last, found.simplex.size = 1, found.direction = {0, 0, 0};
      return Told::meet;
    }
    n = simplex.direction();
    c = next();
  }
  keep(found, simplex);
  found.direction = {0, 0, 0};
  return Told::unsure;
}

Told quickly_told_round(const QuickBody& a, const QuickBody& b, GjkCache& found, std::uint32_t& steps) {
  constexpr int most_rounds = 32;                                // a guess: whoever has not ended by then goes round
  constexpr double nearer = 1 - 0x1p-30, farther = 1 + 0x1p-30;  // guesses: beyond them a proof is likely
  const QuickHull &p = a.hull, &q = b.hull;
  const double square = (a.radius + b.radius) * (a.radius + b.radius);
  const auto& [x, y, z] = found.direction;
  const bool has_way = x != 0 || y != 0 || z != 0;
  GjkCorner last = are_corners(p, q, found.simplex) ? found.simplex.corners[0] : GjkCorner{0, 0};
  const auto next = [&](const Plain& n) {
    last = {p.farthest(n * -1, last[0]), q.farthest(n, last[1])};
    return Corner{last, p.at(last[0]) - q.at(last[1])};
  };
  constexpr std::uint32_t few = 8;  // a guess: of so few any corner is as good a start
  const bool is_any = !has_way && p.size() <= few && q.size() <= few;
  Plain n = has_way ? arith::vec<double>(found.direction) : is_any ? Plain{0, 0, 0} : p.middle() - q.middle();
  Corner c = is_any ? Corner{last, p.at(last[0]) - q.at(last[1])} : next(n);
  LongSimplex simplex({c.ends, c.at});
  const auto told = [&](bool is_far) {
    found.simplex = named_corners(simplex), found.direction = {n.x, n.y, n.z};
    if (is_far) return is_out_of_reach(a, b, n, c.ends, c.at) ? Told::apart : Told::unsure;
    found.direction = {0, 0, 0};
    return is_within_reach(a, b, simplex) ? Told::meet : Told::unsure;
  };
  for (int round = 0; round < most_rounds; ++round) {
    ++steps;
    const double along = dot(c.at, n);
    if (along > 0 && along * along > square * dot(n, n) * farther) return told(true);
    if (round > 0) {
      const double from = dot(n, n);
      const bool is_known = std::ranges::count(simplex.corners(), c.ends, &LongSimplex::Corner::ends) != 0;
      if (!(along < from) || is_known || simplex.is_full()) return told(from >= square && !simplex.is_full());
      simplex.add({c.ends, c.at});
    }
    n = simplex.nearest();
    if (dot(n, n) < square * nearer) return told(false);
    c = next(n);
  }
  found.simplex = named_corners(simplex), found.direction = {0, 0, 0};
  return Told::unsure;
}

}  // namespace plumb::query
