#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "plumb/arith/error.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/space/kd_tree/point_range.hpp"
#include "space/bvh/parts.hpp"
#include "space/kd_tree/point_search.hpp"
#include "tool/nearest/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

constexpr std::uint64_t block = 1 << 14;  // queries between two looks at the progress, at the most

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Told when there is one too many: how many there are after all is known only at the end.
void require_room(const NearestReport& r, std::uint64_t more) {
  if (!r.keeps_all || r.answers + more <= r.most) return;
  throw Error(
      fmt::format("nearest: there are more than {} answers, {} at least, and so many are kept at the most; leave out "
                  "--all, --json, --out, --distances and --svg to count them all, or give a greater --most, for each "
                  "of which 16 bytes are kept",
                  grouped(r.most), grouped(r.answers + more)));
}

/// How many more are kept, of so many.
std::size_t kept_of(const NearestReport& r, std::size_t more) {
  return r.keeps_all ? more : std::min(more, NearestReport::listed - std::min(NearestReport::listed, r.found.size()));
}

/// The answers of one query more.
void append(NearestReport& r, std::span<const NearestPoint> answers) {
  const auto kept = answers.first(kept_of(r, answers.size()));
  r.found.insert(r.found.end(), kept.begin(), kept.end());
  r.first.push_back(r.found.size());
  r.answers += answers.size();
}

/// How many queries are answered at once: of what is not known beforehand few at first, then so that their answers,
/// if they are as many as those before, take little memory.
std::size_t queries_at_once(const NearestReport& r, std::size_t answered) {
  constexpr std::uint64_t most_answers = 1 << 22, at_first = 16;
  const bool is_known = r.is_even() || (r.ties && !r.keeps_all && r.found.size() >= NearestReport::listed);
  if (!is_known && answered == 0) return at_first;
  const std::uint64_t each = is_known ? *r.k : r.answers / answered + 1;
  return std::clamp<std::uint64_t>(most_answers / each, is_known ? 1 : at_first, block);
}

/// k of each.
template <class Point>
void append_nearest(const KdTree<Point>& tree, std::span<const Point> queries, NearestReport& report) {
  const std::size_t k = *report.k;
  require_room(report, queries.size() * k);
  std::vector<NearestPoint> found(queries.size() * k);
  nearest(tree, queries, k, std::span(found));
  for (std::size_t i = 0; i < queries.size(); ++i) append(report, std::span(found).subspan(i * k, k));
}

/// Those that are as near as the last of these as well.
template <class Point>
void append_with_ties(const KdTree<Point>& tree, std::span<const Point> points, std::span<const Point> queries,
                      NearestReport& report) {
  const std::size_t k = *report.k;
  std::vector<std::vector<NearestPoint>> lists(queries.size());
  std::vector<std::size_t> more(queries.size());  // than are in the list
  const bool counts = !report.keeps_all && report.found.size() >= NearestReport::listed;
  space::for_blocks(Execution::parallel, queries.size(), 64, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      lists[i] = nearest(tree, queries[i], k, counts ? Ties::lowest : Ties::all);
      if (counts)
        more[i] = space::kd::count_ties_above(tree, queries[i], points[lists[i].back().index], lists[i].back().index);
    }
  });
  for (std::size_t i = 0; i < queries.size(); ++i) {
    report.tied += lists[i].size() + more[i] > k ? 1 : 0;
    require_room(report, lists[i].size());
    append(report, lists[i]);
    report.answers += more[i];
  }
}

template <class Point>
void append_within(const KdTree<Point>& tree, std::span<const Point> points, std::span<const Point> queries,
                   NearestReport& report) {
  const PointLists lists = within(tree, queries, *report.radius);
  require_room(report, lists.numbers.size());
  const std::size_t before = report.found.size(), kept = kept_of(report, lists.numbers.size());
  report.found.resize(before + kept);
  for (std::size_t i = 1; i < lists.first.size(); ++i)
    report.first.push_back(before + std::min<std::size_t>(lists.first[i], kept));
  space::for_blocks(Execution::parallel, queries.size(), 64, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      std::size_t at = before + lists.first[i];
      for (const std::uint32_t number : lists[i]) {
        if (at >= report.found.size()) break;
        // The search has compared; a distance is computed where it is told.
        const bool is_told = report.keeps_distances || at < NearestReport::listed;
        report.found[at++] = {number, is_told ? distance(queries[i], points[number]) : 0};
      }
    }
  });
  report.answers += lists.numbers.size();
}

template <class Point>
void search_among(std::span<const Point> points, std::span<const Point> queries, NearestReport& report, Progress& bar) {
  auto start = std::chrono::steady_clock::now();
  const KdTree<Point> tree = build_kd_tree(points);
  report.build_ms = milliseconds_since(start);
  report.levels = tree.levels;
  start = std::chrono::steady_clock::now();
  for (std::size_t from = 0, end = 0; from < queries.size(); from = end) {
    end = std::min(queries.size(), from + queries_at_once(report, from));
    const std::span<const Point> now = queries.subspan(from, end - from);
    if (report.radius) {
      append_within(tree, points, now, report);
    } else if (report.ties) {
      append_with_ties(tree, points, now, report);
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
