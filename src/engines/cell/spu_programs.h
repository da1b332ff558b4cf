/// @file
/// The SPU programs of the engines, by the handles that they are loaded with.
#pragma once

#include <libspe2.h>

extern "C" spe_program_handle_t cell_paper_spu, cell_brute_spu, cell_resident_spu, cell_stream_spu;
