/// @file
/// The table of peers, and what each adapter adds to it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/peers/peer.h"

namespace cellsweep::bench {

/// All peers of this build, `memory` and the project's own engines first.
std::span<const PeerInfo> peer_table();

/// What a reader must know of each peer to read its times: a table in Markdown.
std::string peer_notes();

void add_own_peers(std::vector<PeerInfo>& peers);
void add_box_pruning(std::vector<PeerInfo>& peers);
void add_embree_peers(std::vector<PeerInfo>& peers);
void add_bullet_peers(std::vector<PeerInfo>& peers);
void add_fcl_peers(std::vector<PeerInfo>& peers);
void add_ode_peers(std::vector<PeerInfo>& peers);
void add_cgal_peers(std::vector<PeerInfo>& peers);

}  // namespace cellsweep::bench
