#include <array>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cellsweep/world/trace.h"
#include "world/files/file_fault.h"
#include "world/files/input_file.h"
#include "world/files/npy_numbers.h"
#include "world/files/npz_arrays.h"
#include "world/files/whole_file.h"
#include "world/files/zip_archive.h"
#include "world/trace_check.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostId = std::numeric_limits<BodyId>::max();

/// Whole numbers as the trace holds them.
template <class Number>
Status load(const NpzArrays& arrays, std::string_view name, std::uint64_t most,
            std::vector<Number>& numbers) {
  const NpzArray& array = arrays[name];
  std::vector<std::uint64_t> wide(array.rows);
  if (Status status = load_numbers(array.bytes, array.header, most, wide); !status.ok())
    return in_array(name, status);
  numbers.reserve(wide.size());
  for (const std::uint64_t number : wide) numbers.push_back(static_cast<Number>(number));
  return {};
}

Status load(const NpzArrays& arrays, std::string_view name, std::vector<Aabb>& boxes) {
  const NpzArray& array = arrays[name];
  boxes.resize(array.rows);
  const auto bad = load_boxes(std::span(array.bytes).subspan(array.header.data_offset), array.header, boxes);
  if (!bad) return {};
  const std::uint64_t offset = array.offset_of(bad->box) + bad->fault.corner * array.header.bytes();
  return in_array(name, fault_at(offset, bad->fault.expected, bad->fault.found));
}

Status load_filters(const NpzArrays& arrays, std::vector<BodyFilter>& filters) {
  if (!arrays["category"].is_there()) return {};
  std::vector<std::uint32_t> categories, masks;
  std::vector<std::uint8_t> statics;
  if (Status status = load(arrays, "category", kMostId, categories); !status.ok()) return status;
  if (Status status = load(arrays, "mask", kMostId, masks); !status.ok()) return status;
  if (Status status = load(arrays, "is_static", 1, statics); !status.ok()) return status;
  const std::uint64_t rows = arrays["inserted"].rows;
  for (const std::string_view name : {"category", "mask", "is_static"}) {
    if (arrays[name].rows == rows) continue;
    return in_array(
        name, fault_at(arrays[name].header.shape_offset, std::to_string(rows) + " elements, as inserted has",
                       "shape " + cellsweep::quoted(arrays[name].header.shape_text)));
  }
  for (std::size_t i = 0; i < rows; ++i) filters.push_back({categories[i], masks[i], statics[i] != 0});
  return {};
}

Status load_all(const NpzArrays& arrays, Trace& trace) {
  for (const auto& [name, ids] : {std::pair("inserted", &trace.inserted),
                                  std::pair("removed", &trace.removed), std::pair("moved", &trace.moved)}) {
    if (Status status = load(arrays, name, kMostId, *ids); !status.ok()) return status;
  }
  for (const auto& [name, ends] :
       {std::pair("inserted_ends", &trace.inserted_ends), std::pair("removed_ends", &trace.removed_ends),
        std::pair("moved_ends", &trace.moved_ends)}) {
    if (Status status = load(arrays, name, std::numeric_limits<std::uint64_t>::max(), *ends); !status.ok())
      return status;
  }
  if (Status status = load(arrays, "inserted_boxes", trace.inserted_boxes); !status.ok()) return status;
  if (Status status = load(arrays, "moved_boxes", trace.moved_boxes); !status.ok()) return status;
  return load_filters(arrays, trace.inserted_filters);
}

std::string in_frame(const TraceFault& fault) {
  return " (frame " + std::to_string(fault.frame) + "): expected " + fault.expected + ", found " +
         fault.found;
}

void add_array(std::vector<ZipMember>& members, std::string_view name, std::vector<std::byte> bytes) {
  members.push_back({std::string(name) + std::string(kNpyEnding), std::move(bytes)});
}

void add_numbers(std::vector<ZipMember>& members, std::string_view name, const auto& numbers,
                 std::size_t number_bytes) {
  const std::string type = number_bytes == 1 ? "|b1" : "<u" + std::to_string(number_bytes);
  std::vector<std::byte> bytes;
  const std::array<std::uint64_t, 1> shape = {numbers.size()};
  append_npy_header(bytes, type, shape);
  for (const auto number : numbers) {
    for (std::size_t i = 0; i < number_bytes; ++i)
      bytes.push_back(static_cast<std::byte>(std::uint64_t{number} >> (8 * i) & 0xff));
  }
  add_array(members, name, std::move(bytes));
}

