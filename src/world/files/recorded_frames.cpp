#include "world/files/recorded_frames.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "geometry/bounds.h"
#include "world/files/whole_file.h"

namespace cellsweep {
namespace {

/// Read from the file at a time, about.
constexpr std::size_t kPartBytes = std::size_t{1} << 20;

struct HeadFormat {
  std::string_view ending;
  Result<BoxFile> (*parse)(std::span<const std::byte>, std::uint64_t);
};

constexpr std::array<HeadFormat, 2> kHeadFormats = {{{".aabbs", parse_aabbs_head}, {".npy", parse_npy_head}}};

Status of_file(const std::string& path, const Status& status) {
  Status with_path = status;
  with_path.message = path + ": " + status.message;
  return with_path;
}

class StreamedFrames final : public FrameSource {
 public:
  explicit StreamedFrames(std::shared_ptr<const RecordedFrames> recorded)
      : recorded_(std::move(recorded)), boxes_(recorded_->bodies()), next_(recorded_->bodies()) {
    if (recorded_->frames() > 0) status_ = recorded_->read(0, boxes_);
  }

  std::string name() const override { return recorded_->name(); }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> moved() const override { return moved_; }
  Status status() const override { return status_; }

  bool advance() override {
    if (!status_.ok() || frame_ + 1 >= recorded_->frames()) return false;
    status_ = recorded_->read((frame_ + 1) * boxes_.size(), next_);
    if (!status_.ok()) return false;
    ++frame_;
    moved_.clear();
    for (std::size_t body = 0; body < boxes_.size(); ++body) {
      if (next_[body] != boxes_[body]) moved_.push_back(static_cast<BodyId>(body));
    }
    std::swap(boxes_, next_);
    return true;
  }

 private:
  std::shared_ptr<const RecordedFrames> recorded_;
  std::size_t frame_ = 0;
  std::vector<Aabb> boxes_;
  std::vector<Aabb> next_;
  std::vector<BodyId> moved_;
  Status status_;
};

}  // namespace

Result<RecordedFrames> RecordedFrames::open(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  const auto format = std::ranges::find(kHeadFormats, std::string_view(ending), &HeadFormat::ending);
  if (format == kHeadFormats.end())
    return refusal_of_file(path, "expected a name that ends in .aabbs or .npy");
  auto file = InputFile::open(path);
  if (!file) return file.status();
  std::vector<std::byte> begin(std::min<std::uint64_t>((*file)->size(), BoxFile::kMostHeadBytes));
  if (Status status = (*file)->read(0, begin); !status.ok()) return status;
  auto head = format->parse(begin, (*file)->size());
  if (!head) return of_file((*file)->path(), head.status());
  RecordedFrames recorded;
  recorded.file_ = std::move(*file);
  recorded.head_ = std::move(*head);
  if (recorded.head_.name.empty() && ending == ".npy") recorded.head_.name = path.stem().string();
  return recorded;
}

Status RecordedFrames::read(std::uint64_t first, std::span<Aabb> boxes) const {
  const std::uint64_t box_bytes = head_.block.box_bytes;
  const std::size_t most = std::max<std::size_t>(1, kPartBytes / box_bytes);
  std::vector<std::byte> bytes(std::min(most, boxes.size()) * box_bytes);
  while (!boxes.empty()) {
    const std::span<Aabb> part = boxes.first(std::min(most, boxes.size()));
    const std::span<std::byte> read = std::span(bytes).first(part.size() * box_bytes);
    if (Status status = file_->read(head_.block.offset + first * box_bytes, read); !status.ok())
      return status;
    if (Status status = head_.load(read, first, part); !status.ok()) return of_file(file_->path(), status);
    first += part.size();
    boxes = boxes.subspan(part.size());
  }
  return {};
}

Status RecordedFrames::for_each_box(const std::function<void(const Aabb&)>& look) const {
  const std::uint64_t all = head_.boxes();
  std::vector<Aabb> part(std::min<std::uint64_t>(all, kPartBytes / sizeof(Aabb)));
  for (std::uint64_t first = 0; first < all; first += part.size()) {
    part.resize(std::min<std::uint64_t>(part.size(), all - first));
    if (Status status = read(first, part); !status.ok()) return status;
    for (const Aabb& box : part) look(box);
  }
  return {};
}

Status RecordedFrames::check() {
  Bounds bounds;
  if (Status status = for_each_box([&](const Aabb& box) { bounds.include(box); }); !status.ok())
    return status;
  if (!head_.world) head_.world = bounds.box();
  return {};
}

Result<Recording> RecordedFrames::read_all() const {
  return recording_of(head_, [this](std::span<Aabb> boxes) { return read(0, boxes); });
}

std::unique_ptr<FrameSource> make_recorded_frames(std::shared_ptr<const RecordedFrames> recorded) {
  return std::make_unique<StreamedFrames>(std::move(recorded));
}

}  // namespace cellsweep
