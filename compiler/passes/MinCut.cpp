#include "MinCut.hpp"

#include <algorithm>

namespace finback::compiler {

int MinCut::add_node() {
  out_.emplace_back();
  return static_cast<int>(out_.size()) - 1;
}

void MinCut::add_edge(int from, int to, Capacity capacity) {
  if (from == to)
    return;
  out_[static_cast<size_t>(from)].push_back(static_cast<int>(edges_.size()));
  edges_.push_back({to, capacity});
  out_[static_cast<size_t>(to)].push_back(static_cast<int>(edges_.size()));
  edges_.push_back({from, 0});
}

bool MinCut::find_levels() {
  level_.assign(out_.size(), -1);
  level_[kSource] = 0;
  std::vector<int> queue = {kSource};
  for (size_t i = 0; i < queue.size(); ++i)
    for (int edge : out_[static_cast<size_t>(queue[i])]) {
      const Edge& e = edges_[static_cast<size_t>(edge)];
      if (e.left > 0 && level_[static_cast<size_t>(e.to)] < 0) {
        level_[static_cast<size_t>(e.to)] = level_[static_cast<size_t>(queue[i])] + 1;
        queue.push_back(e.to);
      }
    }
  return level_[kSink] >= 0;
}

MinCut::Capacity MinCut::push(int node, Capacity limit) {
  if (node == kSink)
    return limit;
  auto n = static_cast<size_t>(node);
  for (; next_[n] < out_[n].size(); ++next_[n]) {
    auto index = static_cast<size_t>(out_[n][next_[n]]);
    Edge& edge = edges_[index];
    if (edge.left <= 0 || level_[static_cast<size_t>(edge.to)] != level_[n] + 1)
      continue;
    Capacity sent = push(edge.to, std::min(limit, edge.left));
    if (sent > 0) {
      edges_[index].left -= sent;
      edges_[index ^ 1].left += sent;
      return sent;
    }
  }
  return 0;
}

std::vector<bool> MinCut::source_side() {
  while (find_levels()) {
    next_.assign(out_.size(), 0);
    while (push(kSource, kInfinite) > 0) {
    }
  }
  std::vector<bool> side(out_.size());
  for (size_t i = 0; i < side.size(); ++i)
    side[i] = level_[i] >= 0;
  return side;
}

}  // namespace finback::compiler
