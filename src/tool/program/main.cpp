#include "tool/program/program.hpp"

int main(int argc, char** argv) { return plumb::tool::run_program(plumb::tool::plumb_facts(), argc, argv); }
