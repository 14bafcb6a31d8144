#include <gtest/gtest.h>
#include <random>

#include <compiler/passes/MinCut.hpp>

namespace finback::compiler {
namespace {

TEST(MinCut, CutsTheCheapestEdgeOfAChain) {
  MinCut cut;
  int a = cut.add_node();
  int b = cut.add_node();
  cut.add_edge(MinCut::kSource, a, 9);
  cut.add_edge(a, b, 2);
  cut.add_edge(b, MinCut::kSink, 5);
  const std::vector<bool> side = cut.source_side();
  EXPECT_TRUE(side[a]);
  EXPECT_FALSE(side[b]);
}

TEST(MinCut, LeavesWhatTheSourceDoesNotReachOnTheSinksSide) {
  MinCut cut;
  int alone = cut.add_node();
  EXPECT_FALSE(cut.source_side()[alone]);
}

/// The cost of a cut, edge by edge.
struct Edge {
  int from;
  int to;
  int64_t capacity;
};

int64_t cost(const std::vector<Edge>& edges, const std::vector<bool>& side) {
  int64_t sum = 0;
  for (const Edge& edge : edges)
    if (side[static_cast<size_t>(edge.from)] && !side[static_cast<size_t>(edge.to)])
      sum += edge.capacity;
  return sum;
}

TEST(MinCut, IsAsCheapAsTheBestOfAllCuts) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    constexpr int kNodes = 8;
    MinCut cut;
    while (cut.add_node() < kNodes - 1) {
    }
    std::vector<Edge> edges;
    for (int i = 0; i < 18; ++i) {
      Edge edge{static_cast<int>(random() % kNodes), static_cast<int>(random() % kNodes),
                static_cast<int64_t>(random() % 20)};
      edges.push_back(edge);
      cut.add_edge(edge.from, edge.to, edge.capacity);
    }
    int64_t best = INT64_MAX;
    for (unsigned sides = 0; sides < (1U << (kNodes - 2)); ++sides) {
      std::vector<bool> side(kNodes);
      side[MinCut::kSource] = true;
      for (int node = 2; node < kNodes; ++node)
        side[static_cast<size_t>(node)] = (sides >> (node - 2) & 1) != 0;
      best = std::min(best, cost(edges, side));
    }
    EXPECT_EQ(cost(edges, cut.source_side()), best) << "round " << round;
  }
}

}  // namespace
}  // namespace finback::compiler
