#include "write_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "plumb/arith/error.hpp"
#include "terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

fs::path temporary_name(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.part", path.filename().string(), ::getpid());
}

[[noreturn]] void refuse(const fs::path& path, const std::error_code& why) {
  throw Error(fmt::format("cannot write {}: {}", printable(path.string()), why.message()));
}

/// Files under temporary names; those that were not renamed are removed at the end.
class Unfinished {
 public:
  Unfinished() = default;
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished() {
    std::error_code ignored;
    for (const fs::path& path : paths_) fs::remove(temporary_name(path), ignored);
  }

  void write(const fs::path& path, const std::string& text) {
    if (fs::is_directory(path)) refuse(path, std::make_error_code(std::errc::is_a_directory));
    paths_.push_back(path);
    write_text_file(temporary_name(path).string(), text);
  }
  void rename_all() {
    for (const fs::path& path : paths_) {
      std::error_code error;
      fs::rename(temporary_name(path), path, error);
      if (error) refuse(path, error);
    }
  }

 private:
  std::vector<fs::path> paths_;
};

}  // namespace

void require_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error) {
    const fs::path probe = temporary_name(fs::path(folder) / "probe");  // some systems' rights promise what is not so
    if (const int file = ::open(probe.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600); file >= 0) {
      ::close(file);
      fs::remove(probe, error);
    } else {
      error = {errno, std::generic_category()};
    }
  }
  if (error) throw Error(fmt::format("cannot write into {}: {}", printable(folder), error.message()));
}

void write_folder(const std::string& folder, const std::vector<NamedText>& files) {
  Unfinished unfinished;
  for (const NamedText& file : files) unfinished.write(fs::path(folder) / file.name, file.text);
  unfinished.rename_all();
}

}  // namespace plumb::tool
