// Which of the compiled filters does this processor take?  Included once by each file of filters, after kernels.hpp.
//
// The choice is looked up at each call, not kept: finding out what the processor has takes long, and waits for the
// first call of all.
#include "certify/batch/chosen_target.hpp"

namespace plumb::certify::batch {
namespace {

PLUMB_EXPORT(many_points);
PLUMB_EXPORT(many_coordinates);
PLUMB_EXPORT(points_against);
PLUMB_EXPORT(coordinates_against);

#define PLUMB_BATCH_CHOSEN(filter)                                                                         \
  [](const void* given, const double* const* at, std::size_t n, signed char* out, std::uint32_t* unsure) { \
    return PLUMB_DISPATCH(filter)(given, at, n, out, unsure);                                              \
  }
constexpr Filter chosen_many_points = PLUMB_BATCH_CHOSEN(many_points);
constexpr Filter chosen_many_coordinates = PLUMB_BATCH_CHOSEN(many_coordinates);
constexpr Filter chosen_points_against = PLUMB_BATCH_CHOSEN(points_against);
constexpr Filter chosen_coordinates_against = PLUMB_BATCH_CHOSEN(coordinates_against);
#undef PLUMB_BATCH_CHOSEN

}  // namespace
}  // namespace plumb::certify::batch
