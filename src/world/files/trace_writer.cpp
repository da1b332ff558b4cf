#include "world/files/trace_writer.h"

#include <string>
#include <utility>

#include "world/files/bytes.h"
#include "world/files/file_fault.h"
#include "world/files/npy_header.h"
#include "world/files/npy_numbers.h"
#include "world/files/npz_arrays.h"
#include "world/files/whole_file.h"

namespace cellsweep {
namespace {

struct ColumnFormat {
  std::string_view name;
  std::string_view type;
  bool is_boxes = false;
};

constexpr std::array<ColumnFormat, 11> kColumnFormats = {{{"inserted", "<u4"},
                                                          {"inserted_boxes", "<f4", true},
                                                          {"inserted_ends", "<u8"},
                                                          {"removed", "<u4"},
                                                          {"removed_ends", "<u8"},
                                                          {"moved", "<u4"},
                                                          {"moved_boxes", "<f4", true},
                                                          {"moved_ends", "<u8"},
                                                          {"category", "<u4"},
                                                          {"mask", "<u4"},
                                                          {"is_static", "|b1"}}};

std::vector<std::byte> head_of(const ColumnFormat& format, std::uint64_t rows) {
  std::vector<std::byte> head;
  const std::array<std::uint64_t, 2> shape = {rows, 6};
  append_npy_header(head, format.type, std::span(shape).first(format.is_boxes ? 2 : 1));
  return head;
}

}  // namespace

Status TraceWriter::open(const std::filesystem::path& path) {
  path_ = path;
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  if (Status status = file_.open(path.string()); !status.ok()) return status;
  for (Column& column : columns_) column.file = std::make_shared<ScratchFile>(path);
  return {};
}

Status TraceWriter::add(const TracePart& part) {
  if (Status status = check(part); !status.ok()) return status;
  Status status = add_numbers(kInserted, part.inserted);
  if (status.ok()) status = add_boxes(kInsertedBoxes, part.inserted_boxes);
  if (status.ok()) status = add_end(kInsertedEnds, kInserted);
  if (status.ok()) status = add_numbers(kRemoved, part.removed);
  if (status.ok()) status = add_end(kRemovedEnds, kRemoved);
  if (status.ok()) status = add_numbers(kMoved, part.moved);
  if (status.ok()) status = add_boxes(kMovedBoxes, part.moved_boxes);
  if (status.ok()) status = add_end(kMovedEnds, kMoved);
  if (status.ok()) status = add_filters(part.inserted_filters);
  return status;
}

Status TraceWriter::check(const TracePart& part) {
  if (Status status = check_boxes("inserted_boxes", kInsertedBoxes, part.inserted_boxes); !status.ok())
    return status;
  if (Status status = check_boxes("moved_boxes", kMovedBoxes, part.moved_boxes); !status.ok()) return status;
  const auto fault = check_.next(part);
  return fault ? refuse(*fault) : Status();
}

Status TraceWriter::check_boxes(std::string_view name, Array array, std::span<const Aabb> boxes) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto fault = find_fault(corners_of(boxes[i]));
    if (!fault) continue;
    return refusal_of_file(path_, std::string(name) + "[" + std::to_string(columns_[array].rows + i) +
                                      "]: expected " + fault->expected + ", found " + fault->found);
  }
  return {};
}

Status TraceWriter::refuse(const TraceFault& fault) const {
  return refusal_of_file(path_,
                         std::string(fault.list) + "[" + std::to_string(fault.index) + "]" + in_frame(fault));
}

Status TraceWriter::add_bytes(Array array, std::size_t rows) {
  columns_[array].rows += rows;
  return columns_[array].file->append(bytes_);
}

template <class Number>
Status TraceWriter::add_numbers(Array array, std::span<const Number> numbers) {
  bytes_.clear();
  for (const Number number : numbers) append_number(bytes_, number);
  return add_bytes(array, numbers.size());
}

Status TraceWriter::add_end(Array ends, Array list) {
  const std::uint64_t end = columns_[list].rows;
  return add_numbers(ends, std::span(&end, 1));
}

Status TraceWriter::add_boxes(Array array, std::span<const Aabb> boxes) {
  bytes_.clear();
  append_boxes(bytes_, boxes);
  return add_bytes(array, boxes.size());
}

Status TraceWriter::add_filters(std::span<const BodyFilter> filters) {
  bytes_.clear();
  for (const BodyFilter& filter : filters) append_number(bytes_, filter.category);
  if (Status status = add_bytes(kCategory, filters.size()); !status.ok()) return status;
  bytes_.clear();
  for (const BodyFilter& filter : filters) append_number(bytes_, filter.mask);
  if (Status status = add_bytes(kMask, filters.size()); !status.ok()) return status;
  bytes_.clear();
  for (const BodyFilter& filter : filters) bytes_.push_back(filter.is_static ? std::byte{1} : std::byte{0});
  return add_bytes(kIsStatic, filters.size());
}

/// Those of the filters only where a body has one.
Result<std::vector<ZipMember>> TraceWriter::members() {
  std::vector<ZipMember> members;
  const std::size_t arrays = columns_[kCategory].rows == 0 ? std::size_t{kCategory} : std::size_t{kArrays};
  for (std::size_t i = 0; i < arrays; ++i) {
    Column& column = columns_[i];
    if (Status status = column.file->flush(); !status.ok()) return status;
    members.push_back({std::string(kColumnFormats[i].name) + std::string(kNpyEnding),
                       std::make_shared<HeadedBytes>(head_of(kColumnFormats[i], column.rows), column.file)});
  }
  return members;
}

Status TraceWriter::commit() {
  if (const auto fault = check_.check_ids()) return refuse(*fault);
  const auto arrays = members();
  if (!arrays) return arrays.status();
  const auto archive = std::make_shared<ScratchFile>(path_);
  if (Status status = write_zip(*arrays, archive); !status.ok()) {
    if (status.code == StatusCode::write_failed) return status;
    return refusal_of_file(path_, status.message);
  }
  if (Status status = copy_to(file_, path_, *archive); !status.ok()) return status;
  return file_.commit();
}

}  // namespace cellsweep
