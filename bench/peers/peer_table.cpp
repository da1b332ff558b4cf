#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

std::vector<PeerInfo> make_table() {
  std::vector<PeerInfo> peers;
  add_own_peers(peers);
  add_box_pruning(peers);
#ifdef CELLSWEEP_PEER_EMBREE
  add_embree_peers(peers);
#endif
#ifdef CELLSWEEP_PEER_BULLET
  add_bullet_peers(peers);
#endif
#ifdef CELLSWEEP_PEER_FCL
  add_fcl_peers(peers);
#endif
#ifdef CELLSWEEP_PEER_ODE
  add_ode_peers(peers);
#endif
#ifdef CELLSWEEP_PEER_CGAL
  add_cgal_peers(peers);
#endif
  return peers;
}

}  // namespace

std::span<const PeerInfo> peer_table() {
  static const std::vector<PeerInfo> table = make_table();
  return table;
}

std::string peer_notes() {
  std::string notes =
      "| name | threads | margin | built and called | what it finds |\n"
      "|---|---|---|---|---|\n";
  for (const PeerInfo& peer : peer_table()) {
    notes.append("| `").append(peer.name).append("`");
    for (const std::string_view cell : {peer.threads, peer.margin, peer.settings, peer.exactness}) {
      notes.append(" | ").append(cell);
    }
    notes.append(" |\n");
  }
  return notes;
}

}  // namespace cellsweep::bench
