/// \file
/// Numbers to and from text, as people write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::cli {

std::string with_separators(std::uint64_t n);  ///< "1,234,567"
std::string human_count(double n);             ///< "12,345", "1.2 million", "3.5e+17"
std::string human_bytes(double bytes);         ///< "1.2 GB" (powers of 1000)
std::string human_seconds(double seconds);     ///< "0.42 s", "12 s", "3 min 05 s"
/// "1 triangle", "2 triangles"; where an s is not enough: "1 vertex", "2 vertices".
std::string plural(std::uint64_t n, const std::string& noun, const std::string& nouns = "");
std::string point_text(const Vec3& p);  ///< "(0, 0.5, 1)"
std::string box_text(const Box3& box);  ///< "(0, 0, 0) to (1, 1, 2)", as the library writes them

/// The number that the whole text is, whatever the locale; none if it is something else (a formula).
std::optional<double> parse_number(const std::string& text);

/// `count` numbers divided by blanks or commas. \throws Error kBadOption naming the option.
std::vector<double> parse_numbers(const std::string& text, std::size_t count, const std::string& option);

/// A positive count with an optional suffix k, M or G (thousands). \throws Error kBadOption.
std::uint64_t parse_count(const std::string& text, const std::string& option);

/// Positive bytes with an optional suffix K, M, G or T (1024). \throws Error kBadOption.
std::uint64_t parse_bytes(const std::string& text, const std::string& option);

}  // namespace unsliver::cli
