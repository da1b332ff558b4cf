#include "world/files/aabbs_file.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "world/files/box_file.h"
#include "world/files/bytes.h"
#include "world/files/file_fault.h"
#include "world/recording_check.h"

namespace cellsweep {
namespace {

constexpr std::size_t kTextBytes = 128;
constexpr std::size_t kNameOffset = 0;
constexpr std::size_t kTypeOffset = 128;
constexpr std::size_t kBodiesOffset = 256;
constexpr std::size_t kFramesOffset = 260;
constexpr std::size_t kReservedOffset = 264;
constexpr std::size_t kWorldOffset = 272;
constexpr std::size_t kHeaderBytes = 304;
constexpr std::size_t kBoxBytes = 32;
constexpr std::size_t kMostCounted = std::numeric_limits<std::int32_t>::max();

using Bytes = std::span<const std::byte>;

Status parse_text(Bytes file, std::size_t offset, std::string_view what, std::string& text) {
  const Bytes field = file.subspan(offset, kTextBytes);
  const auto end = std::ranges::find(field, std::byte{0});
  if (end == field.end()) {
    return fault_at(offset, std::string(what) + " that ends in a NUL within 128 bytes",
                    "128 bytes without one");
  }
  for (auto byte = field.begin(); byte != end; ++byte) text.push_back(static_cast<char>(*byte));
  return {};
}

Status parse_count(Bytes file, std::size_t offset, std::string_view what, std::uint64_t& count) {
  const auto stored = load_number<std::int32_t>(file, offset);
  if (stored < 0) {
    return fault_at(offset, std::string(what) + " that is not negative", std::to_string(stored));
  }
  count = static_cast<std::uint64_t>(stored);
  return {};
}

Status check_reserved(Bytes file) {
  for (const std::size_t offset : {kReservedOffset, kReservedOffset + 4}) {
    const auto stored = load_number<std::int32_t>(file, offset);
    if (stored != 0) return fault_at(offset, "zero in a reserved field", std::to_string(stored));
  }
  return {};
}

/// Where a corner's number is within a box: each corner is followed by a fourth float.
std::size_t corner_place(std::size_t corner) {
  return 4 * (corner < 3 ? corner : corner + 1);
}

std::optional<BoxFault> parse_box(Bytes file, std::size_t offset, Aabb& box, std::size_t& place) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.min[i] = load_number<float>(file, offset + corner_place(i));
    box.max[i] = load_number<float>(file, offset + corner_place(i + 3));
  }
  if (auto fault = find_fault(corners_of(box))) {
    place = corner_place(fault->corner);
    return fault;
  }
  for (place = 12; place < kBoxBytes; place += 16) {
    const auto filler = load_number<float>(file, offset + place);
    if (filler != 0.0F) return BoxFault{0, "zero as a corner's fourth float", number_text(filler)};
  }
  return std::nullopt;
}

Status parse_world(Bytes file, Aabb& world) {
  std::size_t place = 0;
  const auto fault = parse_box(file, kWorldOffset, world, place);
  if (!fault) return {};
  return fault_at(kWorldOffset + place, fault->expected + " of the world", fault->found);
}

Status load_aabbs(Bytes bytes, const BoxBlock& block, std::uint64_t first, std::span<Aabb> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::size_t place = 0;
    const auto fault = parse_box(bytes, i * kBoxBytes, boxes[i], place);
    if (fault) return box_fault_at(block, first + i, place, *fault);
  }
  return {};
}

Status parse_header(Bytes begin, std::uint64_t file_bytes, BoxFile& head) {
  if (begin.size() < kHeaderBytes) {
    return fault_at(begin.size(), "a header of 304 bytes", "the end of the file");
  }
  Status status = parse_text(begin, kNameOffset, "a name", head.name);
  if (status.ok()) status = parse_text(begin, kTypeOffset, "a type", head.type);
  if (status.ok()) status = parse_count(begin, kBodiesOffset, "a number of bodies", head.block.bodies);
  if (status.ok()) status = parse_count(begin, kFramesOffset, "a number of frames", head.block.frames);
  if (status.ok()) status = check_reserved(begin);
  // The header counts the updates; frame 0 is stored before them.
  head.block.frames += 1;
  if (status.ok()) status = check_file_size(head.block, file_bytes);
  if (status.ok()) status = parse_world(begin, head.world.emplace());
  return status;
}

