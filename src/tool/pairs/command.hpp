// `plumb pairs`: the broad phase on files: which of these boxes overlap, all pairs of one set or of two?
//
// Laws: (1) text, JSON and array hold the same pairs, in the order of the library's answer.  (2) Everything but the
// time depends on the boxes, --no-touching and the method alone, not on threads.  (3) Array and picture replace no
// file, unless that is asked for.  Exit code 0 when done, also where no two meet; files that cannot be read, boxes that
// are none, more pairs to keep than --most and outputs that cannot be written throw Error.  (4) Where no output has the
// pairs, they are counted as they come, and none is kept; methods that keep them all are not asked for more than --most.
// Source: RTCD 2.4.1, 7; plumb/space/broad_phase/overlapping_pairs.hpp.
// Cost: that of reading, which is most, and of the search; pairs are kept where an output has them.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "tool/pairs/box_input.hpp"
#include "tool/terminal/progress.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct PairsOptions {
  MeshArguments files;  // one or two
  bool no_touching = false;
  std::string method = "automatic";  // of method_names.hpp
  unsigned threads = 0;
  bool all = false;                           // list every pair
  bool count = false;                         // only count: no pair is kept, none is in the JSON
  std::uint64_t most = 100'000'000;           // pairs that are kept, for outputs or by the method
  std::optional<std::string> json, out, svg;  // "-" is standard output
  bool overwrite = false;                     // what --out and --svg name
};

int run_pairs(const PairsOptions& options);

/// How a box lies to others.
enum class Meets : std::uint8_t { none, touching, overlapping };

struct PairsReport {
  std::vector<BoxInput> sets;  // one or two
  bool touching = true;        // counts
  std::string method;
  std::uint64_t touch = 0, overlap = 0;  // pairs that do no more, and that do
  double search_ms = 0;
  std::optional<std::vector<BoxPair>> pairs;  // where they are kept
  std::vector<std::vector<Meets>> meets;      // of each box of each set, where a picture is asked for

  [[nodiscard]] bool of_one() const { return sets.size() == 1; }
  [[nodiscard]] bool is_planar() const { return sets.front().is_planar; }
  [[nodiscard]] Relation relation(const BoxPair& pair) const;
};

PairsReport pairs_report(const PairsOptions& options, std::vector<BoxInput> sets, Progress& bar);
/// Lists all pairs or none.
std::string pairs_text(const PairsReport& report, bool all, const Style& style);
nlohmann::json pairs_json(const PairsReport& report, bool with_pairs);
/// The boxes, and what the search divides them into; of many boxes some.
std::string pairs_svg(const PairsReport& report);

}  // namespace plumb::tool
