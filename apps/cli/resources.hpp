/// \file
/// Memory of this machine and of this process.
#pragma once

#include <cstdint>

namespace unsliver::cli {

/// Bytes that can be had without swapping: the machine's, or the control group's where that is less.
/// 0 = unknown.
std::uint64_t available_memory();

/// The largest resident size of this process so far, in bytes.
std::uint64_t peak_resident_memory();

}  // namespace unsliver::cli
