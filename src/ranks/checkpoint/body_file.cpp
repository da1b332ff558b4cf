#include "ranks/checkpoint/body_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "ranks/checkpoint/file_fault.h"
#include "ranks/checkpoint/hdf5_handle.h"

namespace cellsweep::ranks {
namespace {

// MPI counts in 32 bits, and HDF5 hands on to it what it is given.
constexpr std::uint64_t kMostRowsAtOnce = 8'000'000;

/// One of the lists of a BodyRows, as a dataset.
struct Column {
  const char* name;
  hid_t type;             // in memory and, when it is written, in the file
  std::uint64_t numbers;  // in a row
  std::size_t row_bytes;
  void* (*rows)(BodyRows& bodies);
};

// The types are known once HDF5 has begun, which their names see to.
std::array<Column, 5> columns() {
  return {{{"id", H5T_NATIVE_UINT64, 1, sizeof(GlobalId),
            [](BodyRows& bodies) -> void* { return bodies.ids.data(); }},
           {"box", H5T_NATIVE_FLOAT, 6, sizeof(Aabb),
            [](BodyRows& bodies) -> void* { return bodies.boxes.data(); }},
           {"category", H5T_NATIVE_UINT32, 1, sizeof(std::uint32_t),
            [](BodyRows& bodies) -> void* { return bodies.categories.data(); }},
           {"mask", H5T_NATIVE_UINT32, 1, sizeof(std::uint32_t),
            [](BodyRows& bodies) -> void* { return bodies.masks.data(); }},
           {"is_static", H5T_NATIVE_UINT8, 1, 1,
            [](BodyRows& bodies) -> void* { return bodies.is_static.data(); }}}};
}
static_assert(sizeof(Aabb) == 6 * sizeof(float));

/// This rank's rows among those of all.
struct Share {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint64_t most = 0;  // of any rank: all make as many calls
};

Share share_of(const Job& job, std::uint64_t mine) {
  Share share{0, mine, mine};
  MPI_Exscan(&mine, &share.first, 1, MPI_UINT64_T, MPI_SUM, job.communicator());
  if (job.rank() == 0) share.first = 0;
  MPI_Allreduce(MPI_IN_PLACE, &share.most, 1, MPI_UINT64_T, MPI_MAX, job.communicator());
  return share;
}

Handle access_by_all(const Job& job) {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(access, job.communicator(), MPI_INFO_NULL);
  // Nobody closes the file for good while others have it.
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
  return access;
}

Handle transfer_by_all() {
  Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  return transfer;
}

/// A space of rows, and of these the ones that a call is for.
Handle select(std::uint64_t rows, std::uint64_t numbers, std::uint64_t first, std::uint64_t count) {
  const std::array<hsize_t, 2> size{rows, numbers};
  const std::array<hsize_t, 2> start{first, 0};
  const std::array<hsize_t, 2> wanted{count, numbers};
  Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
  if (count == 0) {
    H5Sselect_none(space);
  } else {
    H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, wanted.data(), nullptr);
  }
  return space;
}

/// Reads this rank's rows of a column, so many at a time. All ranks call it as often.
bool read_rows(hid_t dataset, const Column& column, const Share& share, std::uint64_t all, BodyRows& mine) {
  const Handle by = transfer_by_all();
  bool good = by.ok();
  for (std::uint64_t done = 0; done < share.most; done += kMostRowsAtOnce) {
    const std::uint64_t from = std::min(done, share.count);
    const std::uint64_t count = std::min(share.count - from, kMostRowsAtOnce);
    const Handle memory = select(count, column.numbers, 0, count);
    const Handle file = select(all, column.numbers, share.first + from, count);
    char* rows = static_cast<char*>(column.rows(mine)) + from * column.row_bytes;
    good = H5Dread(dataset, column.type, memory, file, by, rows) >= 0 && good;
  }
  return good;
}

/// Writes them to where the column lies in the file. Each rank by itself: its rows lie together, and MPI's
/// collective call leaves the others waiting where one cannot write.
bool write_rows(MPI_File file, MPI_Offset place, const Column& column, const Share& share, BodyRows& mine) {
  for (std::uint64_t from = 0; from < share.count; from += kMostRowsAtOnce) {
    const std::uint64_t count = std::min(share.count - from, kMostRowsAtOnce);
    const char* rows = static_cast<char*>(column.rows(mine)) + from * column.row_bytes;
    const auto at = place + static_cast<MPI_Offset>((share.first + from) * column.row_bytes);
    const int bytes = static_cast<int>(count * column.row_bytes);
    MPI_Status status;
    int written = 0;
    if (MPI_File_write_at(file, at, rows, bytes, MPI_BYTE, &status) != MPI_SUCCESS) return false;
    if (MPI_Get_count(&status, MPI_BYTE, &written) != MPI_SUCCESS || written != bytes) return false;
  }
  return true;
}

Handle make_dataset(hid_t file, const Column& column, std::uint64_t rows) {
  const std::array<hsize_t, 2> size{rows, column.numbers};
  const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose);
  const Handle options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_fill_time(options, H5D_FILL_TIME_NEVER);
  H5Pset_alloc_time(options, H5D_ALLOC_TIME_EARLY);
  H5Pset_obj_track_times(options, 0);  // the same world makes the same file
  return {H5Dcreate2(file, column.name, column.type, space, H5P_DEFAULT, options, H5P_DEFAULT), H5Dclose};
}

