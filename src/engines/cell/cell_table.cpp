#include <string_view>

#include "base/text.h"
#include "cellsweep/cell.h"
#include "cellsweep/engines.h"
#include "engines/cell/settings.h"

namespace cellsweep {
namespace {

struct CellRow {
  std::string_view name;
  std::string_view summary;
  std::vector<SettingInfo> (*settings)();
  Result<Broadphase> (*make)(const SettingValues& settings);
  Result<LocalStoreMap> (*map)(const SettingValues& settings, std::uint64_t bodies);
};

template <class Options>
constexpr std::string_view kNameOf{};
template <>
constexpr std::string_view kNameOf<CellPaperOptions> = "cell-paper";
template <>
constexpr std::string_view kNameOf<CellBruteOptions> = "cell-brute";
template <>
constexpr std::string_view kNameOf<CellResidentOptions> = "cell-resident";
template <>
constexpr std::string_view kNameOf<CellStreamOptions> = "cell-stream";

template <class Options>
Result<Options> read(const SettingValues& settings) {
  return read_settings<Options>(kNameOf<Options>, settings, cell::setting_rows<Options>());
}

template <class Options>
constexpr CellRow row_of(std::string_view summary) {
  return {kNameOf<Options>, summary, [] { return describe_settings(cell::setting_rows<Options>()); },
          [](const SettingValues& settings) -> Result<Broadphase> {
            const auto options = read<Options>(settings);
            return options ? make_broadphase(*options) : options.status();
          },
          [](const SettingValues& settings, std::uint64_t bodies) -> Result<LocalStoreMap> {
            const auto options = read<Options>(settings);
            return options ? local_store_map(*options, bodies) : options.status();
          }};
}

constexpr CellRow kRows[] = {
    row_of<CellPaperOptions>(
        "the document's Cell version step by step: an axis an SPU, threads started each frame"),
    row_of<CellBruteOptions>(
        "what Bullet's Cell port did: every changed body against all others on the SPUs, no sort"),
    row_of<CellResidentOptions>(
        "SPU programs that stay alive, keep the pairs' status, and are told only what changed"),
    row_of<CellStreamOptions>(
        "engine stream with its cells compared on the SPUs: in pieces, they go through the local stores")};

}  // namespace

void add_cell_engines() {
  for (const CellRow& row : kRows) add_engine({row.name, row.summary, row.settings(), row.make});
}

Result<LocalStoreMap> local_store_map(std::string_view engine, const SettingValues& settings,
                                      std::uint64_t bodies) {
  for (const CellRow& row : kRows) {
    if (row.name == engine) return row.map(settings, bodies);
  }
  // A name that is in no table is refused in the table's words.
  if (find_engine(engine) == nullptr) return make_broadphase(engine, settings).status();
  return Status::bad_option("engine",
                            text("Engine ", engine, " does not run on SPEs and has no local store."));
}

}  // namespace cellsweep
