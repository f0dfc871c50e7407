#include "octree/emission.hpp"

#include <atomic>
#include <bit>
#include <limits>

#include "lattice/level.hpp"
#include "octree/parallel.hpp"
#include "octree/parts.hpp"
#include "octree/vertex_chunk.hpp"
#include "unsliver/error.hpp"

namespace unsliver::octree {
namespace {

constexpr std::size_t kTasksPerThread = 64;
/// Of a leaf, or of a uniform node: n points have fewer than n^2 / 2 Delaunay tetrahedra.
constexpr std::size_t kMostTetsAtOnce = kSlotCount * kSlotCount / 2;

/// Corner of a leaf that an own vertex number above 0 stands for.
Vec3 own_point(const Cell& cell, int own) {
  if (own == 0) return cell.center();
  const double side = double(cell.side());
  const int corner = own - 1;
  return cell.corner() + Vec3{side * (corner & 1), side * (corner >> 1 & 1), side * (corner >> 2)};
}

/// The number of ones, for the nine bits of Node::used.
constexpr auto kOnes = [] {
  std::array<std::uint8_t, 512> table{};
  for (std::size_t i = 0; i < 512; ++i) table[i] = std::uint8_t(std::popcount(i));
  return table;
}();

/// Visits what is below a node and can own kept tetrahedra, depth first: visitor.leaf(view), or
/// visitor.uniform(block, place, cell) for eight leaves at once.
template <class Visitor>
void visit_leaves(const Forest& forest, const Block& block, int place, const Cell& cell, Visitor& visitor) {
  const Node& node = forest[cell.node];
  if ((node.flags & kOutside) != 0) return;
  if (node.is_leaf()) return visitor.leaf(LeafView{forest, block, place, cell});
  if (is_uniform(block, place) && (node.flags & kDisturbed) == 0) return visitor.uniform(block, place, cell);
  const Block inner = child_block(forest, block, place);
  for (int child = 0; child < 8; ++child)
    visit_leaves(forest, inner, place_of_child(child), forest.child(cell, child), visitor);
}

/// The same for all leaves, without their neighbours.
template <class OnLeaf>
void for_each_cell(const Forest& forest, const Cell& cell, const OnLeaf& on_leaf) {
  if (forest[cell.node].is_leaf()) return on_leaf(cell);
  for (int child = 0; child < 8; ++child) for_each_cell(forest, forest.child(cell, child), on_leaf);
}

/// Are all its tetrahedra kept?
bool is_whole(const Node& leaf) { return (leaf.flags & (kInside | kDisturbed)) == kInside; }

/// World coordinates of a slot.
Vec3 slot_point(const LeafView& leaf, Key key, int slot) {
  const auto at = slot_position(slot, is_halved_slot(key, slot));
  const double quarter = 0.25 * double(leaf.cell.side());
  return leaf.cell.corner() + quarter * Vec3{double(at[0]), double(at[1]), double(at[2])};
}

}  // namespace

Emission::Emission(Forest& forest, Settings settings) : forest_(forest), settings_(std::move(settings)) {
  settings_.threads = std::max(1u, settings_.threads);
  for (const Part& part : cut(forest_, kTasksPerThread * settings_.threads))
    if (part.whole) tasks_.push_back({part.cell});
  for (unsigned i = 0; i < settings_.threads; ++i) caches_.emplace_back(templates_);
}

template <class Visitor>
void Emission::visit_leaves_of(const Task& task, Visitor& visitor) const {
  const Site site = site_of(forest_, task.cell);
  visit_leaves(forest_, site.block, site.place, task.cell, visitor);
}

template <class Visit>
void Emission::run_tasks(const Visit& visit) {
  for_each_task(tasks_.size(), settings_.threads, [&](std::size_t i, unsigned worker) {
    if (worker == 0 && settings_.poll) settings_.poll();
    visit(tasks_[i], worker);
  });
}

/// Chooses the tetrahedra of one task.
class Emission::Chooser {
 public:
  Chooser(Emission& all, Task& task, TemplateCache& templates)
      : forest_(all.forest_),
        keep_(all.settings_.keep),
        guest_(all.settings_.guest),
        uniform_(all.uniform_),
        task_(task),
        templates_(templates) {}

