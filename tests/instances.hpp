// What is compiled once and not in each of 400 tests?  Instances of the standard's templates and GoogleTest's that a
// quarter of the tests and more ask for: C++20 makes the members of std::string constexpr, so that libstdc++ leaves even
// those to each file.  It is precompiled with the tests' other headers; instances.cpp, which every test links, compiles
// them.
#pragma once

#include <gmock/gmock.h>

#include <array>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "plumb/arith/point.hpp"

#ifndef PLUMB_INSTANCE
#define PLUMB_INSTANCE extern template
#endif

PLUMB_INSTANCE class std::basic_string<char>;
PLUMB_INSTANCE class std::unique_ptr<std::string>;
PLUMB_INSTANCE class std::unique_ptr<std::stringstream>;
PLUMB_INSTANCE class std::vector<double>;
PLUMB_INSTANCE class std::vector<int>;
PLUMB_INSTANCE class std::vector<unsigned>;
PLUMB_INSTANCE class std::vector<std::size_t>;
PLUMB_INSTANCE class std::vector<std::string>;
PLUMB_INSTANCE class std::vector<std::array<unsigned, 3>>;
PLUMB_INSTANCE class std::vector<plumb::Point2>;
PLUMB_INSTANCE class std::vector<plumb::Point3>;
PLUMB_INSTANCE class std::vector<plumb::Vector2>;
PLUMB_INSTANCE class std::vector<plumb::Vector3>;

namespace std {
PLUMB_INSTANCE string operator+(string&&, string&&);
PLUMB_INSTANCE string operator+(string&&, const string&);
PLUMB_INSTANCE string operator+(const string&, const char*);
PLUMB_INSTANCE string operator+(const char*, const string&);
PLUMB_INSTANCE string operator+(string&&, const char*);
PLUMB_INSTANCE string operator+(const char*, string&&);
}  // namespace std

namespace testing {
namespace internal {
PLUMB_INSTANCE class SuiteApiResolver<Test>;
PLUMB_INSTANCE class MatcherBase<const std::string&>;
PLUMB_INSTANCE class PredicateFormatterFromMatcher<PolymorphicMatcher<HasSubstrMatcher<std::string>>>;
}  // namespace internal

PLUMB_INSTANCE class PolymorphicMatcher<internal::HasSubstrMatcher<std::string>>::MonomorphicImpl<const std::string&>;
PLUMB_INSTANCE std::string PrintToString(const bool&);
PLUMB_INSTANCE std::string PrintToString(const char* const&);
PLUMB_INSTANCE std::string PrintToString(const double&);
PLUMB_INSTANCE std::string PrintToString(const int&);
PLUMB_INSTANCE std::string PrintToString(const std::size_t&);
PLUMB_INSTANCE std::string PrintToString(const std::string&);
PLUMB_INSTANCE std::string PrintToString(const unsigned&);
PLUMB_INSTANCE AssertionResult& AssertionResult::operator<<(const char* const&);
PLUMB_INSTANCE AssertionResult& AssertionResult::operator<<(const std::string&);

namespace internal {
#define PLUMB_COMPARED(A, B)                                                                       \
  PLUMB_INSTANCE AssertionResult CmpHelperEQ(const char*, const char*, const A&, const B&);        \
  PLUMB_INSTANCE AssertionResult CmpHelperEQFailure(const char*, const char*, const A&, const B&); \
  PLUMB_INSTANCE AssertionResult CmpHelperOpFailure(const char*, const char*, const A&, const B&, const char*)
PLUMB_COMPARED(bool, bool);
PLUMB_COMPARED(double, double);
PLUMB_COMPARED(double, int);
PLUMB_COMPARED(int, int);
PLUMB_COMPARED(std::size_t, int);
PLUMB_COMPARED(std::size_t, std::size_t);
PLUMB_COMPARED(std::size_t, unsigned);
PLUMB_COMPARED(std::string, std::string);
PLUMB_COMPARED(unsigned, unsigned);
#undef PLUMB_COMPARED
}  // namespace internal
}  // namespace testing
