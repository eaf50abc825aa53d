// What did the check find?  The same findings as text for people and as JSON for programs.
//
// Laws: text and JSON hold the same numbers; nothing is written that was not measured.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "tool/check/mesh.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

/// Of the report on one mesh what each step of the check lets say: name and the first two lines of the verdict, its
/// other two, everything else.
std::string text_opening(const MeshCheck& check, const Style& style);
std::string text_verdict(const MeshCheck& check);
std::string text_tables(const MeshCheck& check, const Style& style);

/// All of it in one line: "part.stl: 3 open edges; 1 shell inside out".
std::string text_brief(const MeshCheck& check);
std::string text_brief(const UnreadMesh& mesh);

/// The totals over several meshes; the table alone.
std::string text_total(std::span<const MeshCheck> checks, const Style& style);
/// What could not be read; nothing where all could.
std::string text_unread(std::span<const UnreadMesh> unread);

/// What the run looked at, beside the meshes that it checked.
struct ReportInputs {
  std::span<const std::string> passed_over;
  std::span<const UnreadMesh> unread;
};
nlohmann::json json_report(std::span<const MeshCheck> checks, const ReportInputs& inputs, unsigned threads);

/// Share of wrong signs against time per decision, one point a method.
std::string chart_svg(std::span<const MeshCheck> checks);

}  // namespace plumb::tool
