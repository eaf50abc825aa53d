// Batches of insphere, and of points against one SphereSide.
#define PLUMB_BATCH_FORMULA InSphere
#include "certify/batch/ask.hpp"
#include "certify/batch/instruction_sets.hpp"
#include "certify/batch/one_by_one.hpp"
#include "certify/batch/replay_plan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/batch/insphere.cpp"
#include <hwy/foreach_target.h>

#include "certify/batch/kernels.hpp"

#if HWY_ONCE
#include "certify/batch/choice.hpp"

namespace plumb {

void insphere(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<const Point3> e, std::span<Sign> out, Execution execution) {
  certify::batch::ask_points<predicates::InSphere>(std::array{a, b, c, d, e}, out, certify::batch::chosen_many_points,
                                                   execution);
}

void insphere(const Points3View& a, const Points3View& b, const Points3View& c, const Points3View& d,
              const Points3View& e, std::span<Sign> out, Execution execution) {
  certify::batch::ask_views<predicates::InSphere>(std::array{a, b, c, d, e}, out,
                                                  certify::batch::chosen_many_coordinates, execution);
}

void certify::side::decide_all(const SphereSide& side, std::span<const Point3> points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_points<predicates::InSphere>(side, points, out, certify::batch::chosen_points_against, execution);
}

void certify::side::decide_all(const SphereSide& side, const Points3View& points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_views<predicates::InSphere>(side, points, out, certify::batch::chosen_coordinates_against,
                                                  execution);
}

}  // namespace plumb
#endif
