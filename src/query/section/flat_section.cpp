// What a plane cuts out of what is generated: generators in it, and where two on different sides meet it between them.
#include <algorithm>

#include "query/convex/flat_set.hpp"

namespace plumb::query {
namespace {

std::vector<mpq_class> heights(const std::vector<Exact3>& vectors, const Exact3& normal, const mpq_class& offset) {
  std::vector<mpq_class> h;
  for (const Exact3& v : vectors) h.emplace_back(dot(normal, v) - offset);
  return h;
}

/// Along a line of the set that crosses the plane, all of it can be moved there.
PlaneSection moved_along(const FlatSet& s, const Exact3& line, const Exact3& normal, const mpq_class& offset) {
  const mpq_class rise = dot(normal, line);
  const auto moved = [&](std::vector<Exact3> vectors, const mpq_class& to) {
    for (Exact3& v : vectors) v = v - mpq_class((dot(normal, v) - to) / rise) * line;
    return vectors;
  };
  PlaneSection all{{moved(s.points, offset), moved(s.directions, 0), moved(s.lines, 0)}, true};
  std::erase_if(all.set.directions, is_zero);
  std::erase_if(all.set.lines, is_zero);
  return all;
}

}  // namespace

PlaneSection section(const FlatSet& s, const Exact3& normal, const mpq_class& offset) {
  for (const Exact3& line : s.lines) {
    if (sgn(dot(normal, line)) != 0) return moved_along(s, line, normal, offset);
  }
  const auto at = heights(s.points, normal, offset), along = heights(s.directions, normal, 0);
  PlaneSection cut{{{}, {}, s.lines}, false};
  bool above = false, below = false;
  for (const auto* all : {&at, &along}) {
    for (const mpq_class& h : *all) {
      above = above || sgn(h) > 0;
      below = below || sgn(h) < 0;
    }
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (sgn(at[i]) == 0) cut.set.points.push_back(s.points[i]);
  }
  const auto add_between = [&](std::size_t i, std::size_t j) {
    if (sgn(at[i]) * sgn(at[j]) >= 0) return;
    cut.set.points.push_back(s.points[i] + mpq_class(at[i] / (at[i] - at[j])) * (s.points[j] - s.points[i]));
  };
  if (s.edges.empty()) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = i + 1; j < at.size(); ++j) add_between(i, j);
    }
  } else {
    for (const auto& [i, j] : s.edges) add_between(i, j);
  }
  for (std::size_t j = 0; j < along.size(); ++j) {
    if (sgn(along[j]) == 0) cut.set.directions.push_back(s.directions[j]);
    for (std::size_t i = 0; i < at.size(); ++i) {
      if (sgn(at[i]) * sgn(along[j]) < 0)
        cut.set.points.push_back(s.points[i] + mpq_class(-at[i] / along[j]) * s.directions[j]);
    }
    for (std::size_t k = j + 1; k < along.size(); ++k) {
      if (sgn(along[j]) * sgn(along[k]) < 0)
        cut.set.directions.push_back(abs(along[k]) * s.directions[j] + abs(along[j]) * s.directions[k]);
    }
  }
  if (cut.set.points.empty()) return {};
  cut.of_inside = above == below;  // on both sides, or all in the plane
  return cut;
}

}  // namespace plumb::query
