#include "world/npy_file.h"

#include <algorithm>
#include <cmath>

#include "world/bytes.h"
#include "world/file_fault.h"
#include "world/npy_header.h"
#include "world/recording_check.h"

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
Status parse_boxes(Bytes file, const BoxBlock& block, std::vector<Aabb>& boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Corners<Number> stored{};
    for (std::size_t k = 0; k < stored.size(); ++k) {
      stored[k] = load_number<Number, order>(file, block.offset + i * block.box_bytes + k * sizeof(Number));
    }
    auto fault = find_fault(stored);
    if (!fault) fault = round_box(stored, boxes[i]);
    if (fault) return box_fault_at(block, i, fault->corner * sizeof(Number), *fault);
  }
  return {};
}

Status parse_boxes(Bytes file, const NpyHeader& header, const BoxBlock& block, std::vector<Aabb>& boxes) {
  if (header.number_bytes == 4) {
    return header.order == ByteOrder::little ? parse_boxes<float, ByteOrder::little>(file, block, boxes)
                                             : parse_boxes<float, ByteOrder::big>(file, block, boxes);
  }
  return header.order == ByteOrder::little ? parse_boxes<double, ByteOrder::little>(file, block, boxes)
                                           : parse_boxes<double, ByteOrder::big>(file, block, boxes);
}

Aabb bounds_of(std::span<const Aabb> boxes) {
  if (boxes.empty()) return {};
  Aabb bounds = boxes.front();
  for (const Aabb& box : boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.min[axis] = std::min(bounds.min[axis], box.min[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], box.max[axis]);
    }
  }
  return bounds;
}

}  // namespace

Result<Recording> parse_npy(std::span<const std::byte> file) {
  const Result<NpyHeader> header = parse_npy_header(file);
  if (!header) return header.status();
  const BoxBlock block{.offset = header->data_offset,
                       .box_bytes = 6 * header->number_bytes,
                       .frames = header->frames,
                       .bodies = header->bodies};
  if (Status status = check_file_size(block, file.size()); !status.ok()) return status;

  Recording recording;
  recording.bodies = block.bodies;
  recording.boxes.resize(block.frames * block.bodies);
  if (Status status = parse_boxes(file, *header, block, recording.boxes); !status.ok()) return status;
  recording.world = bounds_of(recording.boxes);
  return recording;
}

Result<std::vector<std::byte>> npy_bytes(const Recording& recording) {
  if (Status status = check_recording(recording); !status.ok()) return status;
  const std::string header = npy_header_bytes(recording.frames(), recording.bodies);
  const Bytes header_bytes = std::as_bytes(std::span(header));
  std::vector<std::byte> bytes;
  bytes.reserve(header_bytes.size() + recording.boxes.size() * 6 * sizeof(float));
  bytes.insert(bytes.end(), header_bytes.begin(), header_bytes.end());
  for (const Aabb& box : recording.boxes) {
    for (const float number : corners_of(box)) append_number(bytes, number);
  }
  return bytes;
}

}  // namespace cellsweep
