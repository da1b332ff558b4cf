#include "cellsweep/checkpoint.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/text.h"
#include "ranks/checkpoint/body_file.h"
#include "ranks/checkpoint/file_fault.h"
#include "ranks/checkpoint/seal.h"
#include "ranks/job.h"

namespace cellsweep {
namespace {

using ranks::BodyRows;
using ranks::Job;
using ranks::WorldRow;

Status collect(const DistributedBroadphase& world, std::string_view note, BodyRows& mine, WorldRow& row) {
  if (note.size() > kMostCheckpointNote) {
    return Status::bad_input(
        text("The checkpoint's note has ", note.size(), " bytes, ", kMostCheckpointNote, " are allowed."),
        "note", note.size(), kMostCheckpointNote);
  }
  row.note = note;
  row.bodies = world.size();
  row.pairs = world.pairs().size();
  row.pair_hash = global_pair_set_hash(world.pairs());
  const std::vector<GlobalId> ids = world.owned();
  mine.resize(ids.size());
  mine.ids = ids;
  if (Status status = world.boxes(ids, mine.boxes); !status.ok()) return status;
  std::vector<BodyFilter> filters(ids.size());
  if (Status status = world.filters(ids, filters); !status.ok()) return status;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    mine.categories[i] = filters[i].category;
    mine.masks[i] = filters[i].mask;
    mine.is_static[i] = filters[i].is_static ? 1 : 0;
  }
  return {};
}

// HDF5 wants the same one from all ranks.
Status share_note(const Job& job, std::string& note) {
  int size = static_cast<int>(note.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, job.communicator());
  Status status = job.agree([&]() -> Status {
    note.resize(static_cast<std::size_t>(size));
    return {};
  });
  if (status.ok()) MPI_Bcast(note.data(), size, MPI_CHAR, 0, job.communicator());
  return status;
}

void add_up_pairs(const Job& job, WorldRow& row) {
  MPI_Allreduce(MPI_IN_PLACE, &row.pairs, 1, MPI_UINT64_T, MPI_SUM, job.communicator());
  MPI_Allreduce(MPI_IN_PLACE, &row.pair_hash, 1, MPI_UINT64_T, MPI_BXOR, job.communicator());
}

// It is the path that is to blame, and not the disk.
Status path_fault(const std::string& path, int error) {
  Status status = ranks::write_fault(path, error);
  status.code = StatusCode::bad_input;
  return status;
}

// Before HDF5 comes, which does not say well what is wrong with a path.
Status try_path(const std::string& path, const std::string& part) {
  if (std::filesystem::is_directory(path)) return path_fault(path, EISDIR);
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return path_fault(part, errno);
  ::close(file);
  return {};
}

// Of the file that is written: the seal, then its name, on the disk. Once it has that, nothing fails.
Status publish(const std::string& part, const std::string& path, const ranks::Seal& seal) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (Status status = ranks::write_seal(part, seal); !status.ok()) return status;
  if (std::rename(part.c_str(), path.c_str()) != 0) return ranks::write_fault(path, errno);
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return {};
  ::fsync(file);
  ::close(file);
  return {};
}

// The checksum of a file of `bytes`, of which each rank reads its part.
Status add_up(const Job& job, const std::string& path, std::uint64_t bytes, std::uint64_t& checksum) {
  checksum = 0;
  Status status = job.agree([&]() -> Status {
    const auto mine = ranks::checksum_of_part(path, bytes, job.rank(), job.ranks());
    if (mine) checksum = *mine;
    return mine.status();
  });
  MPI_Allreduce(MPI_IN_PLACE, &checksum, 1, MPI_UINT64_T, MPI_BXOR, job.communicator());
  return status;
}

Status read_back(const Job& job, const std::string& part, const BodyRows& mine) {
  BodyRows rows;
  WorldRow world;
  if (Status status = ranks::read_bodies(job, part, mine.ids.size(), world, rows); !status.ok())
    return status;
  return job.agree([&]() -> Status {
    return rows == mine ? Status() : ranks::write_fault(part, "what was written reads otherwise");
  });
}

