// A guess in floating point of where boxes and points lie, to be looked at: two axes of their space, on one scale.
//
// Laws: (1) what lies farther right or up on paper does not lie farther left or down in space.  (2) Any finite doubles
// have a place, the largest and the least included.  (3) Well-formed XML; same input, same text.
// Source: none.
// Cost: linear in what is drawn.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace plumb::tool {

/// From the least number on an axis to the greatest.
struct DataAxis {
  std::string name;
  double min = 0, max = 0;
};

/// Free strips of these heights below the plan and left of it, in pixels, for what lies along one axis alone.
struct DataStrips {
  double below = 0, left = 0;
};

class DataView {
 public:
  /// `style` is CSS for the kinds of what is drawn, beside those of chart_style.
  DataView(const std::string& title, std::string_view style, DataAxis right, DataAxis up, DataStrips strips = {});

  /// A line of text under the title.
  void say(std::string_view text);
  /// What a kind of rectangles means.
  void explain(std::string_view kind, std::string_view text);

  void begin_group(std::string_view id, double stroke_width);
  /// What reaches beyond the plan by more than some pixels is cut off there.
  void begin_cut_group(std::string_view id, double stroke_width);
  void end_group();
  /// From one corner to the opposite one; flat ones are a pixel wide.
  void rectangle(std::string_view kind, std::array<double, 2> from, std::array<double, 2> to);
  void line(std::string_view kind, std::array<double, 2> from, std::array<double, 2> to);
  void dot(std::string_view kind, std::array<double, 2> at, double pixels);
  /// Of a radius as long as that in space.
  void circle(std::string_view kind, std::array<double, 2> center, double radius);
  /// In the strip below, or left, from and to a number on its axis, and from 0, next to the plan, to 1 across.
  void bar_below(std::string_view kind, std::array<double, 2> along, std::array<double, 2> across);
  void bar_left(std::string_view kind, std::array<double, 2> along, std::array<double, 2> across);

  /// The document.
  [[nodiscard]] std::string text() const;

 private:
  [[nodiscard]] double right_of(double x) const;
  [[nodiscard]] double down_of(double y) const;
  void put_rectangle(std::string_view kind, double left, double top, double right, double bottom);

  DataAxis right_, up_;
  DataStrips strips_;
  std::string title_, style_, said_, legend_, body_;
  double span_ = 0;    // half of what fills the paper's height
  double height_ = 0;  // of the plan, in pixels
  double next_line_ = 58, next_legend_ = 24;
};

}  // namespace plumb::tool
