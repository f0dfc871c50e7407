/// \file
/// The numbers of a VTU array, whatever its encoding.
#pragma once

#include <cstdint>
#include <vector>

#include "io/vtu_document.hpp"

namespace unsliver::io {

/// All values of the array. Error kFormat when it is damaged or of another size than it says; takes memory in
/// proportion to the file's bytes. `T` is double or std::int64_t; values that T cannot hold are kBadInput.
template <class T>
std::vector<T> vtu_values(const VtuDocument& document, const VtuArray& array);

extern template std::vector<double> vtu_values(const VtuDocument&, const VtuArray&);
extern template std::vector<std::int64_t> vtu_values(const VtuDocument&, const VtuArray&);

}  // namespace unsliver::io
