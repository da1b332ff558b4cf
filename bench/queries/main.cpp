/// @file
/// The program of the suite of queries: Google Benchmark's options. Those that are compared take turns, so
/// that each row comes three times; all go into out/queries/queries.json, too, unless rows are chosen.
/// `--quick`, as the first argument, asks a few questions to worlds of 1,000 bodies, once.
#include <array>
#include <cstddef>
#include <string_view>

#include "bench/queries/frame_suite.h"
#include "bench/queries/query_suite.h"
#include "bench/run_rows.h"

namespace {

using cellsweep::bench::FrameSuite;
using cellsweep::bench::QuerySuite;

constexpr std::array<std::size_t, 1> kQuickBodies = {1'000};
constexpr QuerySuite kQuick{kQuickBodies, 256, 1};
constexpr FrameSuite kQuickFrames{kQuickBodies, 256, 30, 1};

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  if (quick) {
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  cellsweep::bench::register_query_suite(quick ? kQuick : QuerySuite{});
  cellsweep::bench::register_frame_suite(quick ? kQuickFrames : FrameSuite{});
  return cellsweep::bench::run_rows(argc, argv, {}, quick ? "" : "out/queries/queries.json");
}
