/// @file
/// Feeds any bytes to the reader of NumPy's .npy.
#include <cstddef>
#include <cstdint>
#include <span>

#include "recording_properties.h"
#include "world/files/npy_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cellsweep::check_reader({cellsweep::parse_npy, cellsweep::npy_bytes}, std::as_bytes(std::span(data, size)));
  return 0;
}