  /// Neighbours that are whole mark their own vertices, but beside guests they may not be.
  void uniform(const Block& block, int place, const Cell& cell) const {
    task_.leaves += 8;
    task_.tets += uniform_.tet_count();
    if (guest_ != nullptr)
      return uniform_.visit_uses(block, place, [this](NodeId n, std::uint8_t own) { mark(n, own); });
    const NodeId first = forest_[cell.node].link;
    for (NodeId n = first; n < first + 8; ++n) mark(n, kUniformUse);
  }

  void leaf(const LeafView& leaf) const {
    const Key key = key_of(leaf);
    const Template& made = templates_[key];
    ++task_.leaves;
    if (is_whole(forest_[leaf.cell.node]))
      take_all(leaf, made);
    else
      take_some(leaf, key, made);
  }

 private:
  /// The leaf's centre and lower corner are inside the domain: in use, if only by a uniform neighbour, which
  /// leaves it to their owner to say so.
  void take_all(const LeafView& leaf, const Template& made) const {
    task_.tets += made.tets.size();
    for (const int slot : made.slots) mark(leaf, slot);
    if ((forest_[leaf.cell.node].flags & kHasCenter) != 0) mark(leaf.cell.node, kUniformUse);
  }

  void take_some(const LeafView& leaf, Key key, const Template& made) const {
    const std::uint8_t flags = forest_[leaf.cell.node].flags;
    const bool inside = (flags & kInside) != 0;
    const auto others =
        (flags & kDisturbed) != 0 ? guest_->neighbours(leaf.cell.node) : std::span<const Vec3>();
    std::array<Vec3, kSlotCount> points;
    for (const std::size_t slot : made.slots) points[slot] = slot_point(leaf, key, int(slot));
    std::uint64_t slots = 0, word = 0;
    for (std::size_t i = 0; i < made.tets.size(); ++i) {
      const auto& t = made.tets[i];
      if (i % 64 == 0 && i > 0) task_.kept.push_back(std::exchange(word, 0));
      const Tet corners{points[t[0]], points[t[1]], points[t[2]], points[t[3]]};
      if (gives_way(corners, others) || (!inside && !keep_(corners))) continue;
      word |= std::uint64_t{1} << i % 64;
      for (const int slot : t) slots |= std::uint64_t{1} << slot;
      ++task_.tets;
    }
    task_.kept.push_back(word);
    task_.tested += made.tets.size();
    for (; slots != 0; slots &= slots - 1) mark(leaf, std::countr_zero(slots));
  }

  void mark(const LeafView& leaf, int slot) const {
    const VertexRef vertex = vertex_at(leaf, slot);
    mark(vertex.leaf, std::uint16_t(vertex.bit()));
  }

  void mark(NodeId owner, std::uint16_t bits) const {
    std::atomic_ref<std::uint16_t> used(forest_[owner].used);
    if ((used.load(std::memory_order_relaxed) & bits) != bits) used.fetch_or(bits, std::memory_order_relaxed);
  }

  Forest& forest_;
  const std::function<bool(const Tet&)>& keep_;
  const Guest* guest_;
  const UniformPattern& uniform_;
  Task& task_;
  TemplateCache& templates_;
};

void Emission::choose() {
  run_tasks([&](Task& task, unsigned worker) {
    Chooser chooser(*this, task, caches_[worker]);
    visit_leaves_of(task, chooser);
  });
  for (Task& task : tasks_) {
    task.first_tet = tet_count_;
    tet_count_ += task.tets;
    leaf_count_ += task.leaves;
    tested_tets_ += task.tested;
  }
}

void Emission::number(VertexId first) {
  vertex_count_ = first;
  run_tasks([&](Task& task, unsigned) {
    for_each_cell(forest_, task.cell,
                  [&](const Cell& cell) { task.vertices += kOnes[forest_[cell.node].used]; });
  });
  for (Task& task : tasks_) {
    task.first_vertex = vertex_count_;
    vertex_count_ += task.vertices;
  }
  if (vertex_count_ > std::uint64_t(std::numeric_limits<std::int32_t>::max()))
    throw Error(ErrorCode::kLimit, "the mesh would have 2^31 vertices or more: ask for larger sizes");
  run_tasks([&](Task& task, unsigned) {
    auto next = std::int32_t(task.first_vertex);
    for_each_cell(forest_, task.cell, [&](const Cell& cell) {
      Node& node = forest_[cell.node];
      node.link = ~next;
      next += kOnes[node.used];
    });
  });
}

void Emission::write_points(const std::function<void(VertexId, const Vec3&, const Cell&, unsigned)>& place) {
  run_tasks([&](Task& task, unsigned worker) {
    auto next = VertexId(task.first_vertex);
    for_each_cell(forest_, task.cell, [&](const Cell& cell) {
      for (unsigned used = forest_[cell.node].used; used != 0; used &= used - 1)
        place(next++, own_point(cell, std::countr_zero(used)), cell, worker);
    });
  });
}

/// Writes the tetrahedra of one task.
class Emission::Writer {
 public:
  Writer(const Emission& all, const Task& task, TemplateCache& templates, std::array<VertexId, 4>* out)
      : forest_(all.forest_),
        uniform_(all.uniform_),
        kept_(task.kept.data()),
        templates_(templates),
        out_(out) {}

