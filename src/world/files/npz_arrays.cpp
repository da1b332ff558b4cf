#include "world/files/npz_arrays.h"

#include <algorithm>
#include <utility>

#include "world/files/file_fault.h"

namespace cellsweep {
namespace {

/// Those of the filters come last: a trace has all of them or none.
constexpr std::array<std::string_view, 11> kNames = {
    "inserted",    "inserted_boxes", "inserted_ends", "removed", "removed_ends", "moved",
    "moved_boxes", "moved_ends",     "category",      "mask",    "is_static"};
constexpr std::size_t kOfEveryTrace = 8;

std::string all_names() {
  std::string names;
  for (const std::string_view name : kNames) names.append(names.empty() ? "" : ", ").append(name);
  return names;
}

bool holds_boxes(std::string_view name) {
  return name == "inserted_boxes" || name == "moved_boxes";
}

Status check_type(std::string_view name, const NpyHeader& header) {
  if (holds_boxes(name) == header.is_of("f")) return {};
  return fault_at(header.type_offset, holds_boxes(name) ? "float32 or float64" : "integers or truth values",
                  cellsweep::quoted(header.type));
}

Status check_shape(std::string_view name, const NpyHeader& header) {
  const std::span<const std::uint64_t> shape = header.shape;
  const bool fits = holds_boxes(name) ? shape.size() == 2 && shape[1] == 6 : shape.size() == 1;
  if (fits) return {};
  return fault_at(header.shape_offset, holds_boxes(name) ? "shape (bodies, 6)" : "one dimension",
                  "shape " + cellsweep::quoted(header.shape_text));
}

// Divides before it multiplies: a liar's number of rows may be any.
Status check_length(const NpzArray& array) {
  const std::uint64_t size = array.bytes.size();
  const std::string claim = std::to_string(array.rows) + " rows of " + std::to_string(array.row_bytes) +
                            " bytes from byte " + std::to_string(array.header.data_offset);
  if (array.rows > (size - array.header.data_offset) / array.row_bytes)
    return fault_at(size, claim, "the end of the array");
  const std::uint64_t end = array.offset_of(array.rows);
  if (end == size) return {};
  return fault_at(end, "the end of the array after " + claim, std::to_string(size - end) + " more bytes");
}

Result<NpzArray> read_array(std::string_view name, ZipMember member) {
  Result<NpyHeader> header = parse_npy_header(member.bytes);
  if (!header) return header.status();
  if (Status status = check_type(name, *header); !status.ok()) return status;
  if (Status status = check_shape(name, *header); !status.ok()) return status;
  NpzArray array;
  array.rows = header->shape[0];
  array.row_bytes = header->bytes() * (holds_boxes(name) ? 6 : 1);
  array.header = std::move(*header);
  array.bytes = std::move(member.bytes);
  if (Status status = check_length(array); !status.ok()) return status;
  return array;
}

}  // namespace

Status in_array(std::string_view name, Status status) {
  status.message = std::string(name) + std::string(kNpyEnding) + ", " + status.message;
  return status;
}

Status NpzArrays::take_all(std::vector<ZipMember> members) {
  for (ZipMember& member : members) {
    if (Status status = take(std::move(member)); !status.ok()) return status;
  }
  const bool has_filters = std::any_of(arrays_.begin() + kOfEveryTrace, arrays_.end(),
                                       [](const NpzArray& array) { return array.is_there(); });
  for (std::size_t i = 0; i < (has_filters ? kNames.size() : kOfEveryTrace); ++i) {
    if (arrays_[i].is_there()) continue;
    return bad_recording("expected the arrays " + all_names() +
                         ", of which the last three may all be missing, found no " + std::string(kNames[i]));
  }
  return {};
}

std::size_t NpzArrays::place_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
}

Status NpzArrays::take(ZipMember member) {
  std::string_view name = member.name;
  const bool has_ending = name.ends_with(kNpyEnding);
  if (has_ending) name.remove_suffix(kNpyEnding.size());
  const std::size_t place = has_ending ? place_of(name) : kNames.size();
  if (place == kNames.size() || arrays_[place].is_there()) {
    return bad_recording("expected the arrays " + all_names() + ", each once, found " +
                         cellsweep::quoted(member.name));
  }
  Result<NpzArray> array = read_array(kNames[place], std::move(member));
  if (!array) return in_array(kNames[place], array.status());
  arrays_[place] = std::move(*array);
  return {};
}

}  // namespace cellsweep
