#include <chrono>
#include <cmath>
#include <optional>

#include "octree/balance.hpp"
#include "octree/box_faces.hpp"
#include "octree/emission.hpp"
#include "octree/fit.hpp"
#include "octree/growth.hpp"
#include "octree/guest.hpp"
#include "octree/octree.hpp"
#include "octree/parallel.hpp"
#include "octree/vertex_chunk.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr auto kReportInterval = std::chrono::milliseconds(100);

/// What a thread holds of a mesh that goes to a sink: chunks of vertices and of tetrahedra.
constexpr std::uint64_t kStreamBytes = kChunkSize * (sizeof(Vec3) + 1 + sizeof(std::array<VertexId, 4>));

/// Thrown to end a run early.
struct Stopped {
  OctreeStatus status;
};

/// Where to grow what.
struct Ground {
  BoxLattice lattice;
  std::uint8_t root_flags = 0;
  const geom::PointTree* guests = nullptr;

  bool is_domain() const { return root_flags == kWholeInside; }
};

Ground around(const Domain& domain, const Sizing& sizing, unsigned threads) {
  const auto world = lattice::World::fit(domain.bounds(), fit_radius(domain, sizing, threads));
  return {{world, brick_around(in_world(domain.bounds(), world))}, 0};
}

Ground exactly(const Box3& box, const Domain& domain, const Sizing& sizing, unsigned threads) {
  return {fit_lattice(lattices_of(box), domain, sizing, threads), kWholeInside};
}

class Run {
 public:
  Run(const Ground& ground, const Domain& domain, const Sizing& sizing, const OctreeOptions& options,
      const Control& control, Guest* guest = nullptr)
      : ground_(ground),
        domain_(domain),
        options_(options),
        control_(control),
        guest_(guest),
        test_(domain, sizing, ground_.lattice.world, ground.guests),
        forest_(ground.lattice.brick) {}

  void run() {
    prepare();
    enter("emit");
    write();
    if (ground_.is_domain() && !ground_.lattice.brick.periodic)
      mark_faces(domain_.bounds(), mesh_, options_.threads);
  }

  void stream(MeshSink& sink) {
    prepare();
    enter("emit");
    require_bytes(emission_->bytes() + options_.threads * kStreamBytes);
    sink.begin({emission_->vertex_count(), emission_->tet_count(), world().frame()});
    stream_points(sink);
    emission_->stream_tets(
        [&](std::uint64_t first, std::span<const std::array<VertexId, 4>> tets) { sink.tets(first, tets); });
  }

  void finish_phase() {
    if (phase_ == nullptr) return;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - phase_start_;
    stats_.phases.push_back({phase_, elapsed.count()});
    phase_ = nullptr;
  }

  OctreeStats stats() const {
    OctreeStats stats = stats_;
    stats.nodes = forest_.size();
    stats.domain_tests = growth_.domain_tests + test_.counts().domain_tests;
    stats.size_evaluations = growth_.size_evaluations;
    if (!emission_) return stats;
    stats.leaves = emission_->leaf_count();
    stats.tested_tets = emission_->tested_tets();
    stats.templates = emission_->template_count();
    stats.vertices = emission_->vertex_count();
    stats.needed_tets = emission_->tet_count();
    return stats;
  }

  TetMesh& mesh() { return mesh_; }

  /// Every point of some leaf is within this of its vertices.
  double radius_of_a_leaf() const {
    NodeId n = 0;
    while (!forest_[n].is_leaf()) n = forest_[n].link;
    const double share = forest_[n].flags & kHasCenter ? lattice::kQuarterSqrt5 : lattice::kHalfSqrt3;
    return share * std::ldexp(world().unit(), forest_[n].exponent);
  }

 private:
  const lattice::World& world() const { return ground_.lattice.world; }

