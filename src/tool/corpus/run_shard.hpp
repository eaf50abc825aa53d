// What is found of each model of a corpus, of one of its shards, by one process a model?  A line each, in a file of the
// shard's own (shard_file.hpp).
//
// Laws: (1) every model of the shard has one line in the end, whatever it does to the process that looks at it, and in
// however many runs.  (2) But for "measured" and "why" a line depends on the model and the settings alone.  (3) Verdicts
// are those of the work, "unreadable" where the model cannot be read, "timeout", "out_of_memory", "crashed".
// Source: none.
// Cost: that of the work, a process each, and a look at each name in the folder.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "tool/corpus/limited_process.hpp"
#include "tool/mesh/inputs.hpp"

namespace plumb::tool {

/// They stand as they were given.
struct ShardOptions {
  std::optional<std::string> shard, folder;  // "3/10", and where the lines go
  std::optional<double> seconds;
  std::optional<std::uint64_t> mib;

  /// Is a shard asked for?  Throws Error where only some of the options are given that go together.
  [[nodiscard]] bool asked() const;
  [[nodiscard]] ProcessLimits limits() const { return {seconds, mib}; }
};

/// --shard, --out, --time-limit, --memory-limit.
void add_shard(CLI::App* parser, ShardOptions& options);

/// Throws Error where one of these that do not go with --shard is given.
void require_none_with_shard(std::initializer_list<std::pair<std::string_view, bool>> given);

struct ShardWork {
  std::string command;
  nlohmann::json settings;  // what findings depend on, but for limits and strictness
  /// "verdict" and what else was found of the mesh; what it throws, an Error, says why it is unreadable.
  std::function<nlohmann::json(const std::string& file)> find;
};

/// Says how many models have which verdict, and returns 0.  Throws Error where the argument is no folder of meshes.
int run_shard(const MeshArguments& meshes, const ShardOptions& options, const ShardWork& work);

}  // namespace plumb::tool
