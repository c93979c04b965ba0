// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/committed_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/process.hpp"

namespace pliant {
namespace {

constexpr std::uint64_t disk_page = 4096;

// Ranks of blocks within a commit. Tree nodes lie between, by falling level.
constexpr int new_rank = 0;
constexpr int superblock_rank = 1;
constexpr int root_node_rank = 2;  // level 255, the highest that a byte holds
constexpr int in_place_rank = 300;

// Ranks where rows are taken away.
constexpr int shrunk_tree_rank = 10'000;
constexpr int shrunk_data_rank = 20'000;
constexpr int shrunk_superblock_rank = 30'000;

// By how much the file is longer than it is said to be: this many times what the last commit added,
// and at least so much.
constexpr std::uint64_t room_factor = 4;
constexpr std::uint64_t least_room = std::uint64_t{64} << 10;

// A version 1 B-tree node begins with TREE, its kind, level (0: leaf), and in two bytes, low one
// first, how many entries it has. HDF5 File Format Specification, III.A.1.
constexpr std::size_t node_head = 8;

bool is_tree_node(std::span<const std::byte> node) {
  constexpr char signature[] = {'T', 'R', 'E', 'E'};
  return node.size() >= node_head && std::memcmp(node.data(), signature, sizeof signature) == 0;
}

int tree_level(std::span<const std::byte> node) {
  return is_tree_node(node) ? std::to_integer<int>(node[5]) : 0;
}

int tree_entries(std::span<const std::byte> node) {
  if (!is_tree_node(node)) return 0;
  return std::to_integer<int>(node[6]) + 256 * std::to_integer<int>(node[7]);
}

/// Copies the part of a block that lies in the window [address, address + window.size()).
void overlay(std::uint64_t block_address, std::span<const std::byte> block, std::uint64_t address,
             std::span<std::byte> window) {
  const std::uint64_t first = std::max(block_address, address);
  const std::uint64_t last =
      std::min(block_address + block.size(), address + std::uint64_t{window.size()});
  if (first < last)
    std::memcpy(window.data() + (first - address), block.data() + (first - block_address),
                last - first);
}

}  // namespace

CommittedFile::CommittedFile(int descriptor) : descriptor_(descriptor), owner_(process_id()) {
  const std::optional<FileFacts> facts = facts_of(descriptor_);
  if (!facts) failure_ = errno;
  known_end_ = committed_end_ = end_ = written_end_ = facts.value_or(FileFacts{}).size;
}

void CommittedFile::write(BlockKind kind, std::uint64_t address, std::span<const std::byte> bytes) {
  if (kind == BlockKind::data && !shrinks_) {
    if (!stays(bytes)) return write_through(address, bytes);
    kept_.emplace_back(address, bytes);
    return;
  }
  pending_[address] = {kind, {bytes.begin(), bytes.end()}};
}

bool CommittedFile::stays(std::span<const std::byte> bytes) const {
  return !stay_.empty() && bytes.data() >= stay_.data() &&
         bytes.data() + bytes.size() <= stay_.data() + stay_.size();
}

void CommittedFile::write_kept() {
  for (const auto& [address, bytes] : kept_) write_through(address, bytes);
  kept_.clear();
  stay_ = {};
}

void CommittedFile::read(std::uint64_t address, std::span<std::byte> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const std::ptrdiff_t count = read_at(descriptor_, address + done, bytes.subspan(done));
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(done), bytes.end(), std::byte{0});
  for (const auto& [kept_address, kept] : kept_) overlay(kept_address, kept, address, bytes);
  for (const auto& [block_address, block] : pending_)
    overlay(block_address, block.bytes, address, bytes);
}

std::uint64_t CommittedFile::size() const {
  std::uint64_t size = written_end_;
  if (!pending_.empty()) {
    const auto& [address, block] = *pending_.rbegin();
    size = std::max(size, address + block.bytes.size());
  }
  for (const auto& [address, bytes] : kept_)
    size = std::max(size, address + std::uint64_t{bytes.size()});
  return size;
}

int CommittedFile::rank(const Blocks::value_type& entry) const {
  const auto& [address, block] = entry;
  if (block.kind == BlockKind::data) return shrunk_data_rank;
  if (address >= known_end_ && !written_.contains(address)) return new_rank;
  if (shrinks_ && block.kind != BlockKind::other_metadata) return rank_when_shrinking(block);
  if (block.kind == BlockKind::superblock) return superblock_rank;
  if (block.kind == BlockKind::tree_node) return root_node_rank + 255 - tree_level(block.bytes);
  return rank_of_header(address);
}

