// How does a picture of the laboratory begin?  With its size, the style that it shares with all charts, and its title.
//
// Law: well-formed XML whatever the texts hold; what follows is the drawing, from 70 pixels down, and "</svg>".
// Source: none.
// Cost: none worth a word.
#pragma once

#include <string>

namespace plumb::lab::stability {

std::string picture_head(double width, double height, const std::string& title, const std::string& subtitle);

}  // namespace plumb::lab::stability
