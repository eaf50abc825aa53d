// Laws 1 to 4 of degenerate/cloud.hpp, by rational signs and by counting.
#include "plumb/degenerate/cloud.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "degenerate/rational_signs.hpp"

namespace plumb {
namespace {

std::vector<double> coordinates(Cloud cloud, std::size_t dimension, std::size_t count, std::uint64_t index) {
  Entropy entropy(77, index);
  std::vector<double> all;
  if (dimension == 2) {
    for (const Point2& p : cloud2(cloud, count, entropy)) all.insert(all.end(), {p.x, p.y});
  } else {
    for (const Point3& p : cloud3(cloud, count, entropy)) all.insert(all.end(), {p.x, p.y, p.z});
  }
  return all;
}

class Clouds : public testing::TestWithParam<std::tuple<CloudInfo, std::size_t>> {};

TEST_P(Clouds, AreFiniteAndOfTheSizeAskedFor) {
  const auto& [info, dimension] = GetParam();
  for (const std::size_t count : {0u, 1u, 2u, 5u, 100u}) {
    const std::vector<double> x = coordinates(info.cloud, dimension, count, count);
    EXPECT_EQ(x.size(), count * dimension);
    for (const double c : x) EXPECT_TRUE(std::isfinite(c));
  }
}

// What every `points` of a cloud are, in rationals: 0 for degenerate.
int sign_of_first(std::span<const double> x, std::size_t dimension, std::size_t points, bool round) {
  std::vector<std::size_t> all(points);
  for (std::size_t i = 0; i < points; ++i) all[i] = i;
  return round ? plumb_test::sign_of_round(x, dimension, all) : plumb_test::sign_of_flat(x, dimension, all);
}

TEST(CloudsTest, AreDegenerateAsTheyAreCalled) {
  for (const std::size_t dimension : {2u, 3u}) {
    for (const auto& [cloud, round] : std::map<Cloud, bool>{{Cloud::plane, false},
                                                            {Cloud::line, false},
                                                            {Cloud::place, false},
                                                            {Cloud::circle, true},
                                                            {Cloud::exact_sphere, true}}) {
      const std::size_t points = dimension + (round ? 2 : 1);
      for (std::uint64_t index = 0; index < 40; ++index) {
        EXPECT_EQ(sign_of_first(coordinates(cloud, dimension, points + 3, index), dimension, points, round), 0)
            << name_of(cloud) << ' ' << dimension << ' ' << index;
      }
    }
  }
}

TEST(CloudsTest, RoundedOnesAreAllButDegenerate) {
  int zeros = 0, cases = 0;
  for (std::uint64_t index = 0; index < 40; ++index, ++cases) {
    const std::vector<double> x = coordinates(Cloud::skew_plane, 3, 4, index);
    zeros += sign_of_first(x, 3, 4, false) == 0;
    const double det = (x[0] * (x[4] * x[8] - x[5] * x[7]) - x[1] * (x[3] * x[8] - x[5] * x[6])) +
                       x[2] * (x[3] * x[7] - x[4] * x[6]);  // of three of them with the origin, which is on it
    EXPECT_LT(std::fabs(det), 0x1p-30);
  }
  EXPECT_LT(zeros, cases / 4);
}

std::size_t different(const std::vector<double>& x, std::size_t dimension) {
  std::set<std::vector<double>> all;
  for (std::size_t i = 0; i < x.size(); i += dimension) {
    const auto from = x.begin() + static_cast<std::ptrdiff_t>(i);
    all.insert(std::vector<double>(from, from + static_cast<std::ptrdiff_t>(dimension)));
  }
  return all.size();
}

TEST(CloudsTest, HaveEqualPointsWhereThereAreNoMore) {
  for (const std::size_t dimension : {2u, 3u}) {
    for (const CloudInfo& info : clouds) {
      const std::size_t n = different(coordinates(info.cloud, dimension, 2000, 3), dimension);
      SCOPED_TRACE(testing::Message() << info.name << ' ' << dimension << ": " << n);
      const bool circle = info.cloud == Cloud::circle || (info.cloud == Cloud::exact_sphere && dimension == 2);
      if (info.cloud == Cloud::place) {
        EXPECT_EQ(n, 1u);
      } else if (circle) {
        EXPECT_GT(n, 16u);
        EXPECT_LE(n, 128u);
      } else if (info.cloud == Cloud::prism || info.cloud == Cloud::facets) {
        EXPECT_GT(n, dimension == 2 ? 200u : 1800u);
      } else {
        EXPECT_GT(n, 1900u);
      }
    }
  }
}

TEST(CloudsTest, LatticeHoldsEveryIntegerOfItsCube) {
  EXPECT_EQ(different(coordinates(Cloud::lattice, 3, 1000, 0), 3), 1000u);
  const std::vector<double> x = coordinates(Cloud::lattice, 3, 1000, 0);
  EXPECT_EQ(*std::max_element(x.begin(), x.end()), 9);
  EXPECT_EQ(*std::min_element(x.begin(), x.end()), 0);
}

// The same bits with every compiler: the numbers change only when a generator is changed on purpose.
TEST(CloudsTest, Golden) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::size_t dimension : {2u, 3u}) {
    for (const CloudInfo& info : clouds) {
      for (const double x : coordinates(info.cloud, dimension, 300, 1)) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
      }
    }
  }
  EXPECT_EQ(hash, 0x413052de31be290au);
}

INSTANTIATE_TEST_SUITE_P(All, Clouds, testing::Combine(testing::ValuesIn(clouds), testing::Values(2, 3)),
                         [](const auto& at) {
                           return std::string(std::get<0>(at.param).name) + std::to_string(std::get<1>(at.param));
                         });

}  // namespace
}  // namespace plumb