  /// All but the result.
  void prepare() {
    enter("size");
    growth_ = grow(forest_, test_,
                   {options_.threads, options_.all_centers, ground_.root_flags,
                    [this](std::uint64_t bytes) { poll(bytes); }});
    enter("balance");
    stats_.balance_splits = balance(
        forest_, [this](const Cell& cell) { set_child_flags(cell); }, options_.threads);
    if (guest_ != nullptr) guest_->on_forest(forest_, [this](const char* phase) { enter(phase); });
    enter("choose");
    emission_.emplace(forest_, Emission::Settings{options_.threads, [this](const Tet& t) { return keeps(t); },
                                                  [this] { poll(forest_.bytes()); }, guest_});
    emission_->choose();
    check_caps();
    enter("number");
    emission_->number(guest_ != nullptr ? guest_->vertex_count() : 0);
  }

  void set_child_flags(const Cell& cell) {
    for (int number = 0; number < 8; ++number) {
      const Cell child = forest_.child(cell, number);
      const std::uint8_t flags = test_.flags(child, forest_[child.node].flags);
      forest_[child.node].flags = std::uint8_t(flags | (options_.all_centers ? kHasCenter : 0));
    }
  }

  bool keeps(const Tet& world_tet) const {
    Tet t;
    for (std::size_t i = 0; i < 4; ++i) t[i] = world().to_caller(world_tet[i]);
    return domain_.meets(t);
  }

  void check_caps() {
    const std::uint64_t of_guest = guest_ != nullptr ? guest_->tet_count() : 0;
    if (options_.max_tets != 0 && emission_->tet_count() + of_guest > options_.max_tets)
      throw Stopped{OctreeStatus::kTetCap};
  }

  void write() {
    mesh_.frame = world().frame();
    const std::size_t vertices = emission_->vertex_count(), tets = emission_->tet_count();
    const std::size_t of_guest = guest_ != nullptr ? guest_->tet_count() : 0;
    require_bytes(emission_->bytes() + vertices * (sizeof(Vec3) + 1) +
                  (tets + of_guest) * sizeof(mesh_.tets[0]));
    if (guest_ != nullptr) {
      mesh_.points.reserve(vertices + guest_->most_vertices());
      mesh_.levels.reserve(vertices + guest_->most_vertices());
    }
    resize_together(mesh_.points, vertices, options_.threads);
    resize_together(mesh_.levels, vertices, options_.threads);
    const auto place = [this](VertexId v, const Vec3& p, const Cell& owner, unsigned) {
      mesh_.points[v] = world().to_caller(p);
      mesh_.levels[v] = level_of(v, p, owner);
    };
    emission_->write_points(place);
    mesh_.tets.reserve(tets + of_guest);
    resize_together(mesh_.tets, tets, options_.threads);
    emission_->write_tets(mesh_.tets.data());
    if (guest_ != nullptr) guest_->complete(mesh_);
  }

  /// Beside guests no coarser than BCC_k, k the leaf's exponent, so that they need not mind vertices that are
  /// far from them.
  std::uint8_t level_of(VertexId number, const Vec3& p, const Cell& owner) {
    const lattice::Level canonical = lattice::canonical_level(p);
    if (guest_ == nullptr) return std::uint8_t(canonical);
    const lattice::Level coarse = std::min(canonical, 2 * owner.exponent);
    const bool is_visited = (forest_[owner.node].flags & (kVisited | kOutside)) != 0;
    return is_visited ? guest_->on_vertex(number, p, coarse) : std::uint8_t(coarse);
  }

  void stream_points(MeshSink& sink) {
    std::vector<VertexChunk> chunks(options_.threads, VertexChunk(sink));
    emission_->write_points([&](VertexId v, const Vec3& p, const Cell&, unsigned worker) {
      chunks[worker].add(v, world().to_caller(p), std::uint8_t(lattice::canonical_level(p)));
    });
    for (VertexChunk& chunk : chunks) chunk.flush();
  }

