// The program `plumb-lab`: how do the ways of answering geometric questions fare?  Charts, experiments, test vectors.
//
// Law: it runs as `plumb` does (tool/program/program.hpp), with commands of its own.
// Source: RTCD 11.2.
// Cost: none.
#pragma once

#include <span>
#include <vector>

#include "lab/stability/experiment.hpp"
#include "lab/trial/tasks.hpp"
#include "tool/program/program.hpp"

namespace plumb::lab {

/// `plumb-lab chart` tries these rivals as well, and `stability` these worlds; the installed program has none.
ProgramFacts laboratory_facts(std::span<const trial::Rival> rivals = {},
                              const std::vector<stability::WorldRival>& worlds = {});

}  // namespace plumb::lab
