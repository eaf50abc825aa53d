// Which models of this shard are done, and what was found?  A file of lines of JSON in the folder of the results, which
// a run that was stopped in any way goes on with.
//
// The first line says what the shard is of (ShardTitle), one follows for each model in whatever order, and where all are
// done a last one, {"done": how many}.
// Laws: (1) a line is there whole or not at all: what a run that was killed left of a line is cut off.  (2) One run at a
// time has the file: another waits for it, and then finds its lines.  (3) A file that is there and was not begun for the
// same shard, settings and version is refused, and so is a folder with shards of another count; nothing is replaced.
// Source: flock(2).
// Cost: the file is read once; a write a line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tool/corpus/shard.hpp"

namespace plumb::tool {

struct ShardTitle {
  std::string command;  // "check"
  std::string corpus;   // the folder's own name
  Shard shard;
  nlohmann::json settings;  // what findings depend on

  [[nodiscard]] std::string line() const;
};

/// "check.3-of-10.jsonl"
std::string shard_file_name(const std::string& command, const Shard& shard);

/// The files of shards in a folder.
struct FoundShard {
  std::filesystem::path path;
  std::string command;
  Shard shard;
};
std::vector<FoundShard> shard_files(const std::filesystem::path& folder);

/// A file's lines; throws Error.
struct ShardLines {
  nlohmann::json title;
  std::vector<nlohmann::json> models;
  bool whole = false;          // its last line is that of the end
  std::uint64_t complete = 0;  // bytes up to the last line break
};
ShardLines read_shard(const std::filesystem::path& path);

class ShardFile {
 public:
  /// The folder is made where it is missing; throws Error.
  ShardFile(const std::filesystem::path& folder, const ShardTitle& title);
  ShardFile(const ShardFile&) = delete;
  ShardFile& operator=(const ShardFile&) = delete;
  ~ShardFile();

  /// Each model has its verdict.
  [[nodiscard]] const std::map<std::string, std::string>& done() const { return done_; }
  void add(const nlohmann::json& model);
  /// All are done.
  void end();

 private:
  void append(const std::string& line);

  std::filesystem::path path_;
  int file_ = -1;
  std::map<std::string, std::string> done_;
  bool whole_ = false;
};

}  // namespace plumb::tool
