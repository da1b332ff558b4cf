/// @file
/// How a call says that it did not do what was asked: a code, a sentence, and the numbers behind it.
#pragma once

#include <cassert>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cellsweep/export.h"
#include "cellsweep/pair.h"

namespace cellsweep {

enum class StatusCode {
  ok,
  invalid_box,     ///< NaN, infinity or min > max; a pose that is none
  unknown_body,    ///< an id that is not there
  duplicate_body,  ///< an id that is there already, or twice in one call that allows it once
  capacity,        ///< more than a stated limit allows
  bad_option,      ///< an unknown engine, or a setting out of its range
  bad_input,       ///< arguments or a file that contradict themselves
  spe_failed,      ///< an SPE of a Cell engine broke a rule or could not be started; the message says which
  write_failed,    ///< a file could not be written, for want of room or by a fault of the disk
};

/// The outcome of a call. When it is not ok, the call changed nothing.
struct [[nodiscard]] CELLSWEEP_API Status {
  /// A status names at most so many of the bodies at fault; `number` counts them all.
  static constexpr std::size_t kMostBodies = 16;

  StatusCode code = StatusCode::ok;
  std::string message{};  ///< a whole sentence for a person: what, which number, which limit, what to change
  std::optional<BodyId> body{};  ///< the first body at fault, when one is
  std::vector<BodyId>
      bodies{};              ///< the bodies at fault, in the order of the call, the first kMostBodies of them
  std::uint64_t number = 0;  ///< what was asked for; of bodies at fault, how many there are
  std::uint64_t limit = 0;   ///< what is allowed, where there is a limit
  std::string setting{};     ///< the option to change; empty when none would help

  bool ok() const { return code == StatusCode::ok; }

  /// A setting that is out of its range. `number` and `limit` where it is a number.
  static Status bad_option(std::string setting, std::string message, std::uint64_t number = 0,
                           std::uint64_t limit = 0);
  /// More than fits. An empty setting: nothing raises the limit.
  static Status over_capacity(std::string message, std::uint64_t number, std::uint64_t limit,
                              std::string setting = {});
  /// Arguments or a file that contradict themselves.
  static Status bad_input(std::string message, std::string setting = {}, std::uint64_t number = 0,
                          std::uint64_t limit = 0);
  /// `all` of the bodies at fault, at least one.
  static Status bad_bodies(StatusCode code, std::string message, std::span<const BodyId> all);
  /// An SPE, by number, that broke a rule or is not to be had.
  static Status spe_failed(std::string message, std::uint64_t spe = 0);
};

/// Either a value or the status that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Status status) : content_(std::move(status)) { assert(!this->status().ok()); }

  bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  /// The value; only when ok(), which is asserted.
  T& operator*() { return *value(); }
  const T& operator*() const { return *value(); }
  T* operator->() { return value(); }
  const T* operator->() const { return value(); }

  /// Why there is no value; an ok status when there is one.
  Status status() const { return ok() ? Status{} : *std::get_if<Status>(&content_); }

 private:
  T* value() {
    assert(ok());
    return std::get_if<T>(&content_);
  }
  const T* value() const {
    assert(ok());
    return std::get_if<T>(&content_);
  }

  std::variant<T, Status> content_;
};

}  // namespace cellsweep
