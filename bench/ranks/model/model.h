/// @file
/// What a world of equal cubes, spread evenly, costs over any number of ranks: foretold, not measured.
#pragma once

#include <cstddef>
#include <vector>

namespace cellsweep::ranks_bench {

/// Found by measuring on few ranks, but for the network.
struct Costs {
  double ns_a_body = 0;       ///< CPU time a frame of a body that moves
  double ns_a_ghost = 0;      ///< and of a ghost, at both ends
  double enters_a_ghost = 0;  ///< bodies a frame that come to a rank, for each ghost that there is
  double latency_us = 2;      ///< of a message
  double gigabytes_s = 12.5;  ///< of a rank's way to the network
};

/// For a job of `ranks` in which all bodies move; sums over its ranks unless they say otherwise.
struct Forecast {
  double bodies = 0;
  int ranks = 1;
  double ghosts = 0;
  double bytes = 0;
  double messages = 0;
  double compute_ms = 0;  ///< of one rank
  double network_ms = 0;  ///< of one rank: agreements, the round, the bytes
};

/// Scene `uniform`: unit cubes whose lower corners fill a cube of edge 2 n^(1/3) - 1.
Forecast foretell(double bodies, int ranks, const Costs& costs);

/// The interior's limit for the ghosts of one rank with so many bodies: 3 e N^(2/3).
double ghosts_of_a_rank(double bodies);

}  // namespace cellsweep::ranks_bench
