/// @file
/// Makes engine `stream`, and engines that are made of it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "cellsweep/broadphase.h"
#include "engines/stream/cells/piece_finder.h"

namespace cellsweep::stream {

/// Makes what finds pairs in the kernels' place, again after it has failed.
using FinderMaker = std::function<Result<std::unique_ptr<PieceFinder>>()>;

/// A broadphase whose engine is called `name`, a literal, with the kernels of `options` or a finder. Errors:
/// those of make_broadphase(StreamOptions) and of the finder's maker.
CELLSWEEP_API Result<Broadphase> make_stream_broadphase(const StreamOptions& options, std::string_view name,
                                                        FinderMaker make_finder, std::string row_name);

}  // namespace cellsweep::stream
