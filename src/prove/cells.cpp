#include "prove/cells.hpp"

#include <algorithm>
#include <bit>
#include <optional>

#include "prove/decimals.hpp"

namespace unsliver::prover {
namespace {

constexpr int kSide = 4;
constexpr unsigned kAllEdges = 0xfff;

enum class SlotKind { kCorner, kEdge, kCenter, kFace, kBeyondEqual, kBeyondHalved };

struct Slot {
  SlotKind kind;
  int index;  ///< of the edge (0..11) or the face (0..5, 2 axis + side)
  Point at;
};

Point on_axis(int axis, std::int64_t value, std::int64_t first, std::int64_t second) {
  return axis == 0   ? Point{value, first, second}
         : axis == 1 ? Point{second, value, first}
                     : Point{first, second, value};
}

/// Edges 4 axis + j run along the axis.
Point edge_middle(int edge) { return on_axis(edge / 4, 2, kSide * (edge & 1), kSide * (edge >> 1 & 1)); }

/// Of the four edges around a face, as bits.
unsigned edges_of_face(int face) {
  unsigned edges = 0;
  for (int e = 0; e < 12; ++e) {
    const Point p = edge_middle(e);
    const std::int64_t coordinate = face / 2 == 0 ? p.x : face / 2 == 1 ? p.y : p.z;
    if (coordinate == kSide * (face & 1)) edges |= 1u << e;
  }
  return edges;
}

std::vector<Slot> slots_of(const CellRules& rules) {
  std::vector<Slot> slots;
  for (int c = 0; c < 8; ++c)
    slots.push_back({SlotKind::kCorner, c, {kSide * (c & 1), kSide * (c >> 1 & 1), kSide * (c >> 2)}});
  for (int e = 0; e < 12; ++e) slots.push_back({SlotKind::kEdge, e, edge_middle(e)});
  if (rules.has_centers) slots.push_back({SlotKind::kCenter, 0, {2, 2, 2}});
  for (int f = 0; f < 6; ++f) {
    const auto beyond = [&](int depth, int first, int second) {
      return on_axis(f / 2, (f & 1) != 0 ? kSide + depth : -depth, first, second);
    };
    slots.push_back({SlotKind::kFace, f, beyond(0, 2, 2)});
    if (!rules.has_centers) continue;
    slots.push_back({SlotKind::kBeyondEqual, f, beyond(2, 2, 2)});
    for (int j = 0; j < 4; ++j)
      slots.push_back({SlotKind::kBeyondHalved, f, beyond(1, 1 + 2 * (j & 1), 1 + 2 * (j >> 1))});
  }
  return slots;
}

/// What is beyond a face, as bits of a set of possibilities.
enum FaceState : unsigned { kNothing = 1, kEqual = 2, kHalved = 4, kEnd = 8 };

/// The keys that four vertices and their empty ball leave possible.
class Possible {
 public:
  explicit Possible(const CellRules& rules) : rules_(rules) {
    faces_.fill(kNothing | kHalved | (rules.has_centers ? kEqual : 0u) | (rules.may_end ? kEnd : 0u));
  }

  /// The slot is a vertex.
  void require(const Slot& slot) {
    switch (slot.kind) {
      case SlotKind::kCorner:
        break;
      case SlotKind::kEdge:
        edges_ |= 1u << slot.index;
        break;
      case SlotKind::kCenter:
        center_ = true;
        break;
      case SlotKind::kFace:
      case SlotKind::kBeyondHalved:
        face(slot) &= kHalved;
        break;
      case SlotKind::kBeyondEqual:
        face(slot) &= kEqual;
        break;
    }
  }

  /// The slot is none.
  void forbid(const Slot& slot) {
    switch (slot.kind) {
      case SlotKind::kCorner:
        impossible_ = true;
        break;
      case SlotKind::kEdge:
        no_edges_ |= 1u << slot.index;
        break;
      case SlotKind::kCenter:
        no_center_ = true;
        break;
      case SlotKind::kFace:
        face(slot) &= ~kHalved;
        break;
      case SlotKind::kBeyondEqual:
        face(slot) &= ~kEqual;
        break;
      case SlotKind::kBeyondHalved:
        if (!rules_.centers_are_optional) face(slot) &= ~kHalved;
        break;
    }
  }

