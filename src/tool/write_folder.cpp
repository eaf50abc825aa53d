#include "write_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "plumb/arith/error.hpp"
#include "terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

std::string temporary_name(const std::string& path) { return fmt::format("{}.{}.part", path, ::getpid()); }

/// Files under temporary names; those that were not renamed are removed at the end.
class Unfinished {
 public:
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    std::error_code ignored;
    for (const std::string& path : paths_) fs::remove(temporary_name(path), ignored);
  }

  void write(const std::string& path, const std::string& text) {
    paths_.push_back(path);
    write_text_file(temporary_name(path), text);
  }
  void rename_all() {
    for (const std::string& path : paths_) {
      std::error_code error;
      fs::rename(temporary_name(path), path, error);
      if (error) throw Error(fmt::format("cannot write {}: {}", path, error.message()));
    }
  }

 private:
  std::vector<std::string> paths_;
};

}  // namespace

void require_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) error = {errno, std::generic_category()};
  if (error) throw Error(fmt::format("cannot write into {}: {}", folder, error.message()));
}

void write_folder(const std::string& folder, const std::vector<NamedText>& files) {
  Unfinished unfinished;
  for (const NamedText& file : files) unfinished.write((fs::path(folder) / file.name).string(), file.text);
  unfinished.rename_all();
}

}  // namespace plumb::tool