int CommittedFile::rank_when_shrinking(const Block& block) const {
  if (block.kind == BlockKind::superblock) return shrunk_superblock_rank;
  return shrunk_tree_rank + 255 - tree_level(block.bytes);
}

int CommittedFile::rank_of_header(std::uint64_t address) const {
  const auto place = std::find(last_.begin(), last_.end(), address);
  return in_place_rank + (place == last_.end() ? 0 : 1 + static_cast<int>(place - last_.begin()));
}

std::vector<CommittedFile::Ranked> CommittedFile::in_commit_order() const {
  std::vector<Ranked> order;
  order.reserve(pending_.size());
  for (const auto& entry : pending_) order.push_back({rank(entry), &entry});
  std::stable_sort(order.begin(), order.end(),
                   [](const Ranked& a, const Ranked& b) { return a.rank < b.rank; });
  return order;
}

void CommittedFile::commit() {
  write_kept();
  if (!may_write()) return;
  const std::vector<Ranked> order = in_commit_order();
  const auto in_place = std::find_if(order.begin(), order.end(),
                                     [](const Ranked& block) { return block.rank != new_rank; });
  for (auto at = order.begin(); at != in_place; ++at)
    write_through(at->entry->first, at->entry->second.bytes);
  make_room();
  if (failure_ != 0) {
    // The file is still as the last commit left it: what lies beyond only takes space.
    static_cast<void>(resize_file(descriptor_, committed_end_));
    return;
  }
  for (auto at = in_place; at != order.end(); ++at) write_in_place(*at->entry);
  if (failure_ != 0) return;
  for (const auto& [address, block] : pending_) written_.insert(address);
  pending_.clear();
  committed_end_ = end_;
  shrinks_ = false;
}

/// The superblock must not promise more than there is, also not to a reader that has asked for the
/// file's length before this commit.
void CommittedFile::make_room() {
  const std::uint64_t added = end_ > committed_end_ ? end_ - committed_end_ : 0;
  if (written_end_ >= end_ + added) return;
  const std::uint64_t room = std::max(room_factor * added, least_room);
  if (may_write() && resize_file(descriptor_, end_ + room)) {
    written_end_ = end_ + room;
  } else if (written_end_ < end_) {
    resize(end_);
  }
}

void CommittedFile::trim() {
  if (written_end_ > committed_end_) resize(committed_end_);
}

void CommittedFile::flush() {
  if (may_write() && !flush_contents(descriptor_)) failure_ = errno;
}

void CommittedFile::write_in_place(const Blocks::value_type& entry) {
  const auto& [address, block] = entry;
  if (block.kind == BlockKind::tree_node && block.bytes.size() > node_head)
    write_node(address, block.bytes);
  else
    write_backwards(address, block.bytes);
}

/// A leaf never counts entries that it does not hold yet. Nodes above change as a whole: between
/// their entries stand bounds of both neighbours.
void CommittedFile::write_node(std::uint64_t address, std::span<const std::byte> bytes) {
  std::array<std::byte, node_head> before{};
  static_cast<void>(read_at(descriptor_, address, before));
  if (tree_level(bytes) > 0 || tree_level(before) > 0) return write_through(address, bytes);
  const bool grows = tree_entries(bytes) >= tree_entries(before);
  if (!grows) write_through(address, bytes.first(node_head));
  write_through(address + node_head, bytes.subspan(node_head));
  if (grows) write_through(address, bytes.first(node_head));
}

void CommittedFile::write_backwards(std::uint64_t address, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const std::uint64_t last_page = (address + bytes.size() - 1) / disk_page * disk_page;
    const std::uint64_t start = std::max(address, last_page);
    write_through(start, bytes.subspan(start - address));
    bytes = bytes.first(start - address);
  }
}

void CommittedFile::resize(std::uint64_t size) {
  if (!may_write()) return;
  if (!resize_file(descriptor_, size)) failure_ = errno;
  written_end_ = size;
}

bool CommittedFile::may_write() const { return failure_ == 0 && owner_ == process_id(); }

void CommittedFile::write_through(std::uint64_t address, std::span<const std::byte> bytes) {
  if (!may_write()) return;
  written_end_ = std::max(written_end_, address + bytes.size());
  if (!write_all_at(descriptor_, address, bytes)) failure_ = errno;
}

}  // namespace pliant
