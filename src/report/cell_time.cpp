#include "report/cell_time.h"

#include <algorithm>

#include "report/table.h"

namespace cellsweep::report {
namespace {

using Json = nlohmann::ordered_json;
using Frames = std::vector<const CellFrame*>;

void add_median_and_longest(std::string_view kind, Frames frames, std::vector<CellRow>& rows) {
  if (frames.empty()) return;
  std::stable_sort(frames.begin(), frames.end(),
                   [](const CellFrame* a, const CellFrame* b) { return a->longest_us() < b->longest_us(); });
  rows.push_back({kind, "median", frames[(frames.size() - 1) / 2]});
  rows.push_back({kind, "longest", frames.back()});
}

double start_us(const CellFrame& frame, const PpuCosts& costs) {
  return frame.threads_started ? costs.spu_start_us : 0;
}

double ppu_us(const CellFrame& frame, const PpuCosts& costs) {
  return frame.host_cpu_ms * 1e3 * costs.factor;
}

std::string microseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

void add_spes(const RunReport& run, const CellRow& row, Table& table) {
  for (std::size_t i = 0; i < row.frame->spes.size(); ++i) {
    const SpeTime& spe = row.frame->spes[i];
    table.add({run.engine, std::string(row.kind), std::string(row.which), std::to_string(row.frame->frame),
               std::to_string(i), microseconds(spe.sort), microseconds(spe.change_detection),
               microseconds(spe.compaction), microseconds(spe.overlap), microseconds(spe.dma_wait),
               microseconds(spe.other), microseconds(spe.total())});
  }
}

Json spe_json(const SpeTime& spe) {
  return {{"sort_us", spe.sort},
          {"change_detection_us", spe.change_detection},
          {"compaction_us", spe.compaction},
          {"overlap_us", spe.overlap},
          {"dma_wait_us", spe.dma_wait},
          {"other_us", spe.other},
          {"total_us", spe.total()}};
}

}  // namespace

std::vector<CellRow> cell_rows(const RunReport& run) {
  std::vector<CellRow> rows;
  Frames still;
  Frames moving;
  for (const CellFrame& frame : run.cell) {
    if (frame.frame == 0) {
      rows.push_back({"initial", "", &frame});
    } else {
      (frame.moved == 0 ? still : moving).push_back(&frame);
    }
  }
  add_median_and_longest("static", still, rows);
  add_median_and_longest("dynamic", moving, rows);
  return rows;
}

std::string cell_tables(std::span<const RunReport> runs, const PpuCosts& costs) {
  Table spes({"engine", "frames", "which", "frame", "SPE", "sort", "changes", "compaction", "overlap",
              "DMA wait", "other", "total"},
             3);
  Table frames(
      {"engine", "frames", "which", "frame", "longest SPE", "SPE start", "PPU (estimate)", "host CPU, here"},
      3);
  for (const RunReport& run : runs) {
    for (const CellRow& row : cell_rows(run)) {
      add_spes(run, row, spes);
      frames.add({run.engine, std::string(row.kind), std::string(row.which), std::to_string(row.frame->frame),
                  microseconds(row.frame->longest_us()), microseconds(start_us(*row.frame, costs)),
                  microseconds(ppu_us(*row.frame, costs)), microseconds(row.frame->host_cpu_ms * 1e3)});
    }
  }
  return "Cell time of the SPEs, simulated, in microseconds:\n" + spes.text() +
         "\nBeside it, in microseconds: the start of SPE threads (a stated number), and the CPU time of the "
         "host's part,\nas measured here and times " +
         microseconds(costs.factor) + " for a Cell's PPU. Neither is simulated.\n" + frames.text();
}

Json cell_json(const RunReport& run, const PpuCosts& costs) {
  Json frames = Json::array();
  for (const CellRow& row : cell_rows(run)) {
    Json spes = Json::array();
    for (const SpeTime& spe : row.frame->spes) spes.push_back(spe_json(spe));
    frames.push_back({{"kind", row.kind},
                      {"which", row.which},
                      {"frame", row.frame->frame},
                      {"spes", spes},
                      {"spu_us", row.frame->longest_us()},
                      {"spu_start_us", start_us(*row.frame, costs)},
                      {"host_cpu_ms", row.frame->host_cpu_ms},
                      {"ppu_us", ppu_us(*row.frame, costs)}});
  }
  return {{"ppu_factor", costs.factor}, {"frames", frames}};
}

}  // namespace cellsweep::report
