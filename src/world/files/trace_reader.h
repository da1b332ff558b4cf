/// @file
/// A trace that is read from its archive frame by frame, and checked as it is read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"
#include "world/files/array_stream.h"
#include "world/files/byte_source.h"
#include "world/files/npz_arrays.h"
#include "world/trace_check.h"
#include "world/trace_part.h"

namespace cellsweep {

/// All arrays in step. What it holds is a part of each array, the states of the bodies, and what the caller
/// asks for: a frame. One thread at a time. Errors: those of parse_npz().
class TraceReader {
 public:
  /// Reads what the headers say, and compares the arrays' lengths.
  static Result<std::unique_ptr<TraceReader>> open(std::shared_ptr<const ByteSource> bytes);

  std::size_t frames() const { return arrays_["inserted_ends"].rows; }
  std::size_t inserted() const { return arrays_["inserted"].rows; }
  std::size_t removed() const { return arrays_["removed"].rows; }
  std::size_t moved() const { return arrays_["moved"].rows; }
  bool has_filters() const { return arrays_.has_filters(); }

  bool has_more() const { return check_.frames() < frames(); }
  /// The next frame; there is one. With the last one it looks at the checksums, too.
  Status next(TraceFrame& frame);
  /// One more than the largest id of the frames that were read.
  std::size_t ids() const { return check_.ids(); }

 private:
  /// A list, where its frames end, and what belongs to its elements.
  struct List {
    std::string_view name;
    std::string_view ends_name;
    ArrayStream bodies;
    ArrayStream ends;
    std::optional<ArrayStream> boxes{};
    std::uint64_t end = 0;  // of the frames before
  };
  struct Filters {
    ArrayStream categories;
    ArrayStream masks;
    ArrayStream statics;
  };

  explicit TraceReader(NpzArrays arrays) : arrays_(std::move(arrays)), check_(arrays_["inserted"].rows) {}

  Status open_all(const ZipArchive& archive);
  Status open_list(const ZipArchive& archive, std::string_view name, std::string_view ends_name,
                   std::string_view boxes_name);
  Status open_filters(const ZipArchive& archive);
  Status read_list(List& list, std::vector<BodyId>& bodies, std::vector<Aabb>* boxes);
  Status read_filters(std::size_t count, std::vector<BodyFilter>& filters);
  Status finish();
  Status refusal_of(const TraceFault& fault) const;

  NpzArrays arrays_;
  std::vector<List> lists_;  // inserted, removed, moved
  std::optional<Filters> filters_;
  TraceCheck check_;
  std::vector<std::uint64_t> end_;
  std::vector<std::uint32_t> categories_;
  std::vector<std::uint32_t> masks_;
  std::vector<std::uint8_t> statics_;
};

}  // namespace cellsweep
