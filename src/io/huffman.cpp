#include "io/huffman.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace unsliver::io {
namespace {

// Depths of the leaves in Huffman's tree. Nodes are numbered leaves first, parents after their children.
std::vector<int> tree_depths(const std::vector<std::uint32_t>& counts) {
  using Node = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Node, std::vector<Node>, std::greater<>> open;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (counts[i] > 0) open.emplace(counts[i], i);

  std::vector<std::size_t> parents(counts.size());
  const auto adopt_rarest = [&] {
    const Node node = open.top();
    open.pop();
    parents[node.second] = parents.size();
    return node.first;
  };
  while (open.size() > 1) {
    const std::uint64_t first = adopt_rarest(), second = adopt_rarest();
    open.emplace(first + second, parents.size());
    parents.push_back(0);
  }

  std::vector<int> depths(parents.size(), 0);
  for (std::size_t i = parents.size() - 1; i-- > 0;)
    if (parents[i] > 0) depths[i] = depths[parents[i]] + 1;
  depths.resize(counts.size());
  return depths;
}

// Halving evens the counts out, and evenly counted symbols have codes of equal length.
std::vector<int> code_lengths(std::vector<std::uint32_t> counts, int longest) {
  for (;;) {
    std::vector<int> lengths = tree_depths(counts);
    if (*std::max_element(lengths.begin(), lengths.end()) <= longest) return lengths;
    for (std::uint32_t& count : counts) count = count / 2 + count % 2;
  }
}

std::uint64_t reversed(std::uint64_t bits, int length) {
  std::uint64_t result = 0;
  for (int i = 0; i < length; ++i) result |= (bits >> i & 1) << (length - 1 - i);
  return result;
}

}  // namespace

std::vector<BitCode> huffman_code(std::span<const std::uint32_t> counts, int longest) {
  const std::vector<int> lengths = code_lengths({counts.begin(), counts.end()}, longest);
  std::vector<BitCode> code(counts.size());
  std::uint64_t next = 0;
  for (int length = 1; length <= longest; ++length, next *= 2)
    for (std::size_t i = 0; i < code.size(); ++i)
      if (lengths[i] == length) code[i] = {reversed(next++, length), length};
  return code;
}

}  // namespace unsliver::io
