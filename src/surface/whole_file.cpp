#include "whole_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "mesh_failure.hpp"

namespace plumb::surface {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  fail_at_file(MeshFileProblem::unwritable, path.string(),
               "cannot be written: " + reason + "; check the folder, its permissions and the room on the disk");
}

// Fills the file and closes it: 0, or the error number.
int fill(std::FILE* file, std::string_view bytes) {
  errno = 0;
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
  int error = written ? 0 : errno != 0 ? errno : EIO;
  if (std::fclose(file) != 0 && error == 0) error = errno;  // some disks say only now that they are full
  return error;
}

// A file that was not there before, beside the target.
std::FILE* create_beside(const fs::path& target, fs::path& created) {
  for (int k = 0;; ++k) {
    created = target;
    created += ".part" + std::to_string(k);
    std::FILE* file = std::fopen(created.c_str(), "wbx");
    if (file || errno != EEXIST) return file;
  }
}

}  // namespace

void write_whole_file(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  fs::path target = path;
  if (fs::is_symlink(path, error)) {
    target = fs::weakly_canonical(path, error);
    if (error) refuse(path, error.message());
  }
  const auto status = fs::status(target, error);
  if (fs::is_directory(status)) refuse(path, "it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    std::FILE* file = std::fopen(target.c_str(), "wb");
    const int failed = file ? fill(file, bytes) : errno;
    if (failed) refuse(path, std::strerror(failed));
    return;
  }
  fs::path part;
  std::FILE* file = create_beside(target, part);
  if (!file) refuse(path, std::strerror(errno));
  if (const int failed = fill(file, bytes)) {
    fs::remove(part, error);
    refuse(path, std::strerror(failed));
  }
  if (fs::exists(status)) fs::permissions(part, status.permissions(), error);
  fs::rename(part, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(part, error);
    refuse(path, reason);
  }
}

}  // namespace plumb::surface
