#include "house/rules.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "house/type_names.hpp"

namespace plumb::house {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_file = 500;
constexpr std::uintmax_t largest_file = 200'000;  // bytes; what is larger, a command makes
constexpr std::string_view cgal_adaptor = "include/plumb/certify/cgal_";
constexpr std::string_view boost_number = "src/arith/boost_number/";  // behind GMP's names, where GMP is not
constexpr std::string_view eigen_adaptor = "include/plumb/figure/basic/eigen.hpp";
constexpr int above_all = 1000;  // the rung of the program, of Python's face and of plumb.hpp

struct Source {
  std::string path;  // relative to the tree, with slashes
  std::size_t lines = 0;
  std::vector<std::string> includes;  // as spelled
  std::vector<std::string> in_brackets{};
  std::vector<std::string> namespaces{};    // opened at the left margin, from the outermost
  std::vector<std::size_t> typed_bounds{};  // the numbers of the lines
  std::vector<std::size_t> without_end{};   // the same of what says that it cannot be reached
};

bool one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_build_product(const std::string& name) {  // what .gitignore leaves out of the tree
  return name.starts_with(".") || name.starts_with("build") || name == "compile_commands.json";
}

/// The spelling between the quotes or brackets, where the line is an #include.
std::optional<std::string> included(std::string_view line) {
  const auto skip = [&line] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
  skip();
  if (!line.starts_with('#')) return {};
  line.remove_prefix(1);
  skip();
  if (!line.starts_with("include")) return {};
  line.remove_prefix(7);
  skip();
  if (!line.starts_with('"') && !line.starts_with('<')) return {};
  const std::size_t end = line.find(line.front() == '"' ? '"' : '>', 1);
  if (end == std::string_view::npos) return {};
  return std::string(line.substr(1, end - 1));
}

/// Does the line hold a small number that may be an error bound typed in by hand?
bool has_typed_bound(std::string_view line) {
  if (line.find("0x1p-") != std::string_view::npos || line.find("2.125") != std::string_view::npos) return true;
  const std::size_t constant = line.find("* filter_constant");
  return constant != std::string_view::npos && constant >= 2 && line[constant - 2] >= '0' && line[constant - 2] <= '9';
}
/// Does a comment argue by how much a number is off?  What is derived needs no argument.
bool has_argued_bound(std::string_view line) {
  const std::size_t comment = line.find("//");
  if (comment == std::string_view::npos) return false;
  line.remove_prefix(comment);
  for (const char* argument : {"off by at most", "off at most", "off by less than two", "together off", "together less",
                               "of the error", "times the error"}) {
    if (line.find(argument) != std::string_view::npos) return true;
  }
  return false;
}
/// Does it say what else that is?  A guess decides nothing; a power of two rounds nothing.
bool says_what_else(std::string_view line) {
  return line.find("uess") != std::string_view::npos || line.find("power of two") != std::string_view::npos ||
         line.find("powers of two") != std::string_view::npos;
}
/// The number of the lines since that was said.
void follow_bounds(std::string_view line, std::size_t number, std::size_t& silent, std::vector<std::size_t>& typed) {
  constexpr std::size_t heard = 4;
  silent = says_what_else(line) ? 0 : silent + 1;
  if (silent > heard && (has_typed_bound(line) || has_argued_bound(line))) typed.push_back(number);
}

/// Keeps the namespaces that are open, by the lines that open and close them as clang-format writes them.
void follow_namespaces(std::string_view line, std::vector<std::string>& open, std::vector<std::string>& opened) {
  constexpr std::string_view start = "namespace ", end = "}  // namespace ";
  if (line.starts_with("inline ")) line.remove_prefix(7);
  if (line.starts_with(end) && !open.empty()) {
    open.pop_back();
  } else if (line.starts_with(start) && line.size() > 11 && line.find(" {") != std::string_view::npos) {
    std::string name(line.substr(start.size(), line.find(' ', start.size()) - start.size()));
    const bool inside = !open.empty() && !open.back().empty();
    if (name != "{") opened.push_back(inside ? open.back() + "::" + name : name);
    const bool stays_open = line.back() != '}';
    if (stays_open) open.push_back(name == "{" ? open.empty() ? "" : open.back() : opened.back());
  }
}

bool is_source(const fs::path& path) {
  const std::string extension = path.extension().string();
  return one_of(extension, {".hpp", ".cpp", ".h", ".c", ".cmake", ".in"}) || path.filename() == "CMakeLists.txt";
}

std::vector<Source> read_sources(const fs::path& tree) {
  std::vector<Source> sources;
  for (const char* top : {"include", "src", "predicates", "tests", "fuzz", "docs"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      if (!entry.is_regular_file() || !is_source(entry.path())) continue;
      Source source{fs::relative(entry.path(), tree).generic_string(), 0, {}};
      std::ifstream in(entry.path());
      std::vector<std::string> open;
      std::size_t silent = longest_file;
      for (std::string line; std::getline(in, line); ++source.lines) {
        follow_namespaces(line, open, source.namespaces);
        follow_bounds(line, source.lines + 1, silent, source.typed_bounds);
        if (line.find("_unreachable()") != std::string::npos) source.without_end.push_back(source.lines + 1);
        if (auto spelled = included(line)) {
          if (line.find('<') < line.find('"')) source.in_brackets.push_back(*spelled);
          source.includes.push_back(std::move(*spelled));
        }
      }
      sources.push_back(std::move(source));
    }
  }
  std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return sources;
}

/// The rung of a name directly below include/plumb or src: a folder, or a face such as surface.hpp.
std::optional<int> rung_of(std::string name) {
  if (one_of(name, {"tool", "python", "c", "js", "plumb.hpp", "plumb.h", "plumb_exact.h", "plumb_surfaces.h",
                    "plumb_world.h"}))
    return above_all;
  if (name == "lab") return above_all + 1;             // the second program knows the first
  if (name == "predicates.hpp") name = "certify.hpp";  // the face of the signs
  if (name == "classic.h") name = "classic.hpp";       // the face for C
  if (name.ends_with(".hpp")) name.resize(name.size() - 4);
  const auto found = std::find(ladder.begin(), ladder.end(), name);
  if (found == ladder.end()) return {};
  return static_cast<int>(found - ladder.begin());
}

std::string first_part(const std::string& path) { return path.substr(0, path.find('/')); }

/// The rung of a source; none for those off the ladder (tests and the like).
std::optional<int> own_rung(const std::string& path) {
  for (const std::string start : {"include/plumb/", "src/"}) {
    if (path.starts_with(start)) return rung_of(first_part(path.substr(start.size())));
  }
  if (path.starts_with("predicates/")) return 0;
  return {};
}

/// The rung of what an #include names; none for what is not ours or lies in the same folder.
std::optional<int> included_rung(const std::string& spelled) {
  if (spelled.starts_with("plumb/")) return rung_of(first_part(spelled.substr(6)));
  if (spelled.find('/') == std::string::npos) return {};
  return rung_of(first_part(spelled));
}

void check_top_level(const fs::path& tree, std::vector<Breach>& out) {
  for (const auto& entry : fs::directory_iterator(tree)) {
    const std::string name = entry.path().filename().string();
    if (is_build_product(name)) continue;
    if (std::find(top_level.begin(), top_level.end(), name) == top_level.end()) {
      out.push_back({name, "is not a name of the top level"});
    }
  }
  for (const std::string& name : top_level) {
    if (!fs::exists(tree / name)) out.push_back({name, "is missing from the top level"});
  }
}

void check_folders(const fs::path& tree, std::vector<Breach>& out) {
  for (const std::string top : {"include/plumb", "src"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::directory_iterator(tree / top)) {
      const std::string name = entry.path().filename().string();
      const std::string extension = entry.path().extension().string();
      const bool known =
          entry.is_directory() ? rung_of(name) && (name != "predicates" || entry.is_symlink()) &&
                                     (!one_of(name, {"tool", "lab", "python", "c", "js"}) || top == "src")
          : top == "src"
              ? one_of(extension, {".cmake", ".in"})
              : (extension == ".hpp" ||
                 one_of(name, {"classic.h", "plumb.h", "plumb_exact.h", "plumb_surfaces.h", "plumb_world.h"})) &&
                    rung_of(name).has_value();
      if (!known) out.push_back({top + "/" + name, "is no rung of the ladder"});
    }
  }
  for (const std::string top : {"include", "predicates"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::directory_iterator(tree / top)) {
      const bool known = top == "include" ? entry.path().filename() == "plumb" : entry.path().extension() == ".hpp";
      if (!known) out.push_back({fs::relative(entry.path(), tree).generic_string(), "is no rung of the ladder"});
    }
  }
}

void check_ladder(const Source& source, std::vector<Breach>& out) {
  const auto own = own_rung(source.path);
  if (!own) return;
  for (const std::string& spelled : source.includes) {
    if (spelled.starts_with("..")) out.push_back({source.path, "includes " + spelled + ", by a path that climbs"});
    if (spelled.starts_with("plumb/") && !included_rung(spelled)) {
      out.push_back({source.path, "includes " + spelled + ", which is on no rung of the ladder"});
    }
    const auto other = included_rung(spelled);
    if (other && *other > *own) out.push_back({source.path, "includes " + spelled + ", of a later folder"});
  }
}

/// The place of a path below include/plumb or src in the ladder and, within its folder, among the rooms.
struct Place {
  std::string folder;
  std::string room;  // empty where the folder has none, or the file is in none
};
Place place_below(const std::string& path) {
  Place place{first_part(path), {}};
  if (!rooms.contains(place.folder)) return place;
  const std::string rest = path.substr(std::min(place.folder.size() + 1, path.size()));
  if (rest.find('/') != std::string::npos) place.room = first_part(rest);
  return place;
}
std::optional<std::string> below_top(const std::string& path) {
  for (const std::string top : {"include/plumb/", "src/"}) {
    if (path.starts_with(top)) return path.substr(top.size());
  }
  return {};
}

std::optional<std::ptrdiff_t> rank_of(const Place& place) {
  const std::vector<std::string>& known = rooms.at(place.folder);
  const auto found = std::find(known.begin(), known.end(), place.room);
  if (found == known.end()) return {};
  return found - known.begin();
}

void check_rooms(const Source& source, std::vector<Breach>& out) {
  const auto below = below_top(source.path);
  if (!below || !rooms.contains(first_part(*below)) || below->ends_with("CMakeLists.txt")) return;
  if (*below != source.path.substr(4) && (first_part(*below) == "tool" || first_part(*below) == "lab"))
    return;  // of include/, where no program belongs
  const Place own = place_below(*below);
  const auto rank = rank_of(own);
  if (!rank) {
    out.push_back({source.path, "is in no room of " + own.folder});
    return;
  }
  for (const std::string& spelled : source.includes) {
    const Place other = place_below(spelled.starts_with("plumb/") ? spelled.substr(6) : spelled);
    if (other.folder != own.folder) continue;
    const auto other_rank = rank_of(other);
    if (other_rank && *other_rank > *rank) out.push_back({source.path, "includes " + spelled + ", of a later room"});
  }
}

/// One spelling, from the root of include/ or src/ or tests/, so that a search for a file finds all who include it.
void check_spelling(const Source& source, std::vector<Breach>& out) {
  if (!below_top(source.path) && !source.path.starts_with("predicates/")) return;
  for (const std::string& spelled : source.in_brackets) {
    if (spelled.starts_with("plumb/")) out.push_back({source.path, "includes <" + spelled + ">, in brackets"});
  }
  for (const std::string& spelled : source.includes) {
    const bool in_quotes =
        std::find(source.in_brackets.begin(), source.in_brackets.end(), spelled) == source.in_brackets.end();
    if (in_quotes && spelled.find('/') == std::string::npos) {
      out.push_back({source.path, "includes \"" + spelled + "\", without its folder"});
    }
  }
}

/// plumb for what users name; all else below the name of its folder.
void check_namespaces(const Source& source, std::vector<Breach>& out) {
  const auto below = below_top(source.path);
  if (!below || below->find('/') == std::string::npos) return;
  const std::string folder = first_part(*below);
  for (const std::string& name : source.namespaces) {
    const auto is_below = [&](const std::string& top) { return name == top || name.starts_with(top + "::"); };
    const bool made_kind = below->starts_with("query/kinds/") && is_below("plumb::degenerate");
    const bool adapts = (source.path.starts_with(cgal_adaptor) && (is_below("CGAL") || is_below("plumb::cgal"))) ||
                        (source.path == eigen_adaptor && is_below("plumb::eigen"));
    const bool fills_gap = source.path == "src/js/library_gaps.hpp" && is_below("std");
    if (name == "plumb" || is_below("plumb::" + folder) || made_kind || adapts || fills_gap) continue;
    out.push_back({source.path, "opens namespace " + name + ", which is not of its folder"});
  }
}

/// What users call is found from a face; what they do not is no header of theirs, or stands under detail/.
void check_named_by_face(const fs::path& tree, const std::vector<Source>& sources, std::vector<Breach>& out) {
  std::string faces;
  if (!fs::is_directory(tree / "include/plumb")) return;
  for (const auto& entry : fs::directory_iterator(tree / "include/plumb")) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path());
    faces.append(std::istreambuf_iterator<char>(in), {});
  }
  for (const Source& source : sources) {
    if (!source.path.starts_with("include/plumb/")) continue;
    const std::string name = source.path.substr(14);
    const bool is_number = name.starts_with("arith/");  // what all of them are made of
    if (is_number || name.find('/') == std::string::npos || name.find("/detail/") != std::string::npos) continue;
    if (faces.find(name) == std::string::npos) out.push_back({source.path, "is named by no face"});
  }
}

