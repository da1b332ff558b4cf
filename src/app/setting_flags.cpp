#include "app/setting_flags.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "base/text.h"

namespace cellsweep::app {
namespace {

constexpr std::string_view kMayBeOff = "local_store";
constexpr std::size_t kLongestChoices = 24;

constexpr std::array<std::pair<char, unsigned>, 3> kUnits = {{{'G', 30}, {'M', 20}, {'K', 10}}};

/// What stands for the values of settings whose kind does not say it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kValueNames = {
    {{"local_store", "SIZE|off"}, {"trace", "FILE"}, {"cycle_parameter", "NAME=VALUE"}}};

SharedSetting& entry_of(const SettingInfo& info, std::vector<SharedSetting>& settings) {
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const SharedSetting& setting) {
    return setting.info.name == info.name;
  });
  if (found != settings.end()) return *found;
  return settings.emplace_back(SharedSetting{info, {}});
}

std::optional<std::uint64_t> read_number(std::string_view digits) {
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, number);
  return error == std::errc() && last == end ? std::optional(number) : std::nullopt;
}

// "512M" is 2^29; nothing for what is no size, or too large a one.
std::optional<std::uint64_t> read_size(std::string_view typed) {
  unsigned shift = 0;
  if (typed.ends_with('B') || typed.ends_with('b')) typed.remove_suffix(1);
  for (const auto& [letter, bits] : kUnits) {
    if (typed.empty() || std::toupper(static_cast<unsigned char>(typed.back())) != letter) continue;
    typed.remove_suffix(1);
    shift = bits;
    break;
  }
  const auto number = read_number(typed);
  if (!number || *number > std::numeric_limits<std::uint64_t>::max() >> shift) return std::nullopt;
  return *number << shift;
}

std::string size_text(std::string_view bytes) {
  const auto number = read_number(bytes);
  if (number && *number == 0) return "off";
  for (const auto& [letter, bits] : kUnits) {
    if (number && *number % (std::uint64_t{1} << bits) == 0) return std::to_string(*number >> bits) + letter;
  }
  return std::string(bytes);
}

std::string joined(const std::vector<std::string_view>& words, std::string_view between) {
  std::string all;
  for (const std::string_view word : words) all.append(all.empty() ? "" : between).append(word);
  return all;
}

std::string default_text(const SettingInfo& info) {
  if (info.initial.empty() || info.kind == SettingKind::flag) return {};
  return " [" + (info.kind == SettingKind::bytes ? size_text(info.initial) : std::string(info.initial)) + "]";
}

// "cell-paper" is one of the house `cell-`; empty for an engine alone.
std::string_view house_of(std::string_view engine) {
  const std::size_t dash = engine.find('-');
  return dash == std::string_view::npos ? std::string_view() : engine.substr(0, dash + 1);
}

// Whether all engines of a house are among these.
bool has_whole_house(std::string_view house, const std::vector<std::string_view>& names) {
  const auto all = engine_table();
  return !house.empty() && std::all_of(all.begin(), all.end(), [&](const EngineInfo& engine) {
    return house_of(engine.name) != house ||
           std::find(names.begin(), names.end(), engine.name) != names.end();
  });
}

// "control, cell-*" where all Cell engines are among them.
std::string short_names_text(const std::vector<std::string_view>& names) {
  std::vector<std::string> shown;
  for (const std::string_view name : names) {
    const std::string_view house = house_of(name);
    std::string one = has_whole_house(house, names) ? std::string(house) + "*" : std::string(name);
    if (std::find(shown.begin(), shown.end(), one) == shown.end()) shown.push_back(std::move(one));
  }
  return joined({shown.begin(), shown.end()}, ", ");
}

bool is_in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

// The word's place from `from` on; npos when it is not there.
std::size_t find_word(const std::string& message, std::string_view word, std::size_t from) {
  for (std::size_t at = message.find(word, from); at != std::string::npos; at = message.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_in_word(message[at - 1])) && (end == message.size() || !is_in_word(message[end])))
      return at;
  }
  return std::string::npos;
}

// `times` at most.
void replace_word(std::string& message, std::string_view word, const std::string& by, std::size_t times) {
  for (std::size_t at = find_word(message, word, 0); at != std::string::npos && times > 0; --times) {
    message.replace(at, word.size(), by);
    at = find_word(message, word, at + by.size());
  }
}

}  // namespace

std::vector<SharedSetting> shared_settings() {
  std::vector<SharedSetting> settings;
  for (const EngineInfo& engine : engine_table()) {
    for (const SettingInfo& info : engine.settings) entry_of(info, settings).engines.push_back(engine.name);
  }
  return settings;
}

std::string flag_of(std::string_view setting) {
  std::string flag = "--" + std::string(setting);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string value_name(const SettingInfo& info) {
  for (const auto& [setting, name] : kValueNames) {
    if (setting == info.name) return std::string(name);
  }
  switch (info.kind) {
    case SettingKind::flag:
      return "";
    case SettingKind::number:
      return "N";
    case SettingKind::bytes:
      return "SIZE";
    case SettingKind::length:
      return "LENGTH";
    case SettingKind::choice: {
      const std::string choices = joined(info.choices, "|");
      return choices.size() <= kLongestChoices ? choices : "NAME";
    }
    default:
      return "TEXT";
  }
}

std::string names_text(const std::vector<std::string_view>& names) {
  return joined(names, ", ");
}

std::string help_of(const SharedSetting& setting) {
  std::string help(setting.info.help);
  if (!help.empty()) help[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(help[0])));
  if (value_name(setting.info) == "NAME") help += ": " + names_text(setting.info.choices);
  const bool all = setting.engines.size() == engine_table().size();
  return with_flags(help) + default_text(setting.info) +
         (all ? "" : " (" + short_names_text(setting.engines) + ")");
}

std::string value_from_typed(const SettingInfo& info, const std::string& typed) {
  if (info.kind != SettingKind::bytes) return typed;
  if (info.name == kMayBeOff && typed == "off") return "0";
  const auto bytes = read_size(typed);
  return bytes ? std::to_string(*bytes) : typed;
}

std::string with_flags(std::string words, std::string_view about) {
  for (const SharedSetting& setting : shared_settings()) {
    const std::string_view name = setting.info.name;
    const bool is_name = name.find('_') != std::string_view::npos;
    // Others are replaced once: behind that they are likely to be the words themselves.
    if (is_name || name == about) replace_word(words, name, flag_of(name), is_name ? words.size() : 1);
  }
  return words;
}

std::string message_with_flags(const Status& status) {
  return with_flags(status.message, status.setting);
}

}  // namespace cellsweep::app
