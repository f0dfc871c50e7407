/// \file
/// Size enforcement, the first step of Figures 5 and 8. Its property only ever improves: a ball that holds a
/// vertex keeps it.
#pragma once

#include <functional>
#include <span>

#include "refine/empty_ball.hpp"

namespace unsliver::refine {

/// Inserts a vertex into (or next to the centre of) an empty ball. `near` is a tetrahedron not far from it.
template <class R>
void insert_for_size(R& refinement, const EmptyBall& ball, TetId near);

/// Inserts a vertex for the ball, perhaps others with it; returns all tetrahedra made, whether or not they
/// are still there.
using InsertForSize = std::function<std::span<const TetId>(const EmptyBall& ball, TetId near)>;

/// Thrifty size enforcement: inserts until every ball B(p, s(p)), p in the domain, holds a vertex. Sweeps
/// with max(s, floor), the floor falling, so that points come in rounds of growing density and the
/// tetrahedralization is never far from uniform; each sweep walks the tetrahedra in storage order and
/// finishes each neighbourhood before it moves on.
template <class R>
void enforce_size(R& refinement, const InsertForSize& insert);
/// The same with insert_for_size.
template <class R>
void enforce_size(R& refinement);

}  // namespace unsliver::refine
