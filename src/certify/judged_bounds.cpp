#include "plumb/certify/judged_bounds.hpp"

#include <set>

#include "certify/case_line.hpp"

namespace plumb {
namespace {

void append_powers(std::string& line, std::uint64_t powers, const Track& track) {
  for (std::size_t s = 0; s < Track::scales; ++s) {
    const int own = Track::power_in(powers, s, 0), next = Track::power_in(powers, s, 1),
              last = Track::power_in(powers, s, 2);
    if (own == 0 && next == 0 && last == 0) continue;
    line.append(" s").append(std::to_string(s));
    if (track.is_of_axes(s)) {
      line.append("(").append(std::to_string(own)).append(",").append(std::to_string(next)).append(",");
      line.append(std::to_string(last)).append(")");
    } else if (own != 1) {
      line.append("^").append(std::to_string(own));
    }
  }
}

std::set<std::string>& judged_so_far() {
  thread_local std::set<std::string> lines;
  return lines;
}

}  // namespace

std::string to_string(const Track& track) {
  std::string line = hexadecimal(arith::track::threshold(track));
  append_powers(line, track.powers, track);
  if (track.others != 0) {
    line.append(" +");
    append_powers(line, track.others, track);
  }
  return line;
}

void BoundListener::judged(const Track& track) { judged_so_far().insert(to_string(track)); }

std::vector<std::string> BoundListener::taken() {
  std::vector<std::string> lines(judged_so_far().begin(), judged_so_far().end());
  judged_so_far().clear();
  return lines;
}

}  // namespace plumb
