// `plumb clash`: which parts of an assembly touch, overlap, pierce or enclose one another, or come too near?
//
// Laws: (1) a part is what plumb/surface/file/read_assembly.hpp says of its file; parts of one name are told apart by
// numbers (bolt, bolt#2), in their order.  (2) The words are those of plumb/world/clash.hpp; rules and --ignore say which
// are left out, and they are counted.  (3) Text, JSON, CSV, BCF and the page tell the same; text names the first clashes,
// or all.  (4) A part or file that cannot be read is told by its name, all others are asked, and the report is kept; but
// where a file that was named cannot be read at all, nothing is kept.
// Exit code 0 when done, 1 where --fail-on-found is given and a clash is listed, 2 where anything cannot be read; words
// that cannot be read and an output that cannot be written throw Error.
// Source: plumb/world/clashes.hpp.
// Cost: that of reading, and of find_clashes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "plumb/world/clashes.hpp"
#include "tool/corpus/run_shard.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct ClashArguments {
  MeshArguments meshes;
  std::optional<double> clearance;
  std::vector<std::string> rules;   // as rules.hpp has them
  std::vector<std::string> ignore;  // of clash_words()
  bool all = false, fail_on_found = false;
  bool unmeasured = false;                          // without volumes and depths
  std::optional<std::string> json, csv, bcf, page;  // "-" is standard output
  bool overwrite = false;                           // of the page
  unsigned threads = 0;
  ShardOptions shard;  // else one assembly of all meshes
};

int run_clash(const ClashArguments& options);

struct AssemblyMember {
  std::string name, file;
  std::size_t vertices = 0, triangles = 0;
  bool closed = false;
  double size = 0;  // the longest edge of its box, rounded, for pictures
};

struct ClashReport {
  std::vector<AssemblyMember> parts;
  std::vector<UnreadMesh> unread;
  std::vector<std::string> passed_over;
  std::optional<double> clearance;
  bool measured = true;            // volumes and depths were asked for
  std::vector<PartClash> clashes;  // that are listed
  std::size_t asked = 0, answered = 0;
  std::vector<std::size_t> counts;           // of each word, of those listed
  std::size_t ignored = 0;                   // not listed
  static constexpr std::size_t listed = 20;  // in text
  static constexpr std::size_t told = 100;   // triangles that meet, of a clash in JSON
};

/// One clash, and how many of what: no line ends.
std::string clash_line(const ClashReport& report, const PartClash& pair, const Style& style);
std::string clash_count(const ClashReport& report);
std::string clash_text(const ClashReport& report, bool all, const Style& style);
nlohmann::json clash_json(const ClashReport& report);
std::string clash_csv(const ClashReport& report);

}  // namespace plumb::tool
