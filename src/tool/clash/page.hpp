// Clashes as one page that opens without a network: the list beside the scene, the two parts of a clash in color.
//
// Laws: (1) names are text, whatever they hold; (2) pictures and the list are in rounded numbers, the line
// that tells a clash has those of the report; (3)
// what is drawn is bounded: parts of listed clashes alone, of large ones every so many triangles and those that meet, and
// the page says so.
// Source: none.
// Cost: linear in the parts, and in the clashes that are listed.
#pragma once

#include <span>
#include <string>

#include "tool/clash/command.hpp"

namespace plumb::tool {

struct ClashPageBounds {
  std::size_t rows = 1000;          // clashes
  std::size_t triangles = 200'000;  // of all parts, beside those that meet
};

/// The meshes are those of the report's parts.
std::string clash_page(const ClashReport& report, std::span<const TriangleMesh> meshes,
                       const ClashPageBounds& bounds = {});

}  // namespace plumb::tool
