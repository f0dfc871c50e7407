/// \file
/// The combinatorics of a tetrahedralization: who has which corners, who is whose neighbour. No geometry.
///
/// Notation. A tetrahedron t has corners v[0..3] and, opposite corner i, facet i, whose neighbour n[i] is
/// packed as 4 * tet + facet of the neighbour, so that crossing a facet needs no search. The vertex at
/// infinity is vertex 0; a *ghost* tetrahedron has it in corner 3 and stands for the half-space beyond a
/// facet of the convex hull. 32 bytes a tetrahedron plus one of marks; freed slots are reused.
#pragma once

#include <cstdint>

#include "base/pod_vector.hpp"
#include "unsliver/types.hpp"

namespace unsliver::delaunay {

using TetId = std::uint32_t;
/// 4 * tet + facet.
using Facet = std::uint32_t;

inline constexpr VertexId kInfinite = 0;
inline constexpr TetId kNoTet = 0x3fffffff;  ///< also the limit on the number of tetrahedra: 2^30 - 1

constexpr TetId tet_of(Facet f) { return f >> 2; }
constexpr int slot_of(Facet f) { return static_cast<int>(f & 3); }
constexpr Facet facet_of(TetId t, int slot) { return t * 4 + static_cast<Facet>(slot); }

/// kFacetCorners[i] lists the corners of facet i so that (corners, corner i) is positively oriented.
inline constexpr int kFacetCorners[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};

struct TetRecord {
  VertexId v[4];
  Facet n[4];
};
static_assert(sizeof(TetRecord) == 32);

/// Slots of tetrahedra with a free list threaded through the unused ones.
class Store {
 public:
  std::size_t slot_count() const { return tets_.size(); }
  std::size_t tet_count() const { return tets_.size() - free_count_; }
  std::size_t bytes() const { return tets_.bytes() + marks_.bytes(); }

  TetRecord& operator[](TetId t) { return tets_[t]; }
  const TetRecord& operator[](TetId t) const { return tets_[t]; }
  std::uint8_t& mark(TetId t) { return marks_[t]; }

  bool alive(TetId t) const { return tets_[t].v[0] != kNoVertex; }
  bool is_ghost(TetId t) const { return tets_[t].v[3] == kInfinite; }

  /// Asks for t's record and mark ahead of use: their latency is most of the cost of a conflict test.
  void prefetch(TetId t) const {
    __builtin_prefetch(tets_.begin() + t);
    __builtin_prefetch(marks_.begin() + t);
  }

  /// A slot with mark 0 and undefined record. \throws std::bad_alloc beyond 2^30 - 1 slots.
  TetId allocate() {
    if (free_ != kNoTet) {
      const TetId t = free_;
      free_ = tets_[t].n[0];
      --free_count_;
      return t;
    }
    if (tets_.size() >= kNoTet) throw std::bad_alloc();
    tets_.resize_uninitialized(tets_.size() + 1);
    marks_.push_back(0);
    return static_cast<TetId>(tets_.size() - 1);
  }

  void release(TetId t) {
    tets_[t].v[0] = kNoVertex;
    tets_[t].n[0] = free_;
    free_ = t;
    ++free_count_;
  }

  /// Makes facets f and g each other's neighbours.
  void glue(Facet f, Facet g) {
    tets_[tet_of(f)].n[slot_of(f)] = g;
    tets_[tet_of(g)].n[slot_of(g)] = f;
  }

  void reserve(std::size_t tets) {
    tets_.reserve(tets);
    marks_.reserve(tets);
  }

 private:
  PodVector<TetRecord> tets_;
  PodVector<std::uint8_t> marks_;
  TetId free_ = kNoTet;
  std::size_t free_count_ = 0;
};

}  // namespace unsliver::delaunay
