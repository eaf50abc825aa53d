// What does a document show?  Its fenced blocks and its links, with their lines.
//
// A block is what stands between ``` lines, with the word after the first ``` as its language.  An HTML comment on the
// line before a block says more about it: <!-- fragment -->, <!-- from FILE -->, <!-- file NAME -->, <!-- add to FILE
// -->; docs/index.md, "How these pages are tested", has the meanings.
#pragma once

#include <filesystem>
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

std::vector<std::string> lines_of(const fs::path& path);
std::string text_of(const fs::path& path);

/// Where the regular expression matches, one after another: the whole, and what its first two groups took.
struct Match {
  std::string whole, first, second;
};
std::vector<Match> matches_of(const std::string& text, const std::string& pattern);
std::string without_matches(const std::string& text, const std::string& pattern);

/// As the usual viewers of Markdown name a heading: lower case, no punctuation, '-' for a blank.
std::string anchor_of(const std::string& heading);

/// Throws where a block is not closed.
Document read_document(const fs::path& path);

/// README.md and docs/*.md, in the order of their names.
std::vector<fs::path> document_paths();

}  // namespace plumb::docs
