#include "spe/debugger_choice.h"

#include <charconv>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace spu_emu {

namespace {
unsigned number_in(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc{} && end == text.data() + text.size()) return number;
  throw std::invalid_argument("SPU_EMU_DEBUG=\"" + std::string(text) +
                              "\" is no number of an SPE; the first that a program makes is 0");
}

/// "all", or numbers with commas between them.
bool names_spe(std::string_view chosen, unsigned number) {
  if (chosen == "all") return true;
  bool found = false;
  for (;;) {
    const std::size_t comma = chosen.find(',');
    found = number_in(chosen.substr(0, comma)) == number || found;
    if (comma == std::string_view::npos) return found;
    chosen.remove_prefix(comma + 1);
  }
}

/// Of a file for each SPE the name has a % where its number stands.
std::string file_of(std::string name, unsigned number) {
  const std::size_t place = name.find('%');
  if (place != std::string::npos) name.replace(place, 1, std::to_string(number));
  return name;
}
}  // namespace

std::optional<DebuggerSettings> debugger_of(const EmulationSettings& settings, unsigned number) {
  if (settings.debugger) return settings.debugger;
  const char* chosen = std::getenv("SPU_EMU_DEBUG");
  if (chosen == nullptr || *chosen == '\0' || !names_spe(chosen, number)) return std::nullopt;
  const char* commands = std::getenv("SPU_EMU_DEBUG_COMMANDS");
  return DebuggerSettings{commands != nullptr ? file_of(commands, number) : ""};
}

}  // namespace spu_emu
