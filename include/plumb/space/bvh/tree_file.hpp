// How is a tree kept, so that nobody builds it twice?  In a file that is read, or mapped into memory as it is.
//
//   write_bvh("part.bvh", build_bvh(mesh));
//   Bvh bvh = map_bvh("part.bvh");                 // pages come from the file when they are looked at
//
// A file is a head of 128 bytes ("plumbbvh", version, byte order, the frame's exponent, the numbers of nodes, vertices
// and slots, the length; its last eight bytes are a checksum of all the others), then nodes, vertices, triangles and
// items as they lie in memory.
// Laws: (1) what is read or mapped equals what was written, to the bit: a file of which up to 32 bits in a row are
//       others is refused, and of changes at random no more than one in 2^32 passes.  (2) Before a tree is handed out,
//       every law of box_tree.hpp and bvh.hpp is looked at, so no file makes a question read out of bounds, run forever
//       or miss a triangle that it holds, not even one whose checksum was made to fit.  (3) A file appears under its name
//       whole or not at all.
// Errors: BvhFileError, whose text names the file, what is wrong where, and the mend.  Files of version 1 have no
// checksum and are refused.
// Who changes or cuts a file while it is mapped breaks (1) and (2) as with any mapped file.
// Source: RTCD 6.6; RFC 1950 and RFC 1952 for the two halves of the checksum.
// Cost: mapping looks at every byte, so that all of the file passes through memory: a third of the time of building.  2
// million triangles, 100 MB, take 0.32 s, of which the checksum 0.06 (0.6 s a gigabyte), the rest the laws and the wide
// form; so the checksum cannot be put off.  Nothing is searched.
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
  damaged,     // its bytes are not those that were written
  broken_law,  // its contents are no tree
};

struct BvhFileError : Error {
  BvhFileError(BvhFileProblem p, const std::string& name, const std::string& text)
      : Error(name + ": " + text), problem(p), file(name) {}
  BvhFileProblem problem;
  std::string file;
};

void write_bvh(const std::string& path, const Bvh& bvh);
/// What such a file holds, for who keeps it in another way.
std::string bvh_bytes(const Bvh& bvh);
Bvh read_bvh(const std::string& path);
Bvh map_bvh(const std::string& path);

}  // namespace plumb
