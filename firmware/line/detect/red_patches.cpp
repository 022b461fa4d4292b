#include "line/detect/red_patches.h"

#include <algorithm>
#include <iterator>

namespace tripoint {
namespace {

constexpr int kGrey = 128;

bool is_red(const Picture& picture, int column, int row, const SphereSettings& settings) {
  const int chroma_row = picture.chroma_rows_halved ? row : RedPatches::kCell_px * row;
  const int red = picture.v.at(column, chroma_row) - kGrey;
  if (red < settings.min_red_step) return false;
  const int less_blue = kGrey - picture.u.at(column, chroma_row);
  const int luma = picture.luma.at(RedPatches::kCell_px * column, RedPatches::kCell_px * row);
  return red >= settings.min_redness * luma && less_blue <= settings.max_hue * red &&
         less_blue >= settings.min_hue * red;
}

}  // namespace

void RedPatches::read(const Picture& picture, const SphereSettings& settings) {
  columns_ = picture.size.width_px / kCell_px;
  rows_ = picture.size.height_px / kCell_px;
  labels_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  parents_.assign(1, 0);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (is_red(picture, column, row, settings)) join(column, row);
    }
  }
  measure();
}

std::int32_t RedPatches::root(std::int32_t label) {
  auto at = static_cast<std::size_t>(label);
  while (parents_[at] != static_cast<std::int32_t>(at)) {
    parents_[at] = parents_[static_cast<std::size_t>(parents_[at])];
    at = static_cast<std::size_t>(parents_[at]);
  }
  return static_cast<std::int32_t>(at);
}

/// Union-find over the cells above and to the left.
void RedPatches::join(int column, int row) {
  const std::int32_t above = label(column, row - 1);
  const std::int32_t before = label(column - 1, row);
  std::int32_t own = std::max(above, before);
  if (own == 0) {
    own = static_cast<std::int32_t>(parents_.size());
    parents_.push_back(own);
  } else if (above != 0 && before != 0) {
    const std::int32_t one = root(above);
    const std::int32_t other = root(before);
    parents_[static_cast<std::size_t>(std::max(one, other))] = std::min(one, other);
  }
  labels_[index(column, row)] = own;
}

void RedPatches::measure() {
  patches_.assign(parents_.size(), {});
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      std::int32_t& own = labels_[index(column, row)];
      if (own == 0) continue;
      own = root(own);
      RedPatch& patch = patches_[static_cast<std::size_t>(own)];
      if (patch.cells++ == 0) patch = {own, 1, column, row, column, row};
      patch.left = std::min(patch.left, column);
      patch.right = std::max(patch.right, column);
      patch.bottom = row;
    }
  }
}

std::vector<RedPatch> RedPatches::at_least(int cells) const {
  std::vector<RedPatch> found;
  std::copy_if(patches_.begin(), patches_.end(), std::back_inserter(found),
               [cells](const RedPatch& patch) { return patch.cells >= std::max(cells, 1); });
  std::stable_sort(found.begin(), found.end(), [](const RedPatch& a, const RedPatch& b) { return a.cells > b.cells; });
  return found;
}

}  // namespace tripoint
