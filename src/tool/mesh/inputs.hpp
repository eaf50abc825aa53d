// Which meshes does a command line mean?  Files, every mesh in a folder, and standard input: for every command alike.
//
// Laws: (1) a folder means the files in it and in its folders, in the order of their paths, whose names end like those
// of meshes; what else lies there is passed over, and said so.  (2) Links to folders are not followed, so a walk ends.
// (3) "-" is standard input, once.  (4) All arguments are looked at before the first mesh is read, so that it is known
// what a run will read.
// Source: none.
// Cost: a look at each name in the folders.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/file/read_assembly.hpp"

namespace plumb::tool {

/// As they were given.
struct MeshArguments {
  std::vector<std::string> words;             // files, folders, "-"
  std::optional<std::uint32_t> unpacked_mib;  // what a packed mesh may unpack to, and parts may make
  bool points_too = false;                    // vertices without faces will do
  bool strict = false, lenient = false;       // one of them at the most

  /// Throws Error where it is both strict and lenient.
  [[nodiscard]] ReadOptions reading() const;
};

/// What they mean.
struct MeshInputs {
  std::vector<std::string> files;
  std::vector<std::string> passed_over;  // in folders: no meshes by their names, and folders that cannot be read
  std::vector<std::string> remarks;      // the same for people, a line for each folder where there is any
  std::vector<MeshFileError> faults;     // folders that hold no mesh or cannot be read
};

/// Throws Error where "-" is among the words twice.
void require_input_once(const std::vector<std::string>& words);

/// Throws Error where standard input is named twice.
MeshInputs mesh_inputs(const MeshArguments& arguments);

/// All of a file, or of standard input for "-"; throws Error where it cannot be read, is a device, which may never end,
/// or is longer than that.
std::string bytes_of_input(const std::string& file, std::uint64_t most_bytes = std::uint64_t{4} << 30);

/// The mesh that these bytes are, of a file of this name; throws as read_input does.
PolygonMesh parse_input(std::string_view bytes, const std::string& name, LoadReport* report,
                        const ReadOptions& options);

/// The mesh of a file, or of standard input for "-".  Throws MeshFileError, and Error where standard input cannot be
/// read or the mesh is larger than the options allow, naming the option that allows it.
PolygonMesh read_input(const std::string& file, LoadReport* report, const ReadOptions& options);

struct InputMesh {
  std::string name;
  PolygonMesh mesh;
  LoadReport load;
};

/// An input that cannot be read, by its name, and why.
struct UnreadMesh {
  std::string name, why;
};

/// Is one of them an argument?  What was named is to be read, what a folder holds is reported on.
bool is_any_named(const MeshArguments& arguments, const std::vector<UnreadMesh>& unread);

/// Every mesh in turn.  What cannot be read is complained of, and told to `refuse` if that is given, and the others are
/// still taken; false then.
bool each_mesh(const MeshInputs& inputs, const ReadOptions& options, const std::function<void(InputMesh)>& take,
               const std::function<void(UnreadMesh)>& refuse = {});

struct InputAssembly {
  std::string name;
  AssemblyParts parts;
  LoadReport load;
};

/// The same of files by the parts that they name.  A part that cannot be read is told to `refuse` by file and name, and
/// the others of its file are taken.
bool each_assembly(const MeshInputs& inputs, const ReadOptions& options, const std::function<void(InputAssembly)>& take,
                   const std::function<void(UnreadMesh)>& refuse);

/// How an input is called: "standard input" for "-".
std::string name_of_input(const std::string& file);

}  // namespace plumb::tool