bool write_number(hid_t file, const char* name, std::uint64_t number) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Awrite(attribute, H5T_NATIVE_UINT64, &number) >= 0;
}

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, bytes);
  return type;
}

// A string that ends with a zero: one of no letters has a size, too.
bool write_note(hid_t file, const std::string& note) {
  const Handle type = text_type(note.size() + 1);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, "note", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Awrite(attribute, type, note.c_str()) >= 0;
}

bool read_number(hid_t file, const char* name, std::uint64_t& number) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Aread(attribute, H5T_NATIVE_UINT64, &number) >= 0;
}

bool read_note(hid_t file, std::string& note) {
  const Handle attribute(H5Aopen(file, "note", H5P_DEFAULT), H5Aclose);
  if (!attribute.ok()) return false;
  const Handle type(H5Aget_type(attribute), H5Tclose);
  const std::size_t size = H5Tget_size(type);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || size == 0) return false;
  std::string letters(size, '\0');
  if (H5Aread(attribute, type, letters.data()) < 0) return false;
  letters.pop_back();
  note = std::move(letters);
  return true;
}

bool has_shape(hid_t dataset, std::uint64_t rows, std::uint64_t numbers) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  std::array<hsize_t, 2> size{};
  return space.ok() && H5Sget_simple_extent_ndims(space) == 2 &&
         H5Sget_simple_extent_dims(space, size.data(), nullptr) == 2 && size[0] == rows && size[1] == numbers;
}

herr_t keep_first(unsigned, const H5E_error2_t* error, void* reason) {
  auto& words = *static_cast<std::string*>(reason);
  if (words.empty() && error->desc != nullptr) words = error->desc;
  return 0;
}

/// Calls of all ranks, after each of which they agree that it was good; after the first that was not there
/// are no more.
template <class Fault>
class AgreedCalls {
 public:
  AgreedCalls(const Job& job, Fault fault) : job_(job), fault_(fault) {}

  template <class Work>
  bool call(const Work& work) {
    if (status_.ok()) status_ = job_.agree([&] { return work() ? Status() : fault_(); });
    return status_.ok();
  }
  /// Once, at the end.
  Status take_status() { return std::move(status_); }

 private:
  const Job& job_;
  Fault fault_;
  Status status_;
};

}  // namespace

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  return reason.empty() ? "HDF5 gives no reason" : "HDF5 says: " + reason;
}

void BodyRows::resize(std::size_t bodies) {
  ids.resize(bodies);
  boxes.resize(bodies);
  categories.resize(bodies);
  masks.resize(bodies);
  is_static.resize(bodies);
}

namespace {

/// Where the columns lie in a file.
using Places = std::array<MPI_Offset, 5>;

/// A file in memory, of which what nobody writes takes none. HDF5 wants one with a name.
class MemoryFile {
 public:
  MemoryFile() : file_(::mkostemp(name_.data(), O_CLOEXEC)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    hide();
    if (file_ >= 0) ::close(file_);
  }

  const char* name() const { return name_.c_str(); }
  /// It loses its name, and goes with whoever has it open.
  void hide() {
    if (file_ >= 0 && !hidden_) ::unlink(name_.c_str());
    hidden_ = true;
  }
  std::uint64_t bytes() const {
    struct stat known {};
    return ::fstat(file_, &known) == 0 ? static_cast<std::uint64_t>(known.st_size) : 0;
  }
  bool copy(std::uint64_t from, std::uint64_t to, int file) const {
    std::vector<char> bytes(to - from);
    const auto at = static_cast<off_t>(from);
    const auto all = static_cast<ssize_t>(bytes.size());
    return ::pread(file_, bytes.data(), bytes.size(), at) == all &&
           ::pwrite(file, bytes.data(), bytes.size(), at) == all;
  }

