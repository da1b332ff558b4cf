/// @file
/// Runs and verifications as tables for a person.
#pragma once

#include <span>
#include <string>

#include "report/run_engine.h"
#include "report/table.h"
#include "report/verify.h"

namespace cellsweep::report {

/// One row an engine: times, and the pairs of the last reported frame.
std::string run_table(const std::string& source, std::span<const RunReport> runs);

/// The pairs and hash of every reported frame, one row an engine and frame.
std::string frame_table(std::span<const RunReport> runs);

/// One row an engine: frames compared and what was missed or invented.
std::string verify_table(const std::string& source, std::span<const VerifyReport> verdicts);

}  // namespace cellsweep::report
