#include "ranks/job.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "base/text.h"

namespace cellsweep::ranks {
namespace {

// A status as it is sent; of a very long sentence its beginning.
struct StatusOnItsWay {
  std::uint64_t code = 0;
  std::uint64_t number = 0;
  std::uint64_t limit = 0;
  std::array<char, 64> setting{};
  std::array<char, 4000> message{};

  StatusOnItsWay() = default;
  explicit StatusOnItsWay(const Status& status)
      : code(static_cast<std::uint64_t>(status.code)), number(status.number), limit(status.limit) {
    status.setting.copy(setting.data(), setting.size() - 1);
    status.message.copy(message.data(), message.size() - 1);
  }
};

/// A string holds so few letters in itself.
constexpr const char* kNoMemory = "No memory left.";

// Words that may be more than there is memory for.
void say(Status& status, FunctionRef<void(Status&)> words) {
  try {
    words(status);
  } catch (const std::bad_alloc&) {
    status.setting.clear();
    status.message = kNoMemory;
  }
}

// Of four numbers the largest of the first three, and the sum of the last.
void put_together(void* given, void* into, int* count, MPI_Datatype*) {
  const auto* from = static_cast<const std::uint64_t*>(given);
  auto* to = static_cast<std::uint64_t*>(into);
  for (int i = 0; i < *count; ++i, from += 4, to += 4) {
    for (int number = 0; number < 3; ++number) to[number] = std::max(to[number], from[number]);
    to[3] += from[3];
  }
}

}  // namespace

Status no_memory_status() noexcept {
  Status status;
  status.code = StatusCode::capacity;
  say(status, [](Status& said) { said.message = "There is no memory left for it."; });
  return status;
}

Job::Job(MPI_Comm communicator) {
  MPI_Comm_dup(communicator, &communicator_);
  MPI_Type_contiguous(4, MPI_UINT64_T, &numbers_);
  MPI_Type_commit(&numbers_);
  MPI_Op_create(put_together, 1, &most_and_sum_);
  MPI_Comm_rank(communicator_, &rank_);
  MPI_Comm_size(communicator_, &ranks_);
}

Job::Job(Job&& other) noexcept {
  *this = std::move(other);
}

Job& Job::operator=(Job&& other) noexcept {
  std::swap(communicator_, other.communicator_);
  std::swap(rank_, other.rank_);
  std::swap(ranks_, other.ranks_);
  std::swap(round_, other.round_);
  std::swap(numbers_, other.numbers_);
  std::swap(most_and_sum_, other.most_and_sum_);
  return *this;
}

Job::~Job() {
  if (communicator_ == MPI_COMM_NULL) return;
  MPI_Op_free(&most_and_sum_);
  MPI_Type_free(&numbers_);
  MPI_Comm_free(&communicator_);
}

Status Job::attempt(FunctionRef<Status()> work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return no_memory_status();
  }
}

// The first rank at fault has the largest number.
Status Job::agree(const Status& status) const noexcept {
  int distance = status.ok() ? 0 : ranks_ - rank_;
  MPI_Allreduce(MPI_IN_PLACE, &distance, 1, MPI_INT, MPI_MAX, communicator_);
  return distance == 0 ? Status() : hear(status, ranks_ - distance);
}

Status Job::agree(const Status& status, std::uint64_t mine, bool flag, Together& together) const noexcept {
  std::array<std::uint64_t, 4> numbers{status.ok() ? 0 : static_cast<std::uint64_t>(ranks_ - rank_), mine,
                                       flag ? 1U : 0U, mine};
  MPI_Allreduce(MPI_IN_PLACE, numbers.data(), 1, numbers_, most_and_sum_, communicator_);
  together = {numbers[3], numbers[1], numbers[2] != 0};
  return numbers[0] == 0 ? Status() : hear(status, ranks_ - static_cast<int>(numbers[0]));
}

