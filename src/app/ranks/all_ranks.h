/// @file
/// Sums over all ranks of the job, which all of them make together.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>

#include "cellsweep/pair.h"
#include "cellsweep/ranks.h"

namespace cellsweep::app {

inline std::uint64_t sum_of_all(std::uint64_t mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

inline std::uint64_t xor_of_all(std::uint64_t mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_UINT64_T, MPI_BXOR, MPI_COMM_WORLD);
  return mine;
}

inline double sum_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return mine;
}

inline double most_of_all(double mine) {
  MPI_Allreduce(MPI_IN_PLACE, &mine, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return mine;
}

/// Pairs of all ranks: how many, and their hash.
struct PairSum {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;

  friend bool operator==(const PairSum&, const PairSum&) = default;
};

inline PairSum sum_of(std::span<const GlobalPair> mine) {
  return {sum_of_all(std::uint64_t{mine.size()}), xor_of_all(global_pair_set_hash(mine))};
}

/// Of one engine, which has them all.
inline PairSum sum_of(std::span<const Pair> whole) {
  return {whole.size(), pair_set_hash(whole)};
}

}  // namespace cellsweep::app
