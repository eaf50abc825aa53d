// How is a tree kept, so that nobody builds it twice?  In a file that is read, or mapped into memory as it is.
//
//   write_bvh("part.bvh", build_bvh(mesh));
//   Bvh bvh = map_bvh("part.bvh");                 // pages come from the file when they are looked at
//
// A file is a head of 128 bytes ("plumbbvh", version, byte order, the frame's exponent, the numbers of nodes, vertices
// and slots, the length), then nodes, vertices, triangles and items as they lie in memory.
// Laws: (1) what is read or mapped equals what was written, to the bit.  (2) Before a tree is handed out, every law of
//       box_tree.hpp and bvh.hpp is looked at, so no file makes a question read out of bounds, run forever or miss a
//       triangle that it holds.  (3) A file appears under its name whole or not at all.
// Errors: BvhFileError, whose text names the file, what is wrong where, and the mend.
// Who changes or cuts a file while it is mapped breaks (2) as with any mapped file.
// Source: RTCD 6.6.
// Cost: some 50 ns a triangle to look through it and to make its wide form, a tenth of building.
#pragma once

#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

enum class BvhFileProblem : unsigned char {
  missing,     // there is no such file
  unreadable,  // a directory, no permission, a failing disk
  unwritable,  // it cannot be created or filled
  not_a_tree,  // it starts with other bytes
  version,     // of another version of the format, or another byte order
  truncated,   // it is shorter or longer than its head says
  broken_law,  // its contents are no tree
};

struct BvhFileError : Error {
  BvhFileError(BvhFileProblem p, const std::string& name, const std::string& text)
      : Error(name + ": " + text), problem(p), file(name) {}
  BvhFileProblem problem;
  std::string file;
};

void write_bvh(const std::string& path, const Bvh& bvh);
Bvh read_bvh(const std::string& path);
Bvh map_bvh(const std::string& path);

}  // namespace plumb
