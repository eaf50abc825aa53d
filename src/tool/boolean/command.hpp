// `plumb boolean`: what is the union, intersection or difference of the solids that these meshes bound?
//
// Laws: (1) the result is exact until it is rounded, once, and what is called sound is certified.  (2) No file that is
// there is replaced, unless that is asked for, and never one that is read.  (3) What is not sound is written only where
// that is asked for.  (4) A mesh that bounds nothing, open or wound against itself, is refused by its name, with an edge
// and what mends it; each such mesh is, and nothing is written.  (5) Text and JSON tell the same.
// Exit code 0 when done, 1 where the rounded result is not sound, 2 where a mesh is refused or cannot be read; words that
// cannot be read and an output that cannot be written throw Error.
// Source: plumb/surface/solid/boolean.hpp, plumb/surface/solid/round.hpp.
// Cost: theirs, and an exact volume of each mesh.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/solid/arrangement.hpp"
#include "plumb/surface/solid/round.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

inline constexpr std::string_view operation_names[] = {"union", "intersection", "difference", "symmetric"};
inline constexpr std::string_view winding_rules[] = {"positive", "nonzero", "odd"};

/// Every command that makes a solid takes these.
struct SolidOptions {
  std::optional<std::string> output;  // "-" is standard output
  std::uint32_t rounds = RoundingOptions{}.rounds;
  bool merge = false;                       // coplanar pieces, before it is rounded
  bool overwrite = false, unsound = false;  // replace a file; write what is not sound
  std::optional<std::string> json;          // "-" is standard output
  unsigned threads = 0;

  [[nodiscard]] Pieces pieces() const { return merge ? Pieces::of_polygons : Pieces::of_triangles; }
};
void add_solid_options(CLI::App* parser, SolidOptions& options);

struct BooleanOptions : SolidOptions {
  std::string operation;          // of operation_names, or "resolve" of one mesh
  MeshArguments meshes;           // two or more
  std::string rule = "positive";  // of winding_rules
};
void add_rule(CLI::App* parser, BooleanOptions& options);

/// The operation "resolve" is that of `plumb resolve`.
int run_boolean(const BooleanOptions& options);

struct BooleanReport {
  std::string operation;
  RoundedMesh result;
  std::optional<double> volume;                 // none where it is not closed, or beyond all doubles
  std::optional<std::string> written;           // the file
  static constexpr std::size_t listed = 10;     // of the pairs that meet, in text
  static constexpr std::size_t told = 100'000;  // in JSON
};

/// Throws Error where it is not said where the result of the command goes.
void require_output(const std::string& command, const SolidOptions& options);
/// Refuses outputs of the command that cannot be written, before anything is read.
void promise_solid(const std::string& command, const SolidOptions& options, OutputFiles& outputs);
/// Rounds, judges and writes what `combine` makes, tells of it in text and after what is `said` as JSON, and keeps the
/// outputs; the exit code.  Throws as combine does.
int conclude(const SolidOptions& options, const std::string& operation, const std::function<ExactMesh()>& combine,
             nlohmann::json said, OutputFiles& outputs);

/// One of several results, rounded, judged and written behind that option; complains where it is not sound.
BooleanReport finished(const SolidOptions& options, const std::string& operation, const ExactMesh& exact,
                       const std::string& option, const std::string& path, OutputFiles& outputs);
/// Promises the mesh of that option; a format that cannot be written is refused before anything is read.
void promise_one(const std::string& option, const std::optional<std::string>& path, const SolidOptions& options,
                 OutputFiles& outputs);

/// "open at the edge from (0, 0, 0) to (1, 0, 0), of triangle 5", or that its triangles run against each other there.
std::string unbalanced_text(const UnbalancedEdge& found);
/// By `positive` what a mesh that is inside out encloses is outside, which is seldom meant.
void complain_of_inside_out(const AskedMesh& asked, const std::string& mend);

std::string boolean_text(const BooleanReport& report, const Style& style);
/// Leaves out what a report begins with.
nlohmann::json boolean_json(const BooleanReport& report);

}  // namespace plumb::tool
