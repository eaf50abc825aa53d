#include "tool/terminal/suggestion.hpp"

#include <algorithm>

namespace plumb::tool {
namespace {

std::size_t changes_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d.back().back();
}

constexpr std::size_t longest = 64;  // of words that are worth comparing

}  // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known) {
  if (word.empty() || word.size() > longest) return "";
  std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
  std::string_view nearest;
  for (const std::string& k : known) {
    const std::size_t changes = changes_between(word, k);
    if (changes >= least) continue;
    least = changes;
    nearest = k;
  }
  if (!nearest.empty() && least == 1) return std::string(nearest);
  const auto begun = std::ranges::find_if(known, [&](const std::string& k) { return k.starts_with(word); });
  return begun == known.end() ? std::string(nearest) : *begun;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known) {
  const std::string nearest = nearest_word(word, known);
  return nearest.empty() ? "" : " (did you mean " + nearest + "?)";
}

}  // namespace plumb::tool
