/// \file
/// Shaded triangles with visible edges into an image, nearest first (z-buffer).
#pragma once

#include <array>
#include <vector>

#include "image.hpp"
#include "unsliver/types.hpp"

namespace unsliver::cli {

/// Where the eye is: far away (an orthographic view), `right` and `up` span the picture, `toward` points at
/// the eye.
struct View {
  Vec3 right, up, toward;
  Vec3 center;       ///< seen in the middle of the picture
  double scale = 1;  ///< pixels a unit of length
};

/// The view from direction `toward`, upright along `up` as far as possible.
/// Requires `toward` nonzero; an `up` parallel to it is replaced.
View look_from(const Vec3& toward, const Vec3& up);

class Raster {
 public:
  Raster(int width, int height, Colour background, View view);

  /// One flat triangle. `edge_pixels`: half the width of the lines along its sides; they fade where the
  /// triangle is so small that they would be all there is to see.
  void draw(const std::array<Vec3, 3>& triangle, Colour colour, double edge_pixels);

  const Image& image() const { return image_; }

 private:
  Vec3 project(const Vec3& p) const;
  Colour lit(const std::array<Vec3, 3>& triangle, Colour colour) const;

  Image image_;
  View view_;
  std::vector<float> depth_;  ///< distance toward the eye, one a pixel
};

}  // namespace unsliver::cli
