// The cheapest separation of a directed graph's source from its sink (Dinic's algorithm).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace finback::compiler {

class MinCut {
 public:
  using Capacity = int64_t;
  static constexpr Capacity kInfinite = Capacity{1} << 50;
  static constexpr int kSource = 0;
  static constexpr int kSink = 1;

  int add_node();
  /// Cutting the edge costs `capacity` when `from` ends on the source's side and `to` on the
  /// sink's.
  void add_edge(int from, int to, Capacity capacity);
  /// For every node: is it on the source's side? The source's side is the smallest possible one.
  std::vector<bool> source_side();

 private:
  struct Edge {
    int to;
    Capacity left;
  };
  bool find_levels();
  Capacity push(int node, Capacity limit);

  std::vector<Edge> edges_;  // an edge and its reverse are neighbours
  std::vector<std::vector<int>> out_ = std::vector<std::vector<int>>(2);
  std::vector<int> level_;
  std::vector<std::size_t> next_;
};

}  // namespace finback::compiler
