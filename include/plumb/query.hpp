// The face of questions about two figures: everything in plumb/query/.
#pragma once
#include "plumb/query/overlap2.hpp"
#include "plumb/query/root.hpp"
