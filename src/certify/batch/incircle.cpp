// Batches of incircle, and of points against one CircleSide.
#define PLUMB_BATCH_FORMULA InCircle
#include "certify/batch/ask.hpp"
#include "certify/batch/instruction_sets.hpp"
#include "certify/batch/one_by_one.hpp"
#include "certify/batch/replay_plan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/batch/incircle.cpp"
#include <hwy/foreach_target.h>

#include "certify/batch/kernels.hpp"

#if HWY_ONCE
#include "certify/batch/choice.hpp"

namespace plumb {

void incircle(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c,
              std::span<const Point2> d, std::span<Sign> out, Execution execution) {
  certify::batch::ask_points<predicates::InCircle>(std::array{a, b, c, d}, out, certify::batch::chosen_many_points,
                                                   execution);
}

void incircle(const Points2View& a, const Points2View& b, const Points2View& c, const Points2View& d,
              std::span<Sign> out, Execution execution) {
  certify::batch::ask_views<predicates::InCircle>(std::array{a, b, c, d}, out, certify::batch::chosen_many_coordinates,
                                                  execution);
}

void certify::side::decide_all(const CircleSide& side, std::span<const Point2> points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_points<predicates::InCircle>(side, points, out, certify::batch::chosen_points_against, execution);
}

void certify::side::decide_all(const CircleSide& side, const Points2View& points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_views<predicates::InCircle>(side, points, out, certify::batch::chosen_coordinates_against,
                                                  execution);
}

}  // namespace plumb
#endif