Status write_part(const Job& job, const std::string& part, const WorldRow& row, BodyRows& mine,
                  ranks::Seal& seal) {
  if (Status status = ranks::write_bodies(job, part, ranks::kSealBytes, row, mine); !status.ok())
    return status;
  if (Status status = read_back(job, part, mine); !status.ok()) return status;
  Status status = job.agree([&]() -> Status {
    const auto bytes = ranks::file_bytes(part);
    if (bytes) seal.bytes = *bytes;
    return bytes.status();
  });
  if (!status.ok()) return status;
  return add_up(job, part, seal.bytes, seal.checksum);
}

// What the file says, from its seal to its bodies.
Status read_checkpoint(const Job& job, const std::string& path, WorldRow& row, BodyRows& mine) {
  ranks::Seal seal;
  Status status = job.agree([&]() -> Status {
    const auto read = ranks::read_seal(path);
    if (read) seal = *read;
    return read.status();
  });
  std::uint64_t checksum = 0;
  if (status.ok()) status = add_up(job, path, seal.bytes, checksum);
  if (!status.ok()) return status;
  status = job.agree([&]() -> Status {
    if (checksum == seal.checksum) return {};
    return Status::bad_input(text(path, " was changed since it was written: its checksum is another one."));
  });
  if (!status.ok()) return status;
  return ranks::read_bodies(job, path, std::nullopt, row, mine);
}

Status insert_all(DistributedBroadphase& world, const BodyRows& mine) {
  std::vector<BodyFilter> filters;
  for (std::size_t i = 0; i < mine.ids.size(); ++i)
    filters.push_back({mine.categories[i], mine.masks[i], mine.is_static[i] != 0});
  // An engine that knows of no filters asks nobody for them.
  if (std::ranges::all_of(filters, [](const BodyFilter& filter) { return filter == BodyFilter(); }))
    filters.clear();
  return world.insert(mine.ids, mine.boxes, filters);
}

}  // namespace

Status save_checkpoint(const DistributedBroadphase& world, const std::string& path, std::string_view note) {
  const Job job(world.communicator());
  BodyRows mine;
  WorldRow row;
  Status status = job.agree([&] { return collect(world, note, mine, row); });
  if (!status.ok()) return status;
  if (status = share_note(job, row.note); !status.ok()) return status;
  add_up_pairs(job, row);
  std::string part;
  status = job.agree([&] {
    part = path + ".part";
    return job.rank() == 0 ? try_path(path, part) : Status();
  });
  if (!status.ok()) return status;
  ranks::Seal seal;
  status = write_part(job, part, row, mine, seal);
  if (status.ok()) status = job.agree([&] { return job.rank() == 0 ? publish(part, path, seal) : Status(); });
  if (!status.ok() && job.rank() == 0) ::unlink(part.c_str());
  return status;
}

Result<RestoredWorld> load_checkpoint(MPI_Comm communicator, const std::string& path,
                                      const RankOptions& options) {
  const Job job(communicator);
  BodyRows mine;
  WorldRow row;
  if (Status status = read_checkpoint(job, path, row, mine); !status.ok()) return status;
  auto world = make_distributed_broadphase(communicator, options);
  if (Status made = Job::attempt([&] { return world.status(); }); !made.ok()) return made;
  Status inserted = job.agree([&] { return insert_all(*world, mine); });
  if (!inserted.ok()) return inserted;
  if (Status updated = Job::attempt([&] { return world->update().status(); }); !updated.ok()) return updated;
  WorldRow found;
  Status status = job.agree([&]() -> Status {
    found.pairs = world->pairs().size();
    found.pair_hash = global_pair_set_hash(world->pairs());
    return {};
  });
  if (!status.ok()) return status;
  add_up_pairs(job, found);
  status = job.agree([&]() -> Status {
    if (found.pairs == row.pairs && found.pair_hash == row.pair_hash) return {};
    return Status::bad_input(text("The bodies in ", path, " have ", found.pairs,
                                  " pairs and others than the ", row.pairs, " that it was written with."));
  });
  if (!status.ok()) return status;
  return RestoredWorld{std::move(*world), std::move(row.note)};
}

}  // namespace cellsweep
