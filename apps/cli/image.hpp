/// \file
/// A grid of pixels and what is drawn flat upon it: rectangles and text.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace unsliver::cli {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// `share` of b in a mixture with a, 0..1.
Colour mix(Colour a, Colour b, double share);

/// Row 0 is the top.
class Image {
 public:
  Image(int width, int height, Colour background)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, background) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Colour at(int x, int y) const { return pixels_[index(x, y)]; }
  void set(int x, int y, Colour colour) { pixels_[index(x, y)] = colour; }

  /// The part inside the image of [x, x + width) x [y, y + height).
  void fill(int x, int y, int width, int height, Colour colour);

  /// `text` in a 5 x 7 face, `scale` pixels a dot, with its top left corner at (x, y).
  void write(int x, int y, std::string_view text, Colour colour, int scale);

  /// Each block of factor x factor pixels averaged into one. Requires sides divisible by factor.
  Image reduced(int factor) const;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  Colour block_average(int x, int y, int factor) const;

  int width_, height_;
  std::vector<Colour> pixels_;
};

/// Width of a text in pixels.
int text_width(std::string_view text, int scale);

}  // namespace unsliver::cli
