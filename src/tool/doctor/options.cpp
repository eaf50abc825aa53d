#include "tool/doctor/command.hpp"
#include "tool/manual/command.hpp"

namespace plumb::tool {

Command doctor_command(CLI::App& program) {
  const auto options = std::make_shared<DoctorOptions>();
  CLI::App* const parser = program.add_subcommand("doctor", "Look whether this machine is as the proofs assume.");
  parser
      ->add_option("--digest", options->digest,
                   "Answer questions of every kind, hash the answers and compare them with what they must be: "
                   "full, a million, or small, some 66,000; full where no size is given.")
      ->expected(0, 1)
      ->default_str("full")
      ->check(CLI::IsMember({"full", "small"}))
      ->type_name("SIZE");
  add_threads(parser, options->threads);
  return {parser, doctor_manual, [options] { return run_doctor(*options); }};
}

}  // namespace plumb::tool
