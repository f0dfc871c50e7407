#include "refine/figure_8_octree.hpp"

#include <algorithm>

#include "refine/disturbers.hpp"
#include "refine/octree_refinement.hpp"

namespace unsliver::refine {

namespace {

class InputGuest final : public octree::Guest {
 public:
  explicit InputGuest(Refinement& r) : r_(r) {}

  void on_forest(octree::Forest& forest, const EnterPhase& enter) override {
    const auto begin = [&](const char* phase) {
      enter(phase);
      r_.enter_phase(phase);
    };
    begin("lift");
    refinement_.emplace(r_, forest);
    refinement_->lift_surroundings();
    begin("quality");
    refinement_->refine();
    begin("stitch");
    number_vertices();
    set_apart(forest);
  }

  std::span<const Vec3> neighbours(octree::NodeId leaf) const override { return disturbers_->at(leaf); }
  VertexId vertex_count() const override { return first_bulk_; }
  std::uint64_t tet_count() const override { return refinement_ ? refinement_->kept().size() : 0; }
  std::uint64_t most_vertices() const override { return number_.size(); }
  std::uint64_t bytes() const override { return refinement_ ? refinement_->bytes() : r_.mesh().bytes(); }

  std::uint8_t on_vertex(VertexId number, const Vec3& p, Level coarse) override {
    const VertexId v = refinement_->lifted_at(p);
    if (v != kNoVertex) number_[v] = number;
    return static_cast<std::uint8_t>(v != kNoVertex ? r_.label(v) : refinement_->label_of(p, coarse));
  }

  void complete(TetMesh& mesh) override {
    for (VertexId v = 1; v < number_.size(); ++v) {
      if (number_[v] == kMissing) {
        number_[v] = static_cast<VertexId>(mesh.points.size());
        mesh.points.emplace_back();
        mesh.levels.emplace_back();
      } else if (number_[v] == kNoVertex || !refinement_->is_guest(v)) {
        continue;
      }
      mesh.points[number_[v]] = r_.output_position(v);
      mesh.levels[number_[v]] = static_cast<std::uint8_t>(r_.label(v));
    }
    for (const TetId t : refinement_->kept()) {
      const auto& v = r_.mesh().tet(t).v;
      mesh.tets.push_back({number_[v[0]], number_[v[1]], number_[v[2]], number_[v[3]]});
    }
    const auto& sources = r_.inputs().sites().first_point;
    mesh.point_source.reserve(mesh.points.size());
    mesh.point_source.assign(sources.begin(), sources.end());
    mesh.point_source.resize(mesh.points.size(), -1);
  }

 private:
  static constexpr VertexId kMissing = kNoVertex - 1;  ///< in use, number not known yet

  /// Guests come first, input vertices before the others.
  void number_vertices() {
    number_.assign(r_.mesh().vertex_count() + 1, kNoVertex);
    for (const TetId t : refinement_->kept())
      for (const VertexId v : r_.mesh().tet(t).v) number_[v] = kMissing;
    first_bulk_ = static_cast<VertexId>(r_.inputs().places().size());
    for (VertexId v = 1; v < number_.size(); ++v)
      if (r_.is_input(v))
        number_[v] = r_.site(v);
      else if (refinement_->is_guest(v) && number_[v] == kMissing)
        number_[v] = first_bulk_++;
  }

  void set_apart(octree::Forest& forest) {
    std::vector<Disturber> all;
    for (VertexId v = 1; v < number_.size(); ++v)
      if (refinement_->is_guest(v)) all.push_back({r_.mesh().point(v), refinement_->home(v)});
    for (const BulkVertex& removed : refinement_->removed()) all.push_back({removed.place, removed.home});
    disturbers_.emplace(forest, std::move(all));
  }

  Refinement& r_;
  std::optional<OctreeRefinement> refinement_;
  std::optional<Disturbers> disturbers_;
  std::vector<VertexId> number_;  ///< in the mesh, by the kernel's vertex
  VertexId first_bulk_ = 0;
};

}  // namespace

octree::OctreeResult figure_8_on_octree(Refinement& r, const Domain& domain, const Sizing& sizing,
                                        const octree::OctreeOptions& options, const Control& control) {
  InputGuest guest(r);
  const geom::PointTree places(r.inputs().places());
  return octree::mesh_domain_octree(domain, sizing, r.world(), options, control, {places, guest});
}

}  // namespace unsliver::refine
