#include <array>
#include <string_view>

#include "cellsweep/world/recording.h"
#include "world/files/aabbs_file.h"
#include "world/files/npy_file.h"
#include "world/files/recorded_frames.h"
#include "world/files/whole_file.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

/// One kind of file: its ending and what is in it.
struct Format {
  std::string_view ending;
  Result<std::vector<std::byte>> (*bytes)(const Recording&);
};

constexpr std::array<Format, 2> kFormats = {{
    {".aabbs", aabbs_bytes},
    {".npy", npy_bytes},
}};

const Format* find_format(const fs::path& path) {
  const std::string ending = path.extension().string();
  for (const Format& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

Status with_path(const fs::path& path, Status status) {
  status.message = path.string() + ": " + status.message;
  return status;
}

Status unknown_ending(const fs::path& path) {
  return refusal_of_file(path, "expected a name that ends in .aabbs or .npy");
}

}  // namespace

Result<Recording> read_recording(const std::filesystem::path& path) {
  const auto recorded = RecordedFrames::open(path);
  if (!recorded) return recorded.status();
  return recorded->read_all();
}

Status write_recording(const Recording& recording, const std::filesystem::path& path) {
  const Format* format = find_format(path);
  if (format == nullptr) return unknown_ending(path);
  const Result<std::vector<std::byte>> bytes = format->bytes(recording);
  if (!bytes) return with_path(path, bytes.status());
  return write_file(path, *bytes);
}

}  // namespace cellsweep
