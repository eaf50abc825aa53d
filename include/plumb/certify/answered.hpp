// What is said to a sign that is asked of what has none?  One sentence each.
//
// Laws: those of arith/no_answer.hpp.
// Cost: compile time only.
#pragma once

#include "plumb/arith/no_answer.hpp"

namespace plumb {

enum class Sign : signed char;
struct Point3;

PLUMB_NO_ANSWER(Sign,
                "plumb: orient2d takes three Point2, or points that are implicit; of many cases three spans of Point2 "
                "and a span of Sign to write to")
orient2d(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Sign,
                "plumb: orient3d takes four Point3, or points that are implicit; of many cases four spans of Point3 "
                "and a span of Sign to write to")
orient3d(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Sign,
                "plumb: incircle takes four Point2, or points that are implicit; of many cases four spans of Point2 "
                "and a span of Sign to write to")
incircle(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Sign,
                "plumb: insphere takes five Point3, or points that are implicit; of many cases five spans of Point3 "
                "and a span of Sign to write to")
insphere(PLUMB_ANYTHING) PLUMB_DELETED;

PLUMB_NO_ANSWER(Point3,
                "plumb: approximate takes what is known exactly: an implicit or posed point, or what intersection, "
                "closest points and contacts answer; the corners of a figure are doubles as they stand")
approximate(PLUMB_ANYTHING) PLUMB_DELETED;

/// No template, of which Clang would say it twice.
PLUMB_NO_ANSWER_TYPE(
    bool,
    "plumb: nothing is printed by <<: print the coordinates, p.x and p.y, a number of the enumeration, or "
    "what name_of and to_string say")
operator<<(const arith::Anything&, const arith::Anything&) PLUMB_DELETED;

}  // namespace plumb
