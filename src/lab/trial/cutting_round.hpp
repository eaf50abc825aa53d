// How is a method asked to cut polygons?  What it makes of a polygon is made before the clock runs, and what is wrong with
// its triangles is judged after.
//
// Law: the answer is the set of faults (cutting_judge.hpp), none where the triangles are a triangulation; unsure where
// there are none.
// Source: none.
// Cost: none beside the method's.
#pragma once

#include <functional>
#include <optional>

#include "lab/trial/cut_polygons.hpp"
#include "lab/trial/ear_clipping.hpp"
#include "lab/trial/tasks.hpp"

namespace plumb::lab::trial {

using CutTriangles = std::optional<EarTriangles>;
/// Cuts the polygon that it was made of.
using Cut = std::function<CutTriangles()>;

Method cutting_method(std::string_view name, std::string_view about, std::function<Cut(const CutPolygon&)> make);

}  // namespace plumb::lab::trial
