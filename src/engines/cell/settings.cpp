#include "engines/cell/settings.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engines/stream/settings.h"

namespace cellsweep::cell {
namespace {

template <class Options>
using Rows = std::vector<SettingRow<Options>>;

constexpr std::array<std::pair<std::string_view, SpeEngine>, 2> kSpeEngines = {
    {{"host", SpeEngine::host}, {"isa", SpeEngine::isa}}};

constexpr std::array<std::pair<std::string_view, DmaMode>, 3> kDmaModes = {
    {{"eager", DmaMode::eager}, {"late", DmaMode::late}, {"unchecked", DmaMode::unchecked}}};

template <class Value, std::size_t count>
std::vector<std::string_view> names_of(const std::array<std::pair<std::string_view, Value>, count>& choices) {
  std::vector<std::string_view> names;
  names.reserve(count);
  for (const auto& choice : choices) names.push_back(choice.first);
  return names;
}

/// What executes the programs.
template <class Options>
void add_engine_rows(Rows<Options>& rows) {
  rows.push_back({{"local_store", SettingKind::bytes, "262144", "local store of an SPE; 0: no limit"},
                  [](Options& options, std::string_view value) {
                    return read_number(options.spes.local_store, value);
                  }});
  rows.push_back({{"spe_engine", SettingKind::choice, "host",
                   "SPU programs compiled for this machine (host), or for a real SPU and executed "
                   "instruction by instruction (isa)",
                   names_of(kSpeEngines)},
                  [](Options& options, std::string_view value) {
                    return read_choice<SpeEngine>(options.spes.spe_engine, value, kSpeEngines);
                  }});
  rows.push_back({{"dma", SettingKind::choice, "eager", "when transfers move", names_of(kDmaModes)},
                  [](Options& options, std::string_view value) {
                    return read_choice<DmaMode>(options.spes.dma, value, kDmaModes);
                  }});
  rows.push_back(
      {{"dma_seed", SettingKind::number, "1", "the order of late transfers"},
       [](Options& options, std::string_view value) { return read_number(options.spes.dma_seed, value); }});
}

template <class Options>
void add_cycle_rows(Rows<Options>& rows) {
  rows.push_back(
      {{"cycles", SettingKind::flag, "false",
        "with spe_engine isa: what the SPEs would take on a Cell, step by step"},
       [](Options& options, std::string_view value) { return read_flag(options.spes.cycles, value); }});
  rows.push_back({{"cycle_parameter", SettingKind::texts, "",
                   "with cycles: change a number of the model, as NAME=VALUE; spu-run "
                   "--list-cycle-parameters names them"},
                  [](Options& options, std::string_view value) {
                    options.spes.cycle_parameter.emplace_back(value);
                    return true;
                  }});
}

template <class Options>
void add_spus_row(Rows<Options>& rows) {
  rows.push_back({{"spus", SettingKind::number, "0", "SPUs that work; 0: the engine chooses"},
                  [](Options& options, std::string_view value) { return read_number(options.spus, value); }});
}

std::string& trace_of(CellStreamOptions& options) {
  return options.stream.trace;
}
template <class Options>
std::string& trace_of(Options& options) {
  return options.trace;
}

/// What every engine on SPEs has.
template <class Options>
void add_common_rows(Rows<Options>& rows) {
  add_engine_rows(rows);
  add_cycle_rows(rows);
  rows.push_back(
      {{"trace", SettingKind::text, "",
        "write a timeline that opens in Perfetto: phases, and SPEs with their transfers and waits"},
       [](Options& options, std::string_view value) { return read_text(trace_of(options), value); }});
}

Rows<CellPaperOptions> paper_rows() {
  using Options = CellPaperOptions;
  Rows<Options> rows = {
      {{"method", SettingKind::number, "1", "the document's overlap test, 1 or 2"},
       [](Options& options, std::string_view value) { return read_number(options.method, value); }},
      {{"literal", SettingKind::flag, "false",
        "the document's logic to the letter, misses and all (not exact)"},
       [](Options& options, std::string_view value) { return read_flag(options.literal, value); }},
      {{"list_dma", SettingKind::flag, "false", "results by DMA list, not in chunks"},
       [](Options& options, std::string_view value) { return read_flag(options.list_dma, value); }},
      {{"pair_map_bytes", SettingKind::bytes, "536870912", "memory its map of all possible pairs may take"},
       [](Options& options, std::string_view value) { return read_number(options.pair_map_bytes, value); }}};
  add_common_rows(rows);
  return rows;
}

Rows<CellBruteOptions> brute_rows() {
  Rows<CellBruteOptions> rows;
  add_spus_row(rows);
  add_common_rows(rows);
  return rows;
}

Rows<CellResidentOptions> resident_rows() {
  using Options = CellResidentOptions;
  Rows<Options> rows;
  add_spus_row(rows);
  rows.push_back(
      {{"spu_boxes", SettingKind::flag, "false", "given poses, it makes their boxes on the SPUs"},
       [](Options& options, std::string_view value) { return read_flag(options.spu_boxes, value); }});
  add_common_rows(rows);
  return rows;
}

Rows<CellStreamOptions> stream_rows() {
  using Options = CellStreamOptions;
  Rows<Options> rows;
  add_spus_row(rows);
  rows.push_back(
      {{"threads", SettingKind::number, "0", "worker threads of the host; 0: the engine chooses"},
       [](Options& options, std::string_view value) { return read_number(options.stream.threads, value); }});
  rows.push_back(
      {{"isa", SettingKind::choice, "best", "instruction set of the host's kernels", names_of(stream::kIsas)},
       [](Options& options, std::string_view value) {
         return read_choice<VectorIsa>(options.stream.isa, value, stream::kIsas);
       }});
  rows.push_back(
      {{"max_pairs", SettingKind::number, "0", "an update that finds more pairs is refused; 0: no limit"},
       [](Options& options, std::string_view value) {
         return read_number(options.stream.max_pairs, value);
       }});
  add_common_rows(rows);
  return rows;
}

}  // namespace

template <>
std::span<const SettingRow<CellPaperOptions>> setting_rows() {
  static const auto rows = paper_rows();
  return rows;
}

template <>
std::span<const SettingRow<CellBruteOptions>> setting_rows() {
  static const auto rows = brute_rows();
  return rows;
}

template <>
std::span<const SettingRow<CellResidentOptions>> setting_rows() {
  static const auto rows = resident_rows();
  return rows;
}

template <>
std::span<const SettingRow<CellStreamOptions>> setting_rows() {
  static const auto rows = stream_rows();
  return rows;
}

}  // namespace cellsweep::cell
