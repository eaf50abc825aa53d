#include "tool/mesh/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>

#include "tool/mesh/load_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

MeshFileError fault(const std::string& folder, const std::string& text) {
  return {MeshFileProblem::unreadable, folder, std::nullopt, std::nullopt, text};
}

bool ends_like_a_mesh(fs::path path) {
  if (path.extension() == ".gz" || path.extension() == ".GZ") path = path.stem();
  return format_by_extension(path).has_value();
}

void walk(const fs::path& folder, MeshInputs& found) {
  std::error_code error;
  std::vector<fs::directory_entry> entries;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) entries.push_back(*at);
  if (error) {
    found.passed_over.push_back(folder.string() + " (" + error.message() + ")");
    return;
  }
  std::ranges::sort(entries, {}, [](const fs::directory_entry& e) { return e.path(); });
  for (const fs::directory_entry& entry : entries) {
    std::error_code ignored;
    const bool is_folder = entry.is_directory(ignored);
    if (is_folder && !entry.is_symlink(ignored)) {
      walk(entry.path(), found);
    } else {
      const bool mesh = !is_folder && ends_like_a_mesh(entry.path());
      (mesh ? found.files : found.passed_over).push_back(entry.path().string());
    }
  }
}

/// "parts: 2 meshes; passed over, no meshes by their names: notes.txt".
std::string remark(const std::string& folder, const MeshInputs& found) {
  constexpr std::size_t shown = 5;
  std::string text = fmt::format("{}: {}; passed over, no meshes by their names:", printable(folder),
                                 plural(found.files.size(), "mesh", "meshes"));
  for (std::size_t i = 0; i < std::min(shown, found.passed_over.size()); ++i)
    text += fmt::format("{} {}", i == 0 ? "" : ",", printable(found.passed_over[i]));
  if (found.passed_over.size() > shown) text += fmt::format(" and {} more", found.passed_over.size() - shown);
  return text + "\n";
}

void add_folder(const std::string& folder, MeshInputs& all) {
  std::error_code error;
  fs::directory_iterator readable(folder, error);
  if (error) {
    all.faults.push_back(fault(folder, "cannot be read: " + error.message() + "; check its permissions"));
    return;
  }
  MeshInputs found;
  walk(folder, found);
  if (found.files.empty()) {
    all.faults.push_back(
        fault(folder, "this folder holds no mesh, expected files that end like one (.obj, .stl, .3mf); name another"));
    return;
  }
  if (!found.passed_over.empty()) all.remarks.push_back(remark(folder, found));
  all.files.insert(all.files.end(), found.files.begin(), found.files.end());
  all.passed_over.insert(all.passed_over.end(), found.passed_over.begin(), found.passed_over.end());
}

/// read() with the mend of a mesh that is too large; and what was passed over in it is told.
template <class Read>
auto told(const std::string& file, LoadReport* report, const Read& read) try {
  LoadReport own;
  LoadReport& load = report != nullptr ? *report : own;
  auto mesh = read(&load);
  for (const PassedOver& p : load.passed_over)
    complain(fmt::format("{}: passed over {}", printable(file), passed_over_text(p)));
  return mesh;
} catch (const MeshFileError& e) {
  if (e.problem != MeshFileProblem::too_large) throw;
  throw Error(fmt::format("{}; '--unpacked MIB' raises it", e.what()));
}

}  // namespace

ReadOptions MeshArguments::reading() const {
  if (strict && lenient) throw Error("--strict and --lenient exclude each other: one refuses what the other reads");
  ReadOptions options{.points_too = points_too};
  options.strictness = strict ? Strictness::strict : lenient ? Strictness::lenient : Strictness::usual;
  if (unpacked_mib) {
    options.most_bytes = std::uint64_t{*unpacked_mib} << 20;
    options.most_ratio = std::numeric_limits<std::uint64_t>::max();
  }
  return options;
}

void require_input_once(const std::vector<std::string>& words) {
  if (std::ranges::count(words, "-") > 1)
    throw Error("'-' stands twice, but standard input is read once; name it once");
}

MeshInputs mesh_inputs(const MeshArguments& arguments) {
  require_input_once(arguments.words);
  MeshInputs inputs;
  for (const std::string& word : arguments.words) {
    std::error_code error;
    if (word != "-" && fs::is_directory(word, error)) {
      add_folder(word, inputs);
    } else {
      inputs.files.push_back(word);
    }
  }
  return inputs;
}

