// How do clashes reach a building model's reviewers?  As BCF 2.1, the BIM Collaboration Format: a topic for each.
//
// Laws: (1) an archive of bcf.version and, for each clash, a folder of its GUID with markup.bcf and viewpoint.bcfv.  (2) GUIDs
// depend on the names of the two parts and the word alone, so that a clash keeps its topic from run to run.  (3) A
// viewpoint looks at the place, and selects both parts by their names.  (4) Entries are stored, not packed.
// Source: buildingSMART BCF-XML 2.1 (version.xsd, markup.xsd, visinfo.xsd); APPNOTE 6.3.4.
// Cost: linear.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tool/clash/command.hpp"

namespace plumb::tool {

/// Names and bytes of files, in order.
std::string stored_zip(const std::vector<std::pair<std::string, std::string>>& files);

/// `date` is ISO 8601.
std::string clash_bcf(const ClashReport& report, const std::string& date);

}  // namespace plumb::tool
