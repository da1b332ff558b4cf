#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "cellsweep/world/trace.h"
#include "world/files/bytes.h"
#include "world/files/file_fault.h"
#include "world/files/npy_header.h"
#include "world/files/npy_numbers.h"
#include "world/files/whole_file.h"
#include "world/files/zip_archive.h"
#include "world/trace_check.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;
using Bytes = std::span<const std::byte>;

constexpr std::string_view kEnding = ".npy";
/// Those of the filters come last: a trace has all of them or none.
constexpr std::array<std::string_view, 11> kNames = {
    "inserted",    "inserted_boxes", "inserted_ends", "removed", "removed_ends", "moved",
    "moved_boxes", "moved_ends",     "category",      "mask",    "is_static"};
constexpr std::size_t kNeeded = 8;
constexpr std::uint64_t kMostId = std::numeric_limits<BodyId>::max();

std::string all_names() {
  std::string names;
  for (const std::string_view name : kNames) names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

Status in_array(std::string_view name, Status status) {
  status.message = std::string(name) + std::string(kEnding) + ", " + status.message;
  return status;
}

/// An array as the archive has it.
struct Array {
  std::vector<std::byte> bytes;
  NpyHeader header;
  std::uint64_t rows = 0;
  std::uint64_t row_bytes = 0;

  bool is_there() const { return !bytes.empty(); }
};

bool holds_boxes(std::string_view name) {
  return name == "inserted_boxes" || name == "moved_boxes";
}

Status check_type(std::string_view name, const NpyHeader& header) {
  if (holds_boxes(name) == header.is_of("f")) return {};
  return fault_at(header.type_offset, holds_boxes(name) ? "float32 or float64" : "integers or truth values",
                  cellsweep::quoted(header.type));
}

/// One number a row, or six.
Result<Array> read_array(std::string_view name, ZipMember member) {
  Result<NpyHeader> header = parse_npy_header(member.bytes);
  if (!header) return header.status();
  if (Status status = check_type(name, *header); !status.ok()) return status;
  const std::span<const std::uint64_t> shape = header->shape;
  if (holds_boxes(name) ? shape.size() != 2 || shape[1] != 6 : shape.size() != 1) {
    return fault_at(header->shape_offset, holds_boxes(name) ? "shape (bodies, 6)" : "one dimension",
                    "shape " + cellsweep::quoted(header->shape_text));
  }
  Array array;
  array.bytes = std::move(member.bytes);
  array.header = std::move(*header);
  array.rows = array.header.shape[0];
  array.row_bytes = array.header.bytes() * (holds_boxes(name) ? 6 : 1);
  const BoxBlock block{array.header.data_offset, array.row_bytes, array.rows, 1};
  const std::uint64_t room = (array.bytes.size() - block.offset) / block.box_bytes;
  const std::string claim = std::to_string(array.rows) + " rows of " + std::to_string(array.row_bytes) +
                            " bytes from byte " + std::to_string(block.offset);
  if (array.rows > room) return fault_at(array.bytes.size(), claim, "the end of the array");
  const std::uint64_t end = block.offset + array.rows * array.row_bytes;
  if (end == array.bytes.size()) return array;
  return fault_at(end, "the end of the array after " + claim,
                  std::to_string(array.bytes.size() - end) + " more bytes");
}

/// The arrays of a trace, by place in kNames.
class Arrays {
 public:
  Status read(Bytes file) {
    Result<std::vector<ZipMember>> members = read_zip(file);
    if (!members) return members.status();
    for (ZipMember& member : *members) {
      if (Status status = take(std::move(member)); !status.ok()) return status;
    }
    const bool has_filters = std::any_of(arrays_.begin() + kNeeded, arrays_.end(),
                                         [](const Array& array) { return array.is_there(); });
    for (std::size_t i = 0; i < (has_filters ? kNames.size() : kNeeded); ++i) {
      if (arrays_[i].is_there()) continue;
      return bad_recording("expected the arrays " + all_names() +
                           ", of which the last three may all be missing, found no " +
                           std::string(kNames[i]));
    }
    return {};
  }

  const Array& operator[](std::string_view name) const { return arrays_[place_of(name)]; }

 private:
  static std::size_t place_of(std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
  }

  Status take(ZipMember member) {
    std::string_view name = member.name;
    const bool has_ending = name.ends_with(kEnding);
    if (has_ending) name.remove_suffix(kEnding.size());
    const std::size_t place = has_ending ? place_of(name) : kNames.size();
    if (place == kNames.size() || arrays_[place].is_there()) {
      return bad_recording("expected the arrays " + all_names() + ", each once, found " +
                           cellsweep::quoted(member.name));
    }
    Result<Array> array = read_array(kNames[place], std::move(member));
    if (!array) return in_array(kNames[place], array.status());
    arrays_[place] = std::move(*array);
    return {};
  }

  std::array<Array, kNames.size()> arrays_;
};

/// Whole numbers as the trace holds them.
template <class Number>
Status load(const Arrays& arrays, std::string_view name, std::uint64_t most, std::vector<Number>& numbers) {
  const Array& array = arrays[name];
  std::vector<std::uint64_t> wide(array.rows);
  if (Status status = load_numbers(array.bytes, array.header, most, wide); !status.ok())
    return in_array(name, status);
  numbers.reserve(wide.size());
  for (const std::uint64_t number : wide) numbers.push_back(static_cast<Number>(number));
  return {};
}

Status load(const Arrays& arrays, std::string_view name, std::vector<Aabb>& boxes) {
  const Array& array = arrays[name];
  boxes.resize(array.rows);
  const auto bad = load_boxes(array.bytes, array.header, boxes);
  if (!bad) return {};
  const std::uint64_t offset =
      array.header.data_offset + bad->box * array.row_bytes + bad->fault.corner * array.header.bytes();
  return in_array(name, fault_at(offset, bad->fault.expected, bad->fault.found));
}

Status load_filters(const Arrays& arrays, std::vector<BodyFilter>& filters) {
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

Status load_all(const Arrays& arrays, Trace& trace) {
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
  members.push_back({std::string(name) + std::string(kEnding), std::move(bytes)});
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

}  // namespace

bool traces_have_files() {
  return zip_is_there();
}

Result<Trace> parse_npz(std::span<const std::byte> file) {
  Arrays arrays;
  if (Status status = arrays.read(file); !status.ok()) return status;
  Trace trace;
  if (Status status = load_all(arrays, trace); !status.ok()) return status;
  const auto fault = find_fault(trace);
  if (!fault) return trace;
  const Array& array = arrays[fault->list];
  return bad_recording(std::string(fault->list) + std::string(kEnding) + ", byte " +
                       std::to_string(array.header.data_offset + fault->index * array.row_bytes) +
                       in_frame(*fault));
}

Result<Trace> read_trace(const std::filesystem::path& path) {
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.status();
  Result<Trace> trace = parse_npz(*bytes);
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
