#include "report/run_table.h"

#include "report/quantile.h"
#include "report/units.h"

namespace cellsweep::report {

std::string run_table(const std::string& source, std::span<const RunReport> runs) {
  Table table({"source", "engine", "bodies", "updates", "set-up", "initial", "median", "p99", "longest"}, 2);
  for (const RunReport& run : runs) {
    table.add({source, run.engine, std::to_string(run.bodies), std::to_string(run.update_ms.size()),
               duration_text(run.setup_ms), duration_text(run.initial_ms),
               duration_text(quantile(run.update_ms, 0.5)), duration_text(quantile(run.update_ms, 0.99)),
               duration_text(quantile(run.update_ms, 1.0))});
  }
  return table.text();
}

std::string frame_table(std::span<const RunReport> runs) {
  Table table({"engine", "frame", "pairs", "hash"});
  for (const RunReport& run : runs) {
    for (const FrameReport& frame : run.frames) {
      table.add(
          {run.engine, std::to_string(frame.frame), std::to_string(frame.pairs), hash_text(frame.hash)});
    }
  }
  return table.text();
}

std::string verify_table(const std::string& source, std::span<const VerifyReport> verdicts) {
  Table table({"source", "engine", "frames", "pairs in all", "missed", "invented", "verdict"}, 2);
  for (const VerifyReport& verdict : verdicts) {
    table.add({source, verdict.engine, std::to_string(verdict.frames), std::to_string(verdict.pairs),
               std::to_string(verdict.missed), std::to_string(verdict.invented),
               verdict.exact() ? "exact" : "differs"});
  }
  return table.text();
}

}  // namespace cellsweep::report
