// How do the outputs of a run arrive?  All of them, whole, and only when the run succeeded.
//
// A command promises its outputs before it works, writes them into this object, and keeps them at its end:
//
//   OutputFiles outputs(options.meshes);                     // what the run reads
//   outputs.promise("--json", options.json);                 // refused here, before minutes of work
//   if (!outputs.on_standard_output()) say(report);
//   if (outputs.wants("--json")) outputs.write("--json", json);
//   outputs.keep();
//
// Laws: (1) until keep() no output's place is touched: a run that fails or is stopped leaves what was there, and
// nothing beside it; (2) no output replaces a file that the run reads, under whatever name, nor standard input's, nor
// one that is a mesh by its ending or its content, nor another output; a mesh replaces nothing unasked; (3)
// "-", and whatever else standard output is, is written to standard output; (4) how the files are written says
// surface/file/whole_file.hpp; what cannot be written throws Error, which names option and file.
// Source: none.
// Cost: the texts are held until they are kept.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "surface/file/whole_file.hpp"

namespace plumb::tool {

struct PathAndText {
  std::filesystem::path path;
  std::string_view text;
  surface::Replacing replacing = surface::Replacing::yes;
};

class OutputFiles {
 public:
  explicit OutputFiles(std::vector<std::string> inputs = {}) : inputs_(std::move(inputs)) {}

  /// What is written there is a report.
  void promise(std::string_view option, const std::optional<std::string>& path);
  /// What is written there is a mesh, and replaces only what the user said it may; else the mend is told.
  void promise_mesh(std::string_view option, const std::optional<std::string>& path, surface::Replacing replacing,
                    std::string_view mend = "give another name, or remove it first");
  /// A report that replaces nothing either, unless that is asked for: --overwrite.
  void promise_unless_there(std::string_view option, const std::optional<std::string>& path, bool overwrite);

  /// What turned out to be read as well; throws Error where an output would replace it.
  void require_not_read(const std::vector<std::string>& files) const;

  [[nodiscard]] bool wants(std::string_view option) const;
  /// Standard output is one output's alone.
  [[nodiscard]] bool on_standard_output() const;
  void write(std::string_view option, std::string text);
  void keep();
  /// The same but for the files, which are left to who keeps them with others; they refer to this object.
  [[nodiscard]] std::vector<PathAndText> keep_streams();

 private:
  struct Output {
    std::string option, path;
    bool is_mesh;
    surface::Replacing replacing;
    bool standard_output;
    std::string text{};
    bool written = false;
  };
  void add(Output output, std::string_view mend);
  void require_distinct(const Output& output) const;
  static void require_other(const std::string& read, const Output& output);

  std::vector<std::string> inputs_;
  std::vector<Output> outputs_;
};

/// Throws std::system_error where such a file could not be kept; leaves nothing.
void probe_file(const std::filesystem::path& path, surface::Replacing replacing = surface::Replacing::yes);

/// The same for files in a folder that may be missing, if only its parent is there.
void probe_folder(const std::filesystem::path& folder);

/// All of the files or, as far as the system lets it, none; throws Error, which names the file. The folders are made in
/// turn where they are missing, and none is left where no file came to be in it.
void keep_files(const std::vector<PathAndText>& files, const std::vector<std::filesystem::path>& folders = {});

}  // namespace plumb::tool
