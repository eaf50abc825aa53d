// A search in doubles, which is a guess, and its proof.
#include "query/gjk/quick_meeting.hpp"

#include <algorithm>

#include "arith/running_error.hpp"
#include "figure/support/gjk_simplex.hpp"
#include "query/gjk/directed.hpp"
#include "query/gjk/origin.hpp"

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
bool is_beyond_plane(const CoreCorners& c, std::uint32_t from, const Plain& along, const RunningVec& m, Sign side) {
  const RunningVec n = arith::vec<Running>(along), first = c.at<Running>(from);
  if (certain(dot(n, first - m)) != side) return false;
  const auto is_beyond = [&](std::uint32_t i) { return certain(dot(n, c.at<Running>(i) - m)) == side; };
  if (c.polyhedron() != nullptr) {
    return is_polyhedron_beyond(
        *c.polyhedron(), from, [&](std::uint32_t i) { return certain(dot(n, c.at<Running>(i) - first)) == side; },
        is_beyond);
  }
  for (std::uint32_t i = 0; i < c.size(); ++i) {
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

/// Is all of a strictly farther along than all of b, both as given and of few corners?
bool are_few_apart(const QuickHull& a, const QuickHull& b, const Plain& n, const GjkCorner& ends, const Plain& gap) {
  const Plain middle = b.at(ends[1]) + gap * 0.5;
  const Point3 m{middle.x, middle.y, middle.z};
  return are_all_on_side<1>(a, n, m) && are_all_on_side<-1>(b, n, m);
}

/// Is all of a strictly farther along than all of b, which these corners are likely nearest to?
bool is_apart(const QuickBody& a, const QuickBody& b, const Plain& n, const GjkCorner& ends, const Plain& gap) {
  if (are_few(a.hull, b.hull)) return are_few_apart(a.hull, b.hull, n, ends, gap);
  if (a.hull.solid() != nullptr && b.hull.solid() != nullptr && a.hull.is_given() && b.hull.is_given()) {
    if (ahead(n, a.hull.given(ends[0]), b.hull.given(ends[1])) != Sign::positive) return false;
    if (is_least(a.hull, ends[0], n) && is_least(b.hull, ends[1], n * -1)) return true;
  }
  const Plain middle = b.hull.at(ends[1]) + gap * 0.5;
  const Point3 m{middle.x, middle.y, middle.z};
  const auto beyond = [&](const QuickBody& body, std::uint32_t from, Sign side) {
    return body.hull.is_given() ? is_beyond_plane(body.hull, from, n, m, side)
                                : is_beyond_plane(body.corners(), from, n, arith::vec<Running>(m), side);
  };
  return beyond(a, ends[0], Sign::positive) && beyond(b, ends[1], Sign::negative);
}

bool is_around(const QuickBody& a, const QuickBody& b, const std::array<GjkCorner, 4>& corners) {
  if (a.hull.is_given() && b.hull.is_given()) return are_around_origin(a.hull, b.hull, corners);
  const CoreCorners p = a.corners(), q = b.corners();
  std::array<RunningVec, 4> at;
  for (std::size_t i = 0; i < 4; ++i) at[i] = p.at<Running>(corners[i][0]) - q.at<Running>(corners[i][1]);
  return figure::gjk::is_around_origin(
      [&](std::size_t i, std::size_t j, std::size_t k) { return certain(dot(at[i], cross(at[j], at[k]))); });
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
    if (dot(gap, n) > 0 && are_few_apart(p, q, n, last, gap)) {
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

}  // namespace plumb::query
