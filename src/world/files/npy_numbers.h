/// @file
/// The numbers behind the header of a .npy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "world/files/file_fault.h"
#include "world/files/npy_header.h"

namespace cellsweep {

/// What is wrong with which of the boxes.
struct FaultyBox {
  std::uint64_t box = 0;
  BoxFault fault;
};

/// Boxes of six float32 or float64 each, which are rounded to the nearest, from the first number on; there
/// are as many. Stops at the first that is not finite with min <= max.
std::optional<FaultyBox> load_boxes(std::span<const std::byte> numbers, const NpyHeader& header,
                                    std::span<Aabb> boxes);

/// As many whole numbers, of any kind of integer or of truth values, from as many whole ones' bytes, the
/// first of which is number `first` of the array. Errors: bad_input naming the byte offset in the array's
/// file of one that is negative or above `most`.
Status load_numbers(std::span<const std::byte> bytes, const NpyHeader& header, std::uint64_t first,
                    std::uint64_t most, std::span<std::uint64_t> numbers);

void append_npy_header(std::vector<std::byte>& bytes, std::string_view type,
                       std::span<const std::uint64_t> shape);
/// As "<f4".
void append_boxes(std::vector<std::byte>& bytes, std::span<const Aabb> boxes);

}  // namespace cellsweep
