// Law 2 of degenerate/points.hpp, law 4 of degenerate/shape_pair.hpp: the same bits with every compiler and
// optimization level.  The numbers change only when a generator is changed on purpose; recorded failures by case number
// change their meaning with them.
#include <gtest/gtest.h>

#include <bit>
#include <map>
#include <string>

#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shape_pair.hpp"

namespace {

std::uint64_t mixed(std::uint64_t hash, double x) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15;
  return hash ^ (hash >> 32);  // so that the high bits of a double reach all bits of the hash
}

std::uint64_t hash_of(plumb::Family family) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const plumb::Degeneracy degeneracy : plumb::degeneracies) {
    for (std::uint64_t i = 0; i < 500; ++i) {
      plumb::Entropy entropy(1, i);
      const auto plane = plumb::coordinates2<4>(family, degeneracy, entropy);
      const auto space = plumb::coordinates3<5>(family, degeneracy, entropy);
      for (const double x : plane) hash = mixed(hash, x);
      for (const double x : space) hash = mixed(hash, x);
    }
  }
  return hash;
}

TEST(Golden, FirstCasesOfEveryFamily) {
  const std::map<std::string, std::uint64_t> golden = {
      {"grid", 0xe5543b8af0c35b76u},
      {"uniform", 0xc220305c694ef5e4u},
      {"float32", 0xf0edfe512a30faa3u},
      {"near_half", 0x74e8c07b193e427du},
      {"degenerate_short", 0x4b2566e43443eb7eu},
      {"degenerate_long", 0x24a3275c08714020u},
      {"off_by_ulps", 0x18cb17563bf3bc1du},
      {"repeated", 0x24ac227fc6bb2973u},
      {"wide", 0x40e6cf4ed510f91fu},
      {"extreme", 0x76e07dd08325b072u},
      {"mixture", 0x7d0fb0b70ff4f9e2u},
  };
  ASSERT_EQ(golden.size(), plumb::families.size());
  for (const auto& info : plumb::families) {
    EXPECT_EQ(hash_of(info.family), golden.at(std::string(info.name))) << info.name;
  }
}

TEST(Golden, FirstPairsOfAllShapes) {
  using namespace plumb::degenerate;
  std::uint64_t hash = 0xcbf29ce484222325, index = 0;
  for (const int dimension : {2, 3}) {
    for (const auto& a : shape_kinds) {
      for (const auto& b : shape_kinds) {
        for (const auto& position : positions) {
          if (!has_position(a.kind, b.kind, dimension, position.position)) continue;
          for (const Nearness nearness : {Nearness::exactly, Nearness::nearly}) {
            plumb::Entropy entropy(2, index++);
            const ShapePair pair = shape_pair(a.kind, b.kind, dimension, position.position, nearness, entropy);
            for (const double x : pair.a) hash = mixed(hash, x);
            for (const double x : pair.b) hash = mixed(hash, x);
          }
        }
      }
    }
  }
  EXPECT_EQ(hash, 0xc5f28f2e571fd37fu);
}

}  // namespace
