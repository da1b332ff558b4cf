#include "world/files/npy_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "world/files/bytes.h"

namespace cellsweep {
namespace {

using Bytes = std::span<const std::byte>;

/// To float32, to the nearest. A finite float64 may be too large for one.
template <class Number>
std::optional<BoxFault> round_box(const Corners<Number>& stored, Aabb& box) {
  Corners<float> rounded{};
  for (std::size_t i = 0; i < stored.size(); ++i) {
    rounded[i] = static_cast<float>(stored[i]);
    if (std::isfinite(rounded[i])) continue;
    return BoxFault{i, std::string(corner_name(i)) + " within the range of float32", number_text(stored[i])};
  }
  std::copy_n(rounded.begin(), 3, box.min.begin());
  std::copy_n(rounded.begin() + 3, 3, box.max.begin());
  return std::nullopt;
}

template <class Number, ByteOrder order>
std::optional<FaultyBox> load_boxes_of(Bytes numbers, std::span<Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Corners<Number> stored{};
    for (std::size_t k = 0; k < stored.size(); ++k) {
      stored[k] = load_number<Number, order>(numbers, (i * stored.size() + k) * sizeof(Number));
    }
    auto fault = find_fault(stored);
    if (!fault) fault = round_box(stored, boxes[i]);
    if (fault) return FaultyBox{i, *fault};
  }
  return std::nullopt;
}

/// The lowest `bytes` bytes of a word, of either order.
std::uint64_t load_bytes(Bytes numbers, std::size_t offset, std::size_t bytes, ByteOrder order) {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = order == ByteOrder::little ? i : bytes - 1 - i;
    word |= std::to_integer<std::uint64_t>(numbers[offset + i]) << (8 * place);
  }
  return word;
}

}  // namespace

std::optional<FaultyBox> load_boxes(std::span<const std::byte> numbers, const NpyHeader& header,
                                    std::span<Aabb> boxes) {
  const bool little = header.order() == ByteOrder::little;
  if (header.bytes() == 4) {
    return little ? load_boxes_of<float, ByteOrder::little>(numbers, boxes)
                  : load_boxes_of<float, ByteOrder::big>(numbers, boxes);
  }
  return little ? load_boxes_of<double, ByteOrder::little>(numbers, boxes)
                : load_boxes_of<double, ByteOrder::big>(numbers, boxes);
}

Status load_numbers(std::span<const std::byte> bytes, const NpyHeader& header, std::uint64_t first,
                    std::uint64_t most, std::span<std::uint64_t> numbers) {
  const std::size_t size = header.bytes();
  const bool is_signed = header.is_of("i");
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = load_bytes(bytes, i * size, size, header.order());
    const bool is_negative = is_signed && (numbers[i] >> (8 * size - 1)) != 0;
    if (!is_negative && numbers[i] <= most) continue;
    return fault_at(header.data_offset + (first + i) * size, "a number of 0 to " + std::to_string(most),
                    is_negative ? "a negative one" : std::to_string(numbers[i]));
  }
  return {};
}

void append_npy_header(std::vector<std::byte>& bytes, std::string_view type,
                       std::span<const std::uint64_t> shape) {
  const std::string header = npy_header_bytes(type, shape);
  const Bytes more = std::as_bytes(std::span(header));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

void append_boxes(std::vector<std::byte>& bytes, std::span<const Aabb> boxes) {
  for (const Aabb& box : boxes) {
    for (const float number : corners_of(box)) append_number(bytes, number);
  }
}

}  // namespace cellsweep
