/// \file
/// A 5 x 7 dot face: capitals (small letters borrow them), digits and common signs.
#pragma once

namespace unsliver::cli {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// Is the dot set? Row 0 is the top. Characters without a glyph show as a small box.
bool glyph_dot(char c, int column, int row);

}  // namespace unsliver::cli