Status check_text(std::string_view what, std::string_view text) {
  if (text.size() >= kTextBytes) {
    return bad_recording("the recording's " + std::string(what) + " has " + std::to_string(text.size()) +
                         " bytes, and a file holds 127");
  }
  if (text.find('\0') != std::string_view::npos) {
    return bad_recording("the recording's " + std::string(what) + " has a NUL, where a file would end it");
  }
  return {};
}

Status check_counts(const RecordingHead& head) {
  const std::size_t updates = head.frames - 1;
  if (head.bodies <= kMostCounted && updates <= kMostCounted) return {};
  return bad_recording(std::to_string(head.bodies) + " bodies and " + std::to_string(updates) +
                       " updates do not both fit the format's limit of 2147483647");
}

Status check_world(const Aabb& world) {
  const auto fault = find_fault(corners_of(world));
  if (!fault) return {};
  return bad_recording("the recording's world: expected " + fault->expected + ", found " + fault->found);
}

void append_text(std::vector<std::byte>& bytes, std::string_view text) {
  const Bytes characters = std::as_bytes(std::span(text));
  const std::size_t end = bytes.size() + kTextBytes;
  bytes.insert(bytes.end(), characters.begin(), characters.end());
  bytes.resize(end);
}

void append_box(std::vector<std::byte>& bytes, const Aabb& box) {
  for (const auto& corner : {box.min, box.max}) {
    for (const float number : corner) append_number(bytes, number);
    append_number(bytes, 0.0F);
  }
}

}  // namespace

Result<BoxFile> parse_aabbs_head(std::span<const std::byte> begin, std::uint64_t file_bytes) {
  BoxFile head;
  head.block = {.offset = kHeaderBytes, .box_bytes = kBoxBytes};
  if (Status status = parse_header(begin, file_bytes, head); !status.ok()) return status;
  head.load = [block = head.block](Bytes bytes, std::uint64_t first, std::span<Aabb> boxes) {
    return load_aabbs(bytes, block, first, boxes);
  };
  return head;
}

Result<Recording> parse_aabbs(std::span<const std::byte> file) {
  const Result<BoxFile> head = parse_aabbs_head(file, file.size());
  if (!head) return head.status();
  return load_all(*head, file);
}

Result<std::vector<std::byte>> aabbs_head(const RecordingHead& head) {
  Status status = check_text("name", head.name);
  if (status.ok()) status = check_text("type", head.type);
  if (status.ok()) status = check_counts(head);
  if (status.ok()) status = check_world(head.world);
  if (!status.ok()) return status;

  std::vector<std::byte> bytes;
  append_text(bytes, head.name);
  append_text(bytes, head.type);
  append_number(bytes, static_cast<std::int32_t>(head.bodies));
  append_number(bytes, static_cast<std::int32_t>(head.frames - 1));
  append_number(bytes, std::uint64_t{0});
  append_box(bytes, head.world);
  return bytes;
}

void append_aabbs(std::vector<std::byte>& bytes, std::span<const Aabb> boxes) {
  for (const Aabb& box : boxes) append_box(bytes, box);
}

Result<std::vector<std::byte>> aabbs_bytes(const Recording& recording) {
  if (Status status = check_recording(recording); !status.ok()) return status;
  auto bytes = aabbs_head(head_of(recording));
  if (!bytes) return bytes;
  bytes->reserve(kHeaderBytes + recording.boxes.size() * kBoxBytes);
  append_aabbs(*bytes, recording.boxes);
  return bytes;
}

}  // namespace cellsweep
