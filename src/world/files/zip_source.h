/// @file
/// The project's files as libzip sees them.
#pragma once

#include <zip.h>

#include <memory>

#include "world/files/byte_source.h"
#include "world/files/scratch_file.h"

namespace cellsweep {

struct ZipSourceCloser {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using ZipSource = std::unique_ptr<zip_source_t, ZipSourceCloser>;

/// To read from. std::bad_alloc where there is no memory.
ZipSource make_zip_source(std::shared_ptr<const ByteSource> bytes);
/// To write to, from the first byte on.
ZipSource make_zip_target(std::shared_ptr<ScratchFile> file);

}  // namespace cellsweep
