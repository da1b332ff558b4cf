// SPU program of stream: pieces of cells flow through the local store, one on its way while another is
// compared.
#include <free_align.h>
#include <malloc_align.h>

#include "engines/cell/spu/stream/block_pairs.h"

namespace {

using namespace cellsweep::cell;

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kFirstPairTag = 2;  // pieces have 0 and 1
constexpr unsigned int kJobTag = 4;
constexpr unsigned int kAllTags = 31;
constexpr unsigned int kBlockVectors = kStreamWords / 4 * kStreamBlock;
constexpr unsigned int kColumnVectors = (kStreamTag + 1) * kStreamBlock / 4;

void* allocate(unsigned int bytes) {
  return _malloc_align(bytes, kLog2Align);
}

void get_block(const StreamPiece& piece, std::uint32_t first, Block& block, std::uint32_t count,
               unsigned int tag) {
  constexpr unsigned int kBoxBytes = 4 * kStreamWords;
  block.count = count;
  get_all(block.boxes, ea_of(piece.boxes) + 1ULL * kBoxBytes * first, kBoxBytes * count, tag);
}

/// The two blocks of a piece.
struct Blocks {
  Block one;
  Block other;

  void get(const StreamPiece& piece, unsigned int tag) {
    get_block(piece, piece.first, one, piece.first_count, tag);
    if (piece.second != piece.first) get_block(piece, piece.second, other, piece.second_count, tag);
  }

  /// Compares from row `row` on; false when the pairs' room is full, `row` saying how far it came.
  bool compare(const StreamPiece& piece, std::uint32_t& row, Columns& columns, PairStream& pairs) const {
    const bool same = piece.second == piece.first;
    columns.fill(same ? one : other);
    for (; row < one.count; ++row) {
      if (!pairs.has_room()) return false;
      add_row(one, row, columns, same ? row + 1 : 0, pairs);
    }
    row = 0;
    return true;
  }
};

/// Pieces that are here; how many were compared, and of the next one how many rows.
std::uint32_t compare_pieces(const StreamPiece* pieces, std::uint32_t count, Blocks* blocks, Columns& columns,
                             std::uint32_t& row, PairStream& pairs) {
  blocks[0].get(pieces[0], 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const unsigned int turn = i & 1U;
    if (i + 1 < count) blocks[turn ^ 1U].get(pieces[i + 1], turn ^ 1U);
    wait_for_tag(turn);
    if (!blocks[turn].compare(pieces[i], row, columns, pairs)) return i;
  }
  return count;
}

StreamResult compare_all(const StreamJob& job, StreamPiece* pieces, Blocks* blocks, Columns& columns,
                         PairStream& pairs) {
  StreamResult result{};
  result.rows_done = job.rows_done;
  while (result.pieces_done < job.count) {
    const std::uint32_t left = job.count - result.pieces_done;
    const std::uint32_t count = left < kStreamPieces ? left : kStreamPieces;
    get_all(pieces, ea_of(job.pieces) + sizeof(StreamPiece) * result.pieces_done, sizeof(StreamPiece) * count,
            kJobTag);
    wait_for_tag(kJobTag);
    const std::uint32_t done = compare_pieces(pieces, count, blocks, columns, result.rows_done, pairs);
    result.pieces_done += done;
    if (done < count) break;
  }
  pairs.flush();
  wait_for_tags(kAllTags);
  result.pairs = pairs.sent();
  return result;
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  auto* job = static_cast<StreamJob*>(allocate(sizeof(StreamJob)));
  auto* result = static_cast<StreamResult*>(allocate(sizeof(StreamResult)));
  auto* pieces = static_cast<StreamPiece*>(allocate(kStreamPieces * sizeof(StreamPiece)));
  auto* chunks = static_cast<std::uint32_t*>(allocate(2 * kStreamPairs * 8));
  auto* boxes = static_cast<vec_float4*>(allocate(4 * kBlockVectors * 16));
  auto* arrays = static_cast<vec_float4*>(allocate(kColumnVectors * 16));
  get_all(job, argp, sizeof(StreamJob), kJobTag);
  wait_for_tag(kJobTag);
  Blocks blocks[2];
  for (unsigned int i = 0; i < 2; ++i) {
    blocks[i].one = {boxes + 2 * i * kBlockVectors, 0};
    blocks[i].other = {boxes + (2 * i + 1) * kBlockVectors, 0};
  }
  Columns columns = {arrays, 0};
  PairStream pairs(chunks, *job, kFirstPairTag);
  *result = compare_all(*job, pieces, blocks, columns, pairs);
  put_all(result, ea_of(job->result), sizeof(StreamResult), kJobTag);
  wait_for_tag(kJobTag);
  _free_align(arrays);
  _free_align(boxes);
  _free_align(chunks);
  _free_align(pieces);
  _free_align(result);
  _free_align(job);
  return 0;
}