  /// The circumcentre is strictly beyond a face.
  void end_at(int face) { faces_[std::size_t(face)] &= kEnd; }

  /// The edges whose middles are vertices in the key with the fewest vertices, or nothing.
  std::optional<unsigned> fewest_edges() const {
    unsigned edges = edges_, implied = 0;
    for (int f = 0; f < 6; ++f) {
      const unsigned states = faces_[std::size_t(f)];
      if (states == 0) return std::nullopt;
      if (states == kHalved) implied |= edges_of_face(f);
    }
    if (!rules_.has_edge_neighbors && !cover(edges & ~implied, implied)) return std::nullopt;
    edges |= implied;
    const bool hangs = edges != 0;
    if (impossible_ || (edges & no_edges_) != 0) return std::nullopt;
    if (no_center_ && (hangs || center_ || !rules_.centers_are_optional)) return std::nullopt;
    return edges;
  }

 private:
  /// Without neighbours at edges each edge takes a halved face: adds the edges of such faces, if there are
  /// some that do not bring a forbidden one.
  bool cover(unsigned edges, unsigned& implied) const;

  unsigned& face(const Slot& slot) { return faces_[std::size_t(slot.index)]; }

  CellRules rules_;
  std::array<unsigned, 6> faces_{};
  unsigned edges_ = 0, no_edges_ = 0;
  bool center_ = false, no_center_ = false, impossible_ = false;
};

bool Possible::cover(unsigned edges, unsigned& implied) const {
  for (unsigned halved = 0; halved < 64; ++halved) {
    unsigned brought = 0;
    bool allowed = true;
    for (int f = 0; f < 6; ++f)
      if ((halved >> f & 1) != 0) {
        brought |= edges_of_face(f);
        allowed &= (faces_[std::size_t(f)] & kHalved) != 0;
      }
    if (!allowed || (edges & ~brought) != 0 || (brought & no_edges_) != 0) continue;
    implied |= brought;
    return true;
  }
  return false;
}

/// visit(t, sphere, edges) for each tetrahedron of slots, in all ties, that some key has with its
/// circumcentre in the leaf.
template <class Visit>
void for_each_cell_tetrahedron(const CellRules& rules, const Visit& visit) {
  const std::vector<Slot> slots = slots_of(rules);
  const auto decide = [&](const std::array<std::size_t, 4>& chosen) {
    const Tetrahedron t{slots[chosen[0]].at, slots[chosen[1]].at, slots[chosen[2]].at, slots[chosen[3]].at};
    const auto sphere = Circumsphere::of(t);
    if (!sphere) return;
    Possible possible(rules);
    for (const std::size_t i : chosen) possible.require(slots[i]);
    for (const Slot& slot : slots)
      if (sphere->holds_inside(slot.at)) possible.forbid(slot);
    for (int axis = 0; axis < 3; ++axis) {
      if (sphere->compare_center(axis, 0) < 0) possible.end_at(2 * axis);
      if (sphere->compare_center(axis, kSide) > 0) possible.end_at(2 * axis + 1);
    }
    if (const auto edges = possible.fewest_edges()) visit(t, *sphere, *edges);
  };
  for (std::size_t a = 0; a < slots.size(); ++a)
    for (std::size_t b = a + 1; b < slots.size(); ++b)
      for (std::size_t c = b + 1; c < slots.size(); ++c)
        for (std::size_t d = c + 1; d < slots.size(); ++d) decide({a, b, c, d});
}

/// How many keys there are: for each choice of halved faces among `states` possibilities a face, the edges
/// that need not hang. Optional centres are not counted.
std::int64_t key_count(int states) {
  std::int64_t count = 0;
  for (unsigned halved = 0; halved < 64; ++halved) {
    unsigned edges = 0;
    std::int64_t others = 1;
    for (int f = 0; f < 6; ++f)
      if ((halved >> f & 1) != 0)
        edges |= edges_of_face(f);
      else
        others *= states - 1;
    count += others << std::popcount(kAllEdges & ~edges);
  }
  return count;
}

struct Census {
  std::int64_t count = 0;
  Shape shape;
  int fewest_edges_of_bad = 12;
};

Census census(const CellRules& rules) {
  Census result;
  for_each_cell_tetrahedron(rules, [&](const Tetrahedron& t, const Circumsphere& sphere, unsigned edges) {
    const Shape shape = shape_of(t, sphere);
    ++result.count;
    result.shape.include(shape);
    if (!shape.within(kAngle30, kAngle135, shape.ratio_sq))
      result.fewest_edges_of_bad = std::min(result.fewest_edges_of_bad, std::popcount(edges));
  });
  return result;
}

}  // namespace

std::set<Tetrahedron> cell_tetrahedra(const CellRules& rules) {
  std::set<Tetrahedron> all;
  for_each_cell_tetrahedron(rules, [&](Tetrahedron t, const Circumsphere&, unsigned) {
    std::sort(t.begin(), t.end());
    all.insert(t);
  });
  return all;
}

Finding prove_octree_keys(const OctreeKeys& claim) {
  Finding finding{count_part("keys of leaves inside a forest", claim.interior_keys, key_count(3)),
                  count_part("keys of leaves at its end", claim.boundary_keys, key_count(4) - key_count(3))};
  const auto decide = [&](const char* of, bool optional, bool may_end) {
    const Census found = census({claim.has_centers, optional, true, may_end});
    finding.push_back(shape_part(fmt::format("{}: ", of), claim.bounds, found.shape));
    finding.back().found += fmt::format("; {} tetrahedra of slots, all ties", found.count);
  };
  decide("inside, all leaves with centres", false, false);
  decide("inside, centres only where vertices hang, or more", true, false);
  decide("everywhere, all leaves with centres", false, true);
  decide("everywhere, centres only where vertices hang, or more", true, true);
  return finding;
}

Finding prove_balanced_octree(const BalancedOctree& claim) {
  const Census faces = census({false, false, false, false}), all = census({false, false, true, false});
  const Fraction ratio_sq{std::int64_t(claim.face_ratio) * claim.face_ratio, 1'000'000},
      below_sq{std::int64_t(claim.face_ratio - 1) * (claim.face_ratio - 1), 1'000'000};
  return {
      part(fmt::format("64 types, split neighbours at faces only: angles in [{}, {}], ratios at most {}",
                       thousandths_text(claim.face_least), text(claim.face_greatest),
                       thousandths_text(claim.face_ratio)),
           fmt::format("cos^2 = {}: {}", text(faces.shape.least.signed_cos_sq()), text(faces.shape)),
           prints_as(faces.shape.least, claim.face_least) && faces.shape.greatest == claim.face_greatest &&
               faces.shape.ratio_sq <= ratio_sq && faces.shape.ratio_sq > below_sq),
      part("these are all types of leaves in a balanced octree",
           fmt::format("no: neighbours at edges may be split too, {} types", key_count(2)),
           key_count(2) == 64, kDifferences),
      count_part("types with split neighbours at edges too", claim.all_types, key_count(2)),
      part(fmt::format("theirs are in [{}, {}], ratios at most {}", thousandths_text(claim.all_least),
                       thousandths_text(claim.all_greatest), root_text(claim.all_ratio_sq)),
           fmt::format("cos^2 = {} and {}: {}", text(all.shape.least.signed_cos_sq()),
                       text(all.shape.greatest.signed_cos_sq()), text(all.shape)),
           prints_as(all.shape.least, claim.all_least) && prints_as(all.shape.greatest, claim.all_greatest) &&
               all.shape.ratio_sq == claim.all_ratio_sq),
      count_part("vertices in the smallest type with an angle outside [30, 135]", claim.smallest_bad,
                 8 + all.fewest_edges_of_bad)};
}

}  // namespace unsliver::prover