void check_crowd(const std::vector<Source>& sources, std::vector<Breach>& out) {
  std::map<std::string, std::size_t> files;
  for (const Source& source : sources) ++files[fs::path(source.path).parent_path().generic_string()];
  for (const auto& [folder, count] : files) {
    if (count > most_files) out.push_back({folder, "has " + std::to_string(count) + " files; 60 are the most"});
  }
}

bool is_gmp(const std::string& spelled) { return one_of(spelled, {"gmp.h", "gmpxx.h", "mpfr.h"}); }

void check_libraries(const Source& source, std::vector<Breach>& out) {
  const std::string& path = source.path;
  const bool for_users = path.starts_with("include/") || path.starts_with("predicates/");
  const auto forbid = [&](const std::string& spelled, const char* why) {
    out.push_back({path, "includes " + spelled + ", " + why});
  };
  for (const std::string& spelled : source.includes) {
    const std::string library = first_part(spelled);
    const bool adapts = path.starts_with(cgal_adaptor) || path.starts_with("docs/examples/cgal/");
    const bool stands_for_gmp = library == "boost" && path.starts_with(boost_number);
    if (one_of(library, {"CGAL", "boost"}) && !adapts && !stands_for_gmp && !path.starts_with("tests/oracle/") &&
        !path.starts_with("tests/bench/")) {
      forbid(spelled, "which is for oracles and rivals (and the adaptor) only");
    }
    if (one_of(library, {"BulletCollision", "LinearMath", "ccd", "embree3", "fcl", "libqhull_r"}) &&
        !path.starts_with("tests/bench/")) {
      forbid(spelled, "which is for rivals only");
    }
    if (("include/" + spelled).starts_with(cgal_adaptor) && !adapts && !path.starts_with("tests/")) {
      forbid(spelled, "which needs CGAL and is for its users alone");
    }
    if (spelled == "plumb/arith/gmp.hpp" && !path.starts_with("tests/")) {
      forbid(spelled, "which needs GMP's headers and is for its users alone");
    }
    if (!for_users) continue;
    if (is_gmp(spelled) && !path.starts_with("include/plumb/arith/")) forbid(spelled, "which stays in arith/");
    if (library == "Eigen" && path != eigen_adaptor) forbid(spelled, "which stays at the edge");
    if (one_of(library, {"rapidcheck", "rapidcheck.h"}) && path != "include/plumb/degenerate/rapidcheck.hpp") {
      forbid(spelled, "which stays in its bridge");
    }
    if (one_of(library, {"fmt", "CLI", "nlohmann"})) forbid(spelled, "which is the program's");
    if (one_of(library, {"tbb", "oneapi", "hwy"})) forbid(spelled, "which stays in .cpp files");
  }
}

