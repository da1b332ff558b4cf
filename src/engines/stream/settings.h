/// @file
/// The settings of engine `stream` by name, for it and for engines that are made of it.
#pragma once

#include <array>
#include <utility>

#include "base/settings.h"
#include "cellsweep/options.h"

namespace cellsweep::stream {

inline constexpr std::array<std::pair<std::string_view, VectorIsa>, 5> kIsas = {
    {{"best", VectorIsa::best},
     {"portable", VectorIsa::portable},
     {"sse4.1", VectorIsa::sse41},
     {"avx2", VectorIsa::avx2},
     {"avx512", VectorIsa::avx512}}};

inline std::vector<SettingRow<StreamOptions>> setting_rows() {
  return {
      {{"threads", SettingKind::number, "0",
        "threads that work, the calling one included; 0: as many as pay"},
       [](StreamOptions& options, std::string_view value) { return read_number(options.threads, value); }},
      {{"isa",
        SettingKind::choice,
        "best",
        "instruction set of the kernels",
        {"best", "portable", "sse4.1", "avx2", "avx512"}},
       [](StreamOptions& options, std::string_view value) {
         return read_choice<VectorIsa>(options.isa, value, kIsas);
       }},
      {{"margin", SettingKind::length, "0",
        "how far fat boxes reach beyond bodies that move; 0: by how each moves"},
       [](StreamOptions& options, std::string_view value) { return read_length(options.margin, value); }},
      {{"max_pairs", SettingKind::number, "0", "an update that finds more pairs is refused; 0: no limit"},
       [](StreamOptions& options, std::string_view value) { return read_number(options.max_pairs, value); }},
      {{"trace", SettingKind::text, "", "write a timeline that opens in Perfetto to this file"},
       [](StreamOptions& options, std::string_view value) { return read_text(options.trace, value); }},
  };
}

}  // namespace cellsweep::stream
