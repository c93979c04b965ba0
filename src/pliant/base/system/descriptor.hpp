// SPDX-License-Identifier: MIT
// Files as the system has them: opened by descriptor, read and written at positions.
// What fails leaves its reason in errno, on Windows too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace pliant {

/// What errno says, in words.
std::string error_words(int error);

/// Owns a file's descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void close();

 private:
  int number_ = -1;
};

/// How a file is opened. None is handed on to programs that this process starts.
enum class Opening {
  to_read,       ///< without waiting for whoever writes to a pipe: without one it is empty
  to_change,     ///< an existing file, for reading and writing
  to_make,       ///< for reading and writing; made if it is not there, and never a symbolic link
  to_make_anew,  ///< the same; fails if it is there
};

/// Opens a file. The descriptor is empty when that fails, and errno says why.
///
/// On Windows others may read, write, rename and delete the file meanwhile, as they may on POSIX.
Descriptor open_file(const std::filesystem::path& path, Opening opening);

enum class FileKind : std::uint8_t { regular, folder, device, stream };

/// What is known of an open file.
struct FileFacts {
  FileKind kind = FileKind::regular;
  std::uint64_t size = 0;  ///< bytes; 0 for what is not a regular file
};

/// Returns nothing when the system does not say, with the reason in errno.
std::optional<FileFacts> facts_of(int descriptor);

/// Whether there is a file, folder or pipe of this name.
bool is_there(const std::filesystem::path& path);

/// Whether the name leads to the open file.
bool is_same_file(int descriptor, const std::filesystem::path& path);

/// Reads up to bytes.size() bytes where the last read ended. Returns how many, 0 at the end, -1
/// when it fails.
std::ptrdiff_t read_some(int descriptor, std::span<std::byte> bytes);
/// The same from a position.
std::ptrdiff_t read_at(int descriptor, std::uint64_t position, std::span<std::byte> bytes);

/// Writes all of the bytes where the last write ended. Returns false when that fails.
bool write_all(int descriptor, std::span<const std::byte> bytes);
/// The same at a position.
bool write_all_at(int descriptor, std::uint64_t position, std::span<const std::byte> bytes);

/// Gives the file this many bytes; new ones are zero. Returns false when that fails.
bool resize_file(int descriptor, std::uint64_t size);

/// Hands to the file system what waits, as closing does: network file systems may say only then
/// that they are full. Returns false when that fails. Takes the locks of this process from the
/// file, but not those of the descriptor.
bool flush_contents(int descriptor);

/// Gives a file another name, in place of a file that has it; `held` is open on that one, if
/// anything is, and is closed. Returns false when that fails.
///
/// On Windows it fails where another program has that file open and does not share it.
bool replace_name(const std::filesystem::path& from, const std::filesystem::path& to,
                  Descriptor held = {});
/// The same, but fails with EEXIST when the name is taken. Where a file system has no hard links,
/// two that take a name at the same moment may both get it.
bool take_name(const std::filesystem::path& from, const std::filesystem::path& to);
/// Deletes a name, if it is there.
void remove_name(const std::filesystem::path& path);

}  // namespace pliant
