#include "tool/doctor/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command doctor_command(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("doctor", "Look whether this machine is as the proofs assume.");
  return {parser, doctor_manual, run_doctor};
}

}  // namespace plumb::tool
