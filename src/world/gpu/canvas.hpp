// What draws cells without a display, and asks whether any pixel of them is left?
//
// Laws: a range is drawn to each of its pixels and to no other; two cells are told apart and found equal exactly, for
// all numbers that a shader compares are whole, or whole over a power of two, and held by floats.
// Source: RTCD 10.1.1, 10.1.2.
// Cost: an upload for each list of ranges; a wait for the queries of a batch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "world/gpu/cells.hpp"

namespace plumb::world {

/// A part of what was uploaded.
struct RangeSpan {
  std::size_t first = 0, count = 0;
};

class Canvas {
 public:
  static constexpr int side_bits = 10;

  /// Tiles of so many pixels a side, as many as there is room for.
  explicit Canvas(int pixel_bits);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  [[nodiscard]] std::int32_t tiles() const { return 1 << 2 * (side_bits - pixel_bits_); }

  /// Makes the context that of this thread until it goes.
  class Use {
   public:
    explicit Use(const Canvas& canvas);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    void *display_, *draw_, *read_, *context_;
    unsigned api_;
  };

  void upload(const std::vector<CellRange>& ranges);

  // The set of a view: the first tile, by its nearest depths.
  void clear_depths();
  /// May a cell of these be at, or behind, the nearest of a pixel?  `from_behind` looks the other way.
  void ask_depths(const RangeSpan& ranges, std::size_t query, bool from_behind);
  void draw_depths(const RangeSpan& ranges, bool from_behind);

  // Pairs: all tiles.
  enum class Side : unsigned char { a, b };
  void clear_spans();
  /// From the least to the greatest depth of each pixel.
  void draw_spans(const RangeSpan& ranges, Side side);
  void clear_slices();
  void draw_slices(const RangeSpan& ranges);
  /// Is there a pixel of the tile in which the spans of both sides meet?
  void ask_spans(std::int32_t tile, std::size_t query);
  /// Does one of the ranges meet the spans of side a?  Or the slices?
  void ask_ranges_in_spans(const RangeSpan& ranges, std::size_t query);
  void ask_ranges_in_slices(const RangeSpan& ranges, std::size_t query);

  /// The answers to the first queries, all of which were asked, in one batch.
  std::vector<bool> read(std::size_t count);

 private:
  enum class Program : unsigned char { depth, span, slices, compare, in_spans, in_slices };
  void use(Program program);
  void set(Program program, const char* uniform, std::int32_t value);
  /// Draws ranges by a program that reads what was drawn, and asks whether any pixel is left.
  void ask(Program program, std::uint32_t of, const RangeSpan& ranges, std::size_t query);
  void draw(const RangeSpan& ranges);
  void begin_query(std::size_t query);
  void end_query();
  void make_programs();
  void make_targets();
  /// Throws Error where the driver has found one.
  void check(const char* what);

  int pixel_bits_;
  void *display_ = nullptr, *context_ = nullptr;
  std::string renderer_;
  std::uint32_t vertices_ = 0, buffer_ = 0, depths_ = 0, spans_ = 0, slices_ = 0;
  std::uint32_t depth_target_ = 0, span_target_ = 0, slice_target_ = 0, query_target_ = 0, blank_ = 0;
  std::uint32_t programs_[6] = {};
  std::vector<std::uint32_t> queries_;
};

}  // namespace plumb::world
