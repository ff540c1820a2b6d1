#include "pattern/seams/seam_trees.h"

#include <cstddef>
#include <iterator>
#include <vector>

namespace toile {

namespace {

/// A node of a tree. To its left is the next one: rows whose feature is at most `value`.
struct Node {
  int feature;  // of PairRow; -1: a leaf
  int right;    // steps to the node on the right
  float value;  // the feature's bound; of a leaf: what it adds
};

/// Learned by tests/benchmarks/fit_seam_trees.py, each tree in preorder.
constexpr Node nodes[] = {
#include "pattern/seams/seam_trees.inc"
};

const Node* end_of(const Node* node) {
  while (node->feature >= 0) node += node->right;
  return node + 1;
}

std::vector<const Node*> roots_of_trees() {
  std::vector<const Node*> roots;
  for (const Node* root = std::begin(nodes); root != std::end(nodes); root = end_of(root)) {
    roots.push_back(root);
  }
  return roots;
}

}  // namespace

double sewn_logit(const PairRow& row) {
  static const std::vector<const Node*> roots = roots_of_trees();
  double sum = 0;
  for (const Node* node : roots) {
    while (node->feature >= 0) {
      const float value = row[static_cast<std::size_t>(node->feature)];
      node += value <= node->value ? 1 : node->right;
    }
    sum += node->value;
  }
  return sum;
}

}  // namespace toile
