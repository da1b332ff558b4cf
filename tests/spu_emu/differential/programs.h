// The SPU programs of the differential test: the same rows for the host engine, twice, and as a real SPU ELF.
#pragma once

#include <libspe2.h>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace differential {

struct Program {
  std::string name;
  const char* const* calls;  ///< what each row calls
  std::size_t rows;
  spe_program_handle_t* fast;     ///< host engine, as built by default
  spe_program_handle_t* precise;  ///< host engine, all of single precision
  spe_program_handle_t* real;     ///< by the real compiler

  /// True if a row takes or returns single-precision floats.
  bool is_single_precision(std::size_t row) const;
};

/// How GoogleTest shows a program: by its name.
void PrintTo(const Program& program, std::ostream* out);

std::vector<Program> programs();

}  // namespace differential
