/// @file
/// What can be wrong with a file of boxes, and the sentences that say so.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// bad_input with a message.
Status bad_recording(std::string message);

/// bad_input: "byte 264: expected zero in the first reserved field, found 7".
Status fault_at(std::uint64_t offset, std::string_view expected, std::string_view found);

/// Text from a stranger, made fit for a message: in quotes, cut at 48 bytes, '?' for what is not printable
/// ASCII.
std::string quoted(std::string_view text);

/// A number in the fewest digits that name it.
std::string number_text(float number);
std::string number_text(double number);

/// A box as files hold it: min xyz, max xyz.
template <class Number>
using Corners = std::array<Number, 6>;

/// "min x" to "max z".
std::string_view corner_name(std::size_t corner);

/// The first thing wrong with a box, and which of its six numbers it was found at.
struct BoxFault {
  std::size_t corner = 0;
  std::string expected;
  std::string found;
};

/// Nothing for a box that is finite with min <= max. For float and double.
template <class Number>
std::optional<BoxFault> find_fault(const Corners<Number>& box);

inline Corners<float> corners_of(const Aabb& box) {
  return {box.min[0], box.min[1], box.min[2], box.max[0], box.max[1], box.max[2]};
}

/// Where the boxes of a file are, as its header claims.
struct BoxBlock {
  std::uint64_t offset = 0;     ///< of the first box
  std::uint64_t box_bytes = 0;  ///< bytes from one box to the next
  std::uint64_t frames = 0;     ///< stored frames
  std::uint64_t bodies = 0;     ///< boxes per frame
};

/// Compares a header's claim with the size of the file, without multiplying what a liar could make overflow.
/// Errors: bad_input for a file that ends before its last box or goes on after it.
Status check_file_size(const BoxBlock& block, std::uint64_t file_bytes);

/// bad_input for a box of the block: fault_at() naming the frame and the body as well. `place` is the byte
/// within the box.
Status box_fault_at(const BoxBlock& block, std::uint64_t box, std::uint64_t place, const BoxFault& fault);

}  // namespace cellsweep
