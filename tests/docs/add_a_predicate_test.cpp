// Is a predicate added in the places that docs/add_a_predicate.md names, and does the rest follow?  Adds the page's
// formula to a copy of predicates/, builds its part of the catalog with it, and asks the catalog.
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/catalog.hpp"
#include "docs/markdown.hpp"
#include "tool/run_program.hpp"

namespace plumb::docs {
namespace {

const fs::path tree = PLUMB_SOURCE_DIR;

std::string block_for(const Document& document, const std::string& remark) {
  const auto found = std::ranges::find(document.blocks, remark, &Block::remark);
  return found == document.blocks.end() ? throw std::runtime_error("no block " + remark) : found->text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error("nowhere: " + what);
  return text.replace(at, what.size(), by);
}

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

TEST(AddAPredicate, TakesTheLinesShown) {
  const Document page = read_document(tree / "docs/add_a_predicate.md");
  const tool::Folder folder;
  const std::string formulas = folder / "include/plumb/predicates";
  fs::create_directories(folder / "include/plumb");
  fs::copy(tree / "predicates", formulas, fs::copy_options::recursive);

  const std::string formula = block_for(page, "from tests/docs/in_diametral_circle.hpp");
  write(formulas + "/in_diametral_circle.hpp",
        "#pragma once\n" + replaced(formula, "namespace mine {", "namespace plumb::predicates {"));
  std::string manifest = text_of(tree / "predicates/manifest.hpp");
  manifest =
      replaced(manifest, "#pragma once\n", "#pragma once\n#include <plumb/predicates/in_diametral_circle.hpp>\n");
  const std::string list = "  X(OrderOnAxis)";  // the list of its subject begins so
  std::string line = block_for(page, "add to predicates/manifest.hpp");
  line.replace(line.find_last_not_of('\n') + 1, line.npos, " \\\n");
  write(formulas + "/manifest.hpp", replaced(manifest, list, line + list));

  // Prints the new line of golden.txt as tests/certify/golden_test.cpp derives it, from the catalog where it can.
  write(folder / "main.cpp", R"(
#include <cstdio>
#include "certify/case_line.hpp"
#include "certify/catalog.hpp"
#include "plumb/certify/decide.hpp"
int main() {
  const plumb::CatalogEntry& e = *plumb::find_predicate("in_diametral_circle");
  std::printf("%s %d %zu %s %d %d %s\n", std::string(e.name).c_str(), e.degree, e.program.instructions.size(),
              plumb::hexadecimal(e.filter_constant).c_str(), e.value_bits(29), e.value_bits(61),
              plumb::filter_is_magnitude<plumb::predicates::InDiametralCircle> ? "magnitude" : "largest");
  const auto line = plumb::parse_case_line("in_diametral_circle 0 0 2 0 1 1 = 0");
  const plumb::Decision d = e.decide(line->coordinates);
  std::printf("%c %zu\n", plumb::to_char(d.sign), plumb::catalog().size());
}
)");
  // The list's part of the catalog is built anew, and takes the place of the one in the library.
  const std::string lines = "cd '" + (folder / "") +
                            "' && " PLUMB_COMPILE " -O0 -Iinclude " PLUMB_INCLUDES " -I" PLUMB_SOURCE_DIR
                            "/src main.cpp " PLUMB_SOURCE_DIR "/src/certify/catalog_directions.cpp " PLUMB_LIBRARIES
                            " -o main && ./main";
  const tool::Outcome outcome = tool::run(lines);
  EXPECT_EQ(outcome.out,
            block_for(page, "add to tests/certify/golden.txt") + "0 " + std::to_string(catalog().size() + 1) + "\n")
      << outcome.err;
}

}  // namespace
}  // namespace plumb::docs
