// Feeds any bytes to the machine as a program.
#include <cstdio>
#include <cstdlib>

#include "machine_properties.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string wrong =
      spu_emu::isa::check_program(std::as_bytes(std::span(data, size)), static_cast<std::uint32_t>(size));
  if (!wrong.empty()) {
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
  }
  return 0;
}
