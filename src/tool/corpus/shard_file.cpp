#include "tool/corpus/shard_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "plumb/arith/error.hpp"
#include "plumb/certify/environment.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string one_line(const json& j) { return j.dump(-1, ' ', false, json::error_handler_t::replace) + "\n"; }

[[noreturn]] void refuse_file(const fs::path& path, std::string_view why) {
  throw Error(fmt::format("{}: {}", printable(path.string()), why));
}

[[noreturn]] void refuse_by_system(const fs::path& path) { refuse_file(path, std::strerror(errno)); }

/// "check.3-of-10.jsonl" read back.
std::optional<FoundShard> named_shard(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t dot = name.find('.'), of = name.find("-of-");
  if (dot == name.npos || of == name.npos || of < dot || path.extension() != ".jsonl") return {};
  FoundShard found{path, name.substr(0, dot), {0, 0}};
  const char* const end = name.data() + name.size() - std::string_view(".jsonl").size();
  const auto first = std::from_chars(name.data() + dot + 1, end, found.shard.number);
  const auto second = std::from_chars(name.data() + of + 4, end, found.shard.count);
  if (first.ec != std::errc() || first.ptr != name.data() + of || second.ec != std::errc() || second.ptr != end)
    return {};
  if (found.shard.number == 0 || found.shard.number > found.shard.count) return {};
  return found;
}

std::string bytes_of_shard(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse_file(path, "cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::string ShardTitle::line() const {
  return one_line({{"plumb", check_environment().version},
                   {"command", command},
                   {"corpus", corpus},
                   {"shard", shard.number},
                   {"shards", shard.count},
                   {"settings", settings}});
}

std::string shard_file_name(const std::string& command, const Shard& shard) {
  return fmt::format("{}.{}-of-{}.jsonl", command, shard.number, shard.count);
}

std::vector<FoundShard> shard_files(const fs::path& folder) {
  std::error_code error;
  std::vector<FoundShard> found;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (std::optional<FoundShard> file = named_shard(at->path())) found.push_back(std::move(*file));
  if (error) refuse_file(folder, "cannot be read: " + error.message());
  std::ranges::sort(found, {},
                    [](const FoundShard& f) { return std::tuple(f.command, f.shard.count, f.shard.number); });
  return found;
}

ShardLines read_shard(const fs::path& path) {
  ShardLines lines;
  const std::string bytes = bytes_of_shard(path);
  std::size_t number = 0;
  for (std::size_t end = 0; (end = bytes.find('\n', lines.complete)) != bytes.npos; lines.complete = end + 1) {
    ++number;
    json line = json::parse(bytes.begin() + static_cast<std::ptrdiff_t>(lines.complete),
                            bytes.begin() + static_cast<std::ptrdiff_t>(end), nullptr, false);
    const auto has = [&](const char* name, json::value_t type) {
      const auto at = line.find(name);
      return at != line.end() && at->type() == type;
    };
    const auto is = json::value_t::string;
    const auto count = json::value_t::number_unsigned;
    if (number == 1 && line.is_object() && has("command", is) && has("corpus", is) && has("shard", count) &&
        has("shards", count) && has("settings", json::value_t::object)) {
      lines.title = std::move(line);
    } else if (number != 1 && line.is_object() && has("model", is) && has("verdict", is)) {
      lines.models.push_back(std::move(line));
      lines.whole = false;
    } else if (number != 1 && line.is_object() && has("done", count)) {
      lines.whole = true;
    } else {
      refuse_file(
          path, fmt::format("line {} is none of a shard; take another folder for '--out', or remove the file", number));
    }
  }
  return lines;
}

ShardFile::ShardFile(const fs::path& folder, const ShardTitle& title)
    : path_(folder / shard_file_name(title.command, title.shard)) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) refuse_file(folder, "cannot be made: " + error.message());
  for (const FoundShard& other : shard_files(folder)) {
    if (other.command == title.command && other.shard.count != title.shard.count)
      refuse_file(other.path, fmt::format("the folder holds a shard of {}, not of {}; take another folder for '--out'",
                                          other.shard.count, title.shard.count));
  }
  file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) refuse_by_system(path_);
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) refuse_by_system(path_);
    complain(fmt::format("{}: another run has this shard; waiting for it", printable(path_.string())));
    while (::flock(file_, LOCK_EX) != 0)
      if (errno != EINTR) refuse_by_system(path_);
  }
  const std::string first = title.line(), there = bytes_of_shard(path_);
  if (there.find('\n') == there.npos) {
    if (!first.starts_with(there)) refuse_file(path_, "is there and is no file of a shard; take another folder");
    if (::ftruncate(file_, 0) != 0) refuse_by_system(path_);
    append(first);
    return;
  }
  if (!there.starts_with(first))
    refuse_file(path_,
                "was begun for another corpus, with other options or by another version; its first line says "
                "which; take another folder for '--out', or remove the file");
  const ShardLines lines = read_shard(path_);
  if (::ftruncate(file_, static_cast<off_t>(lines.complete)) != 0) refuse_by_system(path_);
  whole_ = lines.whole;
  for (const json& model : lines.models)
    done_[model.at("model").get<std::string>()] = model.at("verdict").get<std::string>();
}

ShardFile::~ShardFile() {
  if (file_ >= 0) ::close(file_);
}

void ShardFile::append(const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t n = ::write(file_, rest.data(), rest.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) refuse_by_system(path_);
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
}

void ShardFile::add(const json& model) {
  append(one_line(model));
  done_[model.at("model").get<std::string>()] = model.at("verdict").get<std::string>();
  whole_ = false;
}

void ShardFile::end() {
  if (!whole_) append(one_line({{"done", done_.size()}}));
  whole_ = true;
}

}  // namespace plumb::tool
