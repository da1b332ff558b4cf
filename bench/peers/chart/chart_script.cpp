#include "bench/peers/chart/chart_script.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bench/peers/chart/ratios.h"
#include "bench/peers/peer_mode.h"

namespace cellsweep::bench {
namespace {

/// Peers of one house share a colour and differ in dashes.
struct House {
  std::string_view prefix;
  std::string_view color;
};

constexpr std::array kHouses = {House{"box_pruning", "#444444"}, House{"embree", "#1b9e77"},
                                House{"bullet", "#2c6fbb"},      House{"fcl", "#e08214"},
                                House{"ode", "#9467bd"},         House{"cgal", "#8c564b"}};

constexpr std::array<std::string_view, 4> kDashes = {"dt solid", "dt (9,4)", "dt (3,3)", "dt (9,3,2,3)"};

// What stands for a peer on paper.
std::string style_of(const std::vector<std::string>& peers, std::size_t number) {
  const std::string& peer = peers[number];
  if (peer == "stream") return "lc rgb '#d7191c' lw 4 dt solid pt 7 ps 1";
  if (peer == "memory") return "lc rgb '#777777' lw 2 dt (2,3) pt 0 ps 0";
  for (const House& house : kHouses) {
    if (!peer.starts_with(house.prefix)) continue;
    std::size_t earlier = 0;
    for (std::size_t i = 0; i < number; ++i) earlier += peers[i].starts_with(house.prefix) ? 1 : 0;
    return text("lc rgb '", house.color, "' lw 1.6 ", kDashes[earlier % kDashes.size()], " pt ",
                5 + 2 * (earlier % 4), " ps 0.7");
  }
  return "lc rgb '#000000' lw 1.6 pt 4 ps 0.7";
}

// Where a peer stands in the key: `stream`, then house by house, the limit last.
std::size_t rank_of(std::string_view peer) {
  if (peer == "stream") return 0;
  if (peer == "memory") return kHouses.size() + 2;
  for (std::size_t i = 0; i < kHouses.size(); ++i) {
    if (peer.starts_with(kHouses[i].prefix)) return i + 1;
  }
  return kHouses.size() + 1;
}

// The same order, and so the same styles, whatever order the rows ran in. Our other engines are of no matter
// to the chart.
std::vector<std::string> drawn_peers(const PeerResults& results) {
  std::vector<std::string> peers;
  for (const std::string& peer : results.peers) {
    if (peer == "stream" || peer == "memory" || is_other(peer)) peers.push_back(peer);
  }
  std::sort(peers.begin(), peers.end(), [](const std::string& a, const std::string& b) {
    return std::pair(rank_of(a), a) < std::pair(rank_of(b), b);
  });
  return peers;
}

std::string title_of(std::string_view peer) {
  std::string title;
  for (const char c : peer) title += c == '_' ? ' ' : c;
  return peer == "memory" ? "memory''s limit" : title;
}

// Empty where the peer was never measured.
std::string points_of(const PeerResults& results, std::size_t scene, std::size_t mode,
                      const std::string& peer) {
  std::string points;
  for (const auto& [cell, times] : results.cells) {
    if (cell.scene != scene || cell.mode != mode) continue;
    const auto time = times.find(peer);
    if (time == times.end() || !time->second.exact()) continue;
    points += text(cell.bodies, " ", time->second.seconds, "\n");
  }
  return points;
}

constexpr std::string_view kStyle =
    "set encoding utf8\n"
    "set micro\n"
    "set logscale xy\n"
    "set format y '%.0s %cs'\n"
    "set xrange [700:*]\n"
    "set offsets graph 0, graph 0.04, 0, 0\n"
    "set xtics ('1,000' 1e3, '10,000' 1e4, '100,000' 1e5, '1 million' 1e6)\n"
    "set grid ytics xtics lt 1 lc rgb '#dde2e7' lw 0.8\n"
    "set border 3 lc rgb '#555555'\n"
    "set tics nomirror\n"
    "unset key\n";

std::string panel(const PeerResults& results, const std::vector<std::string>& peers, std::size_t scene,
                  std::size_t mode) {
  std::string blocks;
  std::string plot;
  for (std::size_t i = 0; i < peers.size(); ++i) {
    const std::string points = points_of(results, scene, mode, peers[i]);
    if (points.empty()) continue;
    const std::string block = text("$data_", mode, "_", i);
    blocks += text(block, " << END\n", points, "END\n");
    plot +=
        text(plot.empty() ? "plot " : ", \\\n  ", block, " using 1:2 with linespoints ", style_of(peers, i));
  }
  if (plot.empty()) return "set multiplot next\n";
  return text(blocks, "set title '", kPeerModes[mode].title, "' font ',15'\n", plot, "\n");
}

// An empty plot that has only a key.
std::string key_panel(const std::vector<std::string>& peers) {
  std::string plot;
  for (std::size_t i = 0; i < peers.size(); ++i) {
    plot += text(plot.empty() ? "plot " : ", \\\n  ", "NaN with linespoints ", style_of(peers, i), " title '",
                 title_of(peers[i]), "'");
  }
  return text(
      "unset title\nunset logscale\nunset border\nunset tics\nunset grid\nunset xlabel\nset xrange [0:1]\n"
      "set yrange [0:1]\nset key center center Left reverse samplen 4 spacing 1.25 font ',13'\n",
      plot.empty() ? "set multiplot next" : plot, "\n");
}

}  // namespace

std::string chart_script(const PeerResults& results, std::size_t scene) {
  const std::vector<std::string> peers = drawn_peers(results);
  std::string script(kStyle);
  // Five panels and the key, or two.
  const bool many = moves_as_told(scene);
  script +=
      text("set terminal pngcairo size 1500,", many ? 960 : 520, " font 'sans,12' background '#ffffff'\n");
  script += text("set multiplot layout ", many ? "2,3" : "1,3", " title \"time of a frame, scene ",
                 kPeerScenes[scene], ", over the number of bodies (both logarithmic)\" font ',17'\n");
  for (std::size_t mode = 0; mode < kPeerModes.size(); ++mode) {
    if (has_mode(scene, kPeerModes[mode].mode)) script += panel(results, peers, scene, mode);
  }
  return script + key_panel(peers) + "unset multiplot\n";
}

}  // namespace cellsweep::bench
