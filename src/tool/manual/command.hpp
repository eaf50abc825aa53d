// What is a command of the program?  A parser with its options, a page, and what runs.
//
// Each command's `options.cpp` makes one: its options stand beside nothing but each other, and their descriptions become
// the page's, the manual's and the shells'. A new command is a function below and a line in program.cpp.
// Law: what the parser fills lives as long as the command; the options that every command has are program.cpp's.
// Source: none.
// Cost: none.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tool/manual/help_text.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/mesh/triangles_obj.hpp"

namespace plumb::tool {

struct Command {
  CLI::App* parser;
  Manual (*manual)();
  std::function<int()> run;
  std::vector<std::string>* takes_rest = nullptr;  // what stands after "--"
  /// What an option ("--task") or an argument ("PREDICATE") may be, for the shells; what its checks list is known.
  std::map<std::string, std::function<std::vector<std::string>()>> choices{};
};

/// All commands of a program, once they are made.
using Commands = std::function<const std::vector<Command>&()>;

Command boolean_command(CLI::App& program);
Command bounds_command(CLI::App& program);
Command bsp_command(CLI::App& program);
Command bvh_command(CLI::App& program);
Command check_command(CLI::App& program);
Command clash_command(CLI::App& program);
Command closest_command(CLI::App& program);
Command collect_command(CLI::App& program);
Command convert_command(CLI::App& program);
Command convex_command(CLI::App& program);
Command csg_command(CLI::App& program);
Command distance_command(CLI::App& program);
Command doctor_command(CLI::App& program);
Command completion_command(CLI::App& program, const Commands& known);
Command fuzz_command(CLI::App& program);
Command hausdorff_command(CLI::App& program);
/// `of_program` is the program's own page; `instead` says what there is in the place of a command that there is not.
Command help_command(CLI::App& program, const Commands& known, Manual (*of_program)(),
                     std::string (*instead)(const std::string& word));
Command inside_command(CLI::App& program);
Command intersect_command(CLI::App& program);
Command nearest_command(CLI::App& program);
Command pairs_command(CLI::App& program);
Command parts_command(CLI::App& program);
Command plan_command(CLI::App& program);
Command proof_command(CLI::App& program);
Command ray_command(CLI::App& program);
Command repair_command(CLI::App& program);
Command replay_command(CLI::App& program);
Command resolve_command(CLI::App& program);
Command section_command(CLI::App& program);
Command sign_command(CLI::App& program);
Command split_command(CLI::App& program);

/// The page of a command, or of the program, on standard output.
void show_page(const CLI::App& program, const Command* command, Manual (*of_program)());

/// Of the manifest.
std::vector<std::string> predicate_names();

/// --seed: what is drawn by chance.
void add_seed(CLI::App* parser, std::uint64_t& seed, const std::string& about);

/// --threads; 0 where it is not given.
void add_threads(CLI::App* parser, unsigned& threads);

/// MESH: what a command reads, with the options that say how.
void add_meshes(CLI::App* parser, MeshArguments& meshes, const std::string& about);

/// These options alone, of commands whose files are not all meshes to read.
void add_reading(CLI::App* parser, MeshArguments& meshes);

/// An option that names the file to write; "-", and no name, is standard output.
void add_output(CLI::App* parser, const std::string& option, std::optional<std::string>& path,
                const std::string& about);

/// --tree: of commands that build the tree of one mesh.
void add_tree(CLI::App* parser, std::optional<std::string>& file);

/// --obj and --overwrite: the triangles of an answer, to be looked at.
void add_obj(CLI::App* parser, ObjOutput& obj, const std::string& about);

/// Of commands that place copies of meshes; the defaults are those that the fields hold.
void add_placements(CLI::App* parser, std::uint32_t& placements, double& refined_ns);

}  // namespace plumb::tool
