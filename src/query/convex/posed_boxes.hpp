// Separating axis test (SAT): how do two solid boxes lie, of which one or both are under a pose?
//
// Boxes that rest on one another, face to face, are what scenes are full of.  Of each box there are three axes, three
// lengths and a middle, so an axis costs a few products and no corner is made; of two turned alike, as they see one
// another, their own three axes are all there are.
// Laws: an answer is that of real arithmetic.  Nothing is answered of other figures, of boxes without an inside, and of
// what is not finite.
// Method: all axes over doubles whose errors are derived, where the boxes' own are doubles (query/body/parting_axes.hpp);
// where a gap is about zero each axis over doubles with a running bound of their errors, in integers where they leave a
// doubt; not where it is the axis along which the boxes touch already.
// Source: Gottschalk, Lin and Manocha 1996; RTCD 4.4.1.
// Cost: a us where they touch and no turn is the same, a third of that else.
#pragma once

#include <optional>

#include "plumb/figure/basic/relation.hpp"
#include "plumb/query/body/posed.hpp"

namespace plumb::query {

std::optional<Relation> relate_posed_boxes(const PosedView& a, const PosedView& b);

}  // namespace plumb::query
