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

std::string_view come_and_go(const PeerInfo& peer) {
  if (peer.removes) return "taken out and entered singly";
  return peer.remembers ? "it cannot take one out: all are entered anew, into a new one"
                        : "all anew, as always";
}

}  // namespace

std::span<const PeerInfo> peer_table() {
  static const std::vector<PeerInfo> table = make_table();
  return table;
}

std::string peer_notes() {
  std::string notes =
      "| name | threads | margin | built and called | what it finds | bodies that come and go |\n"
      "|---|---|---|---|---|---|\n";
  for (const PeerInfo& peer : peer_table()) {
    notes.append("| `").append(peer.name).append("`");
    for (const std::string_view cell :
         {peer.threads, peer.margin, peer.settings, peer.exactness, come_and_go(peer)}) {
      notes.append(" | ").append(cell);
    }
    notes.append(" |\n");
  }
  return notes;
}

}  // namespace cellsweep::bench
