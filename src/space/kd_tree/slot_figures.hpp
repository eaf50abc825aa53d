// The figures in a tree's slots, as the search for what is nearest asks for them.
#pragma once

#include "plumb/space/kd_tree/figure_tree.hpp"
#include "space/closest/nearest_search.hpp"

namespace plumb::space {

namespace kd {

template <class Figure>
class SlotFigures {
 public:
  using Point = typename FigureTree<Figure>::Point;

  explicit SlotFigures(const FigureTree<Figure>& tree) : figures_(tree.figures), numbers_(tree.tree.items.view()) {}

  [[nodiscard]] std::size_t slots() const { return figures_.size(); }
  [[nodiscard]] std::uint32_t number(std::size_t slot) const { return numbers_[slot]; }
  [[nodiscard]] const Figure& figure(std::size_t slot) const { return figures_[slot]; }

 private:
  std::span<const Figure> figures_;
  std::span<const std::uint32_t> numbers_;
};

}  // namespace kd

template <class Figure>
struct SlotsOf<FigureTree<Figure>> {
  using Items = kd::SlotFigures<Figure>;
};

}  // namespace plumb::space
