/// @file
/// The program of the suite of peers: Google Benchmark's options and, by default, up to 100,000 bodies. Peers
/// that are compared take turns, so that each row comes several times; all go into out/peers/peers.json, too,
/// unless rows are chosen. `--notes` prints how to read the rows; `--giant first|middle|last`, as the first
/// argument, puts a giant into every scene, and the results into out/peers/giant-SLOT.json.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "bench/peers/few_suite.h"
#include "bench/peers/peer_suite.h"
#include "bench/peers/peer_table.h"
#include "bench/peers/tail_suite.h"
#include "bench/run_rows.h"

namespace {

std::optional<cellsweep::GiantSlot> slot_of(std::string_view word) {
  using cellsweep::GiantSlot;
  if (word == "first") return GiantSlot::first;
  if (word == "middle") return GiantSlot::middle;
  if (word == "last") return GiantSlot::last;
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--notes") {
    std::fputs(cellsweep::bench::peer_notes().c_str(), stdout);
    return 0;
  }
  cellsweep::GiantSlot giant = cellsweep::GiantSlot::none;
  std::string out = "out/peers/peers.json";
  if (argc > 1 && std::string_view(argv[1]) == "--giant") {
    const auto slot = argc > 2 ? slot_of(argv[2]) : std::nullopt;
    if (!slot) {
      std::fputs("--giant: first, middle or last is wanted.\n", stderr);
      return 2;
    }
    giant = *slot;
    out = "out/peers/giant-" + std::string(argv[2]) + ".json";
    benchmark::AddCustomContext("giant", argv[2]);
    // The name of the program stands in front of what is left.
    argv[2] = argv[0];
    argv += 2;
    argc -= 2;
  }
  cellsweep::bench::register_peer_suite(giant);
  cellsweep::bench::register_few_suite();
  cellsweep::bench::register_tail_suite();
  return cellsweep::bench::run_rows(argc, argv, {"--benchmark_filter=/(1000|10000|100000)/"}, out);
}
