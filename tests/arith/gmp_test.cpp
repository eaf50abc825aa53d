// Are GMP's numbers and ours the same, there and back?
#include "plumb/arith/gmp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Gmp, ThereAndBack) {
  mpz_class large;
  mpz_ui_pow_ui(large.get_mpz_t(), 3, 500);
  for (const mpq_class& q :
       {mpq_class(0), mpq_class(-7), mpq_class(1, 3), mpq_class(-large, 1024), mpq_class(1, large)}) {
    EXPECT_EQ(mpq(rational(q)), q);
    EXPECT_EQ(rational(q).text(), q.get_str());
  }
  EXPECT_EQ(mpz(rational(large)), large);
  EXPECT_EQ(rational(large), Rational::from_text(large.get_str()));
  EXPECT_EQ(mpq(Rational(0.1)), mpq_class(0.1));
  mpq_class not_lowest;
  mpz_set_si(not_lowest.get_num_mpz_t(), 4);
  mpz_set_si(not_lowest.get_den_mpz_t(), -6);
  EXPECT_EQ(rational(not_lowest), Rational(-2, 3));
  EXPECT_EQ(mpz(Rational(7, 2).floor()), 3);
}

TEST(Gmp, WhatIsNoneThrows) {
  mpq_class by_zero;
  mpz_set_si(by_zero.get_den_mpz_t(), 0);
  EXPECT_THROW(rational(by_zero), DegeneratePoint);
  EXPECT_THAT([] { return mpz(Rational(7, 2)); }, ThrowsMessage<Error>(HasSubstr("7/2 is no integer")));
}

}  // namespace
}  // namespace plumb
