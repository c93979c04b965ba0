// SPDX-License-Identifier: MIT
// An output file that gets its name only when it is complete, and that only one process writes to.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "pliant/base/system/descriptor.hpp"

namespace pliant {

/// A new file beside its final name, locked against other writers as long as it is open.
///
/// The lock is that of base/system/file_lock.hpp, which conflicts with no reader. File systems
/// without locks give no such protection.
class OutputFile {
 public:
  /// Creates the file under a temporary name in the directory of `target` (".NAME.partial",
  /// replacing what a killed writer left there); a symbolic link is followed. Throws FileError with
  /// the system's reason when that fails, or when publish() could not succeed: `target` exists and
  /// `overwrite` is false, it is not a regular file, or another process is writing it.
  OutputFile(const std::filesystem::path& target, bool overwrite);
  /// Opens an existing file, unchanged, for writing. Throws FileError when it is not a regular
  /// file, cannot be written, or is being written.
  explicit OutputFile(const std::filesystem::path& existing);
  /// Deletes the file unless it was published.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  int descriptor() const { return file_.get(); }
  /// Appends all of `text`. Throws FileError with the system's reason.
  void write(std::string_view text) const;
  const std::filesystem::path& target() const { return target_; }
  /// Where the file is until it is published.
  const std::filesystem::path& partial() const { return temporary_; }
  /// Throws FileError unless the file system has taken all that was written.
  void flush() const;
  /// Flushes the file and gives it its final name. With `overwrite` it replaces an existing file of
  /// that name atomically. Throws as the constructor does.
  void publish();
  bool is_published() const { return published_; }
  void close();

 private:
  void create();
  void create_apart();
  void open_temporary(Opening opening);
  bool replace_existing();
  bool take_free_name();

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool overwrite_;
  bool published_ = false;
  Descriptor file_;
};

/// Where an OutputFile is until it is published: ".NAME.partial" beside its target.
std::filesystem::path partial_name(const std::filesystem::path& target);

/// Who is writing the file now: "process 123", "another recorder" if the process is unknown, "" for
/// nobody.
std::string writer_of(const std::filesystem::path& path);

/// Writes a complete file or none at all. Throws as OutputFile does.
void write_text_file(const std::filesystem::path& path, std::string_view text, bool overwrite);

/// Makes a folder and its missing parents. Throws FileError with the system's reason.
void make_folder(const std::filesystem::path& path);

}  // namespace pliant
