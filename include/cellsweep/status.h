/// @file
/// How a call says that it did not do what was asked: a code, a sentence, and the numbers behind it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "cellsweep/pair.h"

namespace cellsweep {

enum class StatusCode {
  ok,
  invalid_box,     ///< NaN, infinity or min > max; a pose that is none
  unknown_body,    ///< an id that is not in the engine
  duplicate_body,  ///< an id that is there already, or twice in one call
  capacity,        ///< more than a stated limit allows
  bad_option,      ///< an unknown engine, or a setting out of its range
  bad_input,       ///< arguments or a file that contradict themselves
  spe_failed,      ///< an SPE of a Cell engine broke a rule or could not be started; the message says which
};

/// The outcome of a call. When it is not ok, the call changed nothing.
struct [[nodiscard]] Status {
  StatusCode code = StatusCode::ok;
  std::string message{};  ///< a whole sentence for a person: what, which number, which limit, what to change
  std::optional<BodyId> body{};  ///< the body at fault, when one is
  std::uint64_t number = 0;      ///< for `capacity`: what was asked for
  std::uint64_t limit = 0;       ///< for `capacity`: what is allowed
  std::string setting{};         ///< for `capacity`: the option to raise; empty when nothing can be raised

  bool ok() const { return code == StatusCode::ok; }
};

/// Either a value or the status that says why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::move(value)) {}
  Result(Status status) : content_(std::move(status)) {}

  bool ok() const { return std::holds_alternative<T>(content_); }
  explicit operator bool() const { return ok(); }

  /// The value; only when ok().
  T& operator*() { return *std::get_if<T>(&content_); }
  const T& operator*() const { return *std::get_if<T>(&content_); }
  T* operator->() { return std::get_if<T>(&content_); }
  const T* operator->() const { return std::get_if<T>(&content_); }

  /// Why there is no value; an ok status when there is one.
  Status status() const { return ok() ? Status{} : *std::get_if<Status>(&content_); }

 private:
  std::variant<T, Status> content_;
};

}  // namespace cellsweep
