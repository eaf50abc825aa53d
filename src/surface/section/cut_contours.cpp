#include "surface/section/cut_contours.hpp"

#include <algorithm>

namespace plumb::surface {
namespace {

constexpr std::uint32_t none = ~0U;

/// A segment that ends or begins in the corner, by its other end.
struct Spoke {
  std::uint32_t segment, other;
  bool ends;
};

/// Counterclockwise, from the direction of the first coordinate on.
void sort_around(std::uint32_t center, std::vector<Spoke>& spokes, const CutCorners& corners) {
  const auto lower_half = [&](std::uint32_t c) {
    const Sign v = corners.compare(c, center, 1);
    return v == Sign::negative || (v == Sign::zero && corners.compare(c, center, 0) == Sign::negative);
  };
  std::vector<std::pair<bool, Spoke>> halved;
  for (const Spoke& s : spokes) halved.emplace_back(lower_half(s.other), s);
  std::stable_sort(halved.begin(), halved.end(), [&](const auto& a, const auto& b) {
    if (a.first != b.first) return b.first;
    return a.second.other != b.second.other && corners.turn(center, a.second.other, b.second.other) == Sign::positive;
  });
  for (std::size_t i = 0; i < spokes.size(); ++i) spokes[i] = halved[i].second;
}

/// The solid lies clockwise of a segment that ends here and counterclockwise of one that begins: each is joined to the
/// next one clockwise that begins, as parentheses are.
void join_around(const std::vector<Spoke>& spokes, std::vector<std::uint32_t>& next) {
  std::vector<std::uint32_t> open;
  std::vector<bool> used(spokes.size());
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = spokes.size(); i-- > 0;) {
      if (spokes[i].ends && round == 0) {
        open.push_back(spokes[i].segment);
      } else if (!spokes[i].ends && !used[i] && !open.empty()) {
        next[open.back()] = spokes[i].segment;
        open.pop_back();
        used[i] = true;
      }
    }
  }
}

/// The segment after each, or none.
std::vector<std::uint32_t> successors(const CutSegments& cut, const CutCorners& corners, std::uint64_t& touching) {
  const std::size_t n = cut.segments.size();
  std::vector<std::uint32_t> first(cut.corners.size() + 1);
  for (const auto& s : cut.segments) ++first[s[0]], ++first[s[1]];
  std::uint32_t sum = 0;
  for (std::uint32_t& f : first) f = sum += f;  // where those of a corner end, and, filled from there, begin
  std::vector<Spoke> spokes(2 * n);
  for (std::size_t i = n; i-- > 0;) {
    const auto [from, to] = cut.segments[i];
    const auto segment = static_cast<std::uint32_t>(i);
    spokes[--first[from]] = {segment, to, false};
    spokes[--first[to]] = {segment, from, true};
  }
  std::vector<std::uint32_t> next(n, none);
  std::vector<Spoke> here;
  for (std::uint32_t c = 0; c + 1 < first.size(); ++c) {
    here.assign(spokes.begin() + first[c], spokes.begin() + first[c + 1]);
    if (here.size() > 2) {
      ++touching;
      sort_around(c, here, corners);
    }
    join_around(here, next);
  }
  return next;
}

}  // namespace

std::vector<CutContour> join_segments(const CutSegments& cut, const CutCorners& corners, std::uint64_t& touching) {
  const std::vector<std::uint32_t> next = successors(cut, corners, touching);
  std::vector<CutContour> contours;
  std::vector<bool> done(next.size()), has_previous(next.size());
  std::vector<std::uint32_t> place(cut.corners.size(), none);  // in the path
  for (const std::uint32_t s : next) {
    if (s != none) has_previous[s] = true;
  }
  std::vector<std::uint32_t> path;
  const auto go = [&](std::uint32_t corner) {
    if (const std::uint32_t at = place[corner]; at != none) {  // been here: a contour is complete
      contours.push_back({{path.begin() + at, path.end()}, true});
      for (std::size_t i = at; i < path.size(); ++i) place[path[i]] = none;
      path.resize(at);
    }
    place[corner] = static_cast<std::uint32_t>(path.size());
    path.push_back(corner);
  };
  const auto follow = [&](std::uint32_t start) {
    path.clear();
    go(cut.segments[start][0]);
    for (std::uint32_t s = start; s != none && !done[s]; s = next[s]) {
      done[s] = true;
      go(cut.segments[s][1]);
    }
    for (const std::uint32_t corner : path) place[corner] = none;
    if (path.size() > 1) contours.push_back({path, false});
  };
  for (std::uint32_t s = 0; s < next.size(); ++s) {  // chains, from where they begin
    if (!has_previous[s]) follow(s);
  }
  for (std::uint32_t s = 0; s < next.size(); ++s) {
    if (!done[s]) follow(s);
  }
  return contours;
}

}  // namespace plumb::surface
