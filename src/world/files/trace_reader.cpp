#include "world/files/trace_reader.h"

#include <limits>
#include <string>
#include <utility>

#include "world/files/file_fault.h"
#include "world/files/zip_archive.h"

namespace cellsweep {
namespace {

constexpr std::uint64_t kMostId = std::numeric_limits<BodyId>::max();
constexpr std::uint64_t kMostEnd = std::numeric_limits<std::uint64_t>::max();

}  // namespace

Result<std::unique_ptr<TraceReader>> TraceReader::open(std::shared_ptr<const ByteSource> bytes) {
  const Result<ZipArchive> archive = ZipArchive::open(std::move(bytes));
  if (!archive) return archive.status();
  NpzArrays arrays;
  if (Status status = arrays.read_headers(*archive); !status.ok()) return status;
  // Not make_unique: the constructor is nobody else's. The streams point into the reader.
  std::unique_ptr<TraceReader> reader(new TraceReader(std::move(arrays)));
  if (Status status = reader->open_all(*archive); !status.ok()) return status;
  return reader;
}

Status TraceReader::open_all(const ZipArchive& archive) {
  Status status = open_list(archive, "inserted", "inserted_ends", "inserted_boxes");
  if (status.ok()) status = open_list(archive, "removed", "removed_ends", {});
  if (status.ok()) status = open_list(archive, "moved", "moved_ends", "moved_boxes");
  if (status.ok() && has_filters()) status = open_filters(archive);
  return status;
}

Status TraceReader::open_list(const ZipArchive& archive, std::string_view name, std::string_view ends_name,
                              std::string_view boxes_name) {
  Result<ArrayStream> bodies = ArrayStream::open(archive, name, arrays_[name]);
  if (!bodies) return bodies.status();
  Result<ArrayStream> ends = ArrayStream::open(archive, ends_name, arrays_[ends_name]);
  if (!ends) return ends.status();
  List list{name, ends_name, std::move(*bodies), std::move(*ends)};
  if (!boxes_name.empty()) {
    Result<ArrayStream> boxes = ArrayStream::open(archive, boxes_name, arrays_[boxes_name]);
    if (!boxes) return boxes.status();
    list.boxes = std::move(*boxes);
  }
  lists_.push_back(std::move(list));
  return {};
}

Status TraceReader::open_filters(const ZipArchive& archive) {
  Result<ArrayStream> categories = ArrayStream::open(archive, "category", arrays_["category"]);
  if (!categories) return categories.status();
  Result<ArrayStream> masks = ArrayStream::open(archive, "mask", arrays_["mask"]);
  if (!masks) return masks.status();
  Result<ArrayStream> statics = ArrayStream::open(archive, "is_static", arrays_["is_static"]);
  if (!statics) return statics.status();
  filters_ = Filters{std::move(*categories), std::move(*masks), std::move(*statics)};
  return {};
}

Status TraceReader::next(TraceFrame& frame) {
  Status status = read_list(lists_[0], frame.inserted, &frame.inserted_boxes);
  if (status.ok()) status = read_list(lists_[1], frame.removed, nullptr);
  if (status.ok()) status = read_list(lists_[2], frame.moved, &frame.moved_boxes);
  if (status.ok() && filters_) status = read_filters(frame.inserted.size(), frame.inserted_filters);
  if (!status.ok()) return status;
  if (const auto fault = check_.next(frame.part())) return refusal_of(*fault);
  return has_more() ? Status() : finish();
}

Status TraceReader::read_list(List& list, std::vector<BodyId>& bodies, std::vector<Aabb>* boxes) {
  if (Status status = list.ends.read(1, kMostEnd, end_); !status.ok()) return status;
  const std::size_t frame = check_.frames();
  const TraceEnd expected{list.ends_name, list.name, list.end, arrays_[list.name].rows};
  if (const auto fault = find_fault(expected, end_[0], frame, frame + 1 == frames()))
    return refusal_of(*fault);
  const std::uint64_t count = end_[0] - list.end;
  list.end = end_[0];
  if (Status status = list.bodies.read(count, kMostId, bodies); !status.ok()) return status;
  return boxes == nullptr ? Status() : list.boxes->read(count, *boxes);
}

Status TraceReader::read_filters(std::size_t count, std::vector<BodyFilter>& filters) {
  Status status = filters_->categories.read(count, kMostId, categories_);
  if (status.ok()) status = filters_->masks.read(count, kMostId, masks_);
  if (status.ok()) status = filters_->statics.read(count, 1, statics_);
  if (!status.ok()) return status;
  filters.clear();
  for (std::size_t i = 0; i < count; ++i) filters.push_back({categories_[i], masks_[i], statics_[i] != 0});
  return {};
}

Status TraceReader::finish() {
  for (List& list : lists_) {
    Status status = list.bodies.finish();
    if (status.ok()) status = list.ends.finish();
    if (status.ok() && list.boxes) status = list.boxes->finish();
    if (!status.ok()) return status;
  }
  if (!filters_) return {};
  Status status = filters_->categories.finish();
  if (status.ok()) status = filters_->masks.finish();
  if (status.ok()) status = filters_->statics.finish();
  return status;
}

Status TraceReader::refusal_of(const TraceFault& fault) const {
  return in_array(
      fault.list,
      bad_recording("byte " + std::to_string(arrays_[fault.list].offset_of(fault.index)) + in_frame(fault)));
}

}  // namespace cellsweep