  void uniform(const Block& block, int place, const Cell&) {
    out_ = uniform_.write(forest_, block, place, out_);
  }

  void leaf(const LeafView& leaf) {
    const Template& made = templates_[key_of(leaf)];
    VertexId ids[kSlotCount];
    for (const std::size_t slot : made.slots) ids[slot] = number_of(vertex_at(leaf, int(slot)));
    const bool all = is_whole(forest_[leaf.cell.node]);
    std::array<VertexId, 4>* out = out_;
    for (std::size_t i = 0; i < made.tets.size(); ++i) {
      const auto& t = made.tets[i];
      if (all || (kept_[i / 64] >> i % 64 & 1) != 0) *out++ = {ids[t[0]], ids[t[1]], ids[t[2]], ids[t[3]]};
    }
    out_ = out;
    if (!all) kept_ += std::max<std::size_t>(1, (made.tets.size() + 63) / 64);
  }

  const std::array<VertexId, 4>* end() const { return out_; }
  void continue_at(std::array<VertexId, 4>* out) { out_ = out; }

 private:
  VertexId number_of(const VertexRef& vertex) const {
    const Node& owner = forest_[vertex.leaf];
    return VertexId(~owner.link) + kOnes[owner.used & (vertex.bit() - 1)];
  }

  const Forest& forest_;
  const UniformPattern& uniform_;
  const std::uint64_t* kept_;
  TemplateCache& templates_;
  std::array<VertexId, 4>* out_;
};

void Emission::write_tets(std::array<VertexId, 4>* out) {
  run_tasks([&](Task& task, unsigned worker) {
    Writer writer(*this, task, caches_[worker], out + task.first_tet);
    visit_leaves_of(task, writer);
  });
}

/// Writes the tetrahedra of one task to a buffer, and empties it now and then.
class Emission::Streamer {
 public:
  static constexpr std::size_t kBufferSize = kChunkSize + kMostTetsAtOnce;

  Streamer(const Writer& writer, std::uint64_t first, std::span<std::array<VertexId, 4>> buffer,
           const TakeTets& take)
      : writer_(writer), first_(first), buffer_(buffer), take_(take) {}

  void uniform(const Block& block, int place, const Cell& cell) {
    make_room();
    writer_.uniform(block, place, cell);
  }
  void leaf(const LeafView& leaf) {
    make_room();
    writer_.leaf(leaf);
  }

  /// To be called at the end.
  void flush() {
    const auto count = std::size_t(writer_.end() - buffer_.data());
    if (count > 0) take_(first_, buffer_.first(count));
    first_ += count;
    writer_.continue_at(buffer_.data());
  }

 private:
  void make_room() {
    if (writer_.end() - buffer_.data() >= std::ptrdiff_t(kChunkSize)) flush();
  }

  Writer writer_;
  std::uint64_t first_;
  std::span<std::array<VertexId, 4>> buffer_;
  const TakeTets& take_;
};

void Emission::stream_tets(const TakeTets& take) {
  std::vector<std::vector<std::array<VertexId, 4>>> buffers(settings_.threads);
  run_tasks([&](Task& task, unsigned worker) {
    auto& buffer = buffers[worker];
    buffer.resize(Streamer::kBufferSize);
    Streamer streamer({*this, task, caches_[worker], buffer.data()}, task.first_tet, buffer, take);
    visit_leaves_of(task, streamer);
    streamer.flush();
  });
}

std::size_t Emission::bytes() const {
  std::size_t total = forest_.bytes() + tasks_.capacity() * sizeof(Task);
  for (const Task& task : tasks_) total += task.kept.capacity() * sizeof(std::uint64_t);
  return total;
}

}  // namespace unsliver::octree
