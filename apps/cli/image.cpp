#include "image.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "font.hpp"

namespace unsliver::cli {

Colour mix(Colour a, Colour b, double share) {
  const auto blend = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround((1 - share) * from + share * to));
  };
  return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b)};
}

void Image::fill(int x, int y, int width, int height, Colour colour) {
  for (int row = std::max(y, 0); row < std::min(y + height, height_); ++row)
    for (int column = std::max(x, 0); column < std::min(x + width, width_); ++column)
      set(column, row, colour);
}

void Image::write(int x, int y, std::string_view text, Colour colour, int scale) {
  for (const char c : text) {
    for (int row = 0; row < kGlyphHeight; ++row)
      for (int column = 0; column < kGlyphWidth; ++column)
        if (glyph_dot(c, column, row)) fill(x + column * scale, y + row * scale, scale, scale, colour);
    x += (kGlyphWidth + 1) * scale;
  }
}

Image Image::reduced(int factor) const {
  Image out(width_ / factor, height_ / factor, {});
  for (int y = 0; y < out.height_; ++y)
    for (int x = 0; x < out.width_; ++x) out.set(x, y, block_average(x * factor, y * factor, factor));
  return out;
}

Colour Image::block_average(int x, int y, int factor) const {
  int r = 0, g = 0, b = 0;
  for (int row = y; row < y + factor; ++row)
    for (int column = x; column < x + factor; ++column) {
      const Colour colour = at(column, row);
      r += colour.r;
      g += colour.g;
      b += colour.b;
    }
  const int count = factor * factor;
  const auto mean = [count](int sum) { return static_cast<std::uint8_t>((sum + count / 2) / count); };
  return {mean(r), mean(g), mean(b)};
}

int text_width(std::string_view text, int scale) {
  return static_cast<int>(text.size()) * (kGlyphWidth + 1) * scale;
}

}  // namespace unsliver::cli