/// The faces, which every user includes, must not bring GMP along by any way.
void check_faces(const std::vector<Source>& sources, std::vector<Breach>& out) {
  std::map<std::string, const Source*> by_spelling;
  for (const Source& source : sources) {
    if (source.path.starts_with("include/")) by_spelling[source.path.substr(8)] = &source;
    if (source.path.starts_with("predicates/")) by_spelling["plumb/" + source.path] = &source;
  }
  for (const auto& [spelling, face] : by_spelling) {
    const bool is_face = face->path == "include/" + spelling && face->path.find('/', 14) == std::string::npos;
    if (!is_face) continue;
    std::set<std::string> seen = {spelling};
    std::vector<const Source*> open = {face};
    while (!open.empty()) {
      const Source* source = open.back();
      open.pop_back();
      for (const std::string& spelled : source->includes) {
        if (is_gmp(spelled)) out.push_back({face->path, "brings " + spelled + " along, through " + source->path});
        const auto found = by_spelling.find(spelled);
        if (found != by_spelling.end() && seen.insert(spelled).second) open.push_back(found->second);
      }
    }
  }
}

/// What decides a question has a bound that is derived, but for what derives bounds, or proves them.  The kinds' inputs
/// are made, and their rivals judged, by others.
void check_bounds(const Source& source, std::vector<Breach>& out) {
  const std::string& path = source.path;
  const auto below = [&path](const std::string& folder) {
    return path.starts_with("src/" + folder) || path.starts_with("include/plumb/" + folder);
  };
  const bool decides = below("certify/") || below("figure/") || below("query/") || below("space/") ||
                       below("surface/") || below("world/");
  const bool derives = below("certify/detail/") || below("certify/proof/") || below("certify/environment.");
  if (!decides || derives || below("query/kinds/") || source.typed_bounds.empty()) return;
  out.push_back({path, "types a bound in line " + std::to_string(source.typed_bounds.front()) +
                           " and says of no guess and no power of two"});
}

