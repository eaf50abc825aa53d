// How do two oriented boxes lie to one another, by CGAL's linear programs?
//
// Laws: exact for all finite doubles.
// Source: CGAL's manual, "Linear and Quadratic Programming Solver".
// Cost: about 1 ms.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb::oracle {

Relation box_relation(const Obb3& a, const Obb3& b);

}  // namespace plumb::oracle
