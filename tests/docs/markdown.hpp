// What does a document show?  Its fenced blocks and its links, with their lines.
//
// A block is what stands between ``` lines, with the word after the first ``` as its language.  An HTML comment on the
// line before a block says more about it: <!-- fragment -->, <!-- from FILE -->, <!-- file NAME -->, <!-- add to FILE
// -->; docs/index.md, "How these pages are tested", has the meanings.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumb::docs {

namespace fs = std::filesystem;

struct Block {
  std::string language, remark, text;
  std::size_t line = 0;
};

struct Link {
  std::string target;
  std::size_t line = 0;
};

struct Document {
  fs::path path;
  std::vector<Block> blocks;
  std::vector<Link> links, mentions;  // mentions: `code` words, which may name files of the tree
  std::vector<std::string> anchors;   // of its headings
};

inline std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path.string());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::string text_of(const fs::path& path) {
  std::string text;
  for (const std::string& line : lines_of(path)) text += line + '\n';
  return text;
}

/// As the usual viewers of Markdown name a heading: lower case, no punctuation, '-' for a blank.
inline std::string anchor_of(const std::string& heading) {
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

inline void find_all(const std::string& line, const std::regex& pattern, std::size_t number, std::vector<Link>& out) {
  for (std::sregex_iterator match(line.begin(), line.end(), pattern), end; match != end; ++match) {
    out.push_back({(*match)[1], number});
  }
}

inline Document read_document(const fs::path& path) {
  static const std::regex remark("<!-- (.*) -->"), link(R"(\]\(([^)\s]+)\))"), code("`([^`]+)`");
  Document document{path, {}, {}, {}, {}};
  bool inside = false;
  std::string before;
  std::size_t number = 0;
  for (const std::string& line : lines_of(path)) {
    ++number;
    if (line.starts_with("```")) {
      std::smatch said;
      if (!inside) {
        document.blocks.push_back(
            {line.substr(3), std::regex_match(before, said, remark) ? said.str(1) : std::string(), "", number});
      }
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

/// README.md and docs/*.md, in the order of their names.
inline std::vector<fs::path> document_paths() {
  const fs::path tree = PLUMB_SOURCE_DIR;
  std::vector<fs::path> paths{tree / "README.md"};
  for (const auto& entry : fs::directory_iterator(tree / "docs")) {
    if (entry.path().extension() == ".md") paths.push_back(entry.path());
  }
  std::sort(paths.begin() + 1, paths.end());
  return paths;
}

}  // namespace plumb::docs
