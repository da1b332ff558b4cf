#include "world/files/npz_arrays.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "world/files/box_file.h"
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
Status check_size(const NpzArray& array, std::uint64_t size) {
  const std::string claim = std::to_string(array.rows) + " rows of " + std::to_string(array.row_bytes) +
                            " bytes from byte " + std::to_string(array.header.data_offset);
  if (array.rows > (size - array.header.data_offset) / array.row_bytes)
    return fault_at(size, claim, "the end of the array");
  const std::uint64_t end = array.offset_of(array.rows);
  if (end == size) return {};
  return fault_at(end, "the end of the array after " + claim, std::to_string(size - end) + " more bytes");
}

/// The first bytes of a member, which have room for any header.
Result<NpyHeader> read_header(const ZipArchive& archive, std::size_t member) {
  Result<ZipStream> stream = archive.stream(member);
  if (!stream) return stream.status();
  std::vector<std::byte> begin(
      std::min<std::uint64_t>(archive.members()[member].bytes, BoxFile::kMostHeadBytes));
  if (Status status = stream->read(begin); !status.ok()) return status;
  return parse_npy_header(begin);
}

Result<NpzArray> read_array(std::string_view name, const ZipArchive& archive, std::size_t member) {
  Result<NpyHeader> header = read_header(archive, member);
  if (!header) return header.status();
  if (Status status = check_type(name, *header); !status.ok()) return status;
  if (Status status = check_shape(name, *header); !status.ok()) return status;
  NpzArray array;
  array.member = member;
  array.rows = header->shape[0];
  array.row_bytes = header->bytes() * (holds_boxes(name) ? 6 : 1);
  array.header = std::move(*header);
  if (Status status = check_size(array, archive.members()[member].bytes); !status.ok()) return status;
  return array;
}

Status wrong_length(std::string_view name, const NpzArray& array, std::uint64_t expected,
                    std::string_view what) {
  const std::uint64_t offset = array.offset_of(std::min(array.rows, expected));
  return in_array(name, bad_recording("byte " + std::to_string(offset) + " (frame 0): expected " +
                                      std::to_string(expected) + std::string(what) + ", found " +
                                      std::to_string(array.rows)));
}

}  // namespace

Status in_array(std::string_view name, Status status) {
  status.message = std::string(name) + std::string(kNpyEnding) + ", " + status.message;
  return status;
}

Status NpzArrays::read_headers(const ZipArchive& archive) {
  for (std::size_t member = 0; member < archive.members().size(); ++member) {
    if (Status status = take(archive, member); !status.ok()) return status;
  }
  if (Status status = check_all_there(); !status.ok()) return status;
  return check_lengths();
}

Status NpzArrays::check_all_there() const {
  const bool any_filters = std::any_of(arrays_.begin() + kOfEveryTrace, arrays_.end(),
                                       [](const NpzArray& array) { return array.is_there(); });
  for (std::size_t i = 0; i < (any_filters ? kNames.size() : kOfEveryTrace); ++i) {
    if (arrays_[i].is_there()) continue;
    return bad_recording("expected the arrays " + all_names() +
                         ", of which the last three may all be missing, found no " + std::string(kNames[i]));
  }
  return {};
}

Status NpzArrays::check_lengths() const {
  const std::uint64_t inserted = (*this)["inserted"].rows;
  for (const std::string_view name : {"category", "mask", "is_static"}) {
    const NpzArray& array = (*this)[name];
    if (!array.is_there() || array.rows == inserted) continue;
    return in_array(
        name, fault_at(array.header.shape_offset, std::to_string(inserted) + " elements, as inserted has",
                       "shape " + cellsweep::quoted(array.header.shape_text)));
  }
  for (const auto& [boxes, list] :
       {std::pair("inserted_boxes", "inserted"), std::pair("moved_boxes", "moved")}) {
    const std::uint64_t rows = (*this)[list].rows;
    if ((*this)[boxes].rows != rows)
      return wrong_length(boxes, (*this)[boxes], rows, " elements, as " + std::string(list) + " has");
  }
  const std::uint64_t frames = (*this)["inserted_ends"].rows;
  if (frames == 0) {
    return in_array("inserted_ends",
                    bad_recording("byte " + std::to_string((*this)["inserted_ends"].offset_of(0)) +
                                  " (frame 0): expected at least one frame, found none"));
  }
  for (const std::string_view name : {"removed_ends", "moved_ends"}) {
    if ((*this)[name].rows != frames)
      return wrong_length(name, (*this)[name], frames, " frames, as inserted_ends has");
  }
  return {};
}

std::size_t NpzArrays::place_of(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
}

Status NpzArrays::take(const ZipArchive& archive, std::size_t member) {
  const std::string& full_name = archive.members()[member].name;
  std::string_view name = full_name;
  const bool has_ending = name.ends_with(kNpyEnding);
  if (has_ending) name.remove_suffix(kNpyEnding.size());
  const std::size_t place = has_ending ? place_of(name) : kNames.size();
  if (place == kNames.size() || arrays_[place].is_there()) {
    return bad_recording("expected the arrays " + all_names() + ", each once, found " +
                         cellsweep::quoted(full_name));
  }
  Result<NpzArray> array = read_array(kNames[place], archive, member);
  if (!array) return in_array(kNames[place], array.status());
  arrays_[place] = std::move(*array);
  return {};
}

}  // namespace cellsweep
