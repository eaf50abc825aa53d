// Reports about figures in motion: contacts that are missed, that are none, or at the wrong time.
#include <gtest/gtest.h>

#include <array>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb::docs {
namespace {

/// The time, of which [0, 1] is all.
std::string told_time(const std::optional<Contact>& contact) { return contact ? "at " + told(contact->time) : "never"; }

constexpr std::array cases{
    Case{"dimforge/ncollide#214",
         [] {
           const Translating<Aabb2> moving{{{-1, -1}, {1, 1}}, {16, 0}};
           return told_time(first_contact(moving, Aabb2{{9, -1.5}, {11, 1.5}}));
         }},
    Case{"dimforge/ncollide#141",
         [] {
           const Aabb3 lower{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, upper{{-0.5, 0.6, -0.5}, {0.5, 1.6, 0.5}};
           const auto moved = [&](double by) {
             return told_time(first_contact(Translating{upper, {0, by, 0}}, lower));
           };
           EXPECT_EQ(first_contact_time(Translating{upper, {0, -1, 0}}, lower), Rational(0.6) - Rational(0.5));
           return moved(0) + ", " + moved(1) + ", " + moved(-1);
         }},
    Case{"dimforge/parry#19",
         [] {
           const Pose2 quarter{{{{0, -1}, {1, 0}}}, {0, 0}};  // clockwise, exactly
           const Posed wall{Segment2{{1, 1}, {-1, 1}}, quarter};
           const auto moved = [&](const Vector2& by) {
             return told_time(
                 first_contact(Translating{Posed{Circle2{{0, 0}, 0.5}, Pose2{{{{1, 0}, {0, 1}}}, {0, 0}}}, by}, wall));
           };
           return moved({1, 0}) + ", " + moved({0, 1});
         }},
    Case{"dimforge/parry#429",
         [] {
           const Aabb3 floor{{-500, -1, -500}, {500, 1, 500}};
           const double radius = 0.5166;
           const Translating<Sphere3> falling{{{123.25, 10, -321.75}, radius}, {0, -20, 0}};
           const Rational time = (Rational(9) - Rational(radius)) / Rational(20);
           EXPECT_EQ(first_contact_time(falling, floor), time);
           return told_time(first_contact(falling, floor));
         }},
    Case{"rustgd/collision-rs#111",
         [] {
           const Translating<Circle2> ball{{{158.0754, -5.287695}, 1}, {159.39767 - 158.0754, -6.6099815 + 5.287695}};
           const Obb2 upright{{164.1754, -13.967552}, {Vector2{0, 1}, Vector2{-1, 0}}, {25, 5}};
           const Rational way = Rational(164.1754) - Rational(6) - Rational(158.0754);
           EXPECT_EQ(first_contact_time(ball, upright), way / Rational(159.39767 - 158.0754));
           return told_time(first_contact(ball, upright));
         }},
    Case{"erincatto/box2d#50",
         [] {
           const Translating<Aabb2> moving{{{0, 0}, {2, 2}}, {5, 0}};
           return told_time(first_contact(moving, Triangle2{{1, 1}, {4, 1}, {4, 4}}));
         }},
    Case{"NVIDIAGameWorks/PhysX#597",
         [] {
           const Triangle3 t{{7.33294010F, 79.6109009F, -26.9337997F},
                             {7.61456013F, 80.2574005F, -27.3008995F},
                             {7.33294010F, 80.2574005F, -26.9337997F}};
           const double half = 0.340350509F, way = 0.149537891F, x = 7.74110079F, y = 80.8543167F, z = -27.2595482F;
           const Capsule3 upright{{x, y - half, z}, {x, y + half, z}, 0.265350759F};
           const Vector3 by{-0.929564953F * way, -0.0281119142F * way, 0.367584974F * way};
           const std::optional<Contact> contact = first_contact(Translating{upright, by}, t);
           EXPECT_NEAR(contact->time * way, 0.0944127962, 1e-4);  // as the report expects it
           return told_time(contact);
         }},
    Case{"jrouwe/JoltPhysics#886",
         [] {
           const Triangle3 sliver{{14.5536213F, 10.5973721F, -0.00600051880F},
                                  {14.5536213F, 10.5969315F, -3.18638134F},
                                  {14.5536213F, 10.5969315F, -5.18637228F}};
           const Translating<Sphere3> ball{{{14.8314590F, 8.19055080F, -4.30825043F}, 0.2F},
                                           {-0.0988006592F, 5.96046448e-08F, 0.000732421875F}};
           return told_time(first_contact(ball, sliver));
         }},
};

}  // namespace

std::span<const Case> motion_cases() { return cases; }

}  // namespace plumb::docs
