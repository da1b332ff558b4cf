#include "bindings/c/call.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "base/text.h"

namespace cellsweep::c {
namespace {

constexpr std::array<const char*, 11> kNames = {
    "ok",        "invalid_box", "unknown_body", "duplicate_body", "capacity",       "bad_option",
    "bad_input", "spe_failed",  "write_failed", "no_memory",      "callback_failed"};

static_assert(static_cast<int>(StatusCode::ok) == CELLSWEEP_OK);
static_assert(static_cast<int>(StatusCode::invalid_box) == CELLSWEEP_INVALID_BOX);
static_assert(static_cast<int>(StatusCode::unknown_body) == CELLSWEEP_UNKNOWN_BODY);
static_assert(static_cast<int>(StatusCode::duplicate_body) == CELLSWEEP_DUPLICATE_BODY);
static_assert(static_cast<int>(StatusCode::capacity) == CELLSWEEP_CAPACITY);
static_assert(static_cast<int>(StatusCode::bad_option) == CELLSWEEP_BAD_OPTION);
static_assert(static_cast<int>(StatusCode::bad_input) == CELLSWEEP_BAD_INPUT);
static_assert(static_cast<int>(StatusCode::spe_failed) == CELLSWEEP_SPE_FAILED);
static_assert(static_cast<int>(StatusCode::write_failed) == CELLSWEEP_WRITE_FAILED);

template <std::size_t kSize>
void write_text(std::string_view from, char (&to)[kSize]) {  // NOLINT(*-avoid-c-arrays): C's
  constexpr std::string_view kCut = "...";
  const std::size_t length = std::min(from.size(), kSize - 1);
  std::memcpy(to, from.data(), length);
  to[length] = '\0';
  if (length < from.size()) std::memcpy(to + length - kCut.size(), kCut.data(), kCut.size());
}

cellsweep_status report_other(cellsweep_status status, std::string_view message, cellsweep_failure* failure) {
  if (failure == nullptr) return status;
  *failure = {};
  failure->status = status;
  write_text(message, failure->message);
  return status;
}

cellsweep_status report_no_memory(cellsweep_failure* failure) {
  return report_other(CELLSWEEP_NO_MEMORY, "There is no memory for this call; nothing has changed.", failure);
}

}  // namespace

Status check(std::initializer_list<Needed> needed) {
  for (const Needed& one : needed) {
    if (one.pointer == nullptr) return Status::bad_input(text("NULL was given for `", one.name, "`."));
  }
  return {};
}

cellsweep_status report(const Status& status, cellsweep_failure* failure) {
  const auto code = static_cast<cellsweep_status>(status.code);
  if (status.ok() || failure == nullptr) return code;
  *failure = {};
  failure->status = code;
  static_assert(std::size(cellsweep_failure{}.bodies) == Status::kMostBodies);
  failure->body_count = static_cast<std::uint32_t>(std::min(status.bodies.size(), Status::kMostBodies));
  std::copy_n(status.bodies.begin(), failure->body_count, failure->bodies);
  failure->number = status.number;
  failure->limit = status.limit;
  write_text(status.setting, failure->setting);
  write_text(status.message, failure->message);
  return code;
}

cellsweep_status report_exception(cellsweep_failure* failure) noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return report_no_memory(failure);
  } catch (const std::length_error&) {  // more elements than any vector can have
    return report_no_memory(failure);
  } catch (...) {
    return report_other(CELLSWEEP_CALLBACK_FAILED, "A C++ exception left a callback and ended the call.",
                        failure);
  }
}

}  // namespace cellsweep::c

const char* cellsweep_status_name(int status) {
  const auto number = static_cast<std::size_t>(status);
  return number < cellsweep::c::kNames.size() ? cellsweep::c::kNames[number] : "unknown";
}
