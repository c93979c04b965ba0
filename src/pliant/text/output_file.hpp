// SPDX-License-Identifier: MIT
// An output that takes its name only when it is worth it, and that no second run writes to.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pliant {

/// A new file beside its final name, locked against other writers as long as it is open.
///
/// The lock is an open file description lock (fcntl F_OFD_SETLK) far beyond the end of the file,
/// which neither readers nor HDF5's own locks (flock) meet. Where the file system has no locks
/// there is none.
class OutputFile {
 public:
  /// Creates the file under a temporary name in the directory of `target` (".NAME.partial", which
  /// takes the place of what a killed writer left there); a symbolic link is followed. Throws
  /// FileError with the system's reason when that cannot be, or when publish() could not succeed:
  /// `target` exists and `overwrite` is false, it is not a regular file, or it is being written.
  OutputFile(const std::filesystem::path& target, bool overwrite);
  /// Opens a file that is there, as it is, to be written on. Throws FileError when it is not a
  /// regular file, cannot be written, or is being written.
  explicit OutputFile(const std::filesystem::path& existing);
  /// Deletes the file unless it was published.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// Appends all of `text`. Throws FileError with the system's reason.
  void write(std::string_view text) const;
  const std::filesystem::path& target() const { return target_; }
  /// Gives the file its final name. With `overwrite` it replaces what has that name, at once and
  /// as a whole. Throws as the constructor does.
  void publish();
  bool is_published() const { return published_; }
  /// Has the folder's entry written to the disk.
  void sync_name() const;
  void close();

 private:
  void create();
  void create_apart();
  bool replace_existing();
  bool take_free_name();

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool overwrite_;
  bool published_ = false;
  int descriptor_ = -1;
};

/// Who is writing the file now: "process 123", "another recorder" where that cannot be told, ""
/// for nobody.
std::string writer_of(const std::filesystem::path& path);

/// Writes a file that is there as a whole or not at all. Throws as OutputFile does.
void write_text_file(const std::filesystem::path& path, std::string_view text, bool overwrite);

/// Makes a folder and those above it, where they are missing. Throws FileError with the system's
/// reason.
void make_folder(const std::filesystem::path& path);

}  // namespace pliant
