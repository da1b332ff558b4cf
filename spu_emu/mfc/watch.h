/// @file
/// Watches the local store bytes of a command in flight, so that a program that touches them too early is
/// told.
#ifndef SPU_EMU_MFC_WATCH_H
#define SPU_EMU_MFC_WATCH_H

#include <vector>

#include "mfc/command.h"
#include "mfc/transfers.h"

namespace spu_emu {

/// The byte that stands in the destination of a get until it lands.
inline constexpr std::byte kPoison{0xa5};

/// True if the local store bytes of the two have any in common.
bool overlap(const Piece& one, const Piece& other);

/// Fills the pieces with kPoison.
void poison(const std::vector<Piece>& pieces);

/// Under AddressSanitizer any access to the pieces by code of this machine is an error from here on.
void forbid_access(const std::vector<Piece>& pieces);

/// Makes the pieces accessible again; true if every byte still is kPoison.
bool end_poison(const std::vector<Piece>& pieces);

/// Makes the bytes accessible to AddressSanitizer again, whatever they hold.
void allow_access(const std::byte* first, std::size_t size);

/// The bytes of the pieces, one after the other.
std::vector<std::byte> snapshot(const std::vector<Piece>& pieces);

}  // namespace spu_emu

#endif
