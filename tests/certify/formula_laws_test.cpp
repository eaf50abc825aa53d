// The laws that the headers of predicates/ state: which arguments may be swapped or negated, and what becomes of the
// sign.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/battery.hpp"

namespace plumb::battery {
namespace {

struct Law {
  std::string_view predicate;
  std::string_view order;   // argument i becomes the one of this letter
  std::string_view negate;  // these letters, before they are moved
  Sign times;               // what becomes of the sign
};

constexpr Sign keeps = Sign::positive, flips = Sign::negative;

constexpr Law laws[]{
    {"order_on_axis", "ba", "", flips},
    {"order_on_axis", "ba", "ab", keeps},
    {"order_along_direction2d", "bac", "", flips},
    {"order_along_direction2d", "abc", "c", flips},
    {"order_along_direction3d", "bac", "", flips},
    {"order_along_direction3d", "abc", "c", flips},
    {"order_along_line2d", "bacd", "", flips},
    {"order_along_line2d", "abdc", "", flips},
    {"order_along_line2d", "cdab", "", keeps},
    {"order_along_line3d", "bacd", "", flips},
    {"order_along_line3d", "cdab", "", keeps},
    {"dot2d", "ba", "", keeps},
    {"dot2d", "ab", "a", flips},
    {"dot3d", "ba", "", keeps},
    {"dot3d", "ab", "b", flips},
    {"angle2d", "cba", "", keeps},
    {"angle3d", "cba", "", keeps},
    {"cross2d", "ba", "", flips},
    {"cross2d", "ab", "a", flips},
    {"cross_x", "ba", "", flips},
    {"cross_y", "ba", "", flips},
    {"cross_z", "ba", "", flips},
    {"orient_x", "bac", "", flips},
    {"orient_y", "bca", "", keeps},
    {"orient_z", "acb", "", flips},
    {"compare_distance2d", "bacd", "", keeps},
    {"compare_distance2d", "cdab", "", flips},
    {"compare_distance3d", "abdc", "", keeps},
    {"compare_distance3d", "cdab", "", flips},
    {"compare_distance_from2d", "acb", "", flips},
    {"compare_distance_from3d", "acb", "", flips},
    {"distance_against2d", "bac", "c", keeps},
    {"distance_against3d", "bac", "c", keeps},
    {"signed_line_distance", "bacd", "", flips},
    {"signed_line_distance", "abdc", "", flips},
    {"line_distance_sum", "bacd", "", flips},
    {"line_distance_sum", "abdc", "", keeps},
    {"compare_line_distance", "bacd", "", keeps},
    {"compare_line_distance", "abdc", "", flips},
    {"line_distance_against2d", "bacd", "d", keeps},
    {"line_distance_against3d", "bacd", "d", keeps},
    {"compare_point_line2d", "badce", "", keeps},
    {"compare_point_line3d", "badce", "", keeps},
    {"compare_line_line2d", "bacedf", "", keeps},
    {"compare_line_line2d", "defabc", "", flips},
    {"compare_line_line3d", "bacedf", "", keeps},
    {"compare_line_line3d", "defabc", "", flips},
    {"side_of_line", "abc", "ab", flips},
    {"side_of_line", "cba", "", keeps},
    {"side_of_plane", "abc", "ab", flips},
    {"normal_distance_against2d", "abcd", "ab", keeps},
    {"normal_distance_against2d", "abcd", "d", keeps},
    {"normal_distance_against3d", "abcd", "ab", keeps},
    {"signed_plane_distance", "bacde", "", flips},
    {"signed_plane_distance", "bcade", "", keeps},
    {"signed_plane_distance", "abced", "", flips},
    {"plane_distance_sum", "bacde", "", flips},
    {"plane_distance_sum", "abced", "", keeps},
    {"plane_distance_against", "bacde", "e", keeps},
    {"plane_distance_against", "bcade", "", keeps},
    {"compare_point_plane", "badcef", "", keeps},
    {"compare_point_plane", "abdecf", "", keeps},
    {"compare_line_plane", "bacedfg", "", keeps},
    {"compare_line_plane", "abcefdg", "", keeps},
    {"compare_plane_plane", "bacdfegh", "", keeps},
    {"compare_plane_plane", "efghabcd", "", flips},
    {"in_smallest_circle", "bac", "", keeps},
    {"in_smallest_sphere2", "bac", "", keeps},
    {"in_smallest_sphere3", "bacd", "", keeps},
    {"in_smallest_sphere3", "bcad", "", keeps},
    {"power_circle", "bacd", "", flips},
    {"power_circle", "abdc", "", flips},
    {"power_circle", "bcad", "", keeps},
    {"power_sphere", "bacde", "", flips},
    {"power_sphere", "abced", "", flips},
    {"power_sphere", "bcdea", "", keeps},
    {"compare_power2d", "acb", "", flips},
    {"compare_power3d", "acb", "", flips},
    {"power_product2d", "ba", "", keeps},
    {"power_product3d", "ba", "", keeps},
    {"determinant2", "ba", "", flips},
    {"determinant2", "ab", "a", flips},
    {"determinant3", "bca", "", keeps},
    {"determinant3", "abc", "b", flips},
    {"determinant4", "abdc", "", flips},
    {"determinant4", "abcd", "d", flips},
    {"determinant5", "bacde", "", flips},
    {"determinant5", "bcdea", "e", flips},
};

std::vector<double> applied(const CatalogEntry& e, const Law& law, std::span<const double> p) {
  std::vector<double> moved;
  for (const char letter : law.order) {
    const auto argument = static_cast<std::size_t>(letter - 'a');
    std::size_t first = 0;
    for (std::size_t k = 0; k < argument; ++k) first += static_cast<std::size_t>(e.arguments[k]);
    const double factor = law.negate.find(letter) == law.negate.npos ? 1 : -1;
    for (int k = 0; k < e.arguments[argument]; ++k) moved.push_back(factor * p[first + static_cast<std::size_t>(k)]);
  }
  return moved;
}

// Cases of every family, tiny ones, and ones at and near the formula's zeros.
template <class Visit>
void for_each_case(const CatalogEntry& e, const Visit& visit) {
  const std::uint64_t each = sanitized ? 10 : 60;
  std::vector<double> p(e.arity());
  for (std::uint64_t i = 0; i < each; ++i) {
    Entropy entropy(start_of(e) + 1, i);
    for (const FamilyInfo& f : families) {
      fill_arguments(e, f.family, p, entropy);
      visit(p);
    }
    fill_tiny(2, p, entropy);
    visit(p);
    fill_at_zero(e, p, entropy);
    visit(p);
    fill_near_zero(e, p, entropy);
    visit(p);
  }
}

TEST(FormulaLawsTest, SwappingAndNegatingArgumentsFlipsOrKeepsTheSign) {
  for (const Law& law : laws) {
    const CatalogEntry* e = find_predicate(law.predicate);
    ASSERT_NE(e, nullptr) << law.predicate;
    ASSERT_EQ(law.order.size(), e->arguments.size()) << law.predicate;
    for_each_case(*e, [&](const std::vector<double>& p) {
      EXPECT_EQ(e->decide(applied(*e, law, p)).sign, law.times * e->decide(p).sign)
          << law.order << " negating " << law.negate << ": " << case_line(*e, p);
    });
  }
}

// A homogeneous formula of degree n is multiplied by the n-th power of a common factor.
TEST(FormulaLawsTest, CommonFactorsActByTheDegree) {
  for (const CatalogEntry& e : catalog()) {
    if (!e.homogeneous) continue;
    const Sign of_minus_one = e.degree % 2 == 0 ? keeps : flips;
    for_each_case(e, [&](const std::vector<double>& p) {
      std::vector<double> negated = p, scaled = p;
      bool exact = true;
      for (double& x : negated) x = -x;
      for (double& x : scaled) {
        const double was = x;
        x = std::ldexp(x, -3);
        exact = exact && std::ldexp(x, 3) == was;
      }
      const Sign sign = e.decide(p).sign;
      EXPECT_EQ(e.decide(negated).sign, of_minus_one * sign) << case_line(e, p);
      if (exact) {
        EXPECT_EQ(e.decide(scaled).sign, sign) << case_line(e, p);
      }
    });
  }
}

}  // namespace
}  // namespace plumb::battery
