/// \file
/// The boundary of a mesh that fills a box, marked.
#pragma once

#include "unsliver/mesh.hpp"

namespace unsliver::octree {

/// Sets triangles to the facets of tetrahedra that lie on the box's faces, outward, in the order of the
/// tetrahedra; triangle_labels to 1 + 2 axis + (0 low, 1 high). Requires positively oriented tetrahedra
/// inside the box. The result does not depend on the number of threads.
void mark_faces(const Box3& box, TetMesh& mesh, unsigned threads = 1);

}  // namespace unsliver::octree
