#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>

#include "plumb/query/closest/closest.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "tool/nearest/command.hpp"

namespace plumb::tool {
namespace {

constexpr std::size_t block = 1 << 14;  // queries between two looks at the progress

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// k of each.
template <class Point>
void append_nearest(const KdTree<Point>& tree, std::span<const Point> queries, NearestReport& report) {
  const std::size_t before = report.found.size();
  report.found.resize(before + queries.size() * *report.k);
  nearest(tree, queries, *report.k, std::span(report.found).subspan(before));
  for (std::size_t i = 1; i <= queries.size(); ++i) report.first.push_back(before + i * *report.k);
}

/// Those that are as near as the last of these as well.
template <class Point>
void append_with_ties(const KdTree<Point>& tree, std::span<const Point> queries, NearestReport& report) {
  std::vector<std::vector<NearestPoint>> lists(queries.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, queries.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      lists[i] = nearest(tree, queries[i], *report.k, Ties::all);
  });
  for (const std::vector<NearestPoint>& list : lists) {
    report.tied += list.size() > *report.k ? 1 : 0;
    report.found.insert(report.found.end(), list.begin(), list.end());
    report.first.push_back(report.found.size());
  }
}

template <class Point>
void append_within(const KdTree<Point>& tree, std::span<const Point> points, std::span<const Point> queries,
                   NearestReport& report) {
  const PointLists lists = within(tree, queries, *report.radius);
  const std::size_t before = report.found.size();
  report.found.resize(before + lists.numbers.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, queries.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      std::size_t at = before + lists.first[i];
      for (const std::uint32_t number : lists[i]) report.found[at++] = {number, distance(queries[i], points[number])};
    }
  });
  for (std::size_t i = 1; i < lists.first.size(); ++i) report.first.push_back(before + lists.first[i]);
}

template <class Point>
void search_among(std::span<const Point> points, std::span<const Point> queries, NearestReport& report, Progress& bar) {
  auto start = std::chrono::steady_clock::now();
  const KdTree<Point> tree = build_kd_tree(points);
  report.build_ms = milliseconds_since(start);
  report.levels = tree.levels;
  start = std::chrono::steady_clock::now();
  for (std::size_t from = 0; from < queries.size(); from += block) {
    const std::span<const Point> now = queries.subspan(from, std::min(block, queries.size() - from));
    if (report.radius) {
      append_within(tree, points, now, report);
    } else if (report.ties) {
      append_with_ties(tree, now, report);
    } else {
      append_nearest(tree, now, report);
    }
    bar.advance(now.size());
  }
  report.search_ms = milliseconds_since(start);
}

}  // namespace

void search_nearest(NearestReport& r, Progress& bar) {
  if (r.is_planar()) {
    search_among<Point2>(r.points.plane, r.queries.plane, r, bar);
  } else {
    search_among<Point3>(r.points.space, r.queries.space, r, bar);
  }
}

}  // namespace plumb::tool