Status Job::gather_bytes(const void* mine, std::size_t rows, std::size_t row_bytes, int root,
                         FunctionRef<void*(std::size_t)> make_room) const noexcept {
  std::vector<int> counts;
  std::vector<int> places;
  void* all = nullptr;
  int count = static_cast<int>(rows);
  Status status = agree([&]() -> Status {
    if (rows > std::numeric_limits<int>::max()) return no_memory_status();
    counts.resize(static_cast<std::size_t>(ranks_));
    places.resize(counts.size());
    return {};
  });
  if (!status.ok()) return status;
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, root, communicator_);
  status = agree([&]() -> Status {
    if (rank_ != root) return {};
    std::size_t sum = 0;
    for (std::size_t rank = 0; rank < counts.size(); ++rank) {
      places[rank] = static_cast<int>(sum);
      sum += static_cast<std::size_t>(counts[rank]);
      if (sum > std::numeric_limits<int>::max()) return no_memory_status();
    }
    all = make_room(sum);
    return {};
  });
  if (!status.ok()) return status;
  MPI_Datatype row = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(row_bytes), MPI_BYTE, &row);
  MPI_Type_commit(&row);
  MPI_Gatherv(mine, count, row, all, counts.data(), places.data(), row, root, communicator_);
  MPI_Type_free(&row);
  return {};
}

// Takes no memory until all have heard it.
Status Job::hear(const Status& status, int from) const noexcept {
  StatusOnItsWay way;
  if (rank_ == from) way = StatusOnItsWay(status);
  MPI_Bcast(&way, sizeof way, MPI_BYTE, from, communicator_);
  Status heard;
  heard.code = static_cast<StatusCode>(way.code);
  heard.number = way.number;
  heard.limit = way.limit;
  say(heard, [&](Status& said) {
    said.setting = way.setting.data();
    said.message = text("Rank ", from, ": ", std::string_view(way.message.data()));
  });
  return heard;
}

namespace {

// A receipt of none of its words: they are lost.
void drop(MPI_Message& message, MPI_Comm communicator) {
  MPI_Errhandler handler = MPI_ERRHANDLER_NULL;
  MPI_Comm_get_errhandler(communicator, &handler);
  MPI_Comm_set_errhandler(communicator, MPI_ERRORS_RETURN);
  MPI_Mrecv(nullptr, 0, MPI_UINT64_T, &message, MPI_STATUS_IGNORE);
  MPI_Comm_set_errhandler(communicator, handler);
  MPI_Errhandler_free(&handler);
}

bool all_are_sent(std::span<Message> out) {
  return std::ranges::all_of(out, [](Message& message) {
    int done = 0;
    MPI_Test(&message.sending, &done, MPI_STATUS_IGNORE);
    return done != 0;
  });
}

}  // namespace

// Nonblocking consensus (Hoefler, Siebert, Lumsdaine 2010): who has sent all, which he knows because each
// message is acknowledged by its receipt, comes to a barrier; when all have come there, nothing is on its
// way.
Status Job::exchange(std::span<Message> out, std::vector<Message>& in) const noexcept {
  in.clear();
  if (ranks_ == 1) return {};
  Status status;
  const int tag = round_ = (round_ + 1) % 1024;
  for (Message& one : out) {
    MPI_Issend(one.words.data(), static_cast<int>(one.words.size()), MPI_UINT64_T, one.rank, tag,
               communicator_, &one.sending);
  }
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool at_barrier = false;
  for (int done = 0; done == 0;) {
    int has_come = 0;
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status envelope;
    MPI_Improbe(MPI_ANY_SOURCE, tag, communicator_, &has_come, &message, &envelope);
    if (has_come != 0) {
      int words = 0;
      MPI_Get_count(&envelope, MPI_UINT64_T, &words);
      try {
        in.push_back({envelope.MPI_SOURCE, std::vector<std::uint64_t>(static_cast<std::size_t>(words))});
        MPI_Mrecv(in.back().words.data(), words, MPI_UINT64_T, &message, MPI_STATUS_IGNORE);
      } catch (const std::bad_alloc&) {
        status = no_memory_status();
        drop(message, communicator_);
      }
    } else if (at_barrier) {
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
    } else if (all_are_sent(out)) {
      MPI_Ibarrier(communicator_, &barrier);
      at_barrier = true;
    }
  }
  std::ranges::sort(in, {}, &Message::rank);
  return status;
}

}  // namespace cellsweep::ranks
