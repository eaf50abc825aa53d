// Batches of orient3d, and of points against one PlaneSide.
#define PLUMB_BATCH_FORMULA Orient3d
#include "certify/batch/ask.hpp"
#include "certify/batch/instruction_sets.hpp"
#include "certify/batch/one_by_one.hpp"
#include "certify/batch/replay_plan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/batch/orient3d.cpp"
#include <hwy/foreach_target.h>

#include "certify/batch/kernels.hpp"

#if HWY_ONCE
#include "certify/batch/choice.hpp"

namespace plumb {

void orient3d(std::span<const Point3> a, std::span<const Point3> b, std::span<const Point3> c,
              std::span<const Point3> d, std::span<Sign> out, Execution execution) {
  certify::batch::ask_points<predicates::Orient3d>(std::array{a, b, c, d}, out, certify::batch::chosen_many_points,
                                                   execution);
}

void orient3d(const Points3View& a, const Points3View& b, const Points3View& c, const Points3View& d,
              std::span<Sign> out, Execution execution) {
  certify::batch::ask_views<predicates::Orient3d>(std::array{a, b, c, d}, out, certify::batch::chosen_many_coordinates,
                                                  execution);
}

void certify::side::decide_all(const PlaneSide& side, std::span<const Point3> points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_points<predicates::Orient3d>(side, points, out, certify::batch::chosen_points_against, execution);
}

void certify::side::decide_all(const PlaneSide& side, const Points3View& points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_views<predicates::Orient3d>(side, points, out, certify::batch::chosen_coordinates_against,
                                                  execution);
}

}  // namespace plumb
#endif
