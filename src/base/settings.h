/// @file
/// Reads an options struct from texts: a row for each member that may be set.
#pragma once

#include <cfloat>
#include <charconv>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.h"
#include "cellsweep/engines.h"

namespace cellsweep {

/// A setting, and what puts a value of it into the options; false for a text that is no value of its kind.
template <class Options>
struct SettingRow {
  SettingInfo info;
  bool (*set)(Options& options, std::string_view value);
};

/// A whole number of any width; false for one that does not fit.
template <class Number>
bool read_number(Number& number, std::string_view value) {
  Number read{};
  const char* const end = value.data() + value.size();
  const auto [last, error] = std::from_chars(value.data(), end, read);
  if (error != std::errc() || last != end) return false;
  number = read;
  return true;
}

/// A number with or without a fraction, not negative, that is finite.
inline bool read_length(float& length, std::string_view value) {
  float read{};
  const char* const end = value.data() + value.size();
  const auto [last, error] = std::from_chars(value.data(), end, read);
  if (error != std::errc() || last != end || !(read >= 0 && read <= FLT_MAX)) return false;
  length = read;
  return true;
}

inline bool read_flag(bool& flag, std::string_view value) {
  if (value != "true" && value != "false") return false;
  flag = value == "true";
  return true;
}

inline bool read_text(std::string& text, std::string_view value) {
  text = value;
  return true;
}

/// One of several names, each with the value that it stands for.
template <class Value>
bool read_choice(Value& chosen, std::string_view value,
                 std::span<const std::pair<std::string_view, Value>> choices) {
  for (const auto& [name, meaning] : choices) {
    if (name != value) continue;
    chosen = meaning;
    return true;
  }
  return false;
}

inline std::string_view describe(SettingKind kind) {
  switch (kind) {
    case SettingKind::flag:
      return "true or false";
    case SettingKind::number:
      return "a whole number, 0 or more, that fits";
    case SettingKind::bytes:
      return "a number of bytes";
    case SettingKind::length:
      return "a length, 0 or more, as 0.25";
    case SettingKind::choice:
      return "one of its choices";
    default:
      return "a text";
  }
}

/// The rows' descriptions, for the engine table.
template <class Options>
std::vector<SettingInfo> describe_settings(std::span<const SettingRow<Options>> rows) {
  std::vector<SettingInfo> infos;
  for (const auto& row : rows) infos.push_back(row.info);
  return infos;
}

/// What is wrong with a value, with the choices there are.
[[gnu::cold]] inline Status bad_value(const SettingInfo& info, std::string_view value) {
  std::string wanted(describe(info.kind));
  for (const std::string_view choice : info.choices)
    wanted += text(choice == info.choices.front() ? ": " : ", ", choice);
  return Status::bad_option(std::string(info.name),
                            text(info.name, " is \"", value, "\"; it must be ", wanted, "."));
}

/// What an engine says to a setting that it does not have.
[[gnu::cold]] inline Status unknown_setting(std::string_view engine, std::string_view name,
                                            std::span<const SettingInfo> infos) {
  std::string known;
  for (const SettingInfo& info : infos) known += text(known.empty() ? "" : ", ", info.name);
  return Status::bad_option(std::string(name), text("Engine ", engine, " has no setting ", name,
                                                    "; it has: ", known.empty() ? "none" : known, "."));
}

/// The options that the values ask for. Errors: bad_option.
template <class Options>
Result<Options> read_settings(std::string_view engine, const SettingValues& values,
                              std::span<const SettingRow<Options>> rows) {
  Options options{};
  for (const auto& [name, value] : values) {
    bool known = false;
    for (const auto& row : rows) {
      if (row.info.name != name) continue;
      if (!row.set(options, value)) return bad_value(row.info, value);
      known = true;
    }
    if (!known) return unknown_setting(engine, name, describe_settings(rows));
  }
  return options;
}

}  // namespace cellsweep
