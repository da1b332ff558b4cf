/// @file
/// The timeline of a run: what the host and the SPEs of engines did when, as a file that opens in Perfetto.
#pragma once

#include <chrono>
#include <iosfwd>
#include <memory>
#include <string>

#include "cellsweep/export.h"
#include "cellsweep/status.h"

namespace cellsweep {

using TimelineTime = std::chrono::steady_clock::time_point;

/// The timeline of one file, written when the last engine that named the file goes, whole or not at all. Any
/// thread.
class CELLSWEEP_API Timeline {
 public:
  /// Writes the SPEs' rows: events of Chrome's trace format, a comma behind each; times from `origin`.
  using SpeRows = void (*)(std::ostream& out, TimelineTime origin);

  /// The timeline that goes to `path`: one for all who name it. Errors: bad_option for a file that cannot be
  /// written, write_failed for a disk that says no.
  [[gnu::cold]] static Result<std::shared_ptr<Timeline>> open(const std::string& path);

  /// What became of those that were written since the last call: ok, or why the first one was lost.
  /// Destructors have no other way to say it. std::bad_alloc where one was lost for want of memory.
  [[gnu::cold]] static Status take_failure();

  [[gnu::cold]] explicit Timeline(const std::string& path);
  [[gnu::cold]] ~Timeline();
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  /// Whose SPEs' rows stand below those of the host; once is enough.
  void show_spes(SpeRows rows);

  /// A new row of the host, by number.
  [[gnu::cold]] unsigned add_row(std::string name);

  /// Spans of a row nest or are apart. `name` is plain text without quotes.
  [[gnu::cold]] void add(unsigned row, std::string name, TimelineTime begin, TimelineTime end);

 private:
  friend class TimelineSpan;
  struct Rows;

  [[gnu::cold]] void note_lost_span() noexcept;

  std::unique_ptr<Rows> rows_;
};

/// Where the calling thread's spans go while it works for a traced engine; null otherwise.
struct CELLSWEEP_API TimelineRow {
  Timeline* timeline = nullptr;
  unsigned number = 0;

  static const TimelineRow* current();
};

/// Gives the calling thread a row for its life; scopes nest.
class CELLSWEEP_API TimelineScope {
 public:
  explicit TimelineScope(const TimelineRow& row);
  ~TimelineScope();
  TimelineScope(const TimelineScope&) = delete;
  TimelineScope& operator=(const TimelineScope&) = delete;

 private:
  const TimelineRow* outer_;
};

/// Its life is a span of the calling thread's row, if it has one.
class CELLSWEEP_API TimelineSpan {
 public:
  explicit TimelineSpan(const char* name);
  ~TimelineSpan();
  TimelineSpan(const TimelineSpan&) = delete;
  TimelineSpan& operator=(const TimelineSpan&) = delete;

 private:
  const char* name_;
  TimelineTime begin_{};
};

}  // namespace cellsweep
