// How does a report look as one page?  Sections of articles, checkboxes that choose among them, and the JSON within.
//
// The body consists of <section> elements that hold <article> elements.  An article, or a row of a table,
// may carry data-KIND for each filter but that of methods; what belongs to one method, a row or a mark, carries
// data-key.  Marks of class "marker" with a <title> explain themselves to the mouse and to the keyboard.
// Laws: (1) the page opens without a network: it refers to nothing outside of itself; (2) without a script it is the
// plain report; (3) it follows the reader's choice of light or dark.
// Source: none.
// Cost: copying.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace plumb::tool {

/// Checkboxes, all checked.  The kind "method" hides what carries that data-key, any other whole articles.
struct PageFilter {
  std::string kind, title;
  std::vector<std::string> names;
};

struct ReportPage {
  std::string title, heading;
  std::string settings;      // how it was asked for: "8192 cases a class, seed 2026"
  std::string introduction;  // how the page is to be read
  std::vector<PageFilter> filters;
  std::string body;          // HTML, as is
  std::string opening = {};  // what stands before the filters; the other texts are plain
};

/// `raw` was begun by origin_json.
std::string report_page(const ReportPage& page, const nlohmann::json& raw);

/// A picture whose style the page has once for all.
std::string inline_picture(std::string svg);

}  // namespace plumb::tool
