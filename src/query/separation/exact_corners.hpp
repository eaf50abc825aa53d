// Closest points of two hulls: the statement asked over one number type, and the exact search that goes on where it does not
// hold: GJK over numbers whose signs are certain.
//
// A turn keeps those corners that the nearest point of their hull needs, asks whether they are nearest of all, and adds what
// lies before the plane through that point.
// Laws: over numbers whose signs are all certain each turn ends strictly nearer than the one before, and a hull has finitely
// many corners, so that the search ends; over others it says nothing once a sign is not.
// Source: Wolfe 1976; Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// Cost: a turn up to 15 times that of query/separation/nearest_corners.hpp.
#pragma once

#include <bit>
#include <optional>

#include "arith/running_error.hpp"
#include "query/separation/proved_corners.hpp"

namespace plumb::query {

/// Those that are in one plane with the first by being in pairs: two differences that share a corner of one figure, and are
/// as near along the way, have corners of the other that are so too.
inline DifferenceCorners linked(const DifferenceCorners& corners) {
  DifferenceCorners known;
  std::array<bool, 4> is_known{};
  const auto take = [&](std::size_t i) { known.add(corners.ends[i]), is_known[i] = true; };
  const auto shares = [&](const std::array<std::uint32_t, 2>& ends) {
    for (std::size_t i = 0; i < known.size; ++i) {
      if (known.ends[i][0] == ends[0] || known.ends[i][1] == ends[1]) return true;
    }
    return false;
  };
  take(0);
  for (std::size_t before = 0; before != known.size && known.size < corners.size;) {
    before = known.size;
    for (std::size_t i = 1; i < corners.size; ++i) {
      if (!is_known[i] && shares(corners.ends[i])) take(i);
    }
  }
  return known;
}

template <class T>
Vec<T> turned_round(const Vec<T>& v) {
  const T zero(0.0);
  return Vec<T>{zero, zero, zero} - v;
}

/// Is it one pair, of m corners of a and n of b?  One corner by itself has but one partner; two edges that are not
/// parallel cross once.
inline bool is_one_pair(const ProvedCorners& p, std::size_t m, std::size_t n) {
  const bool a_ends = p.a.level == p.a.known, b_ends = p.b.level == p.b.known;
  return (m == 1 && a_ends) || (n == 1 && b_ends) || (m == 2 && n == 2 && p.corners.size == 3 && a_ends && b_ends);
}

/// Does it lead anywhere, for certain?
template <class T>
bool leads_somewhere(const Vec<T>& way) {
  const auto is_not_zero = [](const T& x) {
    CertainSigns ask;
    return ask(x) != Sign::zero && ask.certain();
  };
  return is_not_zero(way.x) || is_not_zero(way.y) || is_not_zero(way.z);
}

/// What the corners prove; nothing where a sign was not certain.  `holds`: that they are nearest.
struct Judged {
  bool holds = false;
  ProvedCorners proved;
};
template <class T>
std::optional<Judged> judged(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  CertainSigns ask;
  const NearestOfCorners<T> n = nearest_of<T>(a, b, corners, ask);
  Judged j{false, {corners, false, false, {}, {}}};
  if (!ask.certain()) return {};
  j.holds = is_within(n, corners.size, ask);
  if (!ask.certain()) return {};
  if (!j.holds) return j;
  j.proved.meets = corners.size == 4;
  if (!j.proved.meets && corners.size != 2 && certainly_zero(n.square)) j.proved.meets = true;
  if constexpr (!std::is_same_v<T, Running>) j.proved.meets = j.proved.meets || certainly_zero(n.square);
  if (j.proved.meets) return j;
  if (!leads_somewhere(n.way)) return {};  // of points and segments nothing else would ask
  const DifferenceCorners known = linked(corners);
  j.proved.a = support_of(a, named(known, 0).all(), n.way, ask);
  if (!ask.certain()) return {};
  j.proved.b = support_of(b, named(known, 1).all(), turned_round(n.way), ask);
  if (!ask.certain()) return {};
  j.holds = j.proved.a.holds && j.proved.b.holds;
  j.proved.is_alone = is_one_pair(j.proved, named(corners, 0).size, named(corners, 1).size);
  return j;
}

/// A corner that none is less than along the way, from one of them.
template <class T>
std::uint32_t least_corner(const CoreCorners& c, std::uint32_t from, const Vec<T>& way, CertainSigns& ask) {
  const auto is_less = [&](std::uint32_t i, std::uint32_t than) {
    return ask(dot(way, c.at<T>(i) - c.at<T>(than))) == Sign::negative;
  };
  if (c.polyhedron() != nullptr) {
    for (bool better = true; better && ask.certain();) {
      better = false;
      for (const std::uint32_t i : c.polyhedron()->neighbors_of(from)) {
        if (is_less(i, from)) from = i, better = true;
      }
    }
    return from;
  }
  for (std::size_t k = 0; k < c.ways(); ++k) {
    const Sign along = ask(dot(way, c.way<T>(k)));
    const std::uint32_t bit = 1u << k;
    if (along != Sign::zero) from = along == Sign::negative ? from | bit : from & ~bit;
  }
  for (std::uint32_t i = 0; c.ways() == 0 && i < c.size(); ++i) {
    if (i != from && is_less(i, from)) from = i;
  }
  return from;
}

/// Those of positive weight, where the nearest point of all corners' affine hull lies within their hull.
template <class T>
std::optional<DifferenceCorners> needed_of_all(const std::array<Vec<T>, 4>& at, const DifferenceCorners& all) {
  CertainSigns ask;
  const NearestOfCorners<T> n = nearest_of<T>(at, all.size, ask);
  if (!n.is_independent || !ask.certain()) return {};
  unsigned positive = 0;
  for (std::size_t i = 0; i < all.size; ++i) {
    const Sign s = all.size == 1 ? Sign::positive : ask(n.weight[i]);
    if (s == Sign::negative || !ask.certain()) return {};
    if (s == Sign::positive) positive |= 1u << i;
  }
  return all.part(positive);
}

/// Of up to four corners those that the nearest point of their hull needs; all where it is the origin.
template <class T>
std::optional<DifferenceCorners> needed(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& all) {
  const unsigned end = 1u << all.size;
  const std::array<Vec<T>, 4> at = differences_of<T>(a, b, all);
  if (const auto part = needed_of_all<T>(at, all)) return part;
  for (int size = 1; size <= static_cast<int>(all.size); ++size) {
    for (unsigned mask = 1; mask < end; ++mask) {
      if (std::popcount(mask) != size) continue;
      const DifferenceCorners part = all.part(mask);
      std::array<Vec<T>, 4> of_part;
      for (std::size_t i = 0, k = 0; i < all.size; ++i) {
        if ((mask >> i & 1) != 0) of_part[k++] = at[i];
      }
      CertainSigns ask;
      const NearestOfCorners<T> n = nearest_of<T>(of_part, part.size, ask);
      bool is_least = is_within(n, part.size, ask);
      const bool at_origin = size == 4 || certainly_zero(n.square);
      for (std::size_t i = 0; i < all.size && is_least && !at_origin; ++i) {
        if ((mask >> i & 1) == 0) is_least = ask(dot(n.way, at[i] - n.at[0])) != Sign::negative;
      }
      if (!ask.certain()) return {};
      if (is_least) return part;
    }
  }
  return {};
}

/// From corners that are near, which may be any; `see` is told those of each turn.  Nothing where a sign was not certain.
template <class T, class See>
std::optional<ProvedCorners> settled(const CoreCorners& a, const CoreCorners& b, DifferenceCorners corners,
                                     const See& see) {
  for (;;) {  // ends, for each turn ends nearer than the one before
    const auto part = needed<T>(a, b, corners);
    if (!part) return {};
    see(*part);
    const auto j = judged<T>(a, b, *part);
    if (!j) return {};
    if (j->holds) return j->proved;
    CertainSigns ask;
    const Vec<T> way = nearest_of<T>(a, b, *part, ask).way;
    corners = *part;
    corners.add(
        {least_corner(a, part->ends[0][0], way, ask), least_corner(b, part->ends[0][1], turned_round(way), ask)});
    if (!ask.certain()) return {};
  }
}

}  // namespace plumb::query