 private:
  std::string name_ = "/dev/shm/cellsweep-XXXXXX";
  int file_;
  bool hidden_ = false;
};

/// All but the columns' rows.
bool make_frame(MemoryFile& memory, std::size_t first_bytes, const WorldRow& world, Places& places) {
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation, first_bytes);
  H5Pset_obj_track_times(creation, 0);
  Handle file(H5Fcreate(memory.name(), H5F_ACC_TRUNC, creation, H5P_DEFAULT), H5Fclose);
  memory.hide();
  bool good = file.ok() && write_number(file, "pairs", world.pairs) &&
              write_number(file, "pair_hash", world.pair_hash) &&
              write_number(file, "bodies", world.bodies) && write_note(file, world.note);
  std::size_t number = 0;
  for (const Column& column : columns()) {
    if (!good) break;
    const Handle dataset = make_dataset(file, column, world.bodies);
    good = dataset.ok();
    places[number++] = good ? static_cast<MPI_Offset>(H5Dget_offset(dataset)) : 0;
  }
  return file.close() && good;
}

// Columns lie in the order in which they were made.
bool copy_frame(const MemoryFile& memory, const WorldRow& world, const Places& places, int file) {
  std::uint64_t from = 0;
  bool good = true;
  std::size_t number = 0;
  for (const Column& column : columns()) {
    const auto place = static_cast<std::uint64_t>(places[number++]);
    if (world.bodies == 0) continue;  // it has no place
    good = good && place >= from && memory.copy(from, place, file);
    from = place + world.bodies * column.row_bytes;
  }
  return good && memory.copy(from, memory.bytes(), file);
}

// Into a file that is there. The disk's room for everything is taken first, and HDF5 itself writes to memory
// alone: neither it nor MPI copes with a disk that is full.
Status write_frame(const std::string& path, const MemoryFile& memory, const WorldRow& world,
                   const Places& places) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return write_fault(path, errno);
  Status status;
  const int error = ::posix_fallocate(file, 0, static_cast<off_t>(memory.bytes()));
  if (error != 0) {
    status = write_fault(path, error);
    status.number = memory.bytes();
    status.message += text(" It needs ", status.number, " bytes.");
  } else if (!copy_frame(memory, world, places, file)) {
    status = write_fault(path, errno);
  }
  ::close(file);
  return status;
}

}  // namespace

Status write_bodies(const Job& job, const std::string& path, std::size_t first_bytes, const WorldRow& world,
                    BodyRows& mine) {
  const QuietHdf5 quiet;
  Places places{};
  Status made = job.agree([&]() -> Status {
    if (job.rank() != 0) return {};
    MemoryFile memory;
    if (!make_frame(memory, first_bytes, world, places)) return write_fault(path, hdf5_reason());
    return write_frame(path, memory, world, places);
  });
  if (!made.ok()) return made;
  MPI_Bcast(places.data(), sizeof places, MPI_BYTE, 0, job.communicator());
  const Share share = share_of(job, mine.ids.size());
  AgreedCalls all(job, [&] { return write_fault(path, "MPI's file was not written whole"); });
  MPI_File file = MPI_FILE_NULL;
  all.call([&] {
    return MPI_File_open(job.communicator(), path.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file) ==
           MPI_SUCCESS;
  });
  std::size_t number = 0;
  for (const Column& column : columns()) {
    const MPI_Offset place = places[number++];
    all.call([&] { return write_rows(file, place, column, share, mine); });
  }
  all.call([&] { return MPI_File_sync(file) == MPI_SUCCESS; });
  if (file != MPI_FILE_NULL) MPI_File_close(&file);
  return all.take_status();
}

Status read_bodies(const Job& job, const std::string& path, std::optional<std::uint64_t> rows,
                   WorldRow& world, BodyRows& mine) {
  const QuietHdf5 quiet;
  AgreedCalls all(job,
                  [&] { return Status::bad_input(text("Cannot read ", path, ": ", hdf5_reason(), ".")); });
  const Handle access = access_by_all(job);
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access), H5Fclose);
  if (!all.call([&] { return file.ok(); })) return all.take_status();
  const bool good = all.call([&] {
    return read_number(file, "pairs", world.pairs) && read_number(file, "pair_hash", world.pair_hash) &&
           read_number(file, "bodies", world.bodies) && read_note(file, world.note);
  });
  if (!good) return all.take_status();
  const auto ranks = static_cast<std::uint64_t>(job.ranks());
  const auto rank = static_cast<std::uint64_t>(job.rank());
  const Share share =
      share_of(job, rows.value_or(world.bodies / ranks + (rank < world.bodies % ranks ? 1 : 0)));
  Status status = job.agree([&]() -> Status {
    mine.resize(share.count);
    return {};
  });
  if (!status.ok()) return status;
  for (const Column& column : columns()) {
    const Handle dataset(H5Dopen2(file, column.name, H5P_DEFAULT), H5Dclose);
    if (!all.call([&] { return dataset.ok() && has_shape(dataset, world.bodies, column.numbers); }))
      return all.take_status();
    if (!all.call([&] { return read_rows(dataset, column, share, world.bodies, mine); }))
      return all.take_status();
  }
  return {};
}

}  // namespace cellsweep::ranks
