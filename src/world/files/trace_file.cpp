#include <memory>
#include <span>
#include <string>
#include <utility>

#include "cellsweep/world/trace.h"
#include "world/files/byte_source.h"
#include "world/files/input_file.h"
#include "world/files/trace_reader.h"
#include "world/files/trace_writer.h"
#include "world/files/whole_file.h"
#include "world/files/zip_archive.h"
#include "world/trace_check.h"

namespace cellsweep {
namespace {

Result<Trace> read_all(std::shared_ptr<const ByteSource> bytes) {
  const auto reader = TraceReader::open(std::move(bytes));
  if (!reader) return reader.status();
  Trace trace;
  TraceFrame frame;
  while ((*reader)->has_more()) {
    if (Status status = (*reader)->next(frame); !status.ok()) return status;
    append(trace, frame.part());
  }
  return trace;
}

}  // namespace

bool traces_have_files() {
  return zip_is_there();
}

Result<Trace> parse_npz(std::span<const std::byte> file) {
  return read_all(std::make_shared<BytesInMemory>(file));
}

Result<Trace> read_trace(const std::filesystem::path& path) {
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  auto file = InputFile::open(path);
  if (!file) return file.status();
  Result<Trace> trace = read_all(std::move(*file));
  if (!trace) return refusal_of_file(path, trace.status().message);
  trace->name = path.stem().string();
  return trace;
}

Status write_trace(const Trace& trace, const std::filesystem::path& path) {
  if (const auto fault = find_fault(trace)) {
    return refusal_of_file(
        path, std::string(fault->list) + "[" + std::to_string(fault->index) + "]" + in_frame(*fault));
  }
  TraceWriter writer;
  if (Status status = writer.open(path); !status.ok()) return status;
  for (std::size_t frame = 0; frame < trace.frames(); ++frame) {
    if (Status status = writer.add(part_of(trace, frame)); !status.ok()) return status;
  }
  return writer.commit();
}

}  // namespace cellsweep
