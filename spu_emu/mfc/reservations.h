/// @file
/// Lock-line reservations: getllar and putllc of all SPEs, and what makes a reservation lost.
#ifndef SPU_EMU_MFC_RESERVATIONS_H
#define SPU_EMU_MFC_RESERVATIONS_H

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "mfc/command.h"

namespace spu_emu {

/// What this processor exchanges at once.
using LineWord = std::uintptr_t;
using LineWords = std::array<LineWord, kLineSize / sizeof(LineWord)>;

/// One SPE's reservation: at most one line, and the line's words when it was loaded.
class Reservation {
 public:
  virtual ~Reservation() = default;

 protected:
  /// Another access took the line; called under a lock, from any thread.
  virtual void lost() = 0;

 private:
  friend class ReservationTable;
  std::atomic<std::byte*> line_{nullptr};
  LineWords loaded_{};
};

/// All reservations of the process. Lines are 128-aligned host addresses of main memory.
///
/// Accesses by SPEs exclude one another. Threads that are no SPE may use std::atomic on the words of a line:
/// their write between a getllar and a putllc makes it fail as long as it changed a value, and a putllc that
/// changes one LineWord is atomic to them; a putllc that changes several is not, to them only.
class ReservationTable {
 public:
  static ReservationTable& instance();

  /// Reads a line and reserves it for `holder`, whose earlier reservation ends.
  void load(Reservation& holder, std::byte* line, LineWords& words);
  /// Writes a line if `holder` still has it reserved; the reservation ends either way. True if written.
  bool store_conditional(Reservation& holder, std::byte* line, const LineWords& words);
  /// Writes a line; everybody's reservation of it is lost.
  void store(std::byte* line, const LineWords& words);
  /// Something was written to [first, first + size): reservations there are lost. Cheap when there are none.
  void written(const std::byte* first, std::size_t size) {
    if (count_.load() != 0) lose_range(first, size);
  }
  /// True if `holder` has a line reserved whose words are no longer what it loaded.
  bool changed(Reservation& holder);
  /// Ends the holder's reservation, if any.
  void drop(Reservation& holder);

 private:
  struct Bucket {
    std::mutex mutex;
    std::vector<Reservation*> holders;
  };

  Bucket& bucket(const std::byte* line);
  void lose_range(const std::byte* first, std::size_t size);
  /// Both under the bucket's lock.
  void end(Bucket& bucket, Reservation& holder);
  void lose_line(Bucket& bucket, const std::byte* line);

  static constexpr std::size_t kBuckets = 256;
  std::array<Bucket, kBuckets> buckets_;
  std::atomic<int> count_{0};
};

}  // namespace spu_emu

#endif
