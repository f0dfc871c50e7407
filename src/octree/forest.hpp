/// \file
/// A forest of octrees over a brick of equal cubes, as one flat array of nodes.
///
/// Coordinates are world integers. A node of exponent k is a cube of side 2^k whose corners are points of
/// SC_k; its centre is a point of BCC_k. Child and corner numbers have bit a set for the upper side along
/// axis a.
#pragma once

#include <array>
#include <cstdint>

#include "base/pod_vector.hpp"
#include "unsliver/types.hpp"

namespace unsliver::octree {

using NodeId = std::int32_t;
inline constexpr NodeId kNoNode = -1;  ///< beyond the forest

/// What is known of a node. Where it lies with respect to the domain (see LeafTest) holds for all descendants
/// too.
enum NodeFlag : std::uint8_t {
  kHasCenter = 1,   ///< of leaves: the centre is a vertex
  kInside = 2,      ///< all tetrahedra that the node can own lie inside the domain
  kOutside = 4,     ///< all of them lie outside
  kDeep = 8,        ///< the node's face neighbours are inside, too
  kUniform = 16,    ///< of split nodes: all children are leaves with kHasCenter and kInside
  kDisturbed = 32,  ///< of leaves: some tetrahedra may give way to a guest's vertices; of their parents, too
  kVisited = 64,    ///< of leaves: a guest is to be asked about its vertices
};

struct Node {
  std::int32_t link;      ///< the first of 8 children in a row; of leaves: ~(number of the first own vertex)
  std::uint8_t exponent;  ///< the side is 2^exponent
  std::uint8_t flags;     ///< of NodeFlag
  std::uint16_t used;     ///< of leaves: the own vertices in use, bit VertexRef::own each

  bool is_leaf() const { return link < 0; }
};

/// A node and where it is.
struct Cell {
  NodeId node;
  int exponent;
  std::int64_t x, y, z;  ///< the lower corner

  std::int64_t side() const { return std::int64_t{1} << exponent; }
  Vec3 corner() const { return {double(x), double(y), double(z)}; }
  Vec3 center() const {
    const double half = 0.5 * double(side());
    return corner() + Vec3{half, half, half};
  }
};

/// count[0] x count[1] x count[2] cubes of side 2^exponent from the lower corner, a point of SC_exponent.
struct Brick {
  int exponent;
  std::array<std::int64_t, 3> lo;
  std::array<int, 3> count;
  bool periodic = false;  ///< opposite faces are one
};

class Forest {
 public:
  explicit Forest(const Brick& brick);

  const Brick& brick() const { return brick_; }
  std::size_t size() const { return nodes_.size(); }
  std::size_t bytes() const { return nodes_.bytes(); }
  Node& operator[](NodeId n) { return nodes_[std::size_t(n)]; }
  const Node& operator[](NodeId n) const { return nodes_[std::size_t(n)]; }

  /// Root number (i, j, k) of the brick; beyond it kNoNode, or the one that is there if it is periodic.
  NodeId root(int i, int j, int k) const;
  Cell root_cell(int i, int j, int k) const;

  /// Makes 8 leaves with the parent's flags, less kHasCenter, below a leaf; returns the first. References to
  /// nodes are lost. \throws Error kLimit at 2^31 nodes.
  NodeId split(NodeId leaf);
  /// Adds nodes that mean nothing yet; returns the first. As split else.
  NodeId make_room(std::size_t count);
  /// Puts a forest of one root, of the leaf's cube, in the leaf's place; its other nodes go to such room:
  /// number n there becomes first - 1 + n.
  void graft(NodeId leaf, const Forest& tree, NodeId first);

  Cell child(const Cell& cell, int number) const {
    const int k = cell.exponent - 1;
    return {(*this)[cell.node].link + number, k, cell.x + (std::int64_t(number & 1) << k),
            cell.y + (std::int64_t(number >> 1 & 1) << k), cell.z + (std::int64_t(number >> 2) << k)};
  }

 private:
  void require_room(std::size_t more) const;

  Brick brick_;
  PodVector<Node> nodes_;
};

/// Calls visit(cell) for each root, x fastest.
template <class Visit>
void for_each_root(const Forest& forest, const Visit& visit) {
  const auto& n = forest.brick().count;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) visit(forest.root_cell(i, j, k));
}

}  // namespace unsliver::octree
