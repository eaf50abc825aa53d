// Ray traversal of a k-d tree of figures: which cells does a ray or segment visit, and which figure does it hit first?
//
// Laws: (1) cells_along tells leaves as of a tree of points (cells_along.hpp).  (2) first_hit tells the figure of the
// least parameter, in real arithmetic, of equal ones that of the lowest number, with the hit that first_hit of the
// figure tells: the answer of asking each.  Cells are visited in the order of entry, until one is entered certainly
// behind the hit.
// A coordinate that is NaN or infinite throws NonFinite, by name.
// Source: RTCD 7.3.7, 7.4.1.
// Cost: a comparison of parameters for each plane that is met, and a test for each figure in the cells up to the hit.
// Bounded by n tests a ray, times most_references, on integers as long as the exponents' span.
#pragma once

#include <optional>

#include "plumb/query/ray/ray.hpp"
#include "plumb/query/ray/ray2.hpp"
#include "plumb/space/kd_tree/cells_along.hpp"
#include "plumb/space/kd_tree/split_tree.hpp"

namespace plumb {

/// The numbers of the leaves.
template <KeptFigure Figure>
std::vector<std::uint32_t> cells_along(const SplitTree<Figure>& tree,
                                       const typename SplitTree<Figure>::Segment& segment,
                                       WalkedCells cells = WalkedCells::closed, std::vector<std::uint32_t> rows = {});
template <KeptFigure Figure>
std::vector<std::uint32_t> cells_along(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray,
                                       WalkedCells cells = WalkedCells::closed, std::vector<std::uint32_t> rows = {});

template <KeptFigure Figure>
struct FigureHit {
  std::uint32_t index;
  std::conditional_t<SplitTree<Figure>::dimension == 2, Hit2, Hit> hit;
  friend bool operator==(const FigureHit&, const FigureHit&) = default;
};

/// All but segments of space, which have no area to hit.
template <class Figure>
concept ShotAtFigure = KeptFigure<Figure> && !std::is_same_v<Figure, Segment3>;

template <ShotAtFigure Figure>
std::optional<FigureHit<Figure>> first_hit(const SplitTree<Figure>& tree,
                                           const typename SplitTree<Figure>::Segment& segment);
template <ShotAtFigure Figure>
std::optional<FigureHit<Figure>> first_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray);

/// Whether there is one: the search ends at the first that is found.
template <ShotAtFigure Figure>
bool any_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Segment& segment);
template <ShotAtFigure Figure>
bool any_hit(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Ray& ray);

}  // namespace plumb
