// What the SPU program of the differential test is told; 32-bit words only.
#pragma once

struct DifferentialJob {
  unsigned int input_hi;
  unsigned int input_lo;
  unsigned int output_hi;
  unsigned int output_lo;
  unsigned int first_row;
  unsigned int rows;
  unsigned int padding[2];
};

// Cases of one run; a case is four quadwords of input and one of output for each row.
constexpr unsigned kCases = 64;
constexpr unsigned kInputsPerCase = 4;
