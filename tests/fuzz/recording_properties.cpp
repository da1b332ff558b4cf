#include "recording_properties.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace cellsweep {
namespace {

void require(bool holds, std::string_view property) {
  if (holds) return;
  std::fprintf(stderr, "property does not hold: %s\n", std::string(property).c_str());
  std::abort();
}

void check_refusal(const Status& status, std::size_t file_bytes) {
  require(status.code == StatusCode::bad_input, "a refusal has the code bad_input");
  constexpr std::string_view kBegin = "byte ";
  require(status.message.starts_with(kBegin), "a refusal begins with the byte at fault");
  const unsigned long long offset = std::stoull(status.message.substr(kBegin.size()));
  require(offset <= file_bytes, "the byte at fault is in the file or at its end");
  require(status.message.size() < 400, "a refusal is a sentence, not a copy of the file");
  for (const char c : status.message) require(c >= ' ' && c <= '~', "a refusal is printable");
}

void check_boxes(const Recording& recording, std::size_t file_bytes) {
  require(recording.boxes.capacity() * sizeof(Aabb) <= file_bytes, "boxes take no more memory than the file");
  require(recording.boxes.size() == recording.frames() * recording.bodies, "boxes fill whole frames");
  for (const Aabb& box : recording.boxes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      require(std::isfinite(box.min[axis]) && std::isfinite(box.max[axis]), "boxes are finite");
      require(box.min[axis] <= box.max[axis], "boxes have min <= max");
    }
  }
}

bool same_bits(const Recording& one, const Recording& other) {
  return one.bodies == other.bodies && one.boxes.size() == other.boxes.size() &&
         (one.boxes.empty() ||
          std::memcmp(one.boxes.data(), other.boxes.data(), one.boxes.size() * sizeof(Aabb)) == 0) &&
         std::memcmp(&one.world, &other.world, sizeof(Aabb)) == 0;
}

void check_round_trip(const RecordingFormat& format, const Recording& recording) {
  const auto written = format.bytes(recording);
  require(written.ok() == (recording.frames() > 0), "what was read can be written, unless it has no frames");
  if (!written) return;
  const Result<Recording> again = format.parse(*written);
  require(again.ok(), "what was written can be read");
  require(same_bits(recording, *again), "what was written reads back bit for bit");
  require(recording.name == again->name && recording.type == again->type, "name and type come back");
}

}  // namespace

void check_reader(const RecordingFormat& format, std::span<const std::byte> file) {
  const Result<Recording> recording = format.parse(file);
  if (!recording) return check_refusal(recording.status(), file.size());
  check_boxes(*recording, file.size());
  check_round_trip(format, *recording);
}

}  // namespace cellsweep
