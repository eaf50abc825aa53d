// How is a small picture of few colors written?  As PNG with a palette, by libpng.
//
// Law: same pixels, same bytes on one version of libpng.
// Source: ISO/IEC 15948.
// Cost: milliseconds.  A grid of signs of 256 x 256 takes some 300 bytes, where as SVG by runs it takes 12 to 28 kB.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace plumb::lab::stability {

using Color = std::array<std::uint8_t, 3>;  // red, green, blue

/// `pixels` are indices into `palette`, row by row from the top; throws Error where libpng fails.
std::string palette_png(std::size_t width, std::span<const std::uint8_t> pixels, std::span<const Color> palette);

/// As it stands behind "data:image/png;base64,".
std::string in_base64(std::string_view bytes);

}  // namespace plumb::lab::stability
