// How is a compact tree kept?  In a file that is read, or mapped into memory as it is, as others are (tree_file.hpp).
//
//   write_compact_bvh("part.bvh", build_compact_bvh(mesh));
//   CompactBvh small = map_compact_bvh("part.bvh");      // pages come from the file when they are looked at
//
// A file is a head of 128 bytes ("plumbcmp", version, byte order, the frame's exponent, the bytes of a corner and of a
// number, how many nodes, vertices and slots there are, the length, the root's box; its last eight bytes are a checksum
// of all the others), then nodes, vertices, corners and numbers as they lie in memory.
// Laws: (1) what is read or mapped equals what was written, to the bit, by the checksum of tree_file.hpp.  (2) Before a
// tree is handed out it is looked at: each node is the child of one before it, each slot in one leaf, no deeper than a
// stack has room for; boxes are floats, and those on the way to a leaf contain its triangles.  So no file makes a
// question read out of bounds, run forever or miss a triangle that it holds.  (3) A file appears under its name whole or
// not at all.
// Errors: BvhFileError, whose text names the file, what is wrong where, and the mend.  Files of version 1 have no
// checksum and are refused.
// Who changes or cuts a file while it is mapped breaks (1) and (2) as with any mapped file.
// Source: RTCD 6.6, 13.4.2.
// Cost: as many bytes as in memory, and 128.  Mapping looks at every byte: 2 million triangles, 53 MB, take 0.17 s, of
// which the checksum 0.03.  Nothing is searched.
#pragma once

#include <string>

#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/bvh/tree_file.hpp"

namespace plumb {

void write_compact_bvh(const std::string& path, const CompactBvh& bvh);
CompactBvh read_compact_bvh(const std::string& path);
CompactBvh map_compact_bvh(const std::string& path);

}  // namespace plumb
