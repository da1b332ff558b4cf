/// @file
/// Writes files whole: under its name there is the file of before or the new one, never a part of one. For
/// the libraries of the project, all of which write that way.
#pragma once

#include <string>
#include <string_view>

#include "cellsweep/export.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// A file on its way. Until commit() it has no name, so that a program that fails or is killed leaves what
/// was there and nothing else; commit() puts it on the disk and gives it its name. It takes owner and mode of
/// the file that it replaces, and the place of the one that a link leads to. What is no file, a device or a
/// pipe, is written to as it is.
///
/// Where a file is replaced, the new one has a name of its own, `.cellsweep-N.tmp`, between two system calls;
/// on file systems without O_TMPFILE from open() on. What a killed program left there goes when another
/// writes in that folder. One thread at a time.
class CELLSWEEP_API NewFile {
 public:
  NewFile() = default;
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  /// Forgets what was not committed.
  ~NewFile();

  /// Called once, first. Errors: bad_input for a path that cannot be written to, such as a folder or a
  /// read-only file; write_failed for a disk that says no.
  [[gnu::cold]] Status open(const std::string& path);

  /// Errors of these: write_failed, with the path in front. After one the file is forgotten.
  [[gnu::cold]] Status write(std::string_view bytes);
  [[gnu::cold]] Status commit();

 private:
  struct Target;

  [[gnu::cold]] Status look_at_target(Target& target) const;
  [[gnu::cold]] Status open_file();
  [[gnu::cold]] bool open_named();
  [[gnu::cold]] bool take_name();
  [[gnu::cold]] bool keep_owner_and_mode(const Target& target) const;
  [[gnu::cold]] bool publish(const Target& target);
  [[gnu::cold]] Status fail(int error);
  [[gnu::cold]] void forget();

  std::string path_;    // as it was given
  std::string target_;  // where it leads
  std::string folder_;  // of the target
  std::string name_;    // the temporary one; empty while there is none
  int file_ = -1;
  bool is_device_ = false;
};

/// The bytes as a file of that path. Errors: those of NewFile.
inline Status write_new_file(const std::string& path, std::string_view bytes) {
  NewFile file;
  if (Status status = file.open(path); !status.ok()) return status;
  if (Status status = file.write(bytes); !status.ok()) return status;
  return file.commit();
}

}  // namespace cellsweep
