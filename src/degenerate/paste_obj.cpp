#include "degenerate/wire_model.hpp"
#include "degenerate/words.hpp"
#include "plumb/degenerate/paste.hpp"

namespace plumb::degenerate {

std::string obj_text(const Kind& kind, std::span<const double> numbers) {
  std::string text = std::string("# ").append(case_line(kind, numbers)).append("\n");
  std::size_t first = 1;  // OBJ counts from 1 through the whole file
  const auto element = [&](std::string_view letter, std::span<const std::size_t> of) {
    text.append(letter);
    for (const std::size_t v : of) text.append(" ").append(std::to_string(first + v));
    text.append("\n");
  };
  for (const WireFigure& figure : wire_model(kind, numbers)) {
    text.append("o ").append(figure.name).append("\n");
    for (const std::array<double, 3>& p : figure.points) text.append("v ").append(joined(p, " ", decimal)).append("\n");
    for (const std::size_t dot : figure.dots) element("p", {&dot, 1});
    for (const auto& edge : figure.edges) element("l", edge);
    for (const auto& arrow : figure.arrows) element("l", arrow);
    for (const auto& face : figure.faces) element("f", face);
    first += figure.points.size();
  }
  return text;
}

}  // namespace plumb::degenerate
