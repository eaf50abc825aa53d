#include "tool/pairs/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "tool/pairs/method_names.hpp"
#include "tool/rows/npy.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

void require_sound(const PairsOptions& o) {
  if (o.files.words.empty() || o.files.words.size() > 2)
    throw Error("pairs: one file of boxes is needed, or two; 'plumb pairs --help' explains");
  require_input_once(o.files.words);
  if (o.count && (o.all || o.out))
    throw Error(fmt::format("pairs: --count and {} exclude each other: one only counts, the other needs the pairs",
                            o.all ? "--all" : "--out"));
}

/// Told when there is one too many: how many there are after all is known only at the end.
[[noreturn]] void refuse_more(const PairsOptions& o, std::uint64_t at_least, bool for_outputs) {
  if (!for_outputs)
    throw Error(fmt::format(
        "pairs: there are more than {} pairs, {} at least, and the method {} keeps all that it finds, so many "
        "at the most; leave out --method to count any number, or give a greater --most, for each of which "
        "8 bytes are kept",
        grouped(o.most), grouped(at_least), o.method));
  throw Error(
      fmt::format("pairs: there are more than {} pairs, {} at least, and so many are kept at the most; leave out "
                  "--all and --out, and give --count for --json, to count them all, or give a greater --most, for "
                  "each of which 8 bytes are kept",
                  grouped(o.most), grouped(at_least)));
}

/// Does the search itself keep every pair, before it tells any?
bool keeps_all(BroadPhaseMethod method) { return method > BroadPhaseMethod::brute_force; }

void require_one_space(const std::vector<BoxInput>& sets) {
  if (sets.front().is_planar == sets.back().is_planar) return;
  const auto where = [](const BoxInput& set) { return set.is_planar ? "in the plane" : "in space"; };
  throw Error(fmt::format("pairs: the boxes of {} lie {}, those of {} {}; both must lie in one", sets[0].name,
                          where(sets[0]), sets[1].name, where(sets[1])));
}

const std::vector<Aabb2>& boxes_of(const BoxInput& set, const Aabb2*) { return set.plane; }
const std::vector<Aabb3>& boxes_of(const BoxInput& set, const Aabb3*) { return set.space; }

/// take(block) for the pairs, block by block.
template <class Box, class Take>
void search(const PairsReport& report, const BroadPhaseOptions& asked, Take& take) {
  constexpr const Box* kind = nullptr;
  const std::vector<Box>& a = boxes_of(report.sets.front(), kind);
  if (report.of_one()) return overlapping_pairs(a, BoxPairSink(take), asked);
  overlapping_pairs(a, boxes_of(report.sets.back(), kind), BoxPairSink(take), asked);
}

/// By the quickest search, which keeps none and is left as soon as there are too many.
void require_no_more(const PairsOptions& options, const PairsReport& report, Progress& bar) {
  bar.note("counting the pairs");
  std::uint64_t pairs = 0;
  auto count = [&](std::span<const BoxPair> found) {
    pairs += found.size();
    if (pairs > options.most) refuse_more(options, pairs, report.pairs.has_value());
  };
  const BroadPhaseOptions asked{.touching = report.touching};
  report.is_planar() ? search<Aabb2>(report, asked, count) : search<Aabb3>(report, asked, count);
}

std::string array_of(const std::vector<BoxPair>& pairs) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(2 * pairs.size());
  for (const BoxPair& p : pairs) numbers.push_back(p.a), numbers.push_back(p.b);
  return npy_of(numbers, std::array<std::size_t, 2>{pairs.size(), 2});
}

}  // namespace

Relation PairsReport::relation(const BoxPair& pair) const {
  const BoxInput &a = sets.front(), &b = sets.back();
  return is_planar() ? relate(a.plane[pair.a], b.plane[pair.b]) : relate(a.space[pair.a], b.space[pair.b]);
}

PairsReport pairs_report(const PairsOptions& options, std::vector<BoxInput> sets, Progress& bar) {
  PairsReport report;
  report.sets = std::move(sets);
  report.touching = !options.no_touching;
  report.method = options.method;
  if (options.all || options.out || (options.json && !options.count)) report.pairs.emplace();
  if (options.svg) {
    for (const BoxInput& set : report.sets) report.meets.emplace_back(set.size(), Meets::none);
  }
  const auto raise = [](Meets& now, Meets to) { now = std::max(now, to); };
  auto take = [&](std::span<const BoxPair> block) {
    std::uint64_t overlap = 0;
    for (const BoxPair& p : block) {
      const bool overlaps = report.relation(p) == Relation::overlapping;
      overlap += overlaps ? 1 : 0;
      if (report.meets.empty()) continue;
      raise(report.meets.front()[p.a], overlaps ? Meets::overlapping : Meets::touching);
      raise(report.meets.back()[p.b], overlaps ? Meets::overlapping : Meets::touching);
    }
    report.overlap += overlap;
    report.touch += block.size() - overlap;
    if (report.pairs && report.pairs->size() + block.size() > options.most)
      refuse_more(options, report.touch + report.overlap, true);
    if (report.pairs) report.pairs->insert(report.pairs->end(), block.begin(), block.end());
    if (bar.shown()) bar.note(plural(report.touch + report.overlap, "pair", "pairs"));
  };
  const BroadPhaseOptions asked{.touching = report.touching, .method = broad_phase_method(options.method)};
  if (keeps_all(asked.method)) require_no_more(options, report, bar);
  const auto start = std::chrono::steady_clock::now();
  if (report.is_planar()) {
    search<Aabb2>(report, asked, take);
  } else {
    search<Aabb3>(report, asked, take);
  }
  report.search_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return report;
}

int run_pairs(const PairsOptions& options) {
  OutputFiles outputs(options.files.words);
  require_no_table_name("--json", options.json);
  outputs.promise("--json", options.json);
  outputs.promise_unless_there("--out", options.out, options.overwrite);
  outputs.promise_unless_there("--svg", options.svg, options.overwrite);
  require_sound(options);
  const ThreadLimit limit(options.threads);
  Progress bar("pairs", options.files.words.size() + 2);  // what is read, the search, what is written
  std::vector<BoxInput> sets;
  for (const std::string& file : options.files.words) {
    bar.note("reading " + printable(name_of_input(file)));
    sets.push_back(read_boxes(file, options.files.reading(), outputs));
    bar.advance();
  }
  require_one_space(sets);
  const PairsReport report = pairs_report(options, std::move(sets), bar);
  bar.advance();
  if (options.json) outputs.write("--json", json_text(pairs_json(report, !options.count)));
  if (options.out) outputs.write("--out", array_of(*report.pairs));
  if (options.svg) outputs.write("--svg", pairs_svg(report));
  bar.erase();
  if (!outputs.on_standard_output()) say(pairs_text(report, options.all, Style(stdout)));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
