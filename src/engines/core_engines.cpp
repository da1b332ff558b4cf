#include "engines/core_engines.h"

#include "base/settings.h"
#include "cellsweep/options.h"
#include "engines/stream/settings.h"

namespace cellsweep {
namespace {

std::vector<SettingRow<ControlOptions>> control_rows() {
  return {
      {{"literal", SettingKind::flag, "false",
        "the document's logic to the letter, misses and all (not exact)"},
       [](ControlOptions& options, std::string_view value) { return read_flag(options.literal, value); }},
      {{"pair_map_bytes", SettingKind::bytes, "536870912",
        "memory that the map of all possible pairs may take"},
       [](ControlOptions& options, std::string_view value) {
         return read_number(options.pair_map_bytes, value);
       }},
      {{"trace", SettingKind::text, "", "write a timeline that opens in Perfetto to this file"},
       [](ControlOptions& options, std::string_view value) { return read_text(options.trace, value); }},
  };
}

std::vector<SettingRow<OracleOptions>> oracle_rows() {
  return {{{"trace", SettingKind::text, "", "write a timeline that opens in Perfetto to this file"},
           [](OracleOptions& options, std::string_view value) { return read_text(options.trace, value); }}};
}

template <class Options>
Result<Broadphase> make_from(std::string_view engine, const SettingValues& values,
                             const std::vector<SettingRow<Options>>& rows) {
  auto options = read_settings<Options>(engine, values, rows);
  if (!options) return options.status();
  return make_broadphase(*options);
}

Result<Broadphase> make_control(const SettingValues& values) {
  return make_from("control", values, control_rows());
}

Result<Broadphase> make_stream(const SettingValues& values) {
  return make_from("stream", values, stream::setting_rows());
}

Result<Broadphase> make_oracle(const SettingValues& values) {
  return make_from("oracle", values, oracle_rows());
}

}  // namespace

std::vector<EngineInfo> core_engines() {
  return {
      {"control",
       "the document's x86 sweep and prune: three insertion-sorted axes, a map of all possible pairs",
       describe_settings<ControlOptions>(control_rows()), make_control},
      {"stream",
       "worlds of any size and density: cells within cells, wide vectors, threads; cost follows change",
       describe_settings<StreamOptions>(stream::setting_rows()), make_stream},
      {"oracle", "all boxes against all boxes, which judges the others",
       describe_settings<OracleOptions>(oracle_rows()), make_oracle},
  };
}

}  // namespace cellsweep
