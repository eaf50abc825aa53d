#include "lab/program/program.hpp"

int main(int argc, char** argv) { return plumb::tool::run_program(plumb::lab::laboratory_facts(), argc, argv); }
