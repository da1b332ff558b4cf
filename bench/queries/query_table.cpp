#include <algorithm>

#include "bench/queries/query_peer.h"

namespace cellsweep::bench {
namespace {

std::vector<QueryPeerInfo> make_query_table() {
  std::vector<QueryPeerInfo> peers;
  add_own_query_peers(peers);
#ifdef CELLSWEEP_QUERY_PEER_BULLET
  add_bullet_query_peers(peers);
#endif
#ifdef CELLSWEEP_QUERY_PEER_EMBREE
  add_embree_query_peers(peers);
#endif
#ifdef CELLSWEEP_QUERY_PEER_FCL
  add_fcl_query_peers(peers);
#endif
#ifdef CELLSWEEP_QUERY_PEER_NANOFLANN
  add_nanoflann_query_peers(peers);
#endif
  return peers;
}

}  // namespace

bool QueryPeerInfo::does_answer(QuestionKind kind) const {
  return std::find(answers.begin(), answers.end(), kind) != answers.end();
}

std::span<const QueryPeerInfo> query_peer_table() {
  static const std::vector<QueryPeerInfo> table = make_query_table();
  return table;
}

}  // namespace cellsweep::bench
