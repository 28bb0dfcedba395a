#include "rays/packets/bsp_build.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

// Cells that are larger are split on all cores together.
constexpr std::size_t kSubtree = 1 << 15;

struct Cell {
    BspBox box;
    int depth = 0;
    double copies = 0;  // Entries that its lists may have, all together.
};

struct Halves {
    Cell left, right;
};

Halves HalvesOf(const Cell& cell, const BspSplit& split, std::size_t left, std::size_t right) {
    Halves halves{cell, cell};
    halves.left.box.high_m[split.axis] = split.at_m;
    halves.right.box.low_m[split.axis] = split.at_m;
    halves.left.depth = halves.right.depth = cell.depth + 1;
    const double share = double(left) / double(std::max<std::size_t>(left + right, 1));
    halves.left.copies = cell.copies * share;
    halves.right.copies = cell.copies * (1 - share);
    return halves;
}

class Builder {
  public:
    Builder(std::span<const Corners> triangles_m, const BspBuildOptions& options)
        : triangles_m_(triangles_m),
          costs_(options.costs),
          most_depth_(std::min(BspTree::kMostDepth,
                               8 + int(1.3 * std::log2(double(triangles_m.size()) + 1)))) {}

    // What a side gets of `references`.
    template <class Add>
    void Side(std::span<const BspReference> references, const BspSplit& split, int side,
              const Add& add) const {
        for (const BspReference& reference : references) {
            const float low = reference.box.low_m[split.axis];
            const float high = reference.box.high_m[split.axis];
            const bool left = NeedsLeft(low, high, split.at_m);
            const bool right = NeedsRight(high, split.at_m);
            if (!(side == 0 ? left : right)) continue;
            BspReference part = reference;
            if (!(left && right) ||
                Narrow(part, triangles_m_[part.triangle], split.axis, split.at_m, side)) {
                add(part);
            }
        }
    }

    std::optional<BspSplit> SplitOf(std::span<const BspReference> references, const Cell& cell,
                                    BspScratch& scratch) const {
        if (cell.depth >= most_depth_) return std::nullopt;
        return CheapestSplit(references, cell.box, costs_, scratch);
    }

  private:
    std::span<const Corners> triangles_m_;
    BspCosts costs_;
    int most_depth_;
};

// A subtree by one thread. Its references lie on a stack: those of a cell, above them those of
// its right and of its left half.
class Subtree {
  public:
    explicit Subtree(const Builder& builder) : builder_(builder) { tree_.nodes.resize(2); }

    BspTree Build(std::vector<BspReference> references, const Cell& cell) {
        stack_ = std::move(references);
        Divide(0, 0, stack_.size(), cell);
        return std::move(tree_);
    }

  private:
    void Divide(std::size_t node, std::size_t begin, std::size_t end, const Cell& cell) {
        tree_.depth = std::max(tree_.depth, cell.depth);
        const std::size_t n = end - begin;
        const std::optional<BspSplit> split =
            builder_.SplitOf({stack_.data() + begin, n}, cell, scratch_);
        if (split) {
            // A copy: the stack grows under it.
            work_.assign(stack_.begin() + std::ptrdiff_t(begin),
                         stack_.begin() + std::ptrdiff_t(end));
            const auto push = [this](const BspReference& part) { stack_.push_back(part); };
            builder_.Side(work_, *split, 1, push);
            const std::size_t middle = stack_.size();
            builder_.Side(work_, *split, 0, push);
            const std::size_t top = stack_.size(), left = top - middle, right = middle - end;
            if (double(left + right) <= std::max(cell.copies, double(n))) {
                const Halves halves = HalvesOf(cell, *split, left, right);
                const std::size_t pair = tree_.nodes.size();
                tree_.nodes.resize(pair + 2);
                tree_.nodes[node] =
                    BspNode::Inner(split->axis, split->at_m, std::uint32_t(pair));
                Divide(pair, middle, top, halves.left);
                stack_.resize(middle);
                Divide(pair + 1, end, middle, halves.right);
                stack_.resize(end);
                return;
            }
            stack_.resize(end);
        }
        tree_.nodes[node] = BspNode::Leaf(std::uint32_t(tree_.lists.size()), std::uint32_t(n));
        for (std::size_t i = begin; i < end; ++i) tree_.lists.push_back(stack_[i].triangle);
    }

    const Builder& builder_;
    BspScratch scratch_;
    std::vector<BspReference> stack_, work_;
    BspTree tree_;
};

// A cell near the root.
struct Top {
    Cell cell;
    std::vector<BspReference> references;  // Empty once it is split.
    std::optional<BspSplit> split;         // Then the children are:
    std::unique_ptr<Top> left, right;
    BspTree subtree;  // Else this.
};