  void require_bytes(std::uint64_t bytes) {
    if (guest_ != nullptr) bytes += guest_->bytes();
    stats_.peak_bytes = std::max(stats_.peak_bytes, bytes);
    if (options_.max_bytes != 0 && bytes > options_.max_bytes) throw Stopped{OctreeStatus::kMemoryCap};
  }

  void poll(std::uint64_t bytes) {
    require_bytes(bytes);
    if (control_.cancelled && control_.cancelled()) throw Stopped{OctreeStatus::kCancelled};
    const auto now = std::chrono::steady_clock::now();
    if (!control_.on_progress || now - last_report_ < kReportInterval) return;
    last_report_ = now;
    Progress progress;
    progress.phase = phase_;
    progress.done = bytes / sizeof(Node);
    control_.on_progress(progress);
  }

  void enter(const char* name) {
    finish_phase();
    phase_ = name;
    phase_start_ = std::chrono::steady_clock::now();
  }

  const Ground ground_;
  const Domain& domain_;
  const OctreeOptions& options_;
  const Control& control_;
  Guest* const guest_;
  LeafTest test_;
  Forest forest_;
  LeafTestCounts growth_;
  std::optional<Emission> emission_;
  TetMesh mesh_;
  OctreeStats stats_;
  const char* phase_ = nullptr;
  std::chrono::steady_clock::time_point phase_start_, last_report_ = std::chrono::steady_clock::now();
};

/// Work ends somehow.
template <class Work>
OctreeResult result_of(Run& run, const Work& work) {
  OctreeResult result;
  try {
    work();
    result.mesh = std::move(run.mesh());
  } catch (const Stopped& stopped) {
    result.status = stopped.status;
  }
  run.finish_phase();
  result.stats = run.stats();
  return result;
}

OctreeResult result_of(Run& run) {
  return result_of(run, [&] { run.run(); });
}

void require_thread(const OctreeOptions& options) {
  if (options.threads == 0) throw Error(ErrorCode::kBadOption, "the octree mesher needs at least one thread");
}

}  // namespace

OctreeResult mesh_domain_octree(const Domain& domain, const Sizing& sizing, const OctreeOptions& options,
                                const Control& control) {
  require_thread(options);
  Run run(around(domain, sizing, options.threads), domain, sizing, options, control);
  return result_of(run);
}

OctreeResult stream_domain_octree(const Domain& domain, const Sizing& sizing, MeshSink& sink,
                                  const OctreeOptions& options, const Control& control) {
  require_thread(options);
  Run run(around(domain, sizing, options.threads), domain, sizing, options, control);
  return result_of(run, [&] { run.stream(sink); });
}

OctreeResult mesh_domain_octree(const Domain& domain, const Sizing& sizing, const lattice::World& world,
                                const OctreeOptions& options, const Control& control,
                                const GuestList& guests) {
  require_thread(options);
  const Ground ground{{world, brick_around(in_world(domain.bounds(), world))}, 0, &guests.places};
  Run run(ground, domain, sizing, options, control, &guests.guest);
  return result_of(run);
}

OctreeResult mesh_box_octree(const Box3& box, const Sizing& sizing, const OctreeOptions& options,
                             const Control& control) {
  require_thread(options);
  const DomainPtr domain = make_box(box);
  Run run(exactly(box, *domain, sizing, options.threads), *domain, sizing, options, control);
  OctreeResult result = result_of(run);
  if (sizing.lipschitz() == 0 && result.status == OctreeStatus::kDone)
    result.stats.radius = run.radius_of_a_leaf();
  return result;
}

OctreeResult mesh_torus_octree(const Box3& cell, const BoxLattice& lattice, const Sizing& sizing,
                               const OctreeOptions& options, const Control& control) {
  require_thread(options);
  const DomainPtr domain = make_box(cell);
  Ground ground{lattice, kWholeInside};
  ground.lattice.brick.periodic = true;
  Run run(ground, *domain, sizing, options, control);
  return result_of(run);
}

}  // namespace unsliver::octree
