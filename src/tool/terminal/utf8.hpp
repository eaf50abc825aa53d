// How is a file's name shown where only UTF-8 may stand?  JSON and XML refuse other bytes; file names are any bytes.
//
// Law: valid text is unchanged; every byte that is no part of a character becomes U+FFFD, and so do the two code points
// that XML 1.0 has not (U+FFFE, U+FFFF).
// Source: RFC 3629, section 4.
// Cost: one pass.
#pragma once

#include <string>
#include <string_view>

namespace plumb::tool {

std::string in_utf8(std::string_view text);

}  // namespace plumb::tool
