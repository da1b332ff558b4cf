/// @file
/// Runs, verifications and the engine table as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "report/run_engine.h"
#include "report/verify.h"

namespace cellsweep::report {

/// {"engines":[{"engine","bodies","frames","initial_ms","setup_ms","update_ms":{"median","p99","max"},
/// "reports":[{"frame","pairs","hash"}]}]}. `frames` counts the updates after frame 0. Times in milliseconds.
nlohmann::ordered_json to_json(std::span<const RunReport> runs);

/// {"exact",  "engines":[{"engine","exact","frames","pairs","missed","invented","first_difference"}]};
/// `first_difference` is there only when there is one.
nlohmann::ordered_json to_json(std::span<const VerifyReport> verdicts);

}  // namespace cellsweep::report
