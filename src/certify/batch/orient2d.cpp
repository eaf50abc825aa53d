// Batches of orient2d, and of points against one LineSide.
#define PLUMB_BATCH_FORMULA Orient2d
#include "certify/batch/ask.hpp"
#include "certify/batch/instruction_sets.hpp"
#include "certify/batch/one_by_one.hpp"
#include "certify/batch/replay_plan.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "certify/batch/orient2d.cpp"
#include <hwy/foreach_target.h>

#include "certify/batch/kernels.hpp"

#if HWY_ONCE
#include "certify/batch/choice.hpp"

namespace plumb {

void orient2d(std::span<const Point2> a, std::span<const Point2> b, std::span<const Point2> c, std::span<Sign> out,
              Execution execution) {
  certify::batch::ask_points<predicates::Orient2d>(std::array{a, b, c}, out, certify::batch::chosen_many_points,
                                                   execution);
}

void orient2d(const Points2View& a, const Points2View& b, const Points2View& c, std::span<Sign> out,
              Execution execution) {
  certify::batch::ask_views<predicates::Orient2d>(std::array{a, b, c}, out, certify::batch::chosen_many_coordinates,
                                                  execution);
}

void certify::side::decide_all(const LineSide& side, std::span<const Point2> points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_points<predicates::Orient2d>(side, points, out, certify::batch::chosen_points_against, execution);
}

void certify::side::decide_all(const LineSide& side, const Points2View& points, std::span<Sign> out,
                               Execution execution) {
  certify::batch::ask_views<predicates::Orient2d>(side, points, out, certify::batch::chosen_coordinates_against,
                                                  execution);
}

}  // namespace plumb
#endif
