/// @file
/// Feeds any bytes to the reader of traces.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>

#include "cellsweep/world/trace.h"

namespace {

void require(bool holds, const char* property) {
  if (holds) return;
  std::fprintf(stderr, "property does not hold: %s\n", property);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto trace = cellsweep::parse_npz(std::as_bytes(std::span(data, size)));
  if (!trace) {
    const cellsweep::Status status = trace.status();
    require(status.code == cellsweep::StatusCode::bad_input, "a refusal has the code bad_input");
    require(status.message.size() < 400, "a refusal is a sentence, not a copy of the file");
    return 0;
  }
  const auto frames = cellsweep::make_trace_frames(std::make_shared<const cellsweep::Trace>(*trace));
  std::size_t count = 1;
  for (; frames->advance(); ++count) {
    for (const cellsweep::BodyId body : frames->bodies())
      require(body < frames->boxes().size(), "every body has a box");
  }
  require(count == trace->frames(), "every frame comes once");
  return 0;
}
