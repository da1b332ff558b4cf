#include "cellsweep/engine/timeline.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

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

struct Timeline::Rows {
  struct Span {
    unsigned row = 0;
    std::string name;
    TimelineTime begin;
    TimelineTime end;
  };

  explicit Rows(const std::string& path) : out(path, std::ios::trunc) {}
  void write();

  std::mutex mutex;
  std::ofstream out;
  TimelineTime origin = std::chrono::steady_clock::now();
  SpeRows spes = nullptr;
  std::vector<std::string> names;
  std::vector<Span> spans;
};

Result<std::shared_ptr<Timeline>> Timeline::open(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<Timeline>> files;
  const std::lock_guard lock(mutex);
  std::weak_ptr<Timeline>& known = files[path];
  std::shared_ptr<Timeline> timeline = known.lock();
  if (!timeline) known = timeline = std::make_shared<Timeline>(path);
  if (timeline->rows_->out.good()) return timeline;
  return Status::bad_option("trace", text("The trace file \"", path, "\" cannot be written."));
}

Timeline::Timeline(const std::string& path) : rows_(std::make_unique<Rows>(path)) {}

Timeline::~Timeline() {
  if (rows_->out.good()) rows_->write();
}

void Timeline::show_spes(SpeRows rows) {
  const std::lock_guard lock(rows_->mutex);
  rows_->spes = rows;
}

unsigned Timeline::add_row(std::string name) {
  const std::lock_guard lock(rows_->mutex);
  rows_->names.push_back(std::move(name));
  return static_cast<unsigned>(rows_->names.size() - 1);
}

void Timeline::add(unsigned row, std::string name, TimelineTime begin, TimelineTime end) {
  const std::lock_guard lock(rows_->mutex);
  rows_->spans.push_back({row, std::move(name), begin, end});
}

void Timeline::Rows::write() {
  std::vector<const Span*> in_order;
  in_order.reserve(spans.size());
  for (const Span& span : spans) in_order.push_back(&span);
  std::sort(in_order.begin(), in_order.end(), [](const Span* a, const Span* b) {
    return std::tuple(a->begin, b->end, a) < std::tuple(b->begin, a->end, b);
  });
  out << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n";
  for (unsigned row = 0; row < names.size(); ++row) {
    const unsigned thread = kHostRows + row;
    out << R"({"ph":"M","name":"thread_name","pid":1,"tid":)" << thread << R"(,"args":{"name":")"
        << names[row] << "\"}},\n"
        << R"({"ph":"M","name":"thread_sort_index","pid":1,"tid":)" << thread
        << ",\"args\":{\"sort_index\":-1}},\n";
  }
  for (const Span* span : in_order) {
    out << R"({"ph":"X","cat":"host","pid":1,"tid":)" << kHostRows + span->row << R"(,"name":")" << span->name
        << R"(","ts":)" << microseconds(span->begin - origin) << R"(,"dur":)"
        << microseconds(span->end - span->begin) << "},\n";
  }
  if (spes != nullptr) spes(out, origin);
  out << R"({"ph":"M","name":"process_name","pid":1,"args":{"name":"cellsweep"}})"
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
