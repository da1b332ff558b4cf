#include "cellsweep/engine/timeline.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <mutex>
#include <new>
#include <ostream>
#include <streambuf>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/process.h"
#include "base/text.h"
#include "cellsweep/engine/new_file.h"

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

/// What a stream writes goes to a file, as long as that works.
class FileBuffer final : public std::streambuf {
 public:
  explicit FileBuffer(NewFile& file) : file_(file), bytes_(kBytes) { start_over(); }

  /// Of what was written until now.
  const Status& status() const { return status_; }

 protected:
  int_type overflow(int_type letter) override {
    if (sync() != 0) return traits_type::eof();
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    return sputc(traits_type::to_char_type(letter));
  }

  int sync() override {
    if (status_.ok()) status_ = file_.write({pbase(), static_cast<std::size_t>(pptr() - pbase())});
    start_over();
    return status_.ok() ? 0 : -1;
  }

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 16;

  void start_over() { setp(bytes_.data(), bytes_.data() + bytes_.size()); }

  NewFile& file_;
  std::vector<char> bytes_;
  Status status_;
};

/// The first failure of those that were written. To note one takes no memory.
struct Failure {
  std::mutex mutex;
  Status status;
  bool memory_ran_out = false;

  void note(Status&& why) noexcept {
    const std::lock_guard lock(mutex);
    if (status.ok()) status = std::move(why);
  }
  void note_out_of_memory() noexcept {
    const std::lock_guard lock(mutex);
    memory_ran_out = true;
  }
};

Failure& failure() {
  static Failure failure;
  return failure;
}

}  // namespace

struct [[gnu::visibility("hidden")]] Timeline::Rows {
  struct Span {
    unsigned row = 0;
    std::string name;
    TimelineTime begin;
    TimelineTime end;
  };

  [[gnu::cold]] explicit Rows(const std::string& file_path) : path(file_path), opened(file.open(path)) {}
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  [[gnu::cold]] ~Rows();
  [[gnu::cold]] Status write();
  [[gnu::cold]] void write(std::ostream & out);

  ProcessMark process;
  std::mutex mutex;
  std::string path;
  NewFile file;
  Status opened;
  bool is_whole = true;
  TimelineTime origin = std::chrono::steady_clock::now();
  SpeRows spes = nullptr;
  std::vector<std::string> names;
  std::vector<Span> spans;
};

Timeline::Rows::~Rows() = default;

Result<std::shared_ptr<Timeline>> Timeline::open(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<Timeline>> files;
  const std::lock_guard lock(mutex);
  std::weak_ptr<Timeline>& known = files[path];
  std::shared_ptr<Timeline> timeline = known.lock();
  if (!timeline) known = timeline = std::make_shared<Timeline>(path);
  const Status& opened = timeline->rows_->opened;
  if (opened.ok()) return timeline;
  Status status = Status::bad_option("trace", text("The trace file ", opened.message));
  if (opened.code == StatusCode::write_failed) status.code = opened.code;
  return status;
}

Status Timeline::take_failure() {
  const std::lock_guard lock(failure().mutex);
  if (std::exchange(failure().memory_ran_out, false)) throw std::bad_alloc();
  return std::exchange(failure().status, Status());
}

Timeline::Timeline(const std::string& path) : rows_(std::make_unique<Rows>(path)) {}

// In a child of fork() it is the parent's to write, which may have begun a file already.
Timeline::~Timeline() {
  if (!rows_->process.is_this_process()) static_cast<void>(rows_.release());
  if (!rows_ || !rows_->opened.ok()) return;
  try {
    failure().note(rows_->write());
  } catch (const std::bad_alloc&) {
    failure().note_out_of_memory();
  }
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

void Timeline::note_lost_span() noexcept {
  const std::lock_guard lock(rows_->mutex);
  rows_->is_whole = false;
}

void Timeline::add(unsigned row, std::string name, TimelineTime begin, TimelineTime end) {
  const std::lock_guard lock(rows_->mutex);
  rows_->spans.push_back({row, std::move(name), begin, end});
}

// Of a timeline with holes there is nothing to be seen.
Status Timeline::Rows::write() {
  if (!is_whole) throw std::bad_alloc();
  FileBuffer buffer(file);
  std::ostream out(&buffer);
  write(out);
  out.flush();
  if (!buffer.status().ok()) return buffer.status();
  if (!out.good()) throw std::bad_alloc();  // the one thing that streams swallow
  return file.commit();
}

void Timeline::Rows::write(std::ostream& out) {
  std::vector<const Span*> in_order;
  in_order.reserve(spans.size());
  for (const Span& span : spans) in_order.push_back(&span);
  const auto is_before = [](const Span* a, const Span* b) {
    return std::tuple(a->begin, b->end, a) < std::tuple(b->begin, a->end, b);
  };
  // Sorts as sort() does, in a third of its code.
  std::make_heap(in_order.begin(), in_order.end(), is_before);
  std::sort_heap(in_order.begin(), in_order.end(), is_before);
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
  try {
    current_row->timeline->add(current_row->number, name_, begin_, std::chrono::steady_clock::now());
  } catch (const std::bad_alloc&) {
    current_row->timeline->note_lost_span();
  }
}

}  // namespace cellsweep
