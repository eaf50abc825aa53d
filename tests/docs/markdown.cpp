// Compiled once: regular expressions take a compiler five seconds.
#include "docs/markdown.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <stdexcept>

namespace plumb::docs {

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const fs::path& path) {
  std::string text;
  for (const std::string& line : lines_of(path)) text += line + '\n';
  return text;
}

std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') {
      anchor += '-';
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return anchor;
}

namespace {

/// Built once for each text.
const std::regex& regex_of(const std::string& pattern) {
  static std::map<std::string, std::regex> known;
  const auto found = known.find(pattern);
  return found != known.end() ? found->second : known.emplace(pattern, std::regex(pattern)).first->second;
}

void find_all(const std::string& line, const std::string& pattern, std::size_t number, std::vector<Link>& out) {
  for (const Match& match : matches_of(line, pattern)) out.push_back({match.first, number});
}

}  // namespace

std::vector<Match> matches_of(const std::string& text, const std::string& pattern) {
  const std::regex& regex = regex_of(pattern);
  std::vector<Match> all;
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    all.push_back({match->str(), (*match)[1], (*match)[2]});
  return all;
}

std::string without_matches(const std::string& text, const std::string& pattern) {
  return std::regex_replace(text, regex_of(pattern), "");
}

Document read_document(const fs::path& path) {
  const std::string remark = "^<!-- (.*) -->$", link = R"(\]\(([^)\s]+)\))", code = "`([^`]+)`";
  Document document{path, {}, {}, {}, {}};
  bool inside = false;
  std::string before;
  std::size_t number = 0;
  for (const std::string& line : lines_of(path)) {
    ++number;
    if (line.starts_with("```")) {
      const std::vector<Match> said = matches_of(before, remark);
      if (!inside) document.blocks.push_back({line.substr(3), said.empty() ? "" : said[0].first, "", number});
      inside = !inside;
    } else if (inside) {
      document.blocks.back().text += line + '\n';
    } else {
      if (const auto hashes = line.find_first_not_of('#'); hashes != 0 && hashes != line.npos && line[hashes] == ' ') {
        document.anchors.push_back(anchor_of(line.substr(hashes + 1)));
      }
      find_all(line, link, number, document.links);
      find_all(line, code, number, document.mentions);
    }
    before = line;
  }
  if (inside) throw std::runtime_error(path.string() + ": a block is not closed");
  return document;
}

std::vector<fs::path> document_paths() {
  const fs::path tree = PLUMB_SOURCE_DIR;
  std::vector<fs::path> paths{tree / "README.md"};
  for (const auto& entry : fs::directory_iterator(tree / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  std::sort(paths.begin() + 1, paths.end());
  return paths;
}

}  // namespace plumb::docs