void add_boxes(std::vector<ZipMember>& members, std::string_view name, std::span<const Aabb> boxes) {
  std::vector<std::byte> bytes;
  const std::array<std::uint64_t, 2> shape = {boxes.size(), 6};
  append_npy_header(bytes, "<f4", shape);
  append_boxes(bytes, boxes);
  add_array(members, name, std::move(bytes));
}

void add_filters(std::vector<ZipMember>& members, std::span<const BodyFilter> filters) {
  std::vector<std::uint32_t> categories, masks;
  std::vector<std::uint8_t> statics;
  for (const BodyFilter& filter : filters) {
    categories.push_back(filter.category);
    masks.push_back(filter.mask);
    statics.push_back(filter.is_static ? 1 : 0);
  }
  add_numbers(members, "category", categories, 4);
  add_numbers(members, "mask", masks, 4);
  add_numbers(members, "is_static", statics, 1);
}

std::vector<ZipMember> members_of(const Trace& trace) {
  std::vector<ZipMember> members;
  add_numbers(members, "inserted", trace.inserted, 4);
  add_boxes(members, "inserted_boxes", trace.inserted_boxes);
  add_numbers(members, "inserted_ends", trace.inserted_ends, 8);
  add_numbers(members, "removed", trace.removed, 4);
  add_numbers(members, "removed_ends", trace.removed_ends, 8);
  add_numbers(members, "moved", trace.moved, 4);
  add_boxes(members, "moved_boxes", trace.moved_boxes);
  add_numbers(members, "moved_ends", trace.moved_ends, 8);
  if (!trace.inserted_filters.empty()) add_filters(members, trace.inserted_filters);
  return members;
}

/// What a trace is that was made in memory.
Status check_trace(const Trace& trace) {
  for (const auto& [name, boxes] :
       {std::pair("inserted_boxes", &trace.inserted_boxes), std::pair("moved_boxes", &trace.moved_boxes)}) {
    for (std::size_t i = 0; i < boxes->size(); ++i) {
      if (const auto fault = find_fault(corners_of((*boxes)[i]))) {
        return bad_recording(std::string(name) + "[" + std::to_string(i) + "]: expected " + fault->expected +
                             ", found " + fault->found);
      }
    }
  }
  const auto fault = find_fault(trace);
  if (!fault) return {};
  return bad_recording(std::string(fault->list) + "[" + std::to_string(fault->index) + "]" +
                       in_frame(*fault));
}

Status with_file(const fs::path& path, const Status& status) {
  return refusal_of_file(path, status.message);
}

Result<Trace> trace_of(Result<std::vector<ZipMember>> members) {
  if (!members) return members.status();
  NpzArrays arrays;
  if (Status status = arrays.take_all(std::move(*members)); !status.ok()) return status;
  Trace trace;
  if (Status status = load_all(arrays, trace); !status.ok()) return status;
  const auto fault = find_fault(trace);
  if (!fault) return trace;
  const NpzArray& array = arrays[fault->list];
  return bad_recording(std::string(fault->list) + std::string(kNpyEnding) + ", byte " +
                       std::to_string(array.offset_of(fault->index)) + in_frame(*fault));
}

}  // namespace

bool traces_have_files() {
  return zip_is_there();
}

Result<Trace> parse_npz(std::span<const std::byte> file) {
  return trace_of(read_zip(file));
}

Result<Trace> read_trace(const std::filesystem::path& path) {
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  const auto file = InputFile::open(path);
  if (!file) return file.status();
  Result<Trace> trace = trace_of(read_zip_file((*file)->path(), (*file)->size()));
  if (!trace) return with_file(path, trace.status());
  trace->name = path.stem().string();
  return trace;
}

Status write_trace(const Trace& trace, const std::filesystem::path& path) {
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  if (Status status = check_trace(trace); !status.ok()) return with_file(path, status);
  const Result<std::vector<std::byte>> bytes = zip_bytes(members_of(trace));
  if (!bytes) return with_file(path, bytes.status());
  return write_file(path, *bytes);
}

}  // namespace cellsweep
