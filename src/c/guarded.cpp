#include "c/guarded.hpp"

#include <exception>
#include <new>

#include "plumb/query/body/any_figure.hpp"
#include "plumb/space/bvh/progress.hpp"
#include "plumb/surface/file/mesh_file.hpp"

namespace plumb::c {
namespace {

/// The text is in a buffer of the thread, so that memory that has run out can be told.
constexpr std::size_t longest_text = 4096;
thread_local char last_error[longest_text] = "";

plumb_status keep(plumb_status status, const char* function, const char* text) noexcept {
  std::size_t at = 0;
  const auto append = [&at](const char* part) {
    while (*part != '\0' && at + 1 < longest_text) last_error[at++] = *part++;
  };
  append(function);
  append(": ");
  append(text);
  last_error[at] = '\0';
  return status;
}

}  // namespace

plumb_status status_of_current_exception(const char* function) noexcept {
  try {
    throw;
  } catch (const InvalidArgument& e) {
    return keep(PLUMB_INVALID_ARGUMENT, function, e.what());
  } catch (const NonFinite& e) {
    return keep(PLUMB_NON_FINITE, function, e.what());
  } catch (const InvalidShape& e) {
    return keep(PLUMB_INVALID_SHAPE, function, e.what());
  } catch (const UnevenPose& e) {
    return keep(PLUMB_UNSUPPORTED, function, e.what());
  } catch (const Unsupported& e) {
    return keep(PLUMB_UNSUPPORTED, function, e.what());
  } catch (const MeshFileError& e) {
    return keep(PLUMB_FILE, function, e.what());
  } catch (const Cancelled& e) {
    return keep(PLUMB_CANCELLED, function, e.what());
  } catch (const std::bad_alloc&) {
    return keep(PLUMB_OUT_OF_MEMORY, function, "memory has run out");
  } catch (const std::exception& e) {
    return keep(PLUMB_FAILED, function, e.what());
  } catch (...) {
    return keep(PLUMB_FAILED, function, "an error that says nothing about itself");
  }
}

}  // namespace plumb::c

extern "C" const char* plumb_last_error(void) { return plumb::c::last_error; }
extern "C" const char* plumb_version(void) { return PLUMB_VERSION; }
