#include "spe/trace.h"

#include <algorithm>
#include <ostream>
#include <set>

#include "mfc/format.h"

namespace spu_emu {

namespace {
double microseconds(TraceTime::duration time) {
  return std::chrono::duration<double, std::micro>(time).count();
}

/// File names may hold anything; the rest of the trace is made of plain names and numbers.
std::string escaped(const char* text) {
  std::string result;
  for (; *text != '\0'; ++text) {
    const auto c = static_cast<unsigned char>(*text);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += *text;
    } else if (c < 0x20) {
      result += format("\\u%04x", c);
    } else {
      result += *text;
    }
  }
  return result;
}

void write_row_name(std::ostream& out, unsigned spe) {
  out << format(R"({"ph":"M","name":"thread_name","pid":1,"tid":%u,"args":{"name":"SPE %u"}},)", spe, spe)
      << '\n';
}

void write_span(std::ostream& out, const TraceSpan& span, TraceTime start) {
  out << format(R"({"ph":"X","name":"%s","cat":"spe","pid":1,"tid":%u,"ts":%.3f,"dur":%.3f,"args":{%s}})",
                span.name.c_str(), span.spe, microseconds(span.begin - start),
                microseconds(span.end - span.begin), span.arguments.c_str());
}

void write_all(std::ostream& out, const std::vector<TraceSpan>& spans, TraceTime start) {
  std::set<unsigned> rows;
  for (const TraceSpan& span : spans) rows.insert(span.spe);
  for (const unsigned spe : rows) write_row_name(out, spe);
  for (const TraceSpan& span : spans) {
    write_span(out, span, start);
    out << ",\n";
  }
}
}  // namespace

Trace& Trace::instance() {
  static Trace trace;
  return trace;
}

void Trace::add(TraceSpan span) {
  const std::lock_guard lock(mutex_);
  spans_.push_back(std::move(span));
}

/// All spans, as they began and the longer first.
std::vector<TraceSpan> Trace::take() {
  std::vector<TraceSpan> spans;
  {
    const std::lock_guard lock(mutex_);
    spans.swap(spans_);
  }
  std::stable_sort(spans.begin(), spans.end(), [](const TraceSpan& a, const TraceSpan& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
  });
  return spans;
}

void Trace::write(std::ostream& out) {
  const std::vector<TraceSpan> spans = take();
  out << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n";
  write_all(out, spans, spans.empty() ? TraceTime{} : spans.front().begin);
  out << R"({"ph":"M","name":"process_name","pid":1,"args":{"name":"spu_emu"}})"
      << "\n]}\n";
}

void Trace::write_events(std::ostream& out, TraceTime origin) {
  write_all(out, take(), origin);
}

void SpeTrace::transfer(const Command& command, std::uint64_t bytes, TraceTime issued, TraceTime begin) {
  std::string arguments =
      format(R"("tag":%u,"size":%u,"bytes":%llu,"ls":"0x%x","ea":"0x%llx","in_flight_us":%.3f)", command.tag,
             command.size, static_cast<unsigned long long>(bytes), command.ls,
             static_cast<unsigned long long>(command.ea), microseconds(begin - issued));
  if (command.where.file != nullptr) {
    arguments += format(R"(,"source":"%s:%d")", escaped(command.where.file).c_str(), command.where.line);
  }
  Trace::instance().add(
      {spe_, command_name(command.opcode), begin, std::chrono::steady_clock::now(), std::move(arguments)});
}

void SpeTrace::wait(const char* what, TraceTime begin) {
  Trace::instance().add({spe_, what, begin, std::chrono::steady_clock::now(), ""});
}

void SpeTrace::run(TraceTime begin) {
  Trace::instance().add({spe_, "run", begin, std::chrono::steady_clock::now(), ""});
}

}  // namespace spu_emu
