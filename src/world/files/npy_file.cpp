#include "world/files/npy_file.h"

#include <array>
#include <utility>

#include "world/files/box_file.h"
#include "world/files/file_fault.h"
#include "world/files/npy_header.h"
#include "world/files/npy_numbers.h"
#include "world/recording_check.h"

namespace cellsweep {
namespace {

Status check_header(const NpyHeader& header) {
  constexpr std::uint64_t kIds = std::uint64_t{1} << 32;
  if (!header.is_of("f")) {
    return fault_at(header.type_offset,
                    "float32 or float64 of a stated byte order (\"<f4\", \"<f8\", \">f4\" or \">f8\")",
                    cellsweep::quoted(header.type));
  }
  const auto refuse = [&](std::string_view expected) {
    return fault_at(header.shape_offset, expected, "shape " + cellsweep::quoted(header.shape_text));
  };
  if (header.shape.size() != 3 || header.shape[2] != 6) return refuse("shape (frames, bodies, 6)");
  if (header.shape[0] == 0) return refuse("at least one frame");
  if (header.shape[1] > kIds) return refuse("no more bodies than 32-bit ids name, 4294967296");
  return {};
}

}  // namespace

Result<BoxFile> parse_npy_head(std::span<const std::byte> begin, std::uint64_t file_bytes) {
  Result<NpyHeader> header = parse_npy_header(begin);
  if (!header) return header.status();
  if (Status status = check_header(*header); !status.ok()) return status;
  BoxFile head;
  head.block = {.offset = header->data_offset,
                .box_bytes = 6 * header->bytes(),
                .frames = header->shape[0],
                .bodies = header->shape[1]};
  if (Status status = check_file_size(head.block, file_bytes); !status.ok()) return status;
  head.load = [block = head.block, header = std::move(*header)](
                  std::span<const std::byte> bytes, std::uint64_t first, std::span<Aabb> boxes) -> Status {
    const auto bad = load_boxes(bytes, header, boxes);
    if (!bad) return {};
    return box_fault_at(block, first + bad->box, bad->fault.corner * header.bytes(), bad->fault);
  };
  return head;
}

Result<Recording> parse_npy(std::span<const std::byte> file) {
  const Result<BoxFile> head = parse_npy_head(file, file.size());
  if (!head) return head.status();
  return load_all(*head, file);
}

Result<std::vector<std::byte>> npy_head(const RecordingHead& head) {
  const std::array<std::uint64_t, 3> shape = {head.frames, head.bodies, 6};
  std::vector<std::byte> bytes;
  append_npy_header(bytes, "<f4", shape);
  return bytes;
}

Result<std::vector<std::byte>> npy_bytes(const Recording& recording) {
  if (Status status = check_recording(recording); !status.ok()) return status;
  auto bytes = npy_head(head_of(recording));
  bytes->reserve(bytes->size() + recording.boxes.size() * 6 * sizeof(float));
  append_boxes(*bytes, recording.boxes);
  return bytes;
}

}  // namespace cellsweep
