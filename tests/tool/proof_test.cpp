// Does `plumb proof` write what Gappa proves, and say in words what it cannot write?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/catalog.hpp"
#include "plumb/certify/proof_script.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const CatalogEntry& insphere() { return *find_predicate("insphere"); }

std::string script_of(const CatalogEntry& e, ProofScale scale) {
  return proof_script(e.name, e.program, e.filter_constant, scale);
}

TEST(Proof, IsTheScriptOfTheLibrary) {
  const Outcome unit = run("$PLUMB proof insphere");
  EXPECT_EQ(unit.code, 0) << unit.err;
  EXPECT_EQ(unit.out, script_of(insphere(), ProofScale::unit));
  const Outcome every = run("$PLUMB proof --every-scale insphere");
  EXPECT_EQ(every.code, 0) << every.err;
  EXPECT_EQ(every.out, script_of(insphere(), ProofScale::every));
}

TEST(Proof, GoesToAFile) {
  const Folder folder;
  const Outcome o = run("$PLUMB proof orient3d --out '" + (folder / "orient3d.gappa") + "'");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(content(folder / "orient3d.gappa"), script_of(*find_predicate("orient3d"), ProofScale::unit));
}

TEST(Proof, IsFoundByGappa) {
  if (run("command -v gappa").code != 0) {
    std::puts("SKIPPED: gappa is not installed (apt-get install gappa), so no bound is proved here.");
    return;
  }
  for (const std::string options : {"", " --every-scale"}) {
    const Outcome o = run("$PLUMB proof insphere" + options + " | gappa");
    EXPECT_EQ(o.code, 0) << o.err;
  }
  EXPECT_NE(run("$PLUMB proof insphere | sed 's/ieee_64/ieee_32/' | gappa -Eno-auto-dichotomy").code, 0);
}

TEST(Proof, ListsEveryPredicate) {
  const Outcome o = run("$PLUMB proof --list");
  EXPECT_EQ(o.code, 0) << o.err;
  for (const CatalogEntry& e : catalog())
    EXPECT_THAT(o.out, HasSubstr(std::string(1, '\n').append(e.name).append(" ")));
  EXPECT_EQ(static_cast<std::size_t>(std::count(o.out.begin(), o.out.end(), '\n')), catalog().size() + 1);
  EXPECT_THAT(o.out, testing::ContainsRegex("\ninsphere +5 +77 +72  0x1\\.e0000002ap-50\n"));
}

void expect_refusal(const std::string& line, const std::string& words) {
  const Outcome o = run(line);
  EXPECT_EQ(o.code, 2) << line;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
  EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
}

TEST(Proof, IsRefusedByName) {
  expect_refusal("$PLUMB proof", "a predicate is expected, such as orient2d");
  expect_refusal("$PLUMB proof orient4d",
                 "there is no predicate 'orient4d' (did you mean orient2d?); there are orient2d, orient3d");
  expect_refusal("$PLUMB proof \"$(printf 'a\\033[1m')\"", "'a?[1m'");
  expect_refusal("$PLUMB proof orient2d orient3d", "'plumb proof --help' explains");
  expect_refusal("$PLUMB proof orient2d --list", "excludes");
  expect_refusal("$PLUMB proof --scale", "--scale");
  expect_refusal("$PLUMB proof orient2d --out /no/such/folder/file", "/no/such/folder/file");
  expect_refusal("$PLUMB proof orient2d >/dev/full", "cannot write standard output");
}

}  // namespace
}  // namespace plumb::tool
