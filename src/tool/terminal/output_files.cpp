#include "tool/terminal/output_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "plumb/arith/error.hpp"
#include "tool/terminal/held_signals.hpp"
#include "tool/terminal/mesh_name.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using surface::Replacing;
using surface::StagedFile;

bool same(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? std::optional(status) : std::nullopt;
}

bool is_stream(const std::string& path, int stream) {
  struct stat there {};
  const auto here = status_of(path);
  return here && ::fstat(stream, &there) == 0 && same(*here, there);
}

bool is_same_file(const std::string& a, const std::string& b) {
  const auto status_a = status_of(a), status_b = status_of(b);
  if (status_a && status_b) return same(*status_a, *status_b) && S_ISREG(status_a->st_mode);
  if (status_a || status_b) return false;
  const auto whole = [](const std::string& path) {  // of what is not there yet
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(surface::target_of(path), error), error);
  };
  return whole(a) == whole(b);
}

/// Folders that are made where they are missing, and are gone again where nothing came to be in them.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  ~MadeFolders() {
    std::error_code holds_something;
    for (; !made_.empty(); made_.pop_back()) fs::remove(made_.back(), holds_something);
  }

  /// Throws std::system_error where that cannot be, its parent be there or not.
  void make(const fs::path& path) {
    made_.push_back(path);  // now, for this may throw
    std::error_code error;
    if (fs::create_directory(path, error)) return;
    made_.pop_back();
    if (error == std::errc::file_exists) error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw std::system_error(error);
  }

 private:
  std::vector<fs::path> made_;
};

[[noreturn]] void refuse(const fs::path& path, const std::system_error& e) {
  throw Error(fmt::format("cannot write {}: {}", printable(path.string()), e.code().message()));
}

}  // namespace

void OutputFiles::promise(std::string_view option, const std::optional<std::string>& path) {
  if (path) add({std::string(option), *path, false, Replacing::yes, false}, "");
}

void OutputFiles::promise_mesh(std::string_view option, const std::optional<std::string>& path, Replacing replacing,
                               std::string_view mend) {
  if (path) add({std::string(option), *path, true, replacing, false}, mend);
}

void OutputFiles::promise_unless_there(std::string_view option, const std::optional<std::string>& path,
                                       bool overwrite) {
  if (!path) return;
  add({std::string(option), *path, false, overwrite ? Replacing::yes : Replacing::no, false},
      "give another name, or --overwrite to replace it");
}

void OutputFiles::add(Output output, std::string_view mend) {
  if (output.path.empty())
    throw Error(fmt::format("{}: the file's name is empty; name one, or '-' for standard output", output.option));
  output.standard_output = output.path == "-" || is_stream(output.path, STDOUT_FILENO);
  require_distinct(output);
  if (!output.standard_output) {
    try {
      probe_file(output.path, output.replacing);
    } catch (const std::system_error& e) {
      if (e.code() != std::errc::file_exists) refuse(output.path, e);
      throw Error(fmt::format("{}: {} is there already and is kept; {}", output.option, printable(output.path), mend));
    }
  }
  outlive_reader();
  outputs_.push_back(std::move(output));
}

void OutputFiles::require_distinct(const Output& output) const {
  const std::string file = printable(output.path);
  for (const Output& other : outputs_) {
    const bool both_said = output.standard_output && other.standard_output;
    if (both_said || other.path == output.path || is_same_file(other.path, output.path))
      throw Error(fmt::format("{} and {} name the same output", other.option, output.option));
  }
  if (output.standard_output) return;
  for (const std::string& input : inputs_) require_other(input, output);
  if (status_of(output.path) && is_stream(output.path, STDIN_FILENO) && S_ISREG(status_of(output.path)->st_mode))
    throw Error(fmt::format("{} would replace {}, which is standard input; give another name", output.option, file));
  if (output.is_mesh) return;  // and may replace one, if anything
  std::error_code error;
  const std::string why = fs::is_directory(output.path, error) ? "is a folder" : why_mesh(output.path);
  if (!why.empty()) {
    throw Error(
        fmt::format("{0} takes the name of the file to write, and {1} {2}, which is kept; write '{0} REPORT {1}', or "
                    "'{0} - {1}' for standard output",
                    output.option, file, why));
  }
}

void OutputFiles::require_other(const std::string& read, const Output& output) {
  if (output.standard_output || !is_same_file(read, output.path)) return;
  throw Error(fmt::format("{} would replace {}, which this run reads; give another name", output.option,
                          printable(output.path)));
}

void OutputFiles::require_not_read(const std::vector<std::string>& files) const {
  for (const std::string& file : files) {
    for (const Output& output : outputs_) require_other(file, output);
  }
}

bool OutputFiles::wants(std::string_view option) const {
  return std::ranges::any_of(outputs_, [&](const Output& o) { return o.option == option; });
}

bool OutputFiles::on_standard_output() const {
  return std::ranges::any_of(outputs_, [](const Output& o) { return o.standard_output; });
}

void OutputFiles::write(std::string_view option, std::string text) {
  for (Output& o : outputs_) {
    if (o.option != option) continue;
    o.text = std::move(text);
    o.written = true;
    return;
  }
}

void OutputFiles::keep() { keep_files(keep_streams()); }

std::vector<PathAndText> OutputFiles::keep_streams() {
  std::vector<PathAndText> files;
  for (const Output& o : outputs_) {
    if (!o.written) continue;
    if (o.standard_output) {
      put_out(o.text);
    } else {
      files.push_back({o.path, o.text, o.replacing});
    }
  }
  flush_output();
  return files;
}

void probe_file(const fs::path& path, Replacing replacing) {
  const HeldSignals held;
  const StagedFile probe(path, "", replacing);
}

void probe_folder(const fs::path& folder) {
  const HeldSignals held;
  MadeFolders made;
  made.make(folder);
  const StagedFile probe(folder / "report", "");  // some systems' rights promise what is not so
}

void keep_files(const std::vector<PathAndText>& files, const std::vector<fs::path>& folders) {
  const fs::path* at = nullptr;
  try {
    std::vector<StagedFile> in_place;  // a pipe may wait for who reads: signals are obeyed meanwhile
    std::vector<const fs::path*> of_in_place;
    {
      const HeldSignals held;
      MadeFolders made;
      for (const fs::path& folder : folders) {
        at = &folder;
        made.make(folder);
      }
      std::vector<StagedFile> staged;
      std::vector<const fs::path*> of_staged;
      for (const PathAndText& file : files) {
        at = &file.path;
        StagedFile next(file.path, file.text, file.replacing);
        (next.in_place() ? of_in_place : of_staged).push_back(at);
        (next.in_place() ? in_place : staged).push_back(std::move(next));
        if (HeldSignals::arrived()) return;
      }
      for (std::size_t k = 0; k < staged.size(); ++k) {
        at = of_staged[k];
        staged[k].keep();
      }
    }
    for (std::size_t k = 0; k < in_place.size(); ++k) {
      at = of_in_place[k];
      in_place[k].keep();
    }
  } catch (const std::system_error& e) {
    refuse(*at, e);
  }
}

}  // namespace plumb::tool