/// Behind what it is told cannot be reached GCC leaves a part of no length, at whose place nobody who unwinds a stack
/// finds the function that stands there.
void check_ends(const Source& source, std::vector<Breach>& out) {
  const bool is_ours = below_top(source.path) || source.path.starts_with("predicates/");
  if (!is_ours || source.without_end.empty()) return;
  out.push_back({source.path, "has no end in line " + std::to_string(source.without_end.front()) +
                                  ", by __builtin_unreachable: return, or abort"});
}

void check_names(const fs::path& tree, std::vector<Breach>& out) {
  for (const char* top : {"include", "src", "predicates", "tests", "fuzz", "docs"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      const std::string stem = entry.path().stem().string();
      for (const std::string vague : {"utils", "util", "common", "shared", "misc", "helpers", "helper"}) {
        if (stem != vague && !stem.ends_with("_" + vague)) continue;
        out.push_back({fs::relative(entry.path(), tree).generic_string(), "has a name that says nothing"});
      }
    }
  }
}

/// A clone is small, and a change can be read: reports are made by commands, not kept. Test vectors are for who has
/// none.
void check_sizes(const fs::path& tree, std::vector<Breach>& out) {
  for (const char* top : {"include", "src", "predicates", "tests", "fuzz", "docs"}) {
    if (!fs::is_directory(tree / top)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      const std::string path = fs::relative(entry.path(), tree).generic_string();
      if (path.starts_with("docs/vectors/") || !entry.is_regular_file() || entry.file_size() <= largest_file) continue;
      out.push_back({path, "has " + std::to_string(entry.file_size()) + " bytes; 200000 are the most"});
    }
  }
}

}  // namespace

std::vector<Breach> breaches(const fs::path& tree) {
  std::vector<Breach> out;
  check_top_level(tree, out);
  check_folders(tree, out);
  check_names(tree, out);
  check_sizes(tree, out);
  const std::vector<Source> sources = read_sources(tree);
  for (const Source& source : sources) {
    check_ladder(source, out);
    check_rooms(source, out);
    check_spelling(source, out);
    check_namespaces(source, out);
    check_libraries(source, out);
    check_bounds(source, out);
    check_ends(source, out);
    if (source.lines > longest_file) {
      out.push_back({source.path, "has " + std::to_string(source.lines) + " lines; 500 are the most"});
    }
  }
  check_crowd(sources, out);
  check_faces(sources, out);
  check_named_by_face(tree, sources, out);
  for (Breach& breach : types_named_twice(tree)) out.push_back(std::move(breach));
  return out;
}

}  // namespace plumb::house
