#include "bench/chart_rival.hpp"
#include "tool/program.hpp"

int main(int argc, char** argv) {
  const std::vector<plumb::tool::trial::Rival> rivals = plumb::bench::chart_rivals();
  return plumb::tool::run_program(argc, argv, rivals);
}
