// In whose words does the laboratory speak?  In the program's: tasks, methods and rounds (tool/trial/), and what a program
// needs to read arguments, write and draw (tool/terminal/, tool/drawing/, tool/manual/), by their own names.
//
// Law: nothing of the laboratory is known to the program.
// Source: none.
// Cost: none.
#pragma once

#include "tool/trial/task.hpp"

namespace plumb::lab {

using namespace tool;  // NOLINT(google-build-using-namespace): one program's parts are the other's

namespace trial {
using namespace tool::trial;   // NOLINT(google-build-using-namespace): here too
using tool::trial::as_answer;  // beside those of the laboratory
}  // namespace trial

}  // namespace plumb::lab
