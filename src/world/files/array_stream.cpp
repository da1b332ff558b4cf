#include "world/files/array_stream.h"

#include <algorithm>
#include <span>
#include <utility>

#include "world/files/npy_numbers.h"

namespace cellsweep {
namespace {

/// Read from a member at a time, about.
constexpr std::uint64_t kHeldOfArray = std::uint64_t{1} << 16;

}  // namespace

Result<ArrayStream> ArrayStream::open(const ZipArchive& archive, std::string_view name,
                                      const NpzArray& array) {
  Result<ZipStream> stream = archive.stream(array.member);
  if (!stream) return stream.status();
  ArrayStream opened(std::move(*stream), name, array);
  if (Status status = opened.skip_header(); !status.ok()) return status;
  return opened;
}

Status ArrayStream::skip_header() {
  std::vector<std::byte> header(array_->header.data_offset);
  return stream_.read(header);
}

Result<std::span<const std::byte>> ArrayStream::next_rows(std::uint64_t count) {
  const std::uint64_t row_bytes = array_->row_bytes;
  if (begin_ == held_.size()) {
    const std::uint64_t most = std::min(array_->rows - row_, kHeldOfArray / row_bytes);
    held_.resize(most * row_bytes);
    begin_ = 0;
    if (Status status = stream_.read(held_); !status.ok()) return status;
  }
  const std::uint64_t rows = std::min<std::uint64_t>(count, (held_.size() - begin_) / row_bytes);
  const std::span<const std::byte> bytes = std::span(held_).subspan(begin_, rows * row_bytes);
  begin_ += bytes.size();
  row_ += rows;
  return bytes;
}

Status ArrayStream::read_part(std::uint64_t count, std::uint64_t most) {
  const std::uint64_t first = row_;
  const auto bytes = next_rows(count);
  if (!bytes) return bytes.status();
  part_.resize(bytes->size() / array_->row_bytes);
  Status status = load_numbers(*bytes, array_->header, first, most, part_);
  return status.ok() ? status : in_array(name_, std::move(status));
}

Status ArrayStream::read(std::uint64_t count, std::vector<Aabb>& boxes) {
  boxes.clear();
  while (boxes.size() < count) {
    const std::size_t first = boxes.size();
    const std::uint64_t first_row = row_;
    const auto bytes = next_rows(count - first);
    if (!bytes) return bytes.status();
    boxes.resize(first + bytes->size() / array_->row_bytes);
    const auto bad = load_boxes(*bytes, array_->header, std::span(boxes).subspan(first));
    if (!bad) continue;
    const std::uint64_t offset =
        array_->offset_of(first_row + bad->box) + bad->fault.corner * array_->header.bytes();
    return in_array(name_, fault_at(offset, bad->fault.expected, bad->fault.found));
  }
  return {};
}

Status ArrayStream::finish() {
  return stream_.finish();
}

}  // namespace cellsweep
