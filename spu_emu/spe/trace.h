/// @file
/// The timeline of all SPEs: spans kept in memory, written as Chrome trace JSON.
#ifndef SPU_EMU_SPE_TRACE_H
#define SPU_EMU_SPE_TRACE_H

#include <iosfwd>
#include <mutex>
#include <string>
#include <vector>

#include "mfc/activity.h"

namespace spu_emu {

/// A span of one SPE; `arguments` is the inside of a JSON object.
struct TraceSpan {
  unsigned spe = 0;
  std::string name;
  TraceTime begin;
  TraceTime end;
  std::string arguments;
};

/// Spans of the whole process; any thread.
class Trace {
 public:
  static Trace& instance();
  void add(TraceSpan span);
  /// Writes every span and forgets them all. Times are in microseconds from the first span's begin.
  void write(std::ostream& out);
  /// Its events alone, a comma behind each, with times from `origin`.
  void write_events(std::ostream& out, TraceTime origin);

 private:
  std::vector<TraceSpan> take();

  std::mutex mutex_;
  std::vector<TraceSpan> spans_;
};

/// The rows of one SPE; used by the thread that runs it.
class SpeTrace final : public ActivityLog {
 public:
  explicit SpeTrace(unsigned spe) : spe_(spe) {}
  void transfer(const Command& command, std::uint64_t bytes, TraceTime issued, TraceTime begin) override;
  void wait(const char* what, TraceTime begin) override;
  void run(TraceTime begin);

 private:
  unsigned spe_;
};

}  // namespace spu_emu

#endif
