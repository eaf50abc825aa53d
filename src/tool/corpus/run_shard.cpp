#include "tool/corpus/run_shard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "plumb/arith/error.hpp"
#include "tool/corpus/shard_file.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/progress.hpp"
#include "tool/terminal/terminal.hpp"
#include "tool/terminal/utf8.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A model by its path below the corpus; a name that JSON cannot hold has its hash behind it, so that no two are alike.
std::string name_below(const fs::path& folder, const std::string& file) {
  const std::string path = fs::path(file).lexically_relative(folder).generic_string();
  std::string name = in_utf8(path);
  return name == path ? path : fmt::format("{}#{:016x}", name, hash_of_text(path));
}

/// They stand by their names, which are sorted.
std::map<std::string, std::string> models_of(const fs::path& folder, const MeshInputs& inputs, const Shard& shard) {
  std::map<std::string, std::string> models;
  for (const std::string& file : inputs.files) {
    std::string name = name_below(folder, file);
    if (shard.holds(name)) models.emplace(std::move(name), file);
  }
  return models;
}

/// Its last part, however it is spelled: "." is where it leads.
std::string corpus_name(const fs::path& folder) {
  std::error_code error;
  fs::path whole = fs::canonical(folder, error);
  if (error) whole = fs::absolute(folder);
  return in_utf8(whole.filename().string());
}

std::string_view verdict_of_end(HowEnded how) {
  switch (how) {
    case HowEnded::timeout:
      return "timeout";
    case HowEnded::out_of_memory:
      return "out_of_memory";
    default:
      return "crashed";
  }
}

json model_line(const std::string& name, const std::string& file, const ShardOptions& options, const ShardWork& work) {
  const ProcessEnd end = run_limited(options.limits(), [&]() -> std::string {
    json found;
    try {
      found = work.find(file);
    } catch (const Error& e) {
      found = {{"verdict", "unreadable"}, {"why", in_utf8(printable(e.what()))}};
    }
    return found.dump(-1, ' ', false, json::error_handler_t::replace);
  });
  json line = end.how == HowEnded::done ? json::parse(end.text) : json{{"verdict", verdict_of_end(end.how)}};
  if (end.how != HowEnded::done) line["why"] = in_utf8(end.why);
  line["model"] = name;
  line["measured"] = {{"seconds", std::round(end.seconds * 1e4) / 1e4}, {"peak_mib", std::round(end.peak_mib)}};
  return line;
}

std::string shard_words(const Shard& shard, const std::map<std::string, std::string>& verdicts, std::size_t before) {
  std::map<std::string, std::size_t> count;
  for (const auto& [model, verdict] : verdicts) ++count[verdict];
  std::string text = fmt::format("shard {}: {}", shard.text(), plural(verdicts.size(), "model", "models"));
  const char* sign = ": ";
  for (const auto& [verdict, n] : count) text += fmt::format("{}{} {}", std::exchange(sign, ", "), grouped(n), verdict);
  if (before != 0) text += fmt::format("; {} of them were there", grouped(before));
  return text + "\n";
}

}  // namespace

bool ShardOptions::asked() const {
  if (shard && !folder) throw Error("--shard: where the lines go is not said; add '--out DIR'");
  if (!shard && (folder || seconds || mib))
    throw Error("--out, --time-limit and --memory-limit are of a shard; add '--shard 1/1' for a whole folder");
  return shard.has_value();
}

void add_shard(CLI::App* parser, ShardOptions& options) {
  parser
      ->add_option("--shard", options.shard,
                   "Take one of N parts of a folder, and write a line of JSON for each model, by a process of its own.")
      ->type_name("I/N");
  parser
      ->add_option("--out", options.folder, "Where the lines of a shard go, and where it goes on when it was stopped.")
      ->type_name("DIR");
  parser
      ->add_option("--time-limit", options.seconds,
                   "End the process of a model of a shard after so long; its verdict is then timeout.")
      ->check(CLI::PositiveNumber)
      ->type_name("SECONDS");
  parser
      ->add_option("--memory-limit", options.mib,
                   "Let the process of a model of a shard take so much memory; its verdict is then out_of_memory.")
      ->check(CLI::Range(1U, 1U << 24))
      ->type_name("MIB");
}

void require_none_with_shard(std::initializer_list<std::pair<std::string_view, bool>> given) {
  for (const auto& [option, is] : given) {
    if (is)
      throw Error(fmt::format("{} and --shard exclude one another; 'plumb collect' makes reports of shards", option));
  }
}

int run_shard(const MeshArguments& meshes, const ShardOptions& options, const ShardWork& work) {
  const Shard shard = Shard::parse(*options.shard);
  if (options.seconds && !std::isfinite(*options.seconds)) throw Error("--time-limit: give a finite number of seconds");
  std::error_code error;
  if (meshes.words.size() != 1 || !fs::is_directory(meshes.words[0], error))
    throw Error("--shard is of a folder; name one, and no file");
  const fs::path folder = meshes.words[0];
  const MeshInputs inputs = mesh_inputs(meshes);
  if (!inputs.faults.empty()) throw Error(inputs.faults[0].what());
  const std::map<std::string, std::string> models = models_of(folder, inputs, shard);
  ShardTitle title{work.command, corpus_name(folder), shard, work.settings};
  title.settings["time_limit"] = options.seconds ? json(*options.seconds) : json();
  title.settings["memory_limit"] = options.mib ? json(*options.mib) : json();
  title.settings["strictness"] = meshes.strict ? "strict" : meshes.lenient ? "lenient" : "usual";
  title.settings["unpacked"] = meshes.unpacked_mib ? json(*meshes.unpacked_mib) : json();
  ShardFile file(*options.folder, title);
  const std::size_t before = file.done().size();
  {
    Progress bar("shard " + shard.text(), models.size());
    for (const auto& [name, path] : models) {
      if (!file.done().contains(name)) file.add(model_line(name, path, options, work));
      bar.advance();
    }
  }
  file.end();
  say(shard_words(shard, file.done(), before));
  return 0;
}

}  // namespace plumb::tool
