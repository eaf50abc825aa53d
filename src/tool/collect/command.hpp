// `plumb collect`: what was found of a corpus, of all of its shards, and which models are the worst?
//
// Laws: (1) text, JSON, CSV and page tell the same of the same lines (shard_file.hpp).  (2) The digest is one of what was
// found of each model, in the order of their names: it depends neither on how many shards there were nor on when and
// where they ran, and not on what was measured or said in words.  (3) A model that two shards tell of is an Error, and so
// are shards of several corpora, commands or settings.  (4) A shard that is missing or not at its end is told by its
// number, the others are collected, and the exit status is 1.
// Source: none.
// Cost: the files are read once; 40 us and 2.6 KB a model where one shard has a million.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct CollectArguments {
  std::vector<std::string> folders;            // one
  std::optional<std::string> json, csv, page;  // "-" is standard output
  std::size_t worst = 20;
};

int run_collect(const CollectArguments& options);

struct CollectedModel {
  std::string name, verdict, why;
  std::vector<std::string> defects;
  std::string faults;  // in words
  std::uint64_t fault_count = 0;
  std::optional<std::uint64_t> triangles;
  double milliseconds = 0, peak_mib = 0;
};

struct Collection {
  std::string command, corpus;
  std::uint32_t shards = 0;
  std::vector<std::uint32_t> unfinished;
  std::vector<CollectedModel> models;                    // by their names
  std::vector<std::size_t> worst;                        // all that are not well, the worst first
  std::map<std::string, std::size_t> verdicts, defects;  // how many models
  std::uint64_t triangles = 0, digest = 0;
  double milliseconds = 0, peak_mib = 0;  // of all, and the most
};

/// Throws Error where it holds no shard, or some that do not belong together.
Collection collect(const std::filesystem::path& folder);

std::string collection_text(const Collection& all, std::size_t worst, const Style& style);
std::string collection_csv(const Collection& all);
/// Without the models where there are too many for a page.
nlohmann::json collection_json(const Collection& all, bool with_models);
std::string collection_page(const Collection& all);

/// The page tells of so many models.
inline constexpr std::size_t most_on_page = 1000;

}  // namespace plumb::tool
