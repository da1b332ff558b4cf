#include <array>
#include <string_view>
#include <utility>

#include "cellsweep/world/recording.h"
#include "world/files/aabbs_file.h"
#include "world/files/npy_file.h"
#include "world/files/npy_numbers.h"
#include "world/files/recorded_frames.h"
#include "world/files/recording_writer.h"
#include "world/files/whole_file.h"
#include "world/recording_check.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

/// One kind of file: its ending and what is in it.
struct Format {
  std::string_view ending;
  Result<std::vector<std::byte>> (*bytes)(const Recording&);
  Result<std::vector<std::byte>> (*head)(const RecordingHead&);
  void (*append)(std::vector<std::byte>&, std::span<const Aabb>);
};

constexpr std::array<Format, 2> kFormats = {{
    {".aabbs", aabbs_bytes, aabbs_head, append_aabbs},
    {".npy", npy_bytes, npy_head, append_boxes},
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

Status RecordingWriter::open(const std::filesystem::path& path, RecordingHead head) {
  path_ = path;
  head_ = std::move(head);
  head_.frames = 1;  // until they are counted
  const Format* format = find_format(path);
  if (format == nullptr) return unknown_ending(path);
  if (const auto bytes = format->head(head_); !bytes) return with_path(path, bytes.status());
  head_.frames = 0;
  if (Status status = file_.open(path.string()); !status.ok()) return status;
  boxes_ = std::make_shared<ScratchFile>(path);
  return {};
}

Status RecordingWriter::add(std::span<const Aabb> boxes) {
  if (auto fault = find_faulty_box(boxes, head_.frames)) return with_path(path_, std::move(*fault));
  bytes_.clear();
  find_format(path_)->append(bytes_, boxes);
  ++head_.frames;
  return boxes_->append(bytes_);
}

Status RecordingWriter::commit() {
  if (head_.bodies == 0 || head_.frames == 0) return with_path(path_, check_recording({}));
  auto head = find_format(path_)->head(head_);
  if (!head) return with_path(path_, head.status());
  if (Status status = boxes_->flush(); !status.ok()) return status;
  if (Status status = copy_to(file_, path_, HeadedBytes(std::move(*head), boxes_)); !status.ok())
    return status;
  return file_.commit();
}

}  // namespace cellsweep
