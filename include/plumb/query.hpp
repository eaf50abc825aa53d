// The face of questions about two figures: everything in plumb/query/.
#pragma once
#include "plumb/query/root.hpp"