// Splits `top` if it is large and worth it.
void SplitTop(const Builder& builder, Top& top) {
    if (top.references.size() <= kSubtree) return;
    BspScratch scratch;
    const std::optional<BspSplit> split = builder.SplitOf(top.references, top.cell, scratch);
    if (!split) return;
    auto left = std::make_unique<Top>(), right = std::make_unique<Top>();
    const auto into = [](Top& side) {
        return [&side](const BspReference& part) { side.references.push_back(part); };
    };
    builder.Side(top.references, *split, 0, into(*left));
    builder.Side(top.references, *split, 1, into(*right));
    const std::size_t n = left->references.size() + right->references.size();
    if (double(n) > std::max(top.cell.copies, double(top.references.size()))) return;
    const Halves halves =
        HalvesOf(top.cell, *split, left->references.size(), right->references.size());
    left->cell = halves.left;
    right->cell = halves.right;
    top.split = split;
    top.left = std::move(left);
    top.right = std::move(right);
    top.references = {};
}

class Assembly {
  public:
    explicit Assembly(BspTree& tree) : tree_(tree) { tree_.nodes.resize(2); }

    void Add(std::size_t node, Top& top) {
        if (top.split) {
            const std::size_t pair = tree_.nodes.size();
            tree_.nodes.resize(pair + 2);
            tree_.nodes[node] = BspNode::Inner(top.split->axis, top.split->at_m, Pointer(pair));
            Add(pair, *top.left);
            Add(pair + 1, *top.right);
            return;
        }
        const BspTree part = std::exchange(top.subtree, {});
        const std::size_t nodes = tree_.nodes.size() - 2, lists = tree_.lists.size();
        const auto moved = [&](const BspNode& from) {
            return from.IsLeaf() ? BspNode::Leaf(Pointer(from.First() + lists), from.Count())
                                 : BspNode::Inner(from.Axis(), from.SplitM(),
                                                  Pointer(from.Left() + nodes));
        };
        tree_.nodes[node] = moved(part.nodes[0]);
        for (std::size_t i = 2; i < part.nodes.size(); ++i) {
            tree_.nodes.push_back(moved(part.nodes[i]));
        }
        tree_.lists.insert(tree_.lists.end(), part.lists.begin(), part.lists.end());
        tree_.depth = std::max(tree_.depth, part.depth);
    }

  private:
    static std::uint32_t Pointer(std::size_t place) {
        if (place >= BspNode::kMostPointed) {
            throw MachineError("the BSP tree has over 2^30 nodes or entries");
        }
        return std::uint32_t(place);
    }

    BspTree& tree_;
};

}  // namespace

BspTree BuildBspTree(std::span<const Corners> triangles_m, const BspBuildOptions& options,
                     Monitor& monitor) {
    const std::size_t n = triangles_m.size();
    const Builder builder(triangles_m, options);
    Top root;
    root.references.resize(n);
    ParallelFor(std::int64_t(n), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            root.references[std::size_t(i)] =
                ReferenceTo(triangles_m[std::size_t(i)], std::uint32_t(i));
        }
    });
    for (std::size_t i = 0; i < n; ++i) {
        const BspBox& box = root.references[i].box;
        if (i == 0) root.cell.box = box;
        for (std::size_t k = 0; k < 3; ++k) {
            root.cell.box.low_m[k] = std::min(root.cell.box.low_m[k], box.low_m[k]);
            root.cell.box.high_m[k] = std::max(root.cell.box.high_m[k], box.high_m[k]);
        }
    }
    root.cell.copies = options.most_copies * double(n) + 1024;

    std::vector<Top*> level{&root}, ends;
    while (!level.empty()) {
        ParallelFor(
            std::int64_t(level.size()), 1,
            [&](std::int64_t i, std::int64_t) { SplitTop(builder, *level[std::size_t(i)]); },
            monitor, "BSP tree: first cells");
        std::vector<Top*> next;
        for (Top* top : level) {
            if (top->split) {
                next.push_back(top->left.get());
                next.push_back(top->right.get());
            } else {
                ends.push_back(top);
            }
        }
        level = std::move(next);
    }
    ParallelFor(
        std::int64_t(ends.size()), 1,
        [&](std::int64_t i, std::int64_t) {
            Top& top = *ends[std::size_t(i)];
            top.subtree = Subtree(builder).Build(std::move(top.references), top.cell);
        },
        monitor, "BSP tree");

    BspTree tree;
    tree.box = root.cell.box;
    Assembly(tree).Add(0, root);
    return tree;
}

}  // namespace plumb