std::string bytes_of_input(const std::string& file, std::uint64_t most_bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (file != "-" && (fs::is_block_file(status) || (fs::is_character_file(status) && file != "/dev/stdin")))
    throw Error(fmt::format("cannot read {}: it is a device, expected a file or a pipe; name a file", printable(file)));
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  errno = 0;
  std::FILE* const stream = file == "-" ? stdin : std::fopen(file.c_str(), "rb");
  if (stream != nullptr) {
    std::size_t got = 0;
    while (bytes.size() <= most_bytes && (got = std::fread(chunk.data(), 1, chunk.size(), stream)) != 0)
      bytes.append(chunk.data(), got);
  }
  const bool failed = stream == nullptr || std::ferror(stream) != 0;
  const std::string why = failed ? std::strerror(errno) : "";
  if (stream != nullptr && stream != stdin) static_cast<void>(std::fclose(stream));
  if (failed) throw Error(fmt::format("cannot read {}: {}", printable(name_of_input(file)), why));
  if (bytes.size() > most_bytes)
    throw Error(
        fmt::format("cannot read {}: it is longer than {} MiB, which is the most that is read; divide it, or "
                    "write it as an array of NumPy (.npy), which is shorter",
                    printable(name_of_input(file)), most_bytes >> 20));
  return bytes;
}

PolygonMesh parse_input(std::string_view bytes, const std::string& name, LoadReport* report,
                        const ReadOptions& options) {
  return told(name, report, [&](LoadReport* load) { return parse_mesh(bytes, name, load, options); });
}

PolygonMesh read_input(const std::string& file, LoadReport* report, const ReadOptions& options) {
  if (file == "-") return parse_input(bytes_of_input(file), name_of_input(file), report, options);
  return told(file, report, [&](LoadReport* load) { return read_polygon_mesh(file, load, options); });
}

bool is_any_named(const MeshArguments& arguments, const std::vector<UnreadMesh>& unread) {
  return std::ranges::any_of(unread, [&](const UnreadMesh& mesh) {
    return std::ranges::any_of(arguments.words,
                               [&](const std::string& word) { return name_of_input(word) == mesh.name; });
  });
}

namespace {

/// read(file, input) for each of them; what that throws is refused, and so is what it returns.
template <class Input, class Read>
bool each_input(const MeshInputs& inputs, const Read& read, const std::function<void(Input)>& take,
                const std::function<void(UnreadMesh)>& refuse) {
  bool good = inputs.faults.empty();
  const auto refused = [&](const std::string& name, const std::string& why) {
    complain(why);
    if (refuse) refuse({name, why});
    good = false;
  };
  for (const MeshFileError& e : inputs.faults) refused(e.file, e.what());
  for (const std::string& file : inputs.files) {
    Input input{name_of_input(file), {}, {}};
    try {
      for (const UnreadMesh& part : read(file, input)) refused(part.name, part.why);
    } catch (const Error& e) {
      refused(input.name, e.what());
      continue;
    }
    take(std::move(input));
  }
  return good;
}

}  // namespace

bool each_mesh(const MeshInputs& inputs, const ReadOptions& options, const std::function<void(InputMesh)>& take,
               const std::function<void(UnreadMesh)>& refuse) {
  const auto read = [&](const std::string& file, InputMesh& input) {
    input.mesh = read_input(file, &input.load, options);
    return std::vector<UnreadMesh>();
  };
  return each_input(inputs, read, take, refuse);
}

bool each_assembly(const MeshInputs& inputs, const ReadOptions& options, const std::function<void(InputAssembly)>& take,
                   const std::function<void(UnreadMesh)>& refuse) {
  const auto read = [&](const std::string& file, InputAssembly& input) {
    input.parts = told(input.name, &input.load, [&](LoadReport* load) {
      return file == "-" ? parse_assembly(bytes_of_input(file), input.name, load, options)
                         : read_assembly(file, load, options);
    });
    std::vector<UnreadMesh> unread;
    for (const UnreadPart& part : input.parts.unread)
      unread.push_back({fmt::format("{}: {}", input.name, part.name), fmt::format("{}: {}", part.name, part.why)});
    return unread;
  };
  return each_input(inputs, read, take, refuse);
}

std::string name_of_input(const std::string& file) { return file == "-" ? "standard input" : file; }

}  // namespace plumb::tool
