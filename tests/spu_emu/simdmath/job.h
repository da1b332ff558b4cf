// What the SPU program that evaluates functions is told; 32-bit words only.
#pragma once

struct SimdmathJob {
  unsigned int function;
  unsigned int batches;
  unsigned int input_hi;
  unsigned int input_lo;
  unsigned int output_hi;
  unsigned int output_lo;
  unsigned int padding[2];
};

// Calls of a batch.
constexpr unsigned kBatch = 64;
