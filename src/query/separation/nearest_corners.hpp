// Closest points of two hulls: are these a few corners between whose hulls the least way is?  A statement over any number
// type, and the search that it ends.
//
// A corner of the difference is one of the first hull less one of the second.  Of up to three independent ones the point
// nearest to the origin, in their affine hull, is `way` over something above zero.  It is nearest of all where it is
// within their hull, and no corner of either figure lies before the plane through it: four more signs a corner, of boxes
// one a way.  Four corners around the origin prove that the figures meet.
// Laws: over a number type whose signs are not certain the question says so, and the answer means nothing.
// Source: Wolfe 1976; Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// Cost: some 60 operations, and 5 a corner or way.
#pragma once

#include <algorithm>
#include <bit>

#include "arith/nearest_of_corners.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query {

using arith::is_within, arith::nearest_of, arith::NearestOfCorners, arith::no_way, arith::Sought, arith::Vec;

/// Up to four corners of the difference, by the numbers of theirs.
struct DifferenceCorners {
  using Ends = std::array<std::uint32_t, 2>;
  std::array<Ends, 4> ends{};
  std::size_t size = 0;

  void add(const Ends& e) { ends[size++] = e; }
  [[nodiscard]] DifferenceCorners part(unsigned mask) const {
    DifferenceCorners r;
    for (std::size_t i = 0; i < size; ++i) {
      if ((mask >> i & 1) != 0) r.add(ends[i]);
    }
    return r;
  }
};

template <class T>
Vec<T> difference_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners::Ends& e) {
  return a.at<T>(e[0]) - b.at<T>(e[1]);
}

template <class T>
std::array<Vec<T>, 4> differences_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners) {
  std::array<Vec<T>, 4> at{no_way<T>(), no_way<T>(), no_way<T>(), no_way<T>()};
  for (std::size_t i = 0; i < corners.size; ++i) at[i] = difference_of<T>(a, b, corners.ends[i]);
  return at;
}
template <class T, Sought sought = Sought::all>
NearestOfCorners<T> nearest_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners,
                               CertainSigns& ask) {
  return nearest_of<T, sought>(differences_of<T>(a, b, corners), corners.size, ask);
}

/// Which corners of a figure lie before, and which in the plane through corner `ref` at right angles to `way`?
struct Support {
  bool holds = true;  // none lies before it
  std::uint64_t level =
      0;  // in it: bits of corners, of a figure with ways of these; of a polyhedron or a list bit 0 for any other
  std::uint64_t known = 0;  // of those, the ones that were known to be
};

/// The bits of `level` that the corners named have by themselves.
inline std::uint64_t level_of(const CoreCorners& c, std::span<const std::uint32_t> named) {
  std::uint64_t level = 0;
  for (const std::uint32_t i : named) {
    if (c.polyhedron() != nullptr || c.is_listed()) continue;
    if (c.ways() == 0) level |= std::uint64_t{1} << i;
    for (const std::uint32_t j : named) {  // of ways those that lead from one of them to another
      if (c.ways() > 0 && std::has_single_bit(i ^ j)) level |= i ^ j;
    }
  }
  return level;
}

/// `named`: corners that are known to lie in the plane; the first is the one that it goes through.
template <class T>
Support support_of(const CoreCorners& c, std::span<const std::uint32_t> named, const Vec<T>& way, CertainSigns& ask) {
  const std::size_t ref = named[0];
  Support s{true, 0, level_of(c, named)};
  s.level = s.known;
  const auto judge = [&](Sign ahead, std::uint64_t bit) {
    if (ahead == Sign::negative) s.holds = false;
    if (ahead == Sign::zero) s.level |= bit;
  };
  if (c.polyhedron() != nullptr) {
    const Vec<T> from = c.at<T>(ref);
    for (const std::uint32_t i : c.polyhedron()->neighbors_of(ref)) {
      if (std::ranges::find(named, i) == named.end()) judge(ask(dot(way, c.at<T>(i) - from)), 1);
      if (!s.holds) break;
    }
    return s;
  }
  if (c.is_listed()) {
    const Vec<T> from = c.at<T>(ref);
    for (std::uint32_t i = 0; i < c.size() && s.holds; ++i) {
      if (std::ranges::find(named, i) == named.end()) judge(ask(dot(way, c.at<T>(i) - from)), 1);
    }
    return s;
  }
  for (std::size_t k = 0; k < c.ways(); ++k) {
    const std::uint64_t bit = std::uint64_t{1} << k;
    if ((s.known & bit) != 0) continue;
    if (!c.has_length(k)) {
      s.level |= bit;
    } else {
      const Sign along = ask(dot(way, c.way<T>(k)));
      judge((ref & bit) != 0 ? -along : along, bit);
    }
  }
  if (c.ways() > 0) return s;
  const Vec<T> from = c.at<T>(ref);
  for (std::size_t i = 0; i < c.size(); ++i) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    if ((s.known & bit) == 0) judge(ask(dot(way, c.at<T>(i) - from)), bit);
  }
  return s;
}

}  // namespace plumb::query
