// SPDX-License-Identifier: MIT
// A file of data and metadata blocks. Metadata reaches the disk only in commits, in an order that
// leaves a readable file behind wherever the writer is killed (ordered, "soft" updates).
//
// HDF5 by itself writes metadata in the order of its cache: a writer killed in between leaves chunk
// trees that point nowhere. A commit of CommittedFile writes
//   1. first blocks that were never written before: nothing refers to them yet;
//   2. then the superblock, which holds the length of the file;
//   3. then chunk tree nodes in place, parents before children: a split has put the right half
//      into a new node by 1, and the left half shrinks only when its parent knows the new one;
//   4. then the other blocks in place, which are object headers with the new extents; those named
//      to write_last() are the last, in that order.
// When rows are removed, the order is another: headers first, then trees, then data, then the
// superblock, so that everything a reader is led to exists.
//
// Readers determine the length of the file before they read the superblock. Until it is closed, the
// file is therefore longer than the superblock says, by as much as the next commit may add.
//
// A kill interrupts a write between two pages of the file, never within one. Tree nodes lie within
// one page (the driver aligns them). Their counts and entries are still written separately, so that
// a disk that fails within a page never leaves a count of missing entries. Blocks in two pages are
// written from their end, because an object header has its extents before the address of its chunk
// tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pliant {

/// What a block of the file holds.
enum class BlockKind : std::uint8_t { data, superblock, tree_node, other_metadata };

/// Writes to an open file descriptor. Nothing throws: after the first failed write (errno in
/// failure()) nothing more reaches the disk, but metadata can still be written and read back, so
/// that HDF5 can close the file normally.
class CommittedFile {
 public:
  /// Does not own `descriptor`, which must be open for reading and writing. The file's present
  /// contents count as committed.
  explicit CommittedFile(int descriptor);

  /// Writes data at once, and metadata with the next commit.
  void write(BlockKind kind, std::uint64_t address, std::span<const std::byte> bytes);
  /// Data that lies in `bytes` is from now on only noted when it is written, and must stay as it is
  /// until write_kept(), or the next commit, hands it to the disk. So HDF5, which one thread may
  /// use at a time, is free meanwhile.
  void keep(std::span<const std::byte> bytes) { stay_ = bytes; }
  void write_kept();
  /// Reads what was written, committed or not; zeros beyond the end.
  void read(std::uint64_t address, std::span<std::byte> bytes) const;

  /// Sets the nominal length of the file (end of allocated space).
  void set_end(std::uint64_t end) { end_ = end; }
  std::uint64_t end() const { return end_; }
  /// Length of the file with what waits for a commit.
  std::uint64_t size() const;

  /// Addresses of the blocks that a commit writes last, in this order.
  void write_last(std::vector<std::uint64_t> addresses) { last_ = std::move(addresses); }
  void commit();
  /// Says that rows are removed: until the next commit data waits, too.
  void shrink() { shrinks_ = true; }
  /// Cuts the file to the length in the superblock. Only after the last commit.
  void trim();
  /// Hands all to the file system. Only after the last commit.
  void flush();

  /// errno of the first write that failed, or 0.
  int failure() const { return failure_; }

 private:
  struct Block {
    BlockKind kind;
    std::vector<std::byte> bytes;
  };
  using Blocks = std::map<std::uint64_t, Block>;

  struct Ranked {
    int rank;
    const Blocks::value_type* entry;
  };

  bool stays(std::span<const std::byte> bytes) const;
  std::vector<Ranked> in_commit_order() const;
  int rank(const Blocks::value_type& entry) const;
  int rank_when_shrinking(const Block& block) const;
  int rank_of_header(std::uint64_t address) const;
  bool may_write() const;
  void write_through(std::uint64_t address, std::span<const std::byte> bytes);
  void write_in_place(const Blocks::value_type& entry);
  void write_node(std::uint64_t address, std::span<const std::byte> bytes);
  void write_backwards(std::uint64_t address, std::span<const std::byte> bytes);
  void resize(std::uint64_t size);
  void make_room();

  int descriptor_;
  bool shrinks_ = false;
  int owner_;  // a forked child holds the same descriptor and must leave the file alone
  std::uint64_t end_ = 0;
  std::uint64_t written_end_ = 0;
  std::uint64_t committed_end_ = 0;
  Blocks pending_;
  std::span<const std::byte> stay_;
  std::vector<std::pair<std::uint64_t, std::span<const std::byte>>> kept_;  ///< by address
  std::uint64_t known_end_ = 0;      // all metadata blocks before it are on the disk ...
  std::set<std::uint64_t> written_;  // ... and those at these addresses
  std::vector<std::uint64_t> last_;
  int failure_ = 0;
};

}  // namespace pliant
