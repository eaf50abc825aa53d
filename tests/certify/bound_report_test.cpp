// Is what a report says of a polynomial what was derived from it?
#include "plumb/certify/bound_report.hpp"

#include <gtest/gtest.h>

#include "certify/catalog.hpp"

namespace plumb {
namespace {

constexpr auto focal_paraboloid = [](auto x, auto y, auto z, auto f) { return f * z - x * x - y * y; };
constexpr auto unit_paraboloid = [](auto x, auto y, auto z) { return z - x * x - y * y; };

TEST(BoundReportTest, SaysInWordsWhatWasDerived) {
  EXPECT_EQ(to_string(bound_report<predicates::Orient2d>()),
            "orient2d: degree 2, 7 operations, 2 terms\n"
            "error: at most 3.000000002 * 2^-53 of the sum of the terms' magnitudes (0x1.80000003p-52)\n"
            "value: 109 bits for coordinates of 53 bits\n");
  EXPECT_EQ(to_string(bound_report(focal_paraboloid, Point3{1, 2, 3}, 4.0)),
            "sign_of: degree 2, 5 operations, 3 terms\n"
            "error: at most 2.000000002 * 2^-53 of the sum of the terms' magnitudes (0x1.000000038p-52)\n"
            "value: 108 bits for coordinates of 53 bits\n");
  EXPECT_EQ(to_string(bound_report(unit_paraboloid, Point3{1, 2, 3})),
            "sign_of: terms of different degree, up to 2, 4 operations, 3 terms\n"
            "error: at most 2.000000002 * 2^-53 of the sum of the terms' magnitudes (0x1.000000038p-52)\n"
            "value: 108 bits for coordinates of 53 bits\n");
  EXPECT_EQ(to_string(bound_report([](auto x, auto y) { return x - y; }, 1.0, 2.0)),
            "sign_of: degree 1, 1 operation, 1 term\n"
            "error: at most 0.000000001 * 2^-53 of the sum of the terms' magnitudes (0x1p-84)\n"
            "value: 54 bits for coordinates of 53 bits\n");
}

TEST(BoundReportTest, AgreesWithTheCatalog) {
  for (const CatalogEntry& e : catalog()) {
    const BoundReport r = bound_report(e.name, e.program, e.filter_constant);
    EXPECT_EQ(r.degree, e.degree) << e.name;
    EXPECT_EQ(r.homogeneous, e.homogeneous) << e.name;
    EXPECT_EQ(r.operations, e.program.instructions.size()) << e.name;
    EXPECT_EQ(r.constant, e.filter_constant) << e.name;
    EXPECT_EQ(r.value_bits, e.value_bits(53)) << e.name;
    EXPECT_GE(r.terms, 1) << e.name;
  }
}

}  // namespace
}  // namespace plumb
