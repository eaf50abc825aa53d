// Which figure does a caller in C mean?
//
// Laws: the figure is what its kind, dimension, numbers and pose say; what is no figure is left to the question, which
// throws as it does for C++.
// Source: none.
// Cost: a copy of its numbers; of a kept figure, of a pointer to its lists.
#pragma once

#include "c/guarded.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/time_of_impact/motion.hpp"

struct plumb_kept {
  plumb::AnyFigure figure;
};

namespace plumb::c {

/// Throws InvalidArgument by the name of the argument.
AnyFigure figure_of(const plumb_figure* given, const char* argument);
/// In motion by these numbers, of which NULL stands for none.
Translating<AnyFigure> moved(const plumb_figure* figure, const double* by, const char* argument);

inline RigidPose rigid_of(const plumb_rigid3& p) {
  return {{p.w, p.x, p.y, p.z}, {p.translation[0], p.translation[1], p.translation[2]}};
}

}  // namespace plumb::c
