#include "plumb/world/clashes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "c/handles.hpp"

using namespace plumb;
using c::guarded, c::need;

struct plumb_clashes {
  std::vector<std::vector<std::uint32_t>> meeting;
  std::vector<plumb_clash> each;
};

namespace {

std::vector<AskedPair> pairs_in(const plumb_clash_options& options, std::size_t parts) {
  need(options.pairs, options.pair_count, "options->pairs");
  std::vector<AskedPair> pairs;
  for (std::size_t i = 0; i < options.pair_count; ++i) {
    const plumb_clash_pair& p = options.pairs[i];
    const std::string name = "options->pairs[" + std::to_string(i) + "]";
    if (p.a >= parts || p.b >= parts || p.a == p.b)
      throw c::InvalidArgument(name + " is no pair of two of " + std::to_string(parts) + " parts");
    if (!std::isfinite(p.clearance)) throw NonFinite(name + ".clearance is not finite");
    AskedPair& pair = pairs.emplace_back(AskedPair{std::min(p.a, p.b), std::max(p.a, p.b), {}});
    if (p.clearance >= 0) pair.clearance = p.clearance;
  }
  return pairs;
}

void add_clash(const PartClash& pair, plumb_clashes& to) {
  const Clash& from = pair.clash;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::uint32_t>& meeting = to.meeting.emplace_back();
  for (const TrianglePair& p : from.meeting) meeting.insert(meeting.end(), {p.a, p.b});
  plumb_clash& told = to.each.emplace_back();
  told.a = pair.a;
  told.b = pair.b;
  told.kind = static_cast<std::int32_t>(from.kind);
  told.inner = from.inner ? static_cast<std::int32_t>(*from.inner) : -1;
  c::copy(told.place, from.place);
  told.distance = from.distance.value_or(none);
  told.volume = from.volume.value_or(none);
  const ClashDepth depth = from.depth.value_or(ClashDepth{none, none, {none, none, none}});
  told.depth_lower = depth.lower;
  told.depth_upper = depth.upper;
  c::copy(told.direction, depth.direction);
  told.meeting = meeting.data();  // which stays where it is when the vector around it grows
  told.meeting_count = from.meeting.size();
}

}  // namespace

extern "C" {

plumb_status plumb_find_clashes(const plumb_mesh* const* parts, std::size_t count, const plumb_clash_options* options,
                                const plumb_progress* progress, plumb_clashes** clashes) {
  return guarded("plumb_find_clashes", [&] {
    need(parts, count, "parts");
    need(clashes, "clashes");
    if (options != nullptr) c::need_size(options, "options");
    std::vector<TriangleMesh> meshes;
    for (std::size_t i = 0; i < count; ++i) {
      need(parts[i], ("parts[" + std::to_string(i) + "]").c_str());
      meshes.push_back(parts[i]->mesh);
    }
    ClashesOptions how;
    how.progress = c::progress_of(progress);
    if (options != nullptr) {
      if (!std::isfinite(options->clearance)) throw NonFinite("options->clearance is not finite");
      if (options->clearance >= 0) how.clearance = options->clearance;
      how.measure = options->measures != 0;
    }
    const bool all = options == nullptr || (options->pairs == nullptr && options->pair_count == 0);
    if (!all) how.clearance.reset();  // pairs have their own
    const Clashes found =
        all ? find_clashes(meshes, how) : find_clashes(meshes, pairs_in(*options, meshes.size()), how);
    auto made = std::make_unique<plumb_clashes>();
    for (const PartClash& pair : found.found) add_clash(pair, *made);
    *clashes = made.release();
  });
}

plumb_status plumb_clashes_of(const plumb_clashes* clashes, const plumb_clash** each, std::size_t* count) {
  return guarded("plumb_clashes_of", [&] {
    need(clashes, "clashes");
    need(each, "each");
    need(count, "count");
    *each = clashes->each.data();
    *count = clashes->each.size();
  });
}

void plumb_clashes_destroy(plumb_clashes* clashes) { delete clashes; }

}  // extern "C"
