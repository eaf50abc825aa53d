// Who knows the exact answer, where the library does not?  A function of the user's, of the kind's own signature.
//
// It is asked in a process of its own, as the function is that it judges.
// Laws: (1) what it answers is right; where it answers NaN, nothing is wrong; (2) where it crashes, hangs, exits or
// throws, the run ends with an Error that names the case.
// Source: none.
// Cost: some 10 us an answer, beside its own.
#pragma once

#include "tool/fuzz/foreign_process.hpp"

namespace plumb::tool {

/// The kind, judged by `symbol` of `library`; conventions are the judge's own.  Throws Error where it cannot be loaded,
/// or the kind's answers are triangles, of which many are right.
degenerate::Kind judged_by(const degenerate::Kind& kind, const std::string& library, const std::string& symbol,
                           std::uint64_t memory_mib, ForeignLimits limits);

}  // namespace plumb::tool
