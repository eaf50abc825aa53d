#include "tool/doctor/command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>

#include "plumb/arith/error.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "tool/doctor/digest.hpp"

namespace plumb::tool {
namespace {

std::string line(const Style& style, bool good, std::string_view what, std::string_view state, std::string_view mend) {
  return good ? fmt::format("  {}   {:<18}{}\n", style.green("ok"), what, state)
              : fmt::format("  {}  {:<18}{}\n", style.red("BAD"), what, mend);
}

/// Which vectors batches take, or why they take none.
struct Batches {
  std::string taken, refused;
};
Batches batches() {
  try {
    const char* const asked = std::getenv("PLUMB_INSTRUCTION_SET");  // NOLINT(concurrency-mt-unsafe): never set here
    const bool is_asked = asked != nullptr && *asked != '\0';
    return {fmt::format("{}{}; PLUMB_INSTRUCTION_SET chooses one of {}", batch_instruction_set(),
                        is_asked ? ", which was asked for" : "", fmt::join(batch_instruction_sets(), " ")),
            {}};
  } catch (const Error& e) {
    return {{}, e.what()};
  }
}

}  // namespace

std::string doctor_report(const Environment& e, const Style& style) {
  std::string report = style.bold("plumb " + e.version) + "\n";
  report += fmt::format("  built by          {}\n  build             {}\n  instruction sets  {}\n\n", e.compiler,
                        e.build, fmt::join(e.instruction_sets, " "));
  report += line(style, e.rounds_to_nearest, "rounding mode", "to nearest",
                 "not to nearest; call std::fesetround(FE_TONEAREST) before asking for signs");
  report += line(style, e.keeps_subnormals, "subnormals", "kept",
                 "flushed to zero; clear FTZ and DAZ of the MXCSR (-ffast-math at link time sets them)");
  report += line(style, !e.contracts, "contraction", "off: a * b + c rounds twice",
                 "on: a * b + c is fused; compile with -ffp-contract=off");
  report += line(style, !e.fast_math, "fast-math", "off", "on; compile without -ffast-math and its parts");
  const Batches b = batches();
  report += line(style, b.refused.empty(), "batches", b.taken, b.refused);
  report += e.sound() ? "\nEverything is as the proofs assume.\n"
                      : fmt::format("\n{}\n", style.red("The proofs do not hold here: signs may be wrong."));
  return report;
}

int run_doctor(const DoctorOptions& options) {
  if (options.digest)
    return run_digest(options.digest == "small" ? DigestSize::small : DigestSize::full, options.threads);
  const Environment environment = check_environment();
  say(doctor_report(environment, Style(stdout)));
  return environment.sound() && batches().refused.empty() ? 0 : 1;
}

}  // namespace plumb::tool
