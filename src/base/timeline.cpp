#include "cellsweep/engine/timeline.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <ostream>
#include <utility>

#include "base/text.h"

namespace cellsweep {
namespace {

thread_local const TimelineRow* current_row = nullptr;

/// Rows of the host are numbered from here; SPEs are numbered from 0.
constexpr unsigned kHostRows = 1000000;

std::string microseconds(TimelineTime::duration time) {
  std::array<char, 48> digits{};
  const double value = std::chrono::duration<double, std::micro>(time).count();
  std::snprintf(digits.data(), digits.size(), "%.3f", value);
  return digits.data();
}

}  // namespace

Result<std::shared_ptr<Timeline>> Timeline::open(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<Timeline>> files;
  const std::lock_guard lock(mutex);
  std::weak_ptr<Timeline>& known = files[path];
  std::shared_ptr<Timeline> timeline = known.lock();
  if (!timeline) known = timeline = std::make_shared<Timeline>(path);
  if (timeline->out_.good()) return timeline;
  return Status::bad_option("trace", text("The trace file \"", path, "\" cannot be written."));
}

Timeline::Timeline(const std::string& path) : out_(path, std::ios::trunc) {}

Timeline::~Timeline() {
  if (out_.good()) write();
}

void Timeline::show_spes(SpeRows rows) {
  const std::lock_guard lock(mutex_);
  spe_rows_ = rows;
}

unsigned Timeline::add_row(std::string name) {
  const std::lock_guard lock(mutex_);
  rows_.push_back(std::move(name));
  return static_cast<unsigned>(rows_.size() - 1);
}

void Timeline::add(unsigned row, std::string name, TimelineTime begin, TimelineTime end) {
  const std::lock_guard lock(mutex_);
  spans_.push_back({row, std::move(name), begin, end});
}

void Timeline::write() {
  std::stable_sort(spans_.begin(), spans_.end(), [](const Span& a, const Span& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end > b.end;
  });
  out_ << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n";
  for (unsigned row = 0; row < rows_.size(); ++row) {
    const unsigned thread = kHostRows + row;
    out_ << R"({"ph":"M","name":"thread_name","pid":1,"tid":)" << thread << R"(,"args":{"name":")"
         << rows_[row] << "\"}},\n"
         << R"({"ph":"M","name":"thread_sort_index","pid":1,"tid":)" << thread
         << ",\"args\":{\"sort_index\":-1}},\n";
  }
  for (const Span& span : spans_) {
    out_ << R"({"ph":"X","cat":"host","pid":1,"tid":)" << kHostRows + span.row << R"(,"name":")" << span.name
         << R"(","ts":)" << microseconds(span.begin - origin_) << R"(,"dur":)"
         << microseconds(span.end - span.begin) << "},\n";
  }
  if (spe_rows_ != nullptr) spe_rows_(out_, origin_);
  out_ << R"({"ph":"M","name":"process_name","pid":1,"args":{"name":"cellsweep"}})"
       << "\n]}\n";
}

const TimelineRow* TimelineRow::current() {
  return current_row;
}

TimelineScope::TimelineScope(const TimelineRow& row) : outer_(std::exchange(current_row, &row)) {}

TimelineScope::~TimelineScope() {
  current_row = outer_;
}

TimelineSpan::TimelineSpan(const char* name) : name_(name) {
  if (current_row != nullptr) begin_ = std::chrono::steady_clock::now();
}

TimelineSpan::~TimelineSpan() {
  if (current_row == nullptr) return;
  current_row->timeline->add(current_row->number, name_, begin_, std::chrono::steady_clock::now());
}

}  // namespace cellsweep
